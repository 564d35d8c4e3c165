// SPDX-License-Identifier: Apache-2.0
// When something happens under the probe: the limit is crossed, there is no value, the largest value is found.
import { normalise, type ValueRange } from "../present";

export interface SenseLimit {
  readonly value: number;
  readonly kind: "above" | "below";
}

export interface ProbeState {
  /** NaN: the probe is on the model but there is no value. */
  readonly value: number;
  readonly range: ValueRange;
  readonly limit?: SenseLimit | null;
}

export type SenseEvent = "limitUp" | "limitDown" | "noValue";

/** Of the range: how far back over the limit a value must come before the next crossing counts. */
const hysteresis = 0.01;

/** Watches one result. Entering the model beyond the limit counts as crossing it. */
export class EventWatch {
  #beyond = false;
  #missing = false;

  /** Beyond the limit now: the state cue (flutter, faster pulses, the card's frame). */
  get beyond(): boolean {
    return this.#beyond;
  }

  /** Once a frame with the probe's state, null when it is off the model. Gives the event of this frame, if any. */
  update(state: ProbeState | null): SenseEvent | null {
    if (!state) {
      this.#beyond = false;
      this.#missing = false;
      return null;
    }
    if (normalise(state.value, state.range).missing) {
      const first = !this.#missing;
      this.#missing = true;
      this.#beyond = false;
      return first ? "noValue" : null;
    }
    this.#missing = false;
    const { limit } = state;
    if (!limit) {
      this.#beyond = false;
      return null;
    }
    const excess = limit.kind === "above" ? state.value - limit.value : limit.value - state.value;
    const slack = hysteresis * Math.abs(state.range.hi - state.range.lo);
    const before = this.#beyond;
    this.#beyond = excess > 0 || (before && excess > -slack);
    if (this.#beyond === before) return null;
    return this.#beyond ? "limitUp" : "limitDown";
  }
}
