// SPDX-License-Identifier: Apache-2.0
// Vectors as arrows and principal directions as crosses of arrows, at nodes of the skin, by the values of the file.
import { principalOf, spacedVertices } from "../../probe";
import { ArrowGlyphs, type Glyph } from "../../render";
import { MISSING, type SceneResult } from "../../scene";
import {
  numberText,
  type PanelPage,
  type Section,
  unitText,
  type VectorFormActions,
  vectorTemplate,
} from "../../ui";
import type { App } from "../app";
import type { Fields } from "../ranges";
import type { Feature } from "./feature";

const VECTOR = "x y z";
const TENSOR = "xx yy zz xy yz zx";
/** Of the diagonal: the side of the cubes that bear one node's arrows each. */
const SPACING = { few: 0.1, some: 0.06, many: 0.035 };
type Density = keyof typeof SPACING;
/** Pull and push, told apart by their heads too. */
const COLOURS = { outward: "#d4380d", inward: "#1d5fd1" };
const SLIM = 0.05;

interface Arrow {
  readonly part: number;
  readonly vertex: number;
  readonly node: number;
  readonly value: number;
  readonly axis: readonly [number, number, number];
}

/** Only what is in the axes of the model, and no amplitudes or phases: they have no direction. */
function canBeDrawn(result: SceneResult): boolean {
  const parts = result.components.join(" ");
  const isComplex = result.complex === "amplitude" || result.complex === "phase";
  return (parts === VECTOR || parts === TENSOR) && !result.system && !isComplex;
}

export class Vectors implements Feature, VectorFormActions {
  readonly id = "vectors";
  readonly #app: App;
  readonly #glyphs: ArrowGlyphs;
  #chosen = "";
  #length = 8;
  #density: Density = "some";
  #read = "";
  #borne = "";
  #laid = "";
  #arrows: readonly Arrow[] = [];
  #fields: Fields | null = null;
  #longest: Arrow | null = null;
  /** All but the largest three in a hundred are smaller: it has the length that is set, so that one peak does not shrink all others. */
  #typical = 0;
  #text = "";

