// SPDX-License-Identifier: Apache-2.0
// Planes that cut the model, typed, dragged or stepped. The inside they open has the values of the volume elements when
// the server has these; else it is hatched, without values.
import { Vector3 } from "three";
import { MAX_CUTS } from "../../render";
import {
  axisOf,
  type CutActions,
  type CutDirection,
  cutListTemplate,
  numberText,
  type PanelPage,
  type Section,
  unitText,
} from "../../ui";
import type { App } from "../app";
import { InsideClient } from "../inside-client";
import { type CapReport, SectionCaps } from "../section-caps";
import type { CutState } from "../store";
import type { Feature, Handle } from "./feature";

const AXES: Record<"x" | "y" | "z", CutState["normal"]> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const SECTIONS = "Sections show the values of the volume elements, from the model file.";
const corner = new Vector3();

export class Cuts implements Feature, CutActions {
  readonly id = "cuts";
  readonly #app: App;
  /** Null: the scene is all there is. */
  readonly #caps: SectionCaps | null;

  constructor(app: App) {
    this.#app = app;
    const client = app.served ? InsideClient.find(app.view.scene.extras.origin ?? [0, 0, 0]) : null;
    const caps = client && new SectionCaps(app, client);
    this.#caps = caps;
    if (caps) app.view.setInsideText(() => caps.insideText);
    app.store.subscribe((state, before) => {
      if (state.cuts !== before.cuts) app.view.applyCuts();
    });
  }

