// SPDX-License-Identifier: Apache-2.0
// The vibration engine against a recording actuator and a clock of our own.
import { expect, test } from "vitest";
import { defaultPulses, pulseOf } from "../../src/present";
import {
  type Actuator,
  actuatorOf,
  actuatorOfDevice,
  createHaptics,
  type HapticEvent,
  type HapticFrame,
  type Haptics,
} from "../../src/sense";
import { measured } from "../support/measured";
import { numbers } from "./script";

const unit = { lo: 0, hi: 1, scale: "linear" } as const;
const frameOf = (u: number): HapticFrame => pulseOf(u, unit, defaultPulses);

interface Call {
  time: number;
  strength: number;
  ms: number;
  cause?: string | undefined;
}

/** An engine in a headset of 72 frames a second. */
class Rig {
  readonly haptics: Haptics = createHaptics();
  readonly calls: Call[] = [];
  time = 0;
  constructor() {
    const actuator: Actuator = {
      pulse: (strength, ms) => this.calls.push({ time: this.time, strength, ms }),
    };
    this.haptics.setActuator(actuator);
  }
  run(seconds: number, frame: (time: number) => HapticFrame | null, step = () => 1 / 72): Call[] {
    const from = this.calls.length;
    for (const end = this.time + seconds; this.time < end; this.time += step()) {
      this.haptics.update(frame(this.time));
      const before = this.calls.length;
      this.haptics.tick(this.time);
      const sent = this.calls[before];
      if (sent) sent.cause = this.haptics.pulses().at(-1)?.cause;
    }
    return this.calls.slice(from);
  }
}

test("steady values give the formula's rate and strength on average, whatever the frames", () => {
  for (const hz of [60, 72, 90, 120]) {
    for (const u of [0, 0.25, 0.5, 0.75, 1]) {
      const rig = new Rig();
      const frame = frameOf(u);
      const calls = rig.run(
        20,
        () => frame,
        () => 1 / hz,
      );
      const first = calls[0]?.time ?? 0;
      const last = calls.at(-1)?.time ?? 0;
      const rate = (calls.length - 1) / (last - first);

      expect(Math.abs(rate / frame.rate - 1), `u ${u}, ${hz} frames a second: ${rate}`).toBeLessThan(0.01);
      expect(calls.every((c) => c.strength === frame.amplitude && c.ms === 35)).toBe(true);
    }
  }
});

test("a beat is off by a frame at most", () => {
  const calls = new Rig().run(10, () => frameOf(1));

  for (const [i, call] of calls.slice(1).entries()) {
    expect(Math.abs(call.time - (calls[i]?.time ?? 0) - 0.1)).toBeLessThan(1 / 72 + 1e-9);
  }
});

test("H1 higher values pulse faster and stronger", () => {
  let last = { rate: 0, strength: 0 };
  for (let i = 0; i <= 20; i++) {
    const calls = new Rig().run(30, () => frameOf(i / 20));
    const now = { rate: calls.length / 30, strength: calls[0]?.strength ?? 0 };
    expect(now.rate).toBeGreaterThan(last.rate);
    expect(now.strength).toBeGreaterThan(last.strength);
    last = now;
  }
});

test("H2 a hundred thousand random frames keep the contract: gaps, lengths, duty", () => {
  const random = numbers(5);
  const rig = new Rig();
  const events: HapticEvent[] = ["maximum", "minimum", "enter", "band", "limitUp", "limitDown"];
  let u = 0.5;
  const calls = rig.run(
    1e5 / 72,
    () => {
      u = Math.min(Math.max(u + 0.4 * (random() - 0.5), 0), 1);
      if (random() < 0.01) rig.haptics.event(events[Math.floor(6 * random())] ?? "enter");
      if (random() < 0.02) return null;
      return {
        ...frameOf(u),
        milliseconds: 10 + 300 * random(),
        alarm: random() < 0.2,
        still: random() < 0.1,
      };
    },
    () => (0.5 + random()) / 72,
  );

  expect(calls.length).toBeGreaterThan(1000);
  let on = 0;
  let shortest = Number.POSITIVE_INFINITY;
  for (const [i, call] of calls.slice(1).entries()) {
    const gap = call.time - (calls[i]?.time ?? 0);
    if (call.cause?.startsWith("limit")) continue;
    expect(gap).toBeGreaterThanOrEqual(0.08 - 1e-9);
    shortest = Math.min(shortest, gap);
  }
  expect(calls.filter((call) => call.cause === "limitUp").length).toBeGreaterThan(50);
  for (const call of calls) {
    expect(call.ms).toBeLessThanOrEqual(200);
    expect(call.strength).toBeLessThanOrEqual(1);
    on += call.ms / 1000;
  }
  expect(on / rig.time).toBeLessThanOrEqual(0.45);
  const longest = Math.max(...calls.map((call) => call.ms));
  measured(
    "H2",
    `shortest gap ${(1000 * shortest).toFixed(1)} ms, longest ${longest} ms, duty ${((100 * on) / rig.time).toFixed(0)} %`,
  );
});

test("a rise of the rate is felt within a frame once its beat is due", () => {
  const rig = new Rig();
  rig.run(1.05, () => frameOf(0));
  const before = rig.calls.at(-1)?.time ?? 0;
  const [first] = rig.run(0.2, () => frameOf(1));

  expect(first?.time).toBeLessThanOrEqual(Math.max(before + 0.1, 1.05) + 2 / 72);
});

