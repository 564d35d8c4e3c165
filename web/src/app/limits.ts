// SPDX-License-Identifier: Apache-2.0
// How much of a limit a value uses. No DOM.
import type { Presented } from "./presentation-doc";

type Limited = Pick<Presented, "limit" | "limitIsUpper">;

/** 1: at the limit; more: past it. Null without a limit, or where a share of it means nothing. */
export function utilisation(value: number | null, { limit, limitIsUpper }: Limited): number | null {
  if (limit === null || value === null || Number.isNaN(value) || limit === 0) return null;
  if (limitIsUpper) return limit > 0 ? value / limit : null;
  // At least 1.5 wanted, 3 found: half of it is used.
  return limit > 0 && value > 0 ? limit / value : null;
}

export function isPast(value: number, { limit, limitIsUpper }: Limited): boolean {
  return limit !== null && (limitIsUpper ? value > limit : value < limit);
}
