// SPDX-License-Identifier: Apache-2.0
// A pinch that rests on one place: after 0.6 s a ring offers a note, and letting go while it is there leaves one. Who
// holds on only to hear and feel sees the ring go again. Times are handed in; no clock here.
import type { Vector3 } from "three";

export const REST_SECONDS = 0.6;
/** How long the ring stays. */
export const OFFER_SECONDS = 1.2;
/** Metres that count as the same place. */
const SAME_PLACE = 0.02;

export class PinchRest {
  #at: Vector3 | null = null;
  #since = 0;

  /** Once a frame while it is held: how far the ring has opened, 0..1; 0: none. */
  update(at: Vector3 | null, seconds: number): number {
    if (!at) this.#at = null;
    else if (!this.#at || this.#at.distanceTo(at) > SAME_PLACE) {
      this.#at = at.clone();
      this.#since = seconds;
    }
    return this.share(seconds);
  }

  /** Whether a note is offered now. */
  share(seconds: number): number {
    const rested = seconds - this.#since - REST_SECONDS;
    if (!this.#at || rested < 0 || rested > OFFER_SECONDS) return 0;
    return Math.min(0.35 + rested / 0.3, 1);
  }

  end(): void {
    this.#at = null;
  }
}
