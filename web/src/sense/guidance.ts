// SPDX-License-Identifier: Apache-2.0
// Finding the largest value by ear: the higher a value ranks among those that can be seen, the faster it ticks.

const slowest = 1.5;
const span = 8;

/** Share of the sorted values that are smaller, 0..1; values that are equal count half. */
export function rankOf(sorted: Float32Array, value: number): number {
  if (sorted.length === 0 || Number.isNaN(value)) return 0;
  const firstNot = (isBefore: (v: number) => boolean) => {
    let low = 0;
    let high = sorted.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (isBefore(sorted[middle] ?? 0)) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  const below = firstNot((v) => v < value);
  const upTo = firstNot((v) => v <= value);
  return upTo === sorted.length && below < upTo ? 1 : (below + upTo) / 2 / sorted.length;
}

/** Ticks a second, 1.5 to 12: most of the way from slow to fast lies in the last tenth. */
export function guideRate(rank: number): number {
  return slowest * span ** (Math.min(Math.max(rank, 0), 1) ** 3);
}
