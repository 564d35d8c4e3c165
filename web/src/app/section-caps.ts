// SPDX-License-Identifier: Apache-2.0
// The section that each plane opens: asked for when the plane rests, drawn while it is that of the plane, the step, the
// result and the shape that are shown; in between it is said that it is not yet computed.
import type { DrawnSection } from "../probe";
import type { InsideMesh } from "../render";
import type { SceneResult, SectionData } from "../scene";
import { numberText, unitText } from "../ui";
import type { App } from "./app";
import { type InsideClient, isGivenUp } from "./inside-client";
import { askedFields, fieldOf, ownersOf, partOfTriangle, shapeOf, subjectOf } from "./inside-subject";
import type { Shown } from "./model-view";
import type { CutState } from "./store";

/** A plane that has not moved for so long rests. */
const REST = 120;
/** A place that has not changed for so long is asked for. */
const PLACE_REST = 60;

interface Cap {
  /** Of what it was made; another one: it is no longer true. */
  key: string;
  /** Null: it is asked for, or will be. */
  drawn: (DrawnSection & { readonly values: Map<string, Float32Array>; readonly mesh: InsideMesh }) | null;
  /** Why there is none. */
  reason: string | null;
  timer: number;
}

export interface CapReport {
  readonly state: "off" | "waiting" | "shown" | "none";
  readonly area: number | null;
  readonly triangles: number | null;
  readonly text: string;
}

export class SectionCaps {
  readonly #app: App;
  readonly #client: InsideClient;
  readonly #caps: (Cap | null)[] = [];
  readonly #pending = new Set<string>();
  #placeTimer = 0;
  #asked: object | null = null;

