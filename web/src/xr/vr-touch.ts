// SPDX-License-Identifier: Apache-2.0
// The touch probe: the tip of a controller or of an index finger near the skin reads it without a ray.
import type { Matrix4 } from "three";
import type { Hit, Picker } from "../probe";
import type { VrPointer } from "./vr-pointers";

/** Metres from the skin within which a tip touches it. */
export const TOUCH_REACH = 0.03;

export class VrTouch {
  readonly #touching = new Map<string, Hit>();

  /** Once a frame and pointer: the place that its tip touches. */
  update(pointer: VrPointer, picker: Picker, world: Matrix4): Hit | null {
    const hit = pointer.tip && picker.near(pointer.tip, TOUCH_REACH, world);
    if (hit) this.#touching.set(pointer.name, hit);
    else this.#touching.delete(pointer.name);
    return hit;
  }

  of(name: string): Hit | null {
    return this.#touching.get(name) ?? null;
  }

  forget(name: string): void {
    this.#touching.delete(name);
  }

  get names(): readonly string[] {
    return [...this.#touching.keys()];
  }
}
