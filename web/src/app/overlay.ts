// SPDX-License-Identifier: Apache-2.0
// What stands at places of the model: extremes, hot spots, notes, the reticle; on the page and in the headset.
import { isCutAway, type Place, placePoint } from "../probe";
import type { Marker } from "../ui";
import type { VrMark } from "../xr/vr-markers";
import type { App } from "./app";
import { extremePlaces } from "./extremes";
import type { PlaceMark } from "./features/feature";
import { PIN } from "./probing";
import { inSight } from "./sight";

/** Pixels that a label of so many letters needs, at least: its letters are 12 px high. */
const labelRoom = (letters: number) => 32 + 7.5 * letters;

/** Cuts count from the scene's origin. */
const NO_ORIGIN = [0, 0, 0];

export class Overlay {
  readonly #app: App;
  #extremes: readonly PlaceMark[] = [];

  constructor(app: App) {
    this.#app = app;
  }

  /** The scene shows other values: its extremes stand elsewhere. */
  renew(): void {
    const { view, store } = this.#app;
    this.#extremes = extremePlaces(view, view.shownAs("colour"), store.state.step).map((mark) => ({
      ...mark,
      id: mark.kind,
    }));
  }

  get firstExtreme(): Place | null {
    return this.#extremes[0]?.place ?? null;
  }

  #marks(): PlaceMark[] {
    const { store, features, view } = this.#app;
    const own = store.state.extremes ? this.#extremes : [];
    const { hidden } = store.state;
    return [...own, ...features.flatMap((f) => f.marks?.() ?? [])].filter(({ place }) => {
      const part = view.scene.parts[place.part];
      if (!part || hidden.includes(part.index)) return false;
      return !isCutAway(view.cuts, ...placePoint(part, place, NO_ORIGIN));
    });
  }

  /** In the room, metres. */
  vrMarks(): VrMark[] {
    const { view } = this.#app;
    const matrix = view.model.worldMatrix();
    return this.#marks().map(({ kind, id, text, detail, place }) => ({
      kind,
      id,
      text,
      detail,
      at: view.picker.worldOf(place, matrix),
    }));
  }

  /** On the canvas; the reticle is at `at`. */
  markers(at: { x: number; y: number } | null): Marker[] {
    const { stage, view, probing } = this.#app;
    const matrix = view.model.worldMatrix();
    const markers = this.#marks().flatMap((mark): Marker[] => {
      const where = stage.project(view.picker.worldOf(mark.place, matrix));
      if (!where) return [];
      return [
        {
          kind: mark.kind,
          text: mark.text,
          detail: mark.detail,
          ...where,
          hidden: !inSight(stage, view, mark.place),
          flipped: where.x > stage.canvas.clientWidth - labelRoom(mark.text.length + mark.detail.length),
          click: () => this.#app.pin(mark.place),
        },
      ];
    });
    const kind = probing.current()?.name === PIN ? "pin" : "reticle";
    const none = { text: "", detail: "", hidden: false, flipped: false, click: null };
    return at ? [...markers, { kind, ...none, ...at }] : markers;
  }
}
