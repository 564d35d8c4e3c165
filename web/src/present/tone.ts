// SPDX-License-Identifier: Apache-2.0
// Value -> pitch of a tone that is equally loud everywhere. Twin of src/present/tone.cpp.
import { normalise } from "./normalise";
import type { PitchEffect, Quantise, Tone, ValueRange } from "./types";

/** Amplitudes of the harmonics 1..4 of the tone, and of the hollow tone of negative values. */
export const tonePartials: readonly number[] = Object.freeze([1, 0.5, 0.25, 0.125]);
export const negativePartials: readonly number[] = Object.freeze([1, 0, 0.45, 0]);

/** Hz, and the dB a pure tone needs above one of 1 kHz to be as loud, at 60 phon (ISO 226:2003). */
const equalLoudnessPoints: readonly (readonly [number, number])[] = [
  [100, 18.6],
  [125, 15.6],
  [160, 12.5],
  [200, 9.9],
  [250, 7.5],
  [315, 5.4],
  [400, 3.4],
  [500, 2.0],
  [630, 0.8],
  [800, -0.1],
  [1000, 0],
  [1250, 2.1],
  [1600, 3.2],
  [2000, 0],
  [2500, -2.8],
  [3150, -3.6],
  [4000, -2.4],
];

/** Level in dB that a pure tone needs to be as loud as one of 1 kHz; constant outside 100..4000 Hz. */
export function equalLoudness(hz: number): number {
  const inside = Math.min(Math.max(hz, 100), 4000);
  let i = 1;
  while (i + 1 < equalLoudnessPoints.length && (equalLoudnessPoints[i]?.[0] ?? 0) < inside) i++;
  const [lowHz, low] = equalLoudnessPoints[i - 1] ?? [100, 0];
  const [highHz, high] = equalLoudnessPoints[i] ?? [4000, 0];
  return low + ((high - low) * Math.log2(inside / lowHz)) / Math.log2(highHz / lowHz);
}

/** Amplitude that makes the sum of the partials as loud as any other tone, before normalisation. */
function loudnessGain(hz: number, partials: readonly number[]): number {
  let power = 0;
  partials.forEach((amplitude, i) => {
    power += amplitude * amplitude * 10 ** (-equalLoudness(hz * (i + 1)) / 10);
  });
  return Math.min(10 ** (12 / 20), 1 / Math.sqrt(power));
}

const hertz = (midi: number) => 440 * 2 ** ((midi - 69) / 12);

const knownLargest = new Map<string, number>();

/** Largest gain of the effect's range: at its ends and on every semitone between them. */
function largestGain(effect: PitchEffect): number {
  const key = `${effect.midiLow} ${effect.midiHigh}`;
  const known = knownLargest.get(key);
  if (known !== undefined) return known;
  const clamp = (midi: number) => Math.min(Math.max(midi, 0), 127);
  const low = clamp(Math.min(effect.midiLow, effect.midiHigh));
  const high = clamp(Math.max(effect.midiLow, effect.midiHigh));
  let largest = loudnessGain(hertz(high), tonePartials);
  for (let midi = low; midi < high; midi++)
    largest = Math.max(largest, loudnessGain(hertz(midi), tonePartials));
  if (knownLargest.size > 100) knownLargest.clear();
  knownLargest.set(key, largest);
  return largest;
}

function quantised(midi: number, quantise: Quantise): number {
  if (quantise === "none") return midi;
  if (quantise === "semitone") return Math.floor(midi + 0.5);
  const octave = Math.floor(midi / 12) * 12;
  let nearest = octave;
  for (const step of [2, 4, 7, 9, 12]) {
    if (Math.abs(octave + step - midi) < Math.abs(nearest - midi)) nearest = octave + step;
  }
  return nearest;
}

const silence: Tone = Object.freeze({ hz: 0, gain: 0, negative: false });

export function toneOf(value: number, range: ValueRange, effect: PitchEffect): Tone {
  const place = normalise(value, range);
  if (place.missing) return silence;
  const share = (effect.invert ? 1 - place.u : place.u) ** effect.gamma;
  const hz = hertz(quantised(effect.midiLow + (effect.midiHigh - effect.midiLow) * share, effect.quantise));
  const negative = range.scale === "signed" && effect.signTimbre && place.sign < 0;
  const gain = loudnessGain(hz, negative ? negativePartials : tonePartials);
  return { hz, gain: Math.min(1, gain / largestGain(effect)), negative };
}
