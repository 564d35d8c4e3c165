// SPDX-License-Identifier: Apache-2.0
// What legend, card, table and panel show, gathered once for the page and the headset alike.
import { type CardModel, type LegendModel, numberText, stepText, type TableModel } from "../ui";
import { cardModel } from "./card-model";
import type { ModelView, Shown } from "./model-view";
import type { Player } from "./player";
import { colourEffect, colourEntry, otherResults, pulseFallback } from "./presentation-doc";
import { PIN, type Probing } from "./probing";
import type { Store } from "./store";

export class ViewModels {
  readonly #view: ModelView;
  readonly #store: Store;
  readonly #probing: Probing;
  readonly #player: Player;

  constructor(view: ModelView, store: Store, probing: Probing, player: Player) {
    this.#view = view;
    this.#store = store;
    this.#probing = probing;
    this.#player = player;
  }

  /** Only displacements are lengths that a shape can be moved by. */
  canShape(shown: Shown): boolean {
    if (shown.name !== "displacement") return false;
    return this.#view.scene.extras.results.some(
      (r) => r.quantity === shown.name && r.components.length === 3,
    );
  }

  table(): TableModel {
    const { doc } = this.#store.state;
    const others = otherResults(doc, this.#view.scene.extras);
    const { touchNote } = this;
    const { reading } = this.#store.state;
    const canShape = (shown: Shown) => this.canShape(shown);
    return { doc, shown: this.#view.shown, others, reading, canShape, touchNote };
  }

  /** Where nothing can shake, the page says what stands in for the pulses. */
  get touchNote(): string {
    const felt = this.#view.shownAs("pulses");
    if (!felt || [...this.#probing.pointers].some((p) => p.actuator !== null)) return "";
    const { doc } = this.#store.state;
    const ticks = pulseFallback(doc) !== null && this.#view.shownAs("ticks") === null;
    return ticks
      ? `Nothing here vibrates: ${felt.label} ticks instead.`
      : `Nothing here vibrates: ${felt.label} is on the card alone.`;
  }

  panel(hover: string | null) {
    return {
      state: this.#store.state,
      shown: this.#view.shown,
      step: this.#view.step,
      steps: this.#view.scene.extras.steps,
      factor: this.#view.factor,
      canShape: (shown: Shown) => this.canShape(shown),
      canPlay: this.#player.canPlay,
      hover,
    };
  }

  card(): CardModel | null {
    const current = this.#probing.current();
    const report = this.#probing.report();
    if (!current || !report) return null;
    const vibrates = current.actuator !== null;
    const { doc, reading } = this.#store.state;
    const options = { pinned: current.name === PIN, sounding: current.held, vibrates, reading };
    return cardModel(this.#view, doc, report, options);
  }

  legend(): LegendModel | null {
    const { state } = this.#store;
    const shown = this.#view.shownAs("colour");
    const effect = colourEffect(state.doc);
    const { palette } = this.#view.model;
    if (!shown || !effect || !palette) return null;
    const { step, factor } = this.#view;
    return {
      shown,
      effect,
      palette,
      probed: this.#probing.report()?.results.find((r) => r.key === shown.key)?.value ?? null,
      stepText: step ? stepText(step) : "",
      deformText: factor === 0 ? "undeformed" : `deformation × ${numberText(factor, 4)}`,
      levelText: this.#view.scene.extras.levels ? this.#view.levelText : null,
      shading: state.shading,
      isolines: colourEntry(state.doc)?.isolines === true,
      hatch: colourEntry(state.doc)?.nanHatch !== false,
    };
  }
}
