// SPDX-License-Identifier: Apache-2.0
// Short sounds with one meaning each (docs/effects.md): limit crossed, no value, largest and smallest value.

export type EventKind =
  | "limitUp"
  | "limitDown"
  | "maximum"
  | "minimum"
  | "noValue"
  | "bandUp"
  | "bandDown"
  | "enter";

export interface Earcon {
  /** Of two at once the heavier sounds. */
  readonly weight: number;
  readonly seconds: number;
  play(context: BaseAudioContext, output: AudioNode, start: number): void;
}

const fromDecibel = (decibel: number) => 10 ** (decibel / 20);

/** A tone with raised-cosine edges. */
function beep(
  context: BaseAudioContext,
  output: AudioNode,
  start: number,
  seconds: number,
  hz: number,
  level: number,
): void {
  const edge = Math.min(0.01, seconds / 3);
  const tone = new OscillatorNode(context, { frequency: hz });
  const gain = new GainNode(context, { gain: 0 });
  // One curve from end to end: browsers move curves of the past to now, where two of them would overlap and throw.
  const count = Math.round((32 * seconds) / edge);
  const curve = Float32Array.from({ length: count + 1 }, (_, i) => {
    const part = Math.min(1, (Math.min(i, count - i) * seconds) / (count * edge));
    return level * (0.5 - 0.5 * Math.cos(Math.PI * part));
  });
  gain.gain.setValueCurveAtTime(curve, start, seconds);
  tone.connect(gain).connect(output);
  tone.start(start);
  tone.stop(start + seconds);
}

function beeps(weight: number, level: number, seconds: number, gap: number, ...pitches: number[]): Earcon {
  return {
    weight,
    seconds: pitches.length * seconds + (pitches.length - 1) * gap,
    play(context, output, start) {
      pitches.forEach((hz, i) => {
        beep(context, output, start + i * (seconds + gap), seconds, hz, fromDecibel(level));
      });
    },
  };
}

/** An equal-tempered major third. */
const third = 2 ** (4 / 12);

export const earcons: Readonly<Record<EventKind, Earcon>> = Object.freeze({
  limitUp: beeps(5, -14, 0.06, 0.06, 1500, 1500),
  limitDown: beeps(5, -14, 0.06, 0, 750),
  maximum: beeps(4, -18, 0.09, 0, 880, 880 * third),
  minimum: beeps(4, -18, 0.09, 0, 880, 880 / third),
  noValue: beeps(3, -18, 0.06, 0, 110),
  bandUp: beeps(2, -26, 0.008, 0, 1300),
  bandDown: beeps(2, -26, 0.008, 0, 950),
  enter: beeps(1, -30, 0.03, 0, 500),
});
