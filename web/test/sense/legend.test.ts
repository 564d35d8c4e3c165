// SPDX-License-Identifier: Apache-2.0
// The legend for ear and hand plays low to high and ends.
import { expect, test } from "vitest";
import { defaultPitch, defaultPulses, defaultTicks } from "../../src/present";
import {
  createHaptics,
  type LegendMoment,
  pitchLegend,
  pulseLegend,
  type SensedLegend,
  tickLegend,
} from "../../src/sense";

/** Runs of equal moments at 72 frames a second; null between them. */
function played(legend: SensedLegend): LegendMoment[] {
  const runs: LegendMoment[] = [];
  let last: number | null = null;
  for (let t = 0; t < legend.seconds + 0.5; t += 1 / 72) {
    const moment = legend.at(t);
    if (moment && moment.u !== last) runs.push(moment);
    last = moment?.u ?? null;
  }
  return runs;
}

test("five tones rise over the scale in three quarters of a second", () => {
  const legend = pitchLegend(defaultPitch);
  const tones = played(legend).map((m) => m.sound?.hz ?? 0);

  expect(legend.seconds).toBeCloseTo(0.76, 9);
  expect(tones.map(Math.round)).toEqual([131, 220, 370, 622, 1047]);
  expect(legend.at(legend.seconds)).toBeNull();
  expect(legend.at(0.13)).toBeNull();
  expect(legend.at(-1)).toBeNull();
});

test("an inverted pitch sounds its legend from high to low", () => {
  const [first] = played(pitchLegend({ ...defaultPitch, invert: true }));

  expect(Math.round(first?.sound?.hz ?? 0)).toBe(1047);
});

test("ticks and pulses show low, middle and high", () => {
  expect(played(tickLegend(defaultTicks)).map((m) => m.sound?.tickRate)).toEqual([
    1.5,
    expect.closeTo(4.243, 3),
    12,
  ]);
  expect(played(pulseLegend(defaultPulses)).map((m) => m.haptic?.rate)).toEqual([
    2,
    expect.closeTo(4.472, 3),
    10,
  ]);
});

test("each step of the touch legend is felt at least twice", () => {
  const legend = pulseLegend(defaultPulses);
  const haptics = createHaptics();
  const felt = new Map<number, number>();
  let now: LegendMoment | null = null;
  haptics.setActuator({ pulse: () => felt.set(now?.u ?? -1, (felt.get(now?.u ?? -1) ?? 0) + 1) });
  for (let t = 0; t < legend.seconds; t += 1 / 72) {
    now = legend.at(t);
    haptics.update(now?.haptic ?? null);
    haptics.tick(t);
  }

  expect([...felt.keys()]).toEqual([0, 0.5, 1]);
  expect(Math.min(...felt.values())).toBeGreaterThanOrEqual(2);
});
