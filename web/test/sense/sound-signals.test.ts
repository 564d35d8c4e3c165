// SPDX-License-Identifier: Apache-2.0
// The page's sounds are made of what tests/contract/sounds.json says, as the native viewer's are.
import { readFileSync } from "node:fs";
import { expect, test, vi } from "vitest";
import { type EventKind, earcons } from "../../src/sense/earcons";
import { limited, pinkNoise, tickSamples } from "../../src/sense/signals";

interface Sampled {
  count: number;
  samples: [index: number, value: number][];
}
interface Contract {
  tick: Sampled;
  pink: Sampled;
  limited: [x: number, y: number][];
  earcons: {
    event: EventKind;
    weight: number;
    seconds: number;
    decibel: number;
    beeps: { start: number; seconds: number; hz: number }[];
  }[];
}
const path = new URL("../../../tests/contract/sounds.json", import.meta.url);
const contract = JSON.parse(readFileSync(path, "utf8")) as Contract;

function expectSampled(found: Float32Array, wanted: Sampled): void {
  expect(found.length).toBe(wanted.count);
  for (const [i, value] of wanted.samples)
    expect(Math.abs((found[i] ?? Number.NaN) - value)).toBeLessThan(1e-6);
}

/** As much of a context as the signals and earcons ask for: it writes down the tones. */
class Pretended {
  readonly sampleRate = 48000;
  readonly tones: { start: number; stop: number; hz: number; curve: Float32Array }[] = [];
  made = new Float32Array(0);
  createBuffer(): { copyToChannel(samples: Float32Array<ArrayBuffer>): void } {
    return {
      copyToChannel: (samples) => {
        this.made = samples;
      },
    };
  }
}

test("tick, noise and limiter are the contract's", () => {
  expectSampled(tickSamples(48000), contract.tick);
  const context = new Pretended();
  pinkNoise(context as unknown as BaseAudioContext);
  expectSampled(context.made, contract.pink);
  for (const [x, y] of contract.limited) expect(Math.abs(limited(x) - y)).toBeLessThan(1e-9);
});

test("earcons beep when, how long, how high and how loud the contract says", () => {
  const context = new Pretended();
  let curve = new Float32Array(0);
  class Gain {
    readonly gain = {
      setValueCurveAtTime: (values: Float32Array<ArrayBuffer>) => {
        curve = values;
      },
    };
    connect() {}
  }
  class Oscillator {
    readonly #hz: number;
    #start = 0;
    constructor(_: unknown, { frequency }: { frequency: number }) {
      this.#hz = frequency;
    }
    connect(next: unknown) {
      return next;
    }
    start(time: number) {
      this.#start = time;
    }
    stop(time: number) {
      context.tones.push({ start: this.#start, stop: time, hz: this.#hz, curve });
    }
  }
  vi.stubGlobal("GainNode", Gain);
  vi.stubGlobal("OscillatorNode", Oscillator);
  expect(contract.earcons.map((e) => e.event).sort()).toEqual(Object.keys(earcons).sort());
  for (const { event, weight, seconds, decibel, beeps } of contract.earcons) {
    context.tones.length = 0;
    const { play, ...about } = earcons[event];
    play(context as unknown as BaseAudioContext, {} as AudioNode, 0);
    expect(about.weight).toBe(weight);
    expect(about.seconds).toBeCloseTo(seconds, 9);
    expect(context.tones.length).toBe(beeps.length);
    for (const [i, beep] of beeps.entries()) {
      const tone = context.tones[i];
      expect(tone?.start).toBeCloseTo(beep.start, 9);
      expect((tone?.stop ?? 0) - (tone?.start ?? 0)).toBeCloseTo(beep.seconds, 9);
      expect(tone?.hz).toBeCloseTo(beep.hz, 6);
      expect(20 * Math.log10(Math.max(...(tone?.curve ?? [])))).toBeCloseTo(decibel, 4);
    }
  }
  vi.unstubAllGlobals();
});
