// SPDX-License-Identifier: Apache-2.0
// When the limit counts as crossed, ticks as planned, and sound as too loud.
import { expect, test } from "vitest";
import { EventWatch, type ProbeState, type SenseEvent } from "../../src/sense";
import { limited, limiterCurve, tickSamples } from "../../src/sense/signals";
import { TickClock } from "../../src/sense/tick-clock";

const range = { lo: 0, hi: 400, scale: "linear" } as const;
const limit = { value: 250, kind: "above" } as const;

function eventsOf(states: (ProbeState | null)[]): SenseEvent[] {
  const watch = new EventWatch();
  return states.map((s) => watch.update(s)).filter((e) => e !== null);
}
const values = (...numbers: number[]) => numbers.map((value) => ({ value, range, limit }));

test("A11 a ramp through the limit and back is one event up and one down", () => {
  const ramp = Array.from({ length: 400 }, (_, i) => i);

  expect(eventsOf(values(...ramp))).toEqual(["limitUp"]);
  expect(eventsOf(values(...ramp, ...ramp.reverse()))).toEqual(["limitUp", "limitDown"]);
});

test("A11 noise of half a per cent of the range around the limit is one event at most", () => {
  const noise = Array.from({ length: 2000 }, (_, i) => 250 + 2 * Math.sin(i * i));

  expect(Math.max(...noise) - Math.min(...noise)).toBeGreaterThan(3.9);
  expect(eventsOf(values(...noise)).length).toBeLessThanOrEqual(1);
});

test("exactly the limit is not beyond it", () => {
  const watch = new EventWatch();

  expect(watch.update({ value: 250, range, limit })).toBeNull();
  expect(watch.beyond).toBe(false);
  expect(watch.update({ value: 250.001, range, limit })).toBe("limitUp");
  expect(watch.beyond).toBe(true);
});

test("a lower limit alarms below it", () => {
  const low = { value: 1, kind: "below" } as const;
  const factor = { lo: 0, hi: 5, scale: "linear" } as const;
  const states = [3, 1.2, 0.9, 1.02, 1.2].map((value) => ({ value, range: factor, limit: low }));

  expect(eventsOf(states)).toEqual(["limitUp", "limitDown"]);
});

test("a place without a value is said once, and again after another visit", () => {
  const nothing = { value: Number.NaN, range, limit };

  expect(eventsOf([nothing, nothing, ...values(10), nothing, null, nothing])).toEqual([
    "noValue",
    "noValue",
    "noValue",
  ]);
});

test("entering the model beyond the limit says so, leaving it says nothing", () => {
  expect(eventsOf([null, ...values(300, 310), null, ...values(300)])).toEqual(["limitUp", "limitUp"]);
});

test("a result without a limit has no limit events", () => {
  expect(eventsOf([10, 1000, -1000].map((value) => ({ value, range })))).toEqual([]);
});

/** Ticks that sounded: planned and not taken back. */
function sounded(
  updates: (clock: TickClock, now: number) => void,
  seconds: number,
  frame = 1 / 72,
): number[] {
  const planned: { time: number; live: boolean }[] = [];
  let now = 0;
  const clock = new TickClock((time) => {
    expect(time, "planned in the past").toBeGreaterThanOrEqual(now);
    const tick = { time, live: true };
    planned.push(tick);
    return () => {
      if (time > now) tick.live = false;
    };
  });
  for (; now < seconds; now += frame) updates(clock, now);
  return planned.filter((t) => t.live && t.time < seconds).map((t) => t.time);
}

test("ticks keep time through slow frames", () => {
  for (const frame of [1 / 120, 1 / 72, 1 / 10, 1 / 5]) {
    const times = sounded((clock, now) => clock.update(now, 7), 10, frame);
    expect(times.length).toBe(70);
    for (const [i, t] of times.slice(1).entries()) expect(t - (times[i] ?? 0)).toBeCloseTo(1 / 7, 9);
  }
});

test("a new rate is heard at once: the rest of the beat is shortened in proportion", () => {
  const times = sounded((clock, now) => clock.update(now, now < 1.1 ? 1.5 : 12), 1.5);
  const before = times.filter((t) => t < 1.1);
  const after = times.filter((t) => t >= 1.1);

  expect(before.length).toBe(2);
  expect(after[0]).toBeLessThan(1.1 + 1 / 12);
  expect(after.length).toBeGreaterThanOrEqual(4);
});

test("stopped ticks do not sound", () => {
  const times = sounded((clock, now) => (now < 1 ? clock.update(now, 10) : clock.stop(now)), 3);

  expect(times.at(-1)).toBeLessThanOrEqual(1);
});

test("touching again and again does not make ticks come closer", () => {
  const times = sounded((clock, now) => clock.update(now, Math.floor(now * 36) % 2 ? 12 : 0), 5);

  expect(times.length).toBeGreaterThan(10);
  for (const [i, t] of times.slice(1).entries())
    expect(t - (times[i] ?? 0)).toBeGreaterThanOrEqual(0.08 - 1e-9);
});

test("the limiter leaves quiet sound alone and lets nothing pass -6 dBFS", () => {
  for (let x = -0.4; x <= 0.4; x += 0.01) expect(limited(x)).toBe(x);
  let last = Number.NEGATIVE_INFINITY;
  for (const x of limiterCurve()) {
    expect(x).toBeGreaterThanOrEqual(last);
    expect(Math.abs(x)).toBeLessThanOrEqual(10 ** (-6 / 20) + 1e-7);
    last = x;
  }
  expect(limited(100)).toBeLessThanOrEqual(10 ** (-6 / 20));
  expect(limiterCurve()[5000]).toBe(0);
});

test("a tick is short, starts and ends at nothing and peaks at 0.2", () => {
  const samples = tickSamples(48000);

  expect(samples.length).toBe(768);
  expect(Math.abs(samples[0] ?? 1)).toBe(0);
  expect(Math.abs(samples.at(-1) ?? 1)).toBeLessThan(1e-3);
  expect(Math.max(...samples.map(Math.abs))).toBeCloseTo(0.2, 6);
});
