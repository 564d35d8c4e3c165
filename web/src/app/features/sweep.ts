// SPDX-License-Identifier: Apache-2.0
// Sweep listening: a plane goes through the model; the tone is the largest value of the slab it is in, a quieter sine
// the mean over its area.
import { Vector3 } from "three";
import { defaultPitch, normalise, toneOf } from "../../present";
import { placeOfVertex, type Slab, slabsOf } from "../../probe";
import { SweepPlane } from "../../render";
import { numberText, type PanelPage, type Section, sweepTemplate, unitText } from "../../ui";
import type { App } from "../app";
import type { Shown } from "../model-view";
import { personalPitch } from "../personal";
import { pitchEffect } from "../presentation-doc";
import type { Feature } from "./feature";

/** The finest in which each slab has a node; where none has, the coarsest. */
const COUNTS = [64, 48, 32, 24, 16, 12, 8] as const;
const SECONDS = 4;
export const SWEEP_AXES = ["longest", "x", "y", "z"] as const;
export type SweepAxis = (typeof SWEEP_AXES)[number];

export class Sweep implements Feature {
  readonly id = "sweep";
  readonly #app: App;
  readonly #plane: SweepPlane;
  #axis: SweepAxis = "longest";
  #backwards = false;
  #slab: Slab | null = null;
  #index: number | null = null;
  #running = false;
  #count = 0;

  constructor(app: App) {
    this.#app = app;
    this.#plane = new SweepPlane(app.view.model.group);
    app.atEnd(app.stage.onFrame(() => this.#frame()));
    app.atEnd(() => this.#plane.dispose());
  }

  setAxis(axis: SweepAxis): void {
    this.#axis = axis;
    this.#app.refreshPage();
  }

  toggleBackwards(): void {
    this.#backwards = !this.#backwards;
    this.#app.refreshPage();
  }

  #axisNumber(): 0 | 1 | 2 {
    if (this.#axis !== "longest") return ({ x: 0, y: 1, z: 2 } as const)[this.#axis];
    const size = this.#app.view.model.box.getSize(new Vector3()).toArray();
    return size.indexOf(Math.max(...size)) as 0 | 1 | 2;
  }

  /** What has a tone, else what is seen. */
  #heard(): Shown | null {
    return this.#app.view.shownAs("pitch") ?? this.#app.view.shownAs("colour");
  }

  #slabs(heard: Shown): Slab[] {
    const { view, store } = this.#app;
    const { parts } = view.scene;
    const query = {
      parts,
      fields: heard.fields,
      component: heard.componentIndex,
      hidden: (part: number) => store.state.hidden.includes(parts[part]?.index ?? -1),
      axis: this.#axisNumber(),
    };
    let slabs: Slab[] = [];
    for (const count of COUNTS) {
      slabs = slabsOf({ ...query, count });
      if (slabs.every((slab) => !Number.isNaN(slab.max))) break;
    }
    return slabs;
  }

  play(): void {
    const { store, senses } = this.#app;
    const heard = this.#heard();
    if (!heard) {
      this.#app.sayNone("There is no result to hear.");
      return;
    }
    const found = this.#slabs(heard);
    if (found.length === 0) {
      this.#app.say("Nothing that can be seen has a value.");
      return;
    }
    const slabs = this.#backwards ? found.reverse() : found;
    const effect = personalPitch(pitchEffect(store.state.doc) ?? defaultPitch, store.state.person);
    const at = (time: number) => {
      const index = Math.min(Math.floor((time / SECONDS) * slabs.length), slabs.length - 1);
      const slab = slabs[index];
      if (!slab) return null;
      this.#slab = slab;
      this.#count = slabs.length;
      this.#index = index;
      if (Number.isNaN(slab.max)) return null;
      const sound = toneOf(slab.max, heard.range, effect);
      const mean = toneOf(slab.mean, heard.range, effect);
      return {
        u: normalise(slab.max, heard.range).u,
        sound: { ...sound, second: mean.gain > 0 ? { hz: mean.hz, gain: mean.gain } : null },
        haptic: null,
      };
    };
    this.#running = true;
    senses.playLegend({ seconds: SECONDS, at });
    this.#app.refreshPage();
  }

  #frame(): void {
    if (!this.#running) return;
    const { senses, view } = this.#app;
    if (!senses.legendPlays) {
      this.#running = false;
      this.#plane.hide();
      this.#slab = null;
      this.#index = null;
      this.#app.refreshPage();
      return;
    }
    const slab = this.#slab;
    if (!slab) return;
    this.#plane.show(view.model.box, this.#axisNumber(), slab.at);
    const place = slab.part < 0 ? null : placeOfVertex(view.scene.parts, slab.part, slab.vertex);
    if (place) this.#app.mark(place);
    this.#app.invalidate();
  }

  section(): Section {
    const heard = this.#heard();
    const model = {
      axis: this.#axis,
      axes: SWEEP_AXES,
      backwards: this.#backwards,
      playing: this.#running,
      what: heard?.label ?? "",
    };
    return {
      id: this.id,
      title: "Listen through the model",
      summary: "",
      body: () => sweepTemplate(model, this),
    };
  }

  page(): PanelPage {
    const slab = this.#slab;
    const unit = unitText(this.#heard()?.unit);
    return {
      id: this.id,
      title: "Sweep",
      rows: [
        {
          text: this.#heard()?.label ?? "nothing to hear",
          detail: slab ? `largest ${numberText(slab.max, 4)} ${unit}` : "largest as tone, mean as quiet sine",
          buttons: [
            { id: "play", text: "Listen", on: this.#running, press: () => this.play() },
            { id: "back", text: "Back", on: this.#backwards, press: () => this.toggleBackwards() },
          ],
        },
        {
          text: "Along",
          buttons: SWEEP_AXES.map((axis) => ({
            id: `axis:${axis}`,
            text: axis,
            on: axis === this.#axis,
            press: () => this.setAxis(axis),
          })),
        },
      ],
    };
  }

  commands() {
    return [
      { keys: ["4"], shown: "4", text: "listen through the model, slab by slab", down: () => this.play() },
    ];
  }

  report() {
    const slab = this.#slab;
    return {
      sweep: {
        axis: this.#axis,
        slab: this.#index,
        slabs: this.#count,
        at: slab?.at ?? null,
        max: slab && !Number.isNaN(slab.max) ? slab.max : null,
        mean: slab && !Number.isNaN(slab.mean) ? slab.mean : null,
      },
    };
  }
}
