// SPDX-License-Identifier: Apache-2.0
// Where each pointer is on the model, which of them are held, and the report of the one that counts.
import type { PointerKind } from "../input/pointer";
import type { Place } from "../probe";
import type { Actuator } from "../sense";
import type { ModelView } from "./model-view";
import { type ProbeReport, reportAt } from "./probe-report";
import type { Store } from "./store";

export interface PointerState {
  readonly name: string;
  readonly kind: PointerKind;
  place: Place | null;
  /** Hear and feel is asked for. */
  held: boolean;
  /** What shakes in the hand that points; null: nothing does. */
  actuator: Actuator | null;
  /** What shows pulses to the eye where nothing shakes; null: nothing does. */
  shows: Actuator | null;
  /** Counts up with each change of place; the latest pointer is the one that counts. */
  moved: number;
}

/** A place that stays marked: what was gone to. */
export const PIN = "pin";

export class Probing {
  readonly #view: ModelView;
  readonly #store: Store;
  readonly #pointers = new Map<string, PointerState>();
  #clock = 0;
  #chosen: Place | null = null;

  constructor(view: ModelView, store: Store) {
    this.#view = view;
    this.#store = store;
  }

  get pointers(): IterableIterator<PointerState> {
    return this.#pointers.values();
  }

  pointer(name: string, kind: PointerKind): PointerState {
    let pointer = this.#pointers.get(name);
    if (!pointer) {
      pointer = { name, kind, place: null, held: false, actuator: null, shows: null, moved: 0 };
      this.#pointers.set(name, pointer);
    }
    return pointer;
  }

  move(name: string, kind: PointerKind, place: Place | null): void {
    const pointer = this.pointer(name, kind);
    pointer.place = place;
    if (place) {
      this.#clock += 1;
      pointer.moved = this.#clock;
      if (name === PIN || pointer.held) this.#chosen = place;
    }
  }

  hold(name: string, kind: PointerKind, on: boolean): void {
    const pointer = this.pointer(name, kind);
    pointer.held = on;
    if (on && pointer.place) this.#chosen = pointer.place;
  }

  remove(name: string): void {
    this.#pointers.delete(name);
  }

  /** The place that was pressed or gone to last. */
  get chosen(): Place | null {
    return this.#chosen;
  }

  /** Nothing is held any more: blur, end of a session. */
  releaseAll(): void {
    for (const pointer of this.#pointers.values()) pointer.held = false;
  }

  get pinned(): PointerState | null {
    const pin = this.#pointers.get(PIN);
    return pin?.place ? pin : null;
  }

  /** The pointer that is on the model: a held one first, then the one that moved last, then the pin. */
  current(): PointerState | null {
    let best: PointerState | null = null;
    const rank = (p: PointerState) => (p.held ? 2 : p.name === PIN ? 0 : 1);
    for (const pointer of this.#pointers.values()) {
      if (!pointer.place) continue;
      if (!best || rank(pointer) > rank(best) || (rank(pointer) === rank(best) && pointer.moved > best.moved))
        best = pointer;
    }
    return best;
  }

  reportOf(pointer: PointerState): ProbeReport | null {
    if (!pointer.place) return null;
    return reportAt(this.#view, this.#store.state.doc, this.#store.state.person, pointer.place, {
      name: pointer.name,
      vibrates: pointer.actuator !== null,
    });
  }

  report(): ProbeReport | null {
    const pointer = this.current();
    return pointer && this.reportOf(pointer);
  }
}
