// SPDX-License-Identifier: Apache-2.0
// The range that all senses of a result share, and the extremes it comes from. No DOM.
import type { ValueRange } from "../present";
import { type Extreme, MISSING, type PartField, type SceneResult } from "../scene";
import type { Presented } from "./presentation-doc";

export type Fields = readonly (PartField | null)[];

/** Extremes over the whole model as the scene states them; null when it does not. */
export function statedExtremes(result: SceneResult, step: number): { min: Extreme; max: Extreme } | null {
  if (result.components.length !== 1) return null;
  const values = result.values.find((v) => v.step === step);
  return values?.min && values.max ? { min: values.min, max: values.max } : null;
}

/** Smallest and largest value on the skin; null when nothing is there. */
export function skinRange(fields: Fields, component: number): { lo: number; hi: number } | null {
  let lo = Number.POSITIVE_INFINITY;
  let hi = Number.NEGATIVE_INFINITY;
  for (const field of fields) {
    if (!field) continue;
    for (let i = 0; i < field.state.length; ++i) {
      if (field.state[i] === MISSING) continue;
      const value = field.values[i * field.components + component] ?? Number.NaN;
      if (value < lo) lo = value;
      if (value > hi) hi = value;
    }
  }
  return lo <= hi ? { lo, hi } : null;
}

function automatic(presented: Presented, step: number, fields: Fields): { lo: number; hi: number } | null {
  const { result } = presented;
  if (!result) return null;
  if (presented.rangeMode === "allSteps") {
    const all = result.values.map((v) => statedExtremes(result, v.step));
    const known = all.filter((e) => e !== null);
    if (known.length > 0 && known.length === all.length) {
      return {
        lo: Math.min(...known.map((e) => e.min.value)),
        hi: Math.max(...known.map((e) => e.max.value)),
      };
    }
  }
  const stated = statedExtremes(result, step);
  if (stated) return { lo: stated.min.value, hi: stated.max.value };
  return skinRange(fields, presented.componentIndex);
}

/** The range in force at a step. */
export function rangeOf(presented: Presented, step: number, fields: Fields): ValueRange {
  const { lo, hi, scale } = presented;
  const stored = lo !== null && hi !== null ? { lo, hi } : null;
  // Ends that only the converter finds, or that nobody has typed, are not there in every file.
  const typed = presented.rangeMode === "manual" || presented.rangeMode === "percentile";
  const range = (typed && stored) || (automatic(presented, step, fields) ?? stored);
  return { lo: range?.lo ?? 0, hi: range?.hi ?? 1, scale };
}