  get #cuts(): readonly CutState[] {
    return this.#app.store.state.cuts;
  }

  #set(cuts: readonly CutState[]): void {
    this.#app.store.set({ cuts });
  }

  /** Where along a direction the model begins and ends, in the solver's coordinates. */
  reach(normal: CutState["normal"]): { from: number; to: number } {
    const { view } = this.#app;
    const origin = view.scene.extras.origin ?? [0, 0, 0];
    const shift = normal[0] * origin[0] + normal[1] * origin[1] + normal[2] * origin[2];
    let from = Number.POSITIVE_INFINITY;
    let to = Number.NEGATIVE_INFINITY;
    const { min, max } = view.model.box;
    for (let i = 0; i < 8; ++i) {
      corner.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z);
      const at = normal[0] * corner.x + normal[1] * corner.y + normal[2] * corner.z + shift;
      from = Math.min(from, at);
      to = Math.max(to, at);
    }
    return { from, to };
  }

  #through(normal: CutState["normal"], share = 0.5): CutState {
    const { from, to } = this.reach(normal);
    return { normal, offset: from + share * (to - from), on: true };
  }

  add(): void {
    const free = (["x", "y", "z"] as const).find((a) => this.#cuts.every((cut) => axisOf(cut.normal) !== a));
    if (this.#cuts.length < MAX_CUTS) this.#set([...this.#cuts, this.#through(AXES[free ?? "x"])]);
  }

  remove(index: number): void {
    this.#set(this.#cuts.filter((_, i) => i !== index));
  }

  change(index: number, change: Partial<CutState>): void {
    this.#set(this.#cuts.map((cut, i) => (i === index ? { ...cut, ...change } : cut)));
  }

  point(index: number, direction: CutDirection): void {
    this.change(index, this.#through(direction === "view" ? this.#towardsEye() : AXES[direction]));
  }

  flip(index: number): void {
    const cut = this.#cuts[index];
    if (!cut) return;
    const [x, y, z] = cut.normal;
    this.change(index, { normal: [0 - x, 0 - y, 0 - z], offset: 0 - cut.offset });
  }

  /** Direction from the model to the camera, in the model's axes. */
  #towardsEye(): CutState["normal"] {
    const { stage, view } = this.#app;
    const back = new Vector3(0, 0, 1).transformDirection(stage.camera.matrixWorld);
    back.transformDirection(view.model.worldMatrix().invert());
    const round = (v: number) => Number(v.toFixed(6));
    return [round(back.x), round(back.y), round(back.z)];
  }

  toggle(): void {
    if (this.#cuts.length === 0) this.add();
    else {
      const on = !this.#cuts.some((cut) => cut.on);
      this.#set(this.#cuts.map((cut) => ({ ...cut, on })));
    }
  }

  /** Moves the first plane by so much of its way through the model. */
  step(share: number): void {
    const cut = this.#cuts[0];
    if (!cut) return;
    const { from, to } = this.reach(cut.normal);
    this.change(0, { offset: Math.min(Math.max(cut.offset + share * (to - from), from), to) });
  }

  section(): Section {
    const on = this.#cuts.filter((cut) => cut.on).length;
    const model = () => ({
      rows: this.#cuts.map((cut, i) => ({
        cut,
        ...this.reach(cut.normal),
        section: this.#sections()[i]?.text ?? "",
      })),
      most: MAX_CUTS,
      lengthUnit: this.#app.view.scene.extras.lengthUnit?.name ?? null,
      insideText: this.#caps ? SECTIONS : this.#app.view.insideText,
    });
    const summary = on === 0 ? "off" : on === 1 ? "1 plane" : `${on} planes`;
    return { id: this.id, title: "Section", summary, body: () => cutListTemplate(model(), this) };
  }

  page(): PanelPage {
    const unit = unitText(this.#app.view.scene.extras.lengthUnit?.name);
    const first = this.#cuts[0];
    const axis = first && axisOf(first.normal);
    const press = (name: "x" | "y" | "z") => () =>
      first ? this.point(0, name) : this.#set([this.#through(AXES[name])]);
    const rows = [
      {
        text: "Cut across",
        detail: first ? `at ${numberText(first.offset, 5)} ${unit}` : "no plane",
        buttons: [
          ...(["x", "y", "z"] as const).map((name) => ({
            id: name,
            text: name,
            on: axis === name,
            press: press(name),
          })),
          { id: "on", text: first?.on ? "On" : "Off", on: first?.on ?? false, press: () => this.toggle() },
        ],
      },
      {
        text: "Move",
        buttons: [-0.1, -0.01, 0.01, 0.1].map((share) => ({
          id: `by:${share}`,
          text: `${share > 0 ? "+" : "−"} ${Math.abs(100 * share)} %`,
          enabled: first !== undefined,
          press: () => this.step(share),
        })),
      },
      {
        text: "Side that goes",
        buttons: [{ id: "flip", text: "Other", enabled: first !== undefined, press: () => this.flip(0) }],
      },
      { text: this.#sections()[0]?.text || (this.#caps ? SECTIONS : this.#app.view.insideText), buttons: [] },
    ];
    return { id: this.id, title: "Section", rows };
  }

  commands() {
    return [
      { keys: ["c"], shown: "C", text: "cut the model, or not", down: () => this.toggle() },
      {
        keys: ["[", "]"],
        shown: "[ ]",
        text: "move the first plane by 1 %",
        down: (key: string) => this.step(key === "]" ? 0.01 : -0.01),
      },
    ];
  }

  /** Moves a plane, as far as the model reaches. */
  moveTo(index: number, offset: number): void {
    const cut = this.#cuts[index];
    if (!cut) return;
    const { from, to } = this.reach(cut.normal);
    this.change(index, { offset: Math.min(Math.max(offset, from), to) });
  }

  /** The first plane from here on; `offset` is counted from the scene's origin. */
  carry(normal: CutState["normal"], offset: number): void {
    const shift = new Vector3(...normal).dot(
      corner.set(...(this.#app.view.scene.extras.origin ?? [0, 0, 0])),
    );
    this.#set([{ normal, offset: offset + shift, on: true }, ...this.#cuts.slice(1)]);
  }

  /** The middle of each plane that is on, in the scene's coordinates. */
  knobs(): (Vector3 | null)[] {
    const { view } = this.#app;
    const origin = view.scene.extras.origin ?? [0, 0, 0];
    const middle = view.model.box.getCenter(new Vector3());
    return this.#cuts.map((cut) => {
      if (!cut.on) return null;
      const normal = new Vector3(...cut.normal);
      const offset = cut.offset - normal.dot(corner.set(...origin));
      return middle.clone().addScaledVector(normal, offset - normal.dot(middle));
    });
  }

  /** A knob at the middle of each plane, to drag it by. */
  handles(): Handle[] {
    const { stage, view, store } = this.#app;
    if (!store.state.open.includes(this.id)) return [];
    const matrix = view.model.worldMatrix();
    const knobs = this.knobs();
    return this.#cuts.flatMap((cut, index): Handle[] => {
      const at = knobs[index];
      if (!at) return [];
      const normal = new Vector3(...cut.normal);
      const size = 0.1 * view.diagonal;
      const here = stage.project(at.clone().applyMatrix4(matrix));
      const there = stage.project(at.clone().addScaledVector(normal, size).applyMatrix4(matrix));
      if (!here || !there) return [];
      const [dx, dy] = [there.x - here.x, there.y - here.y];
      const square = dx * dx + dy * dy;
      const start = cut.offset;
      const drag = (x: number, y: number) => {
        const moved = square > 1 ? (size * (x * dx + y * dy)) / square : 0;
        this.moveTo(index, start + moved);
      };
      return [{ id: `cut-${index}`, label: `drag plane ${index + 1}`, ...here, drag }];
    });
  }

  #sections(): CapReport[] {
    return this.#caps?.reports() ?? [];
  }

  report() {
    return { cuts: this.#cuts, sections: this.#caps ? this.#sections() : null };
  }
}