  constructor(app: App) {
    this.#app = app;
    this.#glyphs = new ArrowGlyphs(app.view.model.group);
    app.atEnd(app.stage.onFrame(() => this.#check()));
    app.atEnd(() => this.#glyphs.dispose());
  }

  get #results(): readonly SceneResult[] {
    return this.#app.view.scene.extras.results.filter(canBeDrawn);
  }

  choose(id: string): void {
    this.#chosen = id;
    this.#app.refreshPage();
  }

  setLength(percent: number): void {
    this.#length = percent;
    this.#app.refreshPage();
  }

  setDensity(density: string): void {
    if (density in SPACING) this.#density = density as Density;
    this.#app.refreshPage();
  }

  next(): void {
    const ids = ["", ...this.#results.map((r) => r.id)];
    this.choose(ids[(ids.indexOf(this.#chosen) + 1) % ids.length] ?? "");
    this.#app.say(this.#chosen ? `Arrows: ${this.#name(this.#chosen)}` : "No arrows.");
  }

  #name(id: string): string {
    const result = this.#results.find((r) => r.id === id);
    if (!result) return "off";
    const name = id.replaceAll("_", " ");
    return result.components.length === 6 ? `${name}: principal directions` : name;
  }

  /** Reads and lays out anew when something that they show has changed. */
  #check(): void {
    const { store, view } = this.#app;
    const { step, hidden, cuts, theme } = store.state;
    const result = this.#results.find((r) => r.id === this.#chosen) ?? null;
    const read = result ? `${result.id} ${step}` : "";
    if (read !== this.#read) {
      this.#read = read;
      this.#fields = null;
      if (result) void this.#load(result, step, read);
    }
    const dark = theme === "dark" || this.#app.stage.renderer.xr.isPresenting;
    const borne = JSON.stringify([read, this.#fields !== null, hidden, cuts, this.#density]);
    const laid = JSON.stringify([borne, view.swing, this.#length, dark]);
    if (laid === this.#laid) return;
    this.#laid = laid;
    const isNew = borne !== this.#borne;
    if (isNew) {
      this.#borne = borne;
      this.#bear(result);
    }
    this.#lay(result, dark);
    if (isNew) this.#app.refreshPage();
    else this.#app.stage.invalidate();
  }

  async #load(result: SceneResult, step: number, read: string): Promise<void> {
    try {
      const fields = await this.#app.view.scene.loadField(result, step);
      if (read === this.#read) this.#fields = fields;
      this.#app.stage.invalidate();
    } catch (error) {
      if (read !== this.#read) return;
      this.#text = error instanceof Error ? error.message : String(error);
      this.#app.refreshPage();
    }
  }

  #bear(result: SceneResult | null): void {
    this.#arrows = result && this.#fields ? this.#found(result, this.#fields) : [];
    this.#longest = null;
    for (const arrow of this.#arrows)
      if (!this.#longest || Math.abs(arrow.value) > Math.abs(this.#longest.value)) this.#longest = arrow;
    const sizes = this.#arrows.map((arrow) => Math.abs(arrow.value)).sort((one, other) => one - other);
    this.#typical = sizes[Math.floor(0.97 * (sizes.length - 1))] ?? 0;
    this.#text = this.#said(result);
  }

  #lay(result: SceneResult | null, dark: boolean): void {
    const { view } = this.#app;
    const scale = this.#typical > 0 ? ((this.#length / 100) * view.diagonal) / this.#typical : 0;
    const at = new Float64Array(3);
    const glyphs = this.#arrows.map(({ part, vertex, value, axis }): Glyph => {
      view.picker.drawn(part, vertex, at);
      const long = Math.abs(value) * scale;
      const kind = result?.components.length === 3 ? "arrow" : value > 0 ? "outward" : "inward";
      return {
        kind,
        at: [at[0] ?? 0, at[1] ?? 0, at[2] ?? 0],
        along: [axis[0] * long, axis[1] * long, axis[2] * long],
      };
    });
    const thickness = (SLIM * this.#length * view.diagonal) / 100;
    this.#glyphs.set(glyphs, thickness, { arrow: dark ? "#f4f6f7" : "#14191c", ...COLOURS });
  }

  #found(result: SceneResult, fields: Fields): Arrow[] {
    const { view } = this.#app;
    const { parts } = view.scene;
    const at = new Float64Array(3);
    const bears = (part: number, vertex: number) => {
      const field = fields[part];
      if (!field || field.state[vertex] === MISSING) return false;
      view.picker.drawn(part, vertex, at);
      return view.picker.isThere(part, at[0] ?? 0, at[1] ?? 0, at[2] ?? 0);
    };
    const spacing = Math.max(SPACING[this.#density] * view.diagonal, 1e-30);
    return spacedVertices(parts, spacing, bears).flatMap((place) => {
      const field = fields[place.part];
      if (!field) return [];
      const from = place.vertex * field.components;
      const values = field.values.subarray(from, from + field.components);
      if (result.components.length === 6)
        return (principalOf(values) ?? []).filter((p) => p.value !== 0).map((p) => ({ ...place, ...p }));
      const value = Math.hypot(...values);
      if (!(value > 0)) return [];
      return [
        { ...place, value, axis: [0, 1, 2].map((k) => (values[k] ?? 0) / value) as [number, number, number] },
      ];
    });
  }

  #said(result: SceneResult | null): string {
    if (!result) return "Arrows stand at nodes of the skin and have the values of the file.";
    if (!this.#fields) return "Reading …";
    if (!this.#longest) return "There is no value to be drawn at this step.";
    const said = (value: number) => `${numberText(value, 4)} ${unitText(result.unit)}`.trim();
    const nodes = new Set(this.#arrows.map((a) => a.node)).size;
    const heads =
      result.components.length === 6 ? " Heads outward (red): tension; inward (blue): compression." : "";
    return `At ${nodes} nodes; the longest ${said(this.#longest.value)}, node ${this.#longest.node}. The length set stands for ${said(this.#typical)}.${heads}`;
  }

  section(): Section | null {
    if (this.#results.length === 0) return null;
    const body = () =>
      vectorTemplate(
        {
          results: this.#results.map(({ id }) => ({ id, name: this.#name(id) })),
          chosen: this.#chosen,
          length: this.#length,
          density: this.#density,
          text: this.#text,
        },
        this,
      );
    return { id: this.id, title: "Vectors, principal directions", summary: this.#name(this.#chosen), body };
  }

  page(): PanelPage | null {
    if (this.#results.length === 0) return null;
    const rows = this.#results.slice(0, 6).map(({ id }) => ({
      text: this.#name(id),
      detail: id === this.#chosen ? this.#text : "",
      buttons: [
        {
          id,
          text: id === this.#chosen ? "On" : "Off",
          on: id === this.#chosen,
          press: () => this.choose(id === this.#chosen ? "" : id),
        },
      ],
    }));
    return { id: this.id, title: "Vectors", rows };
  }

  commands() {
    const down = () => this.next();
    return this.#results.length === 0
      ? []
      : [{ keys: ["9"], shown: "9", text: "next vector or principal directions as arrows", down }];
  }

  report() {
    const shown = this.#arrows.slice(0, 2000).map(({ node, value, axis }) => ({ node, value, axis }));
    const ready = this.#chosen === "" || this.#fields !== null;
    return { arrows: this.#chosen ? { result: this.#chosen, ready, shown } : null };
  }
}
