// SPDX-License-Identifier: Apache-2.0
// What the sound engine puts out, rendered by Chromium offline and measured.
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { defaultPitch, equalLoudness, negativePartials, toneOf, tonePartials } from "../../src/present";
import type { EventKind, SoundFrame } from "../../src/sense";
import { earcons } from "../../src/sense/earcons";
import { measured } from "../support/measured";
import { canRender, type Renderer, startRenderer } from "./renderer";
import { frames, numbers } from "./script";
import { amplitudeAt, decibel, fundamental, highPass, onsets, part, peak, rms } from "./signal";
import type { Script, Step } from "./sound-page";

const unit = { lo: 0, hi: 1, scale: "linear" } as const;
const toneFrame = (u: number): SoundFrame => toneOf(u, unit, defaultPitch);

describe.skipIf(!canRender)("sound engine", { timeout: 120_000 }, () => {
  let page: Page;

  let renderer: Renderer;
  beforeAll(async () => {
    renderer = await startRenderer();
    page = renderer.page;
  }, 120_000);
  afterAll(async () => renderer?.close());
  const render = (script: Script) => renderer.render(script);
  const loud = { master: 1, mono: true };
  const steady = (seconds: number, frame: SoundFrame, options = loud): Script => ({
    seconds,
    options,
    steps: frames(0, seconds, () => frame),
  });

  test("A1 pitch is the formula's within a thousandth, and rises with the value", async () => {
    let last = 0;
    for (let i = 0; i <= 1000; i++) {
      const { hz } = toneOf(i / 1000, unit, defaultPitch);
      expect(Math.abs(hz / (440 * 2 ** ((48 + 36 * (i / 1000) - 69) / 12)) - 1)).toBeLessThan(1e-12);
      expect(hz).toBeGreaterThan(last);
      last = hz;
    }
    last = 0;
    let worst = 0;
    for (let i = 0; i <= 20; i++) {
      const frame = toneFrame(i / 20);
      const [left] = await render(steady(0.7, frame));
      const hz = fundamental(part(left, 0.3, 0.7));
      const error = Math.abs(hz / (frame.hz ?? 0) - 1);
      expect(error, `u ${i / 20}: ${hz} Hz`).toBeLessThanOrEqual(0.001);
      worst = Math.max(worst, error);
      expect(hz).toBeGreaterThan(last);
      last = hz;
    }
    measured("A1", `worst of 21 tones ${(100 * worst).toFixed(4)} %`);
  });

  test("A3 37 pitches are equally loud within 1.5 dB, hollow ones too", async () => {
    const levels: number[] = [];
    for (let i = 0; i <= 36; i++) {
      const signed = { lo: -1, hi: 1, scale: "signed" } as const;
      const frame = toneOf(i % 6 === 5 ? -i / 36 : i / 36, signed, defaultPitch);
      const [left] = await render(steady(0.7, frame));
      const x = part(left, 0.3, 0.7);
      let power = 0;
      (frame.negative ? negativePartials : tonePartials).forEach((_, k) => {
        const hz = frame.hz * (k + 1);
        power += amplitudeAt(x, hz) ** 2 * 10 ** (-equalLoudness(hz) / 10);
      });
      levels.push(10 * Math.log10(power));
    }
    const spread = Math.max(...levels) - Math.min(...levels);
    expect(spread).toBeLessThanOrEqual(1.5);
    measured("A3", `spread ${spread.toFixed(3)} dB`);
  });

  test("A4 nothing passes -6 dBFS with every voice and every event at full level", async () => {
    const random = numbers(7);
    let u = 0.5;
    const steps = frames(0, 10, () => {
      u = Math.min(Math.max(u + 0.2 * (random() - 0.5), 0), 1);
      const second = { hz: 311.7, gain: 1 };
      return { ...toneFrame(u), tickRate: 12, second, pan: 2 * random() - 1, tremolo: random() < 0.3 };
    });
    (Object.keys(earcons) as EventKind[]).forEach((event, i) => {
      for (let t = 0.3 + 0.17 * i; t < 10; t += 1.2) steps.push({ at: t, event });
    });
    // As it is, and with a tone ten times too loud: the limiter must hold.
    for (const options of [{ master: 1 }, { master: 1, toneGain: 1, mono: true }]) {
      const [left, right] = await render({ seconds: 10, options, steps });
      const loudest = decibel(Math.max(peak(left), peak(right)));
      expect(loudest).toBeLessThanOrEqual(-6);
      measured(
        "A4",
        `peak ${loudest.toFixed(1)} dBFS${"toneGain" in options ? ", tone ten times too loud" : ""}`,
      );
      expect(peak(left)).toBeGreaterThan("toneGain" in options ? 0.49 : 0.1);
    }
  });

  test("the second sine sounds its own pitch 9 dB below a tone of the same gain", async () => {
    const frame = { ...toneFrame(0.8), second: { hz: 311.7, gain: 0.5 } };
    const [left] = await render(steady(0.9, frame));
    const level = amplitudeAt(part(left, 0.3, 0.8), 311.7);
    // Mono shares the sound between the ears.
    expect(decibel(level / (0.1 * 0.5 * Math.SQRT1_2))).toBeCloseTo(-9, 0);
    const [alone] = await render(steady(0.9, toneFrame(0.8)));
    expect(amplitudeAt(part(alone, 0.3, 0.8), 311.7)).toBeLessThan(level / 20);
  });

  test("A4 the default mix is no louder than -20 dBFS on average", async () => {
    const frame = { ...toneFrame(0), tickRate: 12 };
    const [left, right] = await render(steady(2, frame, {} as typeof loud));

    const level = decibel(Math.max(rms(part(left, 0.5, 2)), rms(part(right, 0.5, 2))));
    expect(level).toBeLessThanOrEqual(-20);
    measured("A4", `default mix ${level.toFixed(1)} dBFS`);
  });

  test("A5 jumps of the value and of the gate make no clicks", async () => {
    const random = numbers(3);
    const us = Array.from({ length: 100 }, random);
    const open = Array.from({ length: 100 }, () => random() < 0.7);
    const steps = frames(0, 10, (t) => {
      const i = Math.floor(t * 10);
      return open[i] ? toneFrame(us[i] ?? 0) : null;
    });
    const [left] = await render({ seconds: 10, options: loud, steps });

    expect(rms(left)).toBeGreaterThan(0.01);
    const clicks = decibel(peak(highPass(left, 12000)));
    expect(clicks).toBeLessThanOrEqual(-80);
    measured("A5", `clicks ${clicks.toFixed(1)} dBFS`);
  });

  test("A7 ticks stand out of the tone in their own band by 10 dB", async () => {
    const [ticks] = await render(steady(1, { tickRate: 8 }));
    const burst = onsets(ticks, 0.05).find((t) => t > 0.4) ?? 0;
    const inBand = (x: Float32Array) => rms(part(bandPass(x), burst, burst + 0.01));
    let least = Number.POSITIVE_INFINITY;
    for (let i = 0; i <= 12; i++) {
      const frame = toneFrame(i / 12);
      // No partial lies higher than 4.2 kHz, so that the band above is the ticks' alone.
      expect((frame.hz ?? 0) * tonePartials.length).toBeLessThanOrEqual(4200);
      const [tone] = await render(steady(1, frame));
      const above = decibel(inBand(ticks) / inBand(tone));
      expect(above, `u ${i / 12}`).toBeGreaterThanOrEqual(10);
      least = Math.min(least, above);
    }
    measured("A7", `least ${least.toFixed(1)} dB`);
  });

  test("A10 release, no value and leaving end in exact silence within 120 ms, stop within 50 ms", async () => {
    const frame = { ...toneFrame(0.3), tickRate: 12 };
    for (const [step, within] of [
      [{ at: 0.6, update: null }, 0.12],
      [{ at: 0.6, update: { ...toneOf(Number.NaN, unit, defaultPitch), tickRate: 0 } }, 0.12],
      [{ at: 0.6, call: "mute" }, 0.12],
      [{ at: 0.6, call: "stop" }, 0.05],
    ] as const) {
      const [left, right] = await render({
        seconds: 1.2,
        options: loud,
        steps: [...frames(0, 0.6, () => frame), step],
      });
      expect(peak(part(left, 0.5, 0.6))).toBeGreaterThan(0.01);
      expect(peak(part(left, 0.6 + 0.003 + within, 1.2))).toBe(0);
      expect(peak(part(right, 0.6 + 0.003 + within, 1.2))).toBe(0);
    }
  });

  test("A5 stopping at once makes no click either", async () => {
    const steps: Step[] = [...frames(0, 0.6, () => toneFrame(0.3)), { at: 0.6, call: "stop" }];
    const [left] = await render({ seconds: 1, options: loud, steps });

    expect(decibel(peak(highPass(left, 12000)))).toBeLessThan(-80);
  });

  test("a page that stops calling falls silent by itself", async () => {
    const frame = { ...toneFrame(0.3), tickRate: 12 };
    const [left] = await render({ seconds: 2, options: loud, steps: frames(0, 0.5, () => frame) });

    expect(peak(part(left, 0.6, 0.9))).toBeGreaterThan(0.01);
    expect(peak(part(left, 1.3, 2))).toBe(0);
  });

  test("A10 mute fades to exact silence and back", async () => {
    const frame = toneFrame(0.5);
    const steps: Step[] = [
      ...frames(0, 1.5, () => frame),
      { at: 0.5, call: "mute" },
      { at: 1, call: "unmute" },
    ];
    const [left] = await render({ seconds: 1.5, options: loud, steps });

    expect(peak(part(left, 0.623, 1))).toBe(0);
    expect(peak(part(left, 1.3, 1.5))).toBeGreaterThan(0.02);
    expect(decibel(peak(highPass(left, 12000)))).toBeLessThan(-80);
  });

  test("A9 both ears: the nearer is louder, the sum stays, mono is bit-equal", async () => {
    const energy = async (pan: number) => {
      const [l, r] = await render(steady(0.7, { ...toneFrame(0.5), pan }, { master: 1 } as typeof loud));
      return [rms(part(l, 0.3, 0.7)) ** 2, rms(part(r, 0.3, 0.7)) ** 2] as const;
    };
    const sums: number[] = [];
    for (const pan of [-1, -0.5, 0, 0.5, 1]) {
      const [l, r] = await energy(pan);
      sums.push(10 * Math.log10(l + r));
      if (pan !== 0) expect(Math.sign(r - l)).toBe(Math.sign(pan));
    }
    const spread = Math.max(...sums) - Math.min(...sums);
    expect(spread).toBeLessThanOrEqual(1.5);
    measured("A9", `energy over azimuth within ${spread.toFixed(2)} dB`);
    const [l, r] = await render(steady(0.7, { ...toneFrame(0.5), tickRate: 8, pan: 0.8 }));
    expect(Buffer.compare(Buffer.from(l.buffer), Buffer.from(r.buffer))).toBe(0);
  });

  test("a tone that rests steps back by 18 dB and returns at once", async () => {
    const frame = toneFrame(0.4);
    const steps = frames(0, 6, (t) => ({ ...frame, still: t > 0.5 && t < 5 }));
    const [left] = await render({ seconds: 6, options: loud, steps });
    const level = (from: number, to: number) => decibel(rms(part(left, from, to)));

    expect(level(4.5, 5) - level(1, 2)).toBeCloseTo(-18, 0);
    expect(level(5.1, 5.5) - level(1, 2)).toBeCloseTo(0, 0);
  });

  test("beyond the limit the tone flutters eight times a second", async () => {
    const [plain] = await render(steady(2, toneFrame(0.5)));
    const [left] = await render(steady(2, { ...toneFrame(0.5), tremolo: true }));
    const levels = (x: Float32Array) =>
      Array.from({ length: 64 }, (_, i) => rms(part(x, 0.8 + i / 64, 0.8 + (i + 1) / 64)));
    const swing = (x: Float32Array) => Math.min(...levels(x)) / Math.max(...levels(x));

    expect(swing(plain)).toBeGreaterThan(0.95);
    expect(swing(left)).toBeLessThan(0.6);
    expect(swing(left)).toBeGreaterThan(0.4);
  });

  test("crossing the limit beeps twice at 1500 Hz over the ducked tone, not again within half a second", async () => {
    const steps: Step[] = [
      { at: 0.5, event: "limitUp" },
      { at: 0.8, event: "limitUp" },
    ];
    const [left] = await render({ seconds: 1.2, options: loud, steps });
    expect(onsets(left, 0.05).length).toBe(2);
    expect(fundamentalOf(part(left, 0.51, 0.55))).toBeCloseTo(1500, -1);
    expect(decibel(amplitudeAt(part(left, 0.515, 0.545), 1500))).toBeCloseTo(-14, 0);
    expect(peak(part(left, 0.75, 1.2))).toBe(0);
  });

  test("an event of less weight gives way to one that sounds", async () => {
    const both: Step[] = [
      { at: 0.5, event: "limitUp" },
      { at: 0.55, event: "noValue" },
    ];
    const [left] = await render({ seconds: 1, options: loud, steps: both });
    const [alone] = await render({ seconds: 1, options: loud, steps: both.slice(0, 1) });

    expect(Buffer.compare(Buffer.from(left.buffer), Buffer.from(alone.buffer))).toBe(0);
  });

  // Real time on a busy machine: a frame that comes half a second late is no fault of the engine.
  test("live: nothing before a gesture, then the pitch of the moment, then silence", {
    retry: 2,
  }, async () => {
    interface Live {
      frame: SoundFrame | null;
      state(): string;
      stop(): void;
      heard(): number[];
    }
    await page.reload();
    const state = await page.evaluate(() => (globalThis as unknown as { live: Live }).live.state());
    expect(state).toBe("suspended");
    await page.mouse.click(5, 5);
    const hear = async (u: number | null) => {
      const frame = u === null ? null : toneFrame(u);
      await page.evaluate((f) => {
        const { live } = globalThis as unknown as { live: Live };
        live.frame = f;
        if (!f) live.stop();
      }, frame);
      await page.waitForTimeout(900);
      const [rate = 0, ...samples] = await page.evaluate(() =>
        (globalThis as unknown as { live: Live }).live.heard(),
      );
      return { rate, samples: Float32Array.from(samples) };
    };
    for (const u of [0.2, 0.9, 0.5]) {
      const { rate, samples } = await hear(u);
      const hz = (fundamental(samples) * rate) / 48000;
      expect(Math.abs(hz / (toneFrame(u).hz ?? 1) - 1), `u ${u}: ${hz} Hz`).toBeLessThan(0.002);
    }
    expect(peak((await hear(null)).samples)).toBe(0);
  });

  test("A12 the same calls give the same samples", async () => {
    const script: Script = {
      seconds: 2,
      options: {},
      steps: frames(0, 2, (t) => ({ ...toneFrame(t / 2), tickRate: 5, pan: Math.sin(t), negative: t > 1 })),
    };
    const [first] = await render(script);
    const [second] = await render(script);

    expect(Buffer.compare(Buffer.from(first.buffer), Buffer.from(second.buffer))).toBe(0);
  });
});

/** Frequency of a pure tone from its zero crossings. */
function fundamentalOf(x: Float32Array): number {
  const crossings: number[] = [];
  for (let i = 1; i < x.length; i++) {
    const [a, b] = [x[i - 1] ?? 0, x[i] ?? 0];
    if (a < 0 && b >= 0) crossings.push(i - 1 + a / (a - b));
  }
  return (48000 * (crossings.length - 1)) / ((crossings.at(-1) ?? 0) - (crossings[0] ?? 0));
}

/** 2.2 to 4.6 kHz. */
function bandPass(x: Float32Array): Float32Array {
  const above = highPass(x, 2200);
  const beyond = highPass(x, 4600);
  return above.map((v, i) => v - (beyond[i] ?? 0));
}
