// SPDX-License-Identifier: Apache-2.0
// Value -> ticks a second for the ear, pulses a second and their strength for the hand. Twin of src/present/rates.cpp.
import { normalise } from "./normalise";
import type { Pulse, PulseEffect, TickEffect, ValueRange } from "./types";

/** Equal ratios: low at 0, high at 1. */
const geometric = (low: number, high: number, share: number) => low * (high / low) ** share;

/** Ticks a second; 0 when missing. */
export function tickRateOf(value: number, range: ValueRange, effect: TickEffect): number {
  const place = normalise(value, range);
  if (place.missing) return 0;
  return geometric(effect.rateLow, effect.rateHigh, effect.invert ? 1 - place.u : place.u);
}

const stillness: Pulse = Object.freeze({ rate: 0, amplitude: 0 });

export function pulseOf(value: number, range: ValueRange, effect: PulseEffect): Pulse {
  const place = normalise(value, range);
  if (place.missing) return stillness;
  const share = effect.invert ? 1 - place.u : place.u;
  return {
    rate: geometric(effect.rateLow, effect.rateHigh, share),
    amplitude: geometric(effect.amplitudeMin, 1, share),
  };
}
