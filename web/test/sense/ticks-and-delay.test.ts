// SPDX-License-Identifier: Apache-2.0
// When things are heard: ticks in time, and a change of value soon after the pose that brought it.
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { defaultPitch, defaultTicks, tickRateOf, toneOf } from "../../src/present";
import type { SoundFrame } from "../../src/sense";
import { measured } from "../support/measured";
import { canRender, type Renderer, startRenderer } from "./renderer";
import { frames, numbers } from "./script";
import { fundamental, onsets, part, sampleRate } from "./signal";
import type { Script } from "./sound-page";

const unit = { lo: 0, hi: 1, scale: "linear" } as const;
const loud = { master: 1, mono: true };
const toneFrame = (u: number): SoundFrame => toneOf(u, unit, defaultPitch);
const intervalsOf = (times: number[]) => times.slice(1).map((t, i) => t - (times[i] ?? 0));

describe.skipIf(!canRender)("when it is heard", { timeout: 120_000 }, () => {
  let renderer: Renderer;
  beforeAll(async () => {
    renderer = await startRenderer();
  }, 120_000);
  afterAll(async () => renderer?.close());

  test("A6 each beat of a steady value keeps the formula's rate within 2 %", async () => {
    let worst = 0;
    for (let i = 0; i <= 10; i++) {
      const rate = 1.5 * 8 ** (i / 10);
      expect(tickRateOf(i / 10, unit, defaultTicks)).toBeCloseTo(rate, 12);
      const steps = frames(0, 8, () => ({ tickRate: tickRateOf(i / 10, unit, defaultTicks) }));
      const [left] = await renderer.render({ seconds: 8, options: loud, steps });
      const times = onsets(left, 0.05);

      expect(times.length).toBeGreaterThan(8 * rate - 2);
      for (const interval of intervalsOf(times)) worst = Math.max(worst, Math.abs(interval * rate - 1));
    }
    expect(worst).toBeLessThanOrEqual(0.02);
    measured("A6", `steady beats within ${(100 * worst).toFixed(3)} %`);
  });

  test("A6 ticks of a random value keep 60 ms apart and never pass 12.5 a second", async () => {
    const random = numbers(11);
    let u = 0;
    const ways: Record<string, (index: number) => number> = {
      "another value each frame": () => tickRateOf(random(), unit, defaultTicks),
      "another value each 0.3 s": (index) => {
        if (index % 22 === 0) u = random();
        return tickRateOf(u, unit, defaultTicks);
      },
      "let go and pressed again": (index) => (Math.floor(index / 3) % 2 ? 12 : 0),
      "a rate nobody may ask for": () => 40,
    };
    let shortest = Number.POSITIVE_INFINITY;
    for (const [way, rate] of Object.entries(ways)) {
      const steps = frames(0, 20, (_, index) => ({ tickRate: rate(index) }));
      const times = onsets((await renderer.render({ seconds: 20, options: loud, steps }))[0], 0.03);

      expect(times.length, way).toBeGreaterThan(40);
      shortest = Math.min(shortest, ...intervalsOf(times));
      expect(Math.min(...intervalsOf(times)), way).toBeGreaterThanOrEqual(0.06);
    }
    // A beginning can be told to one sample.
    expect(shortest).toBeGreaterThanOrEqual(1 / 12.5 - 1.01 / sampleRate);
    measured("A6", `random values: shortest ${(1000 * shortest).toFixed(2)} ms`);
  });

  test("A8 a pose of 72 a second is heard within 20 ms, with blocks of 128 to 512 samples", async () => {
    let worst = 0;
    for (const block of [128, 256, 384, 512]) {
      for (let phase = 0; phase < 8; phase++) {
        // Frames and blocks drift against each other; the pose of this frame brings the new value.
        const start = 0.01 + phase / 8 / 72;
        const pose = start + 20 / 72;
        const script = (u: number): Script => ({
          seconds: 0.5,
          options: loud,
          block,
          steps: frames(start, 0.5, (t) => toneFrame(t < pose - 1e-9 ? 0.5 : u)),
        });
        const [before] = await renderer.render(script(0.5));
        const [after] = await renderer.render(script(0.52));
        const delay = before.findIndex((v, i) => v !== after[i]) / sampleRate - pose;

        expect(delay).toBeGreaterThanOrEqual(0);
        worst = Math.max(worst, delay);
      }
    }
    expect(worst).toBeLessThanOrEqual(0.02);
    measured("A8", `at most ${(1000 * worst).toFixed(1)} ms`);
  });

  test("a jump of value is within 10 cents of its pitch after 80 ms", async () => {
    const steps = frames(0, 1, (t) => toneFrame(t < 0.5 ? 0.5 : 0.52));
    const [left] = await renderer.render({ seconds: 1, options: loud, steps });
    const hz = fundamental(part(left, 0.58, 0.9));

    expect(Math.abs(1200 * Math.log2(hz / (toneFrame(0.52).hz ?? 1)))).toBeLessThan(10);
  });
});
