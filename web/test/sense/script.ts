// SPDX-License-Identifier: Apache-2.0
// What tests of sound and touch share: calls once a frame, and random numbers that are always the same.
import type { SoundFrame } from "../../src/sense";
import type { Step } from "./sound-page";

/** A call of update at 72 Hz from one time to another. */
export function frames(
  from: number,
  to: number,
  frame: (time: number, index: number) => SoundFrame | null,
): Step[] {
  const count = Math.floor((to - from) * 72);
  return Array.from({ length: count }, (_, i) => ({ at: from + i / 72, update: frame(from + i / 72, i) }));
}

/** A repeatable row of numbers in 0..1. */
export function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
