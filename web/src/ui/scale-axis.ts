// SPDX-License-Identifier: Apache-2.0
// Positions on a legend and the values they stand for. No DOM.
import { normalise, type ValueRange } from "../present";

/** The value at position t (0..1) of a range: the inverse of `normalise`. */
export function valueAtPosition(t: number, range: ValueRange): number {
  const { lo, hi, scale } = range;
  const magnitude = Math.max(Math.abs(lo), Math.abs(hi));
  if (scale === "signed") return -magnitude + 2 * magnitude * t;
  if (scale === "linear" || magnitude === 0) return lo + (hi - lo) * t;
  if (scale === "log" && lo > 0) return 10 ** (Math.log10(lo) + (Math.log10(hi) - Math.log10(lo)) * t);
  const c = 1e-3 * magnitude;
  const forward = (v: number) => Math.sign(v) * Math.log10(1 + Math.abs(v) / c);
  const p = forward(lo) + (forward(hi) - forward(lo)) * t;
  return Math.sign(p) * c * (10 ** Math.abs(p) - 1);
}

/** Where a value stands on the legend; null when it has none. */
export function positionOf(value: number | null, range: ValueRange): number | null {
  if (value === null) return null;
  const place = normalise(value, range);
  return place.missing ? null : place.position;
}

/** Positions of labels: every band edge while there is room, else evenly spread. */
export function labelPositions(bands: number): number[] {
  let count = bands > 0 ? bands : 8;
  while (count > 14) {
    if (count % 2 !== 0) {
      count = 8;
      break;
    }
    count /= 2;
  }
  return Array.from({ length: count + 1 }, (_, i) => i / count);
}
