// SPDX-License-Identifier: Apache-2.0
// Where a value lies in its range: the one number that all senses share. Twin of src/present/normalise.cpp.
import type { Normalised, ValueRange } from "./types";

const nothing: Normalised = Object.freeze({
  u: 0,
  position: 0,
  sign: 1,
  below: false,
  above: false,
  missing: true,
});

/** Linear within a thousandth of the largest magnitude, logarithmic beyond. */
function symmetricLog(value: number, halfWidth: number): number {
  const log = Math.log10(1 + Math.abs(value) / halfWidth);
  return value < 0 ? -log : log;
}

/** (value - lo) / (hi - lo), and the middle of a range without width. */
function fraction(value: number, lo: number, hi: number): number {
  return hi > lo ? Math.min(Math.max((value - lo) / (hi - lo), 0), 1) : 0.5;
}

function place(
  inside: number,
  lo: number,
  hi: number,
  magnitude: number,
  scale: ValueRange["scale"],
): number {
  if (scale === "log" && lo > 0) return fraction(Math.log10(inside), Math.log10(lo), Math.log10(hi));
  if (scale === "linear" || magnitude === 0) return fraction(inside, lo, hi);
  // Symmetric logarithm, and a logarithm over a range that reaches zero.
  const halfWidth = 1e-3 * magnitude;
  return fraction(symmetricLog(inside, halfWidth), symmetricLog(lo, halfWidth), symmetricLog(hi, halfWidth));
}

/** NaN, and an unusable range, give `missing`. */
export function normalise(value: number, range: ValueRange): Normalised {
  if (Number.isNaN(value) || !Number.isFinite(range.lo) || !Number.isFinite(range.hi)) return nothing;
  const magnitude = Math.max(Math.abs(range.lo), Math.abs(range.hi));
  const isSigned = range.scale === "signed";
  const lo = isSigned ? -magnitude : range.lo;
  const hi = isSigned ? magnitude : range.hi;
  const flags = { sign: value < 0 ? -1 : 1, below: value < lo, above: value > hi, missing: false };
  const inside = Math.min(Math.max(value, lo), Math.max(lo, hi));
  if (isSigned) {
    return {
      u: magnitude > 0 ? Math.abs(inside) / magnitude : 0,
      position: fraction(inside, lo, hi),
      ...flags,
    };
  }
  const u = place(inside, lo, hi, magnitude, range.scale);
  return { u, position: u, ...flags };
}

/** 0.05 x largest side / largest displacement; 0 when there is no displacement. */
export function automaticDeformationFactor(largestSide: number, largestDisplacement: number): number {
  const factor = (0.05 * largestSide) / largestDisplacement;
  return largestDisplacement > 0 && Number.isFinite(factor) ? factor : 0;
}
