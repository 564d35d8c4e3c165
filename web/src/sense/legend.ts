// SPDX-License-Identifier: Apache-2.0
// The legend for ear and hand: what low, middle and high sound and feel like. A script of time that the page plays in
// its frame loop and shows beside the colours.
import {
  type PitchEffect,
  type PulseEffect,
  pulseOf,
  type TickEffect,
  tickRateOf,
  toneOf,
  type ValueRange,
} from "../present";
import type { SoundFrame } from "./audio";
import type { HapticFrame } from "./haptics";

export interface LegendMoment {
  /** Place on the legend, 0..1: what to mark. */
  readonly u: number;
  readonly sound: SoundFrame | null;
  readonly haptic: HapticFrame | null;
}

export interface SensedLegend {
  readonly seconds: number;
  /** What to hear and feel so many seconds after the start; null: a gap, or over. */
  at(time: number): LegendMoment | null;
}

/** Position on the scale, not a value: range and scale of the result do not matter. */
const unit: ValueRange = Object.freeze({ lo: 0, hi: 1, scale: "linear" });

function steps(
  us: readonly number[],
  length: number,
  gap: number,
  show: (u: number) => LegendMoment,
): SensedLegend {
  return {
    seconds: us.length * length + (us.length - 1) * gap,
    at(time) {
      const index = Math.floor(time / (length + gap));
      const u = us[index];
      return u === undefined || time < 0 || time - index * (length + gap) >= length ? null : show(u);
    },
  };
}

/** Five tones from low to high, 0.76 s in all. */
export function pitchLegend(effect: PitchEffect): SensedLegend {
  return steps([0, 0.25, 0.5, 0.75, 1], 0.12, 0.04, (u) => ({
    u,
    sound: toneOf(u, unit, effect),
    haptic: null,
  }));
}

/** Ticks of low, middle and high. */
export function tickLegend(effect: TickEffect): SensedLegend {
  return steps([0, 0.5, 1], 0.8, 0.2, (u) => ({
    u,
    sound: { tickRate: tickRateOf(u, unit, effect) },
    haptic: null,
  }));
}

/** Pulses of low, middle and high. */
export function pulseLegend(effect: PulseEffect): SensedLegend {
  return steps([0, 0.5, 1], 0.8, 0.2, (u) => ({
    u,
    sound: null,
    haptic: { ...pulseOf(u, unit, effect), milliseconds: effect.milliseconds },
  }));
}
