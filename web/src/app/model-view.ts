// SPDX-License-Identifier: Apache-2.0
// Scene + state -> what is drawn: loads the results of a step, sets ranges, colour and deformation.
import { Vector3 } from "three";
import { automaticDeformationFactor, type ValueRange } from "../present";
import { type Cut, Picker } from "../probe";
import { ModelObject } from "../render";
import {
  isPreview,
  onShape,
  type SceneData,
  type SceneLevel,
  type SceneResult,
  type SceneStep,
} from "../scene";
import { unitText } from "../ui";
import { largestOf, toVectors } from "./displacements";
import { covers, drawnOf, levelWords } from "./level-words";
import {
  colourEffect,
  colourEntry,
  drivenBy,
  findResult,
  type Presented,
  presentedOf,
} from "./presentation-doc";
import { type Fields, rangeOf } from "./ranges";
import type { Store } from "./store";

/** Maps whose neighbours differ in lightness alone: shade would be read as another value, so they get half of it. */
const TOLD_BY_LIGHTNESS: ReadonlySet<string> = new Set(["cividis", "cool_warm"]);
/** A step that is left again so soon, while another is still on its way, is not read. */
const PASSED_BY_MS = 120;
const scratch = new Vector3();

const SKIN_ONLY =
  "Inside the material: this scene has no volume elements, so no value is here. Open the model file for values.";

/** A result of the presentation with its values and range at the step that is shown. */
export interface Shown extends Presented {
  readonly fields: Fields;
  readonly range: ValueRange;
}

export class ModelView {
  readonly model: ModelObject;
  readonly picker: Picker;
  /** Settled when the element edges are drawn, or when they cannot be. */
  readonly edgesCame: Promise<void>;
  #scene: SceneData;
  readonly #store: Store;
  readonly #changed: () => void;
  #shown: readonly Shown[] = [];
  #displacements: readonly (Float32Array | null)[] = [];
  #largestDisplacement = 0;
  #loadedStep = Number.NaN;
  #turn = 0;
  /** The shape can be pointed at before its results are there. */
  #isPointedAt = false;
  /** Refreshes that are waiting for their results. */
  #loading = 0;
  #imaginary: readonly (Float32Array | null)[] | null = null;
  /** What the card has as values. */
  #coloured: { fields: Fields | null; component: number } = { fields: null, component: -1 };
  /** What the displacements were made of. */
  #shapeSources: readonly unknown[] = [];
  /** Position in the swing of a mode, radians. */
  #angle = 0;
  #cuts: readonly Cut[] = [];
  #insideText: () => string = () => SKIN_ONLY;

  constructor(scene: SceneData, store: Store, changed: () => void) {
    this.#scene = scene;
    this.#store = store;
    this.#changed = changed;
    this.model = new ModelObject(scene);
    this.picker = new Picker(scene.parts);
    this.edgesCame = scene.edgesCame.then(
      () => this.#drawEdges(),
      (error: Error) => this.#store.set({ problem: `Edges of elements: ${error.message}` }),
    );
  }

  get scene(): SceneData {
    return this.#scene;
  }