  constructor(app: App, client: InsideClient) {
    this.#app = app;
    this.#client = client;
    app.atEnd(app.stage.onFrame(() => this.#check()));
    app.atEnd(() => {
      for (const i of this.#caps.keys()) this.#drop(i);
      clearTimeout(this.#placeTimer);
    });
  }

  #keyOf(cut: CutState): { key: string; reason: string | null } {
    const subject = subjectOf(this.#app, "Section");
    if ("reason" in subject) return { key: `none ${subject.reason}`, reason: subject.reason };
    const { field, shape, step } = subject;
    return { key: JSON.stringify([cut.normal, cut.offset, field, step, shape]), reason: null };
  }

  /** Every picture: what has changed is no longer drawn, and asked for anew once it rests. */
  #check(): void {
    const { cuts } = this.#app.store.state;
    let changed = false;
    let on = -1;
    for (let i = 0; i < Math.max(cuts.length, this.#caps.length); ++i) {
      const cut = cuts[i];
      if (cut?.on) on += 1;
      changed = this.#checkOne(i, cut) || changed;
      this.#caps[i]?.drawn?.mesh.lieIn(on);
    }
    if (changed) this.#tell();
    this.#askPlace();
    this.#fillValues();
  }

  #checkOne(index: number, cut: CutState | undefined): boolean {
    const cap = this.#caps[index] ?? null;
    if (!cut?.on) {
      this.#drop(index);
      return cap !== null;
    }
    const { key, reason } = this.#keyOf(cut);
    if (cap?.key === key) return false;
    this.#drop(index);
    const made: Cap = { key, drawn: null, reason, timer: 0 };
    if (reason === null) made.timer = window.setTimeout(() => void this.#ask(index, made, cut), REST);
    this.#caps[index] = made;
    return true;
  }

  #drop(index: number): void {
    const cap = this.#caps[index];
    if (!cap) return;
    clearTimeout(cap.timer);
    cap.drawn?.mesh.remove();
    this.#client.giveUp(`cut${index}`);
    this.#caps[index] = null;
  }

  async #ask(index: number, cap: Cap, cut: CutState): Promise<void> {
    const subject = subjectOf(this.#app, "Section");
    if ("reason" in subject) return;
    const { field, shape, step } = subject;
    try {
      const data = await this.#client.section(`cut${index}`, cut, field, step, shape);
      if (this.#caps[index] !== cap) return;
      cap.drawn = this.#draw(data, cut, subject.shown.key);
    } catch (error) {
      if (isGivenUp(error) || this.#caps[index] !== cap) return;
      cap.reason = `No section: ${error instanceof Error ? error.message : String(error)}`;
    }
    this.#tell();
  }

  #draw(data: SectionData, cut: CutState, key: string): NonNullable<Cap["drawn"]> {
    const { view } = this.#app;
    const [x, y, z] = view.scene.extras.origin ?? [0, 0, 0];
    const offset = cut.offset - cut.normal[0] * x - cut.normal[1] * y - cut.normal[2] * z;
    const part = partOfTriangle(this.#app, data);
    const owners = ownersOf(this.#app, data);
    const mesh = view.model.addInside({ ...data, owners, normal: cut.normal });
    return {
      plane: { normal: cut.normal, offset },
      data,
      values: new Map([[key, data.values]]),
      isDrawn: (triangle) => {
        const index = view.scene.parts[part(triangle)]?.index ?? -1;
        const { hidden, clear } = this.#app.store.state;
        return !hidden.includes(index) && !clear.includes(index);
      },
      mesh,
    };
  }

  #tell(): void {
    this.#app.view.picker.setSections(this.#caps.flatMap((cap) => cap?.drawn ?? []));
    this.#app.refreshPage();
  }

  /** Values of what else is heard, felt and listed, one after the other. */
  #fillValues(): void {
    const { view, store } = this.#app;
    for (const [index, cap] of this.#caps.entries()) {
      const cut = store.state.cuts[index];
      if (!cap?.drawn || !cut) continue;
      for (const shown of view.shown) {
        const slot = `cut${index}_values`;
        if (!shown.result || shown.result.minus || cap.drawn.values.has(shown.key)) continue;
        if (this.#pending.has(slot)) break;
        if (!shown.result.values.some((v) => v.step === store.state.step)) continue;
        this.#pending.add(slot);
        void this.#fill(slot, cap, cut, shown, shown.result).finally(() => {
          this.#pending.delete(slot);
          this.#app.invalidate();
        });
        break;
      }
    }
  }

  async #fill(slot: string, cap: Cap, cut: CutState, shown: Shown, result: SceneResult): Promise<void> {
    const { store } = this.#app;
    const drawn = cap.drawn;
    if (!drawn) return;
    try {
      const asked = [fieldOf(result, shown), store.state.step, shapeOf(this.#app)] as const;
      const data = await this.#client.section(slot, cut, ...asked);
      // The same plane through the same elements has the same vertices; what moved meanwhile has not.
      const same = data.values.length === drawn.data.values.length;
      if (same && this.#caps.includes(cap)) drawn.values.set(shown.key, data.values);
    } catch (error) {
      if (!isGivenUp(error))
        drawn.values.set(shown.key, new Float32Array(drawn.data.values.length).fill(Number.NaN));
    }
  }

  /** The place that counts, once it rests on a section, is asked for: the element's own functions say more than the drawing. */
  #askPlace(): void {
    const { probing, view, store } = this.#app;
    const place = probing.current()?.place?.section ?? null;
    if (place === this.#asked) return;
    this.#asked = place;
    clearTimeout(this.#placeTimer);
    if (!place) return;
    this.#placeTimer = window.setTimeout(async () => {
      const fields = askedFields(this.#app);
      const origin = view.scene.extras.origin ?? [0, 0, 0];
      const at = place.point.map((v, axis) => v + (origin[axis] ?? 0));
      try {
        const shape = shapeOf(this.#app);
        place.exact = await this.#client.point("place", at, fields, store.state.step, shape);
        this.#app.invalidate();
      } catch (error) {
        if (!isGivenUp(error)) this.#app.store.set({ problem: `No value inside: ${String(error)}` });
      }
    }, PLACE_REST);
  }

  #textOf(index: number): CapReport {
    const cap = this.#caps[index] ?? null;
    const none = { area: null, triangles: null };
    if (!cap) return { state: "off", ...none, text: "" };
    if (cap.reason !== null) return { state: "none", ...none, text: cap.reason };
    if (!cap.drawn) return { state: "waiting", ...none, text: "Section not yet computed." };
    const { data } = cap.drawn;
    const unit = unitText(this.#app.view.scene.extras.lengthUnit?.name);
    const size = `${numberText(data.area, 5)}${unit ? ` ${unit}²` : ""}`;
    const lost =
      data.elementsWithoutPlace > 0
        ? `; ${data.elementsWithoutPlace} elements have corners without a place`
        : "";
    const text =
      data.elements === 0 ? "Cuts no volume elements." : `Cuts ${data.elements} elements, ${size}${lost}.`;
    return { state: "shown", area: data.area, triangles: data.indices.length / 3, text };
  }

  reports(): CapReport[] {
    return this.#app.store.state.cuts.map((_, i) => this.#textOf(i));
  }

  /** Said where the pointer is inside and nothing is drawn. */
  get insideText(): string {
    const open = this.reports().find((report) => report.state === "waiting" || report.state === "none");
    return open ? `Inside the material. ${open.text}` : "Inside the material: no value here.";
  }
}
