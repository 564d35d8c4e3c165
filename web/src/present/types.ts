// SPDX-License-Identifier: Apache-2.0
// What maps to what: ranges, effects and what they give. The twin of include/feelem/present.hpp.

export type Scale = "linear" | "log" | "signed" | "symlog";

/** One range a result, shared by all its effects, so that the senses cannot disagree. */
export interface ValueRange {
  readonly lo: number;
  readonly hi: number;
  readonly scale: Scale;
}

/** Position of a value in a range. */
export interface Normalised {
  /** Clamped to 0..1; a range without width puts its one value in the middle. */
  readonly u: number;
  /** On the colour map: u, but for signed ranges (0 -> 0.5). */
  readonly position: number;
  /** Of the value: 1 or -1. */
  readonly sign: number;
  readonly below: boolean;
  readonly above: boolean;
  readonly missing: boolean;
}

/** sRGB, 0..255. */
export type Rgb = readonly [number, number, number];

export interface ColourEffect {
  readonly map: string;
  /** 0: continuous. */
  readonly bands: number;
  readonly invert: boolean;
  readonly above: Rgb;
  readonly below: Rgb;
  readonly missing: Rgb;
}
export const defaultColour: ColourEffect = Object.freeze({
  map: "batlow",
  bands: 9,
  invert: false,
  above: [255, 0, 255],
  below: [255, 255, 0],
  missing: [128, 128, 128],
} as const);

export type Quantise = "none" | "semitone" | "pentatonic";
export interface PitchEffect {
  readonly midiLow: number;
  readonly midiHigh: number;
  /** 0.5..2 */
  readonly gamma: number;
  readonly invert: boolean;
  readonly quantise: Quantise;
  /** Negative values of a signed range sound hollow. */
  readonly signTimbre: boolean;
}
export const defaultPitch: PitchEffect = Object.freeze({
  midiLow: 48,
  midiHigh: 84,
  gamma: 1,
  invert: false,
  quantise: "none",
  signTimbre: true,
});

export interface Tone {
  readonly hz: number;
  /** Equal-loudness gain, 0..1; 0: silent (missing). */
  readonly gain: number;
  /** Use negativePartials. */
  readonly negative: boolean;
}

export interface TickEffect {
  /** Hz */
  readonly rateLow: number;
  readonly rateHigh: number;
  readonly invert: boolean;
}
export const defaultTicks: TickEffect = Object.freeze({ rateLow: 1.5, rateHigh: 12, invert: false });

export interface PulseEffect {
  /** Hz */
  readonly rateLow: number;
  readonly rateHigh: number;
  readonly amplitudeMin: number;
  readonly milliseconds: number;
  readonly invert: boolean;
}
export const defaultPulses: PulseEffect = Object.freeze({
  rateLow: 2,
  rateHigh: 10,
  amplitudeMin: 0.15,
  milliseconds: 35,
  invert: false,
});

export interface Pulse {
  /** Hz; 0 when missing. */
  readonly rate: number;
  /** 0..1 */
  readonly amplitude: number;
}
