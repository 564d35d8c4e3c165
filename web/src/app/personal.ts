// SPDX-License-Identifier: Apache-2.0
// What a person needs against what a presentation asks for: a wider scale of tones, a stronger weakest pulse.
import type { PitchEffect, PulseEffect } from "../present";
import type { Person } from "./person";

/** Four octaves instead of three: two per cent of the range are 96 cents. */
const WIDE = { midiLow: 48, midiHigh: 96 } as const;

export function personalPitch(effect: PitchEffect, person: Person): PitchEffect;
export function personalPitch(effect: PitchEffect | null, person: Person): PitchEffect | null;
export function personalPitch(effect: PitchEffect | null, person: Person): PitchEffect | null {
  return effect && person.wide ? { ...effect, ...WIDE } : effect;
}

export function personalPulse(effect: PulseEffect | null, person: Person): PulseEffect | null {
  return effect && person.weakest !== null ? { ...effect, amplitudeMin: person.weakest } : effect;
}