  /** The shape alone is there: nothing is known of results yet. */
  get isPreview(): boolean {
    return isPreview(this.#scene.extras);
  }

  /** Results for the shape that is drawn; false: this is another shape. */
  adopt(finished: SceneData): boolean {
    const scene = onShape(this.#scene, finished);
    if (!scene) return false;
    this.#scene = scene;
    // Nothing is coloured yet.
    this.#loadedStep = Number.NaN;
    this.#isPointedAt = true;
    return true;
  }

  #drawEdges(): void {
    this.model.addEdges(this.scene.parts);
    if (!Number.isNaN(this.#loadedStep)) this.#changed();
  }

  get shown(): readonly Shown[] {
    return this.#shown;
  }

  shownAs(slot: "colour" | "pitch" | "ticks" | "pulses" | "shape"): Shown | null {
    const key = drivenBy(this.#store.state.doc, slot);
    return this.#shown.find((s) => s.key === key && s.result) ?? null;
  }

  get step(): SceneStep | null {
    return this.scene.extras.steps.find((s) => s.id === this.#store.state.step) ?? null;
  }

  /** What 5 % of the largest side makes of this step's displacement; 0 without one. */
  get automaticFactor(): number {
    return automaticDeformationFactor(this.model.largestSide, this.#largestDisplacement);
  }

  get hasShape(): boolean {
    return this.#displacements.some((d) => d !== null);
  }

  /** The deformation factor in force. */
  get factor(): number {
    const { deformMode, typedFactor } = this.#store.state;
    if (!this.hasShape || deformMode === "off") return 0;
    if (deformMode === "true") return 1;
    return deformMode === "auto" ? this.automaticFactor : typedFactor;
  }

  /** The displacement that moves the shape. */
  get shapeResult(): SceneResult | null {
    return this.hasShape ? this.#shapeResult() : null;
  }

  #shapeResult(): SceneResult | null {
    const key = drivenBy(this.#store.state.doc, "shape");
    const wanted = presentedOf(this.#store.state.doc, this.scene.extras).find((p) => p.key === key);
    if (!wanted) return null;
    const isVector = (r: SceneResult) =>
      r.complex !== "imaginary" &&
      r.components.length === 3 &&
      ["x", "y", "z"].every((c) => r.components.includes(c));
    const { results } = this.scene.extras;
    return (
      results.find((r) => r.quantity === wanted.name && isVector(r)) ??
      results.find((r) => r.id === wanted.name && isVector(r)) ??
      null
    );
  }

  /** The other part of a complex shape at this step; null: the shape is real. */
  #imaginaryOf(shape: SceneResult | null, step: number): SceneResult | null {
    if (shape?.complex !== "real") return null;
    const { results } = this.scene.extras;
    const is = (r: SceneResult) =>
      r.complex === "imaginary" && r.quantity === shape.quantity && r.components.length === 3;
    return results.find((r) => is(r) && r.values.some((v) => v.step === step)) ?? null;
  }

  /** Whether the shape turns as it swings: the step has a complex displacement. */
  get isComplex(): boolean {
    return this.#imaginary !== null;
  }

  /** Factors of the real and the imaginary displacement as they are drawn now. */
  get swing(): { re: number; im: number } {
    const { factor } = this;
    const im = this.#imaginary ? 0 - factor * Math.sin(this.#angle) : 0;
    return { re: factor * Math.cos(this.#angle), im };
  }

  /** Displacement of a vertex at this step, model units; null without one. */
  displacementAt(part: number, vertex: number): readonly [number, number, number] | null {
    const vectors = this.#displacements[part];
    if (!vectors || vertex < 0) return null;
    const by = (axis: number) => {
      const moved = vectors[3 * vertex + axis] ?? 0;
      return Number.isNaN(moved) ? 0 : moved;
    };
    return [by(0), by(1), by(2)];
  }

  applyGhost(): void {
    this.model.setGhost(this.#store.state.ghost && this.factor !== 0);
  }

  /** Results that a step needs to be shown. */
  #wantedAt(step: number): ReadonlySet<SceneResult> {
    const presented = presentedOf(this.#store.state.doc, this.scene.extras);
    const shape = this.#shapeResult();
    const others = [shape, this.#imaginaryOf(shape, step)].filter((result) => result !== null);
    return new Set([...presented.flatMap((p) => p.result ?? []), ...others]);
  }

  /** Reads a step that will be shown soon; what cannot be read is said when it is shown. */
  readAhead(step: number): void {
    for (const result of this.#wantedAt(step)) this.scene.loadField(result, step).catch(() => {});
  }

  /** Loads what the state asks for and shows it; a result that cannot be read is said and left out. */
  async refresh(): Promise<void> {
    this.#turn += 1;
    const turn = this.#turn;
    if (this.#loading > 0) {
      // Somebody runs through the steps: what is passed by is not read.
      await new Promise((later) => setTimeout(later, PASSED_BY_MS));
      if (turn !== this.#turn) return;
    }
    const { doc, step } = this.#store.state;
    const presented = presentedOf(doc, this.scene.extras);
    const shape = this.#shapeResult();
    const wanted = this.#wantedAt(step);
    // Nothing is coloured yet: the colour does not wait for what is heard and felt, unless that could be read as missing.
    const isFirst = Number.isNaN(this.#loadedStep) && !this.#isPointedAt;
    const seen = isFirst ? drivenBy(doc, "colour") : null;
    const first = presented.find((p) => p.key === seen && p.result);
    const problems: string[] = [];
    const loaded = new Map<SceneResult, Fields>();
    const nothing: Fields = this.scene.parts.map(() => null);
    this.#loading += 1;
    await Promise.all(
      [...wanted].map(async (result) => {
        try {
          const fields = await this.scene.loadField(result, step);
          loaded.set(result, fields);
          if (first?.result === result && turn === this.#turn)
            this.#colourEarly(presented, result, fields, step);
        } catch (error) {
          problems.push(`${result.name}: ${error instanceof Error ? error.message : String(error)}`);
          loaded.set(result, nothing);
        }
      }),
    );
    this.#loading -= 1;
    if (turn !== this.#turn) return;
    this.#shown = presented.map((p) => {
      const fields = (p.result && loaded.get(p.result)) ?? nothing;
      return { ...p, fields, range: rangeOf(p, step, fields) };
    });
    this.#applyShape(shape, (result) => loaded.get(result) ?? null, step);
    this.#loadedStep = step;
    this.#applyColour();
    this.applyFactor();
    if (problems.length > 0) this.#store.set({ problem: problems.join("; ") });
    this.#changed();
  }

  #applyShape(shape: SceneResult | null, read: (r: SceneResult) => Fields | null, step: number): void {
    const vectors = (result: SceneResult | null) => {
      const fields = result && read(result);
      return this.scene.parts.map((_, i) => (fields?.[i] ? toVectors(fields[i]) : null));
    };
    const other = this.#imaginaryOf(shape, step);
    // Another result is seen but the shape is the same: nothing of it goes to the card again.
    const sources = [shape && read(shape), other && read(other)];
    if (sources.every((source, i) => source === this.#shapeSources[i])) return;
    this.#shapeSources = sources;
    this.#displacements = vectors(shape);
    this.#imaginary = other ? vectors(other) : null;
    this.#largestDisplacement = 0;
    if (shape) {
      const magnitude = findResult(this.scene.extras, shape.quantity ?? shape.id, "magnitude");
      const stated = magnitude?.result.values.find((v) => v.step === step)?.max?.value;
      this.#largestDisplacement = Math.max(
        stated ?? largestOf(this.#displacements),
        largestOf(this.#imaginary ?? []),
      );
    }
    this.model.setDisplacements(this.#displacements, this.#imaginary);
  }

  /** Names and ranges, for a page that waits for its first results. */
  outline(): void {
    const { doc, step } = this.#store.state;
    this.#shown = this.#outlined(presentedOf(doc, this.scene.extras), step, null, null);
    this.#changed();
  }

  #outlined(
    all: readonly Presented[],
    step: number,
    result: SceneResult | null,
    came: Fields | null,
  ): readonly Shown[] {
    const nothing: Fields = this.scene.parts.map(() => null);
    return all.map((p) => {
      const fields = came && p.result === result ? came : nothing;
      return { ...p, fields, range: rangeOf(p, step, fields) };
    });
  }

  /** Until the rest has come nothing can be pointed at: nobody takes what is still on its way for missing. */
  #colourEarly(all: readonly Presented[], result: SceneResult, came: Fields, step: number): void {
    this.#shown = this.#outlined(all, step, result, came);
    this.#applyColour();
    this.#changed();
  }

  #applyColour(): void {
    const colour = this.shownAs("colour");
    this.model.setColour(colour ? colourEffect(this.#store.state.doc) : null, colour?.range ?? null);
    const entry = colourEntry(this.#store.state.doc);
    const limit = colour?.limit ?? null;
    this.model.setLines({
      isolines: entry?.isolines === true,
      limit: limit ?? 0,
      limitSign: limit === null ? 0 : colour?.limitIsUpper ? 1 : -1,
      missingHatch: entry?.nanHatch !== false,
    });
    this.applyShading();
    const [fields, component] = [colour?.fields ?? null, colour?.componentIndex ?? 0];
    if (fields === this.#coloured.fields && component === this.#coloured.component) return;
    this.#coloured = { fields, component };
    this.model.setValues(fields, component);
  }

  /** Draws the deformation; `angle` swings a mode: Re cos - Im sin, at rest at 0. */
  applyFactor(angle = this.#angle): void {
    this.#angle = angle;
    const { re, im } = this.swing;
    this.model.setFactor(re, im);
    this.picker.setShape(this.#displacements, re, this.#imaginary, im);
    this.applyGhost();
  }

  /** The step whose values are drawn: the one before, until another one has come. */
  get #drawnStep(): number {
    return Number.isNaN(this.#loadedStep) ? this.#store.state.step : this.#loadedStep;
  }

  /** Whether a level of detail states how wrong it may be of what is drawn now: the result that is seen, and the shape. */
  isCovered(level: SceneLevel): boolean {
    const step = this.#drawnStep;
    const shape = this.factor === 0 ? null : this.shapeResult;
    const all = [this.shownAs("colour")?.result, shape, this.#imaginaryOf(shape, step)];
    return covers(
      level,
      all.flatMap((result) => drawnOf(result, step)),
    );
  }

  /** What may be wrong with the picture while a reduced level is drawn; empty: nothing is. */
  get levelText(): string {
    const level = this.scene.extras.levels?.[this.model.level - 1];
    if (!level) return "";
    const colour = this.shownAs("colour");
    const unit = unitText(colour?.unit ?? "");
    return levelWords(level, this.scene.extras, {
      result: colour?.result ?? null,
      step: this.#drawnStep,
      unit,
    });
  }

  /** Diagonal of the undeformed box, model units. */
  get diagonal(): number {
    return this.model.box.getSize(scratch).length();
  }

  /** Planes in force, model units minus the scene's origin. */
  get cuts(): readonly Cut[] {
    return this.#cuts;
  }

  applyCuts(): void {
    const [x, y, z] = this.scene.extras.origin ?? [0, 0, 0];
    this.#cuts = this.#store.state.cuts
      .filter((cut) => cut.on)
      .map(({ normal, offset }) => ({
        normal,
        offset: offset - normal[0] * x - normal[1] * y - normal[2] * z,
      }));
    this.model.setCuts(this.#cuts);
    this.picker.setCuts(this.#cuts);
  }

  /** What is said of the material that a cut has opened. */
  get insideText(): string {
    return this.#insideText();
  }

  /** Somebody knows more of the inside than the scene does. */
  setInsideText(text: () => string): void {
    this.#insideText = text;
  }

  applyShading(): void {
    const entry = colourEntry(this.#store.state.doc);
    const asked = typeof entry?.shadeFloor === "number" ? Math.min(Math.max(entry.shadeFloor, 0), 1) : 0.75;
    const map = colourEffect(this.#store.state.doc)?.map ?? "";
    const floor = TOLD_BY_LIGHTNESS.has(map) ? (1 + asked) / 2 : asked;
    this.model.setShadeFloor(this.#store.state.shading ? floor : 1);
  }

  get ready(): boolean {
    return !this.isPreview && this.#loadedStep === this.#store.state.step;
  }

  dispose(): void {
    this.model.dispose();
  }
}