test("release stops at once and the next touch begins at once", () => {
  const rig = new Rig();
  rig.run(1, () => frameOf(1));
  expect(rig.run(1, () => null)).toEqual([]);
  const start = rig.time;

  expect(rig.run(0.1, () => frameOf(0))[0]?.time).toBe(start);
});

test("stop forgets beats and events", () => {
  const rig = new Rig();
  rig.run(0.5, () => frameOf(1));
  rig.haptics.event("limitUp");
  rig.haptics.stop();

  expect(rig.run(1, () => null)).toEqual([]);
});

test("H3 crossing the limit is a double pulse that nothing overrides for 250 ms", () => {
  for (let offset = 0; offset < 30; offset++) {
    const rig = new Rig();
    rig.run(0.5 + offset / 72, () => frameOf(1));
    const start = rig.time;
    rig.haptics.event("limitUp");
    const during = rig.run(0.25, () => {
      rig.haptics.event("maximum");
      return frameOf(1);
    });

    expect(during.map((c) => [c.strength, c.ms])).toEqual([
      [1, 60],
      [1, 60],
    ]);
    expect(during[0]?.time).toBe(start);
    expect((during[1]?.time ?? 0) - start).toBeGreaterThanOrEqual(0.12);
    expect(rig.run(0.5, () => frameOf(1)).length).toBeGreaterThan(2);
  }
});

test("coming back below the limit is one soft pulse", () => {
  const rig = new Rig();
  rig.haptics.event("limitDown");

  expect(rig.run(0.25, () => frameOf(0.2)).map((c) => [c.strength, c.ms])).toEqual([[0.4, 40]]);
});

test("beyond the limit pulses come a quarter faster, but never above ten a second", () => {
  const alarmed = (u: number) => new Rig().run(20, () => ({ ...frameOf(u), alarm: true })).length / 20;

  expect(alarmed(0.5) / frameOf(0.5).rate).toBeCloseTo(1.25, 1);
  expect(alarmed(1)).toBeLessThanOrEqual(10.05);
});

test("a hand that rests feels one soft pulse a second, and the value again when it moves", () => {
  const rig = new Rig();
  rig.run(2, () => ({ ...frameOf(1), still: true }));
  const resting = rig.run(5, () => ({ ...frameOf(1), still: true }));
  const moving = rig.run(1, () => frameOf(1));

  expect(resting.length).toBe(5);
  expect(resting.every((c) => c.strength === 0.5)).toBe(true);
  expect(moving.length).toBeGreaterThan(8);
  expect(moving.at(-1)?.strength).toBe(1);
});

test("personal strength scales what is felt and zero sends nothing", () => {
  const rig = new Rig();
  rig.haptics.setStrength(0.5);
  expect(rig.run(0.1, () => frameOf(1))[0]?.strength).toBe(0.5);
  rig.haptics.setStrength(0);
  expect(rig.run(1, () => frameOf(1))).toEqual([]);
  rig.haptics.setStrength(1.5);
  expect(rig.run(1, () => frameOf(1))[0]?.strength).toBe(1);
});

test("what was sent is recorded with its cause", () => {
  const rig = new Rig();
  rig.run(0.05, () => frameOf(0));
  rig.haptics.event("limitUp");
  rig.run(0.3, () => frameOf(0));

  expect(rig.haptics.pulses().map((p) => p.cause)).toEqual(["beat", "limitUp", "limitUp"]);
  expect(rig.haptics.pulses().map((p) => p.time)).toEqual(rig.calls.map((c) => c.time));
});

test("H4 without an actuator nothing is sent and the caller is told", () => {
  const haptics = createHaptics();
  haptics.update(frameOf(1));
  haptics.tick(0);

  expect(haptics.hasActuator).toBe(false);
  expect(haptics.pulses()).toEqual([]);
});

test("actuators are probed in order: pulse, then playEffect, then none", () => {
  const said: unknown[] = [];
  const pulse = (value: number, ms: number) => {
    said.push(["pulse", value, ms]);
    return Promise.resolve(true);
  };
  const playEffect = (type: string, options: unknown) => {
    said.push([type, options]);
    return Promise.reject(new Error("preempted"));
  };
  const gamepad = (parts: object) => parts as unknown as Gamepad;

  actuatorOf(gamepad({ hapticActuators: [{ pulse }], vibrationActuator: { playEffect } }))?.pulse(0.5, 35);
  actuatorOf(gamepad({ hapticActuators: [], vibrationActuator: { playEffect } }))?.pulse(0.5, 35);

  expect(said).toEqual([
    ["pulse", 0.5, 35],
    ["dual-rumble", { duration: 35, strongMagnitude: 0.5, weakMagnitude: 0.5 }],
  ]);
  expect(actuatorOf(gamepad({ vibrationActuator: null }))).toBeNull();
  expect(actuatorOf(gamepad({}))).toBeNull();
  expect(actuatorOf(undefined)).toBeNull();
});

test("a phone with Android shakes as a whole, once it was tapped; others do not", () => {
  const sent: unknown[] = [];
  const device = (userAgent: string, hasBeenActive = true) => ({
    userAgent,
    userActivation: { hasBeenActive, isActive: false },
    vibrate: (ms: unknown) => {
      sent.push(ms);
      return true;
    },
  });

  actuatorOfDevice(device("Mozilla/5.0 (Linux; Android 15)"))?.pulse(0.5, 35);

  expect(sent).toEqual([35]);
  expect(actuatorOfDevice(device("Mozilla/5.0 (Linux; Android 15)", false))).toBeNull();
  expect(actuatorOfDevice(device("Mozilla/5.0 (X11; Linux x86_64)"))).toBeNull();
});
