// SPDX-License-Identifier: Apache-2.0
// A blind listener: a program that gets nothing but the sound, or nothing but the pulses, and says the values of the
// boiler along a hundred rays.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Matrix4, Ray, Vector3 } from "three";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { type PresentationDoc, presentedOf } from "../../src/app/presentation-doc";
import { rangeOf } from "../../src/app/ranges";
import {
  defaultPitch,
  defaultPulses,
  defaultTicks,
  normalise,
  pulseOf,
  tickRateOf,
  toneOf,
  type ValueRange,
} from "../../src/present";
import { Picker, valueAt } from "../../src/probe";
import { openScene } from "../../src/scene";
import { createHaptics } from "../../src/sense";
import { canRender, type Renderer, startRenderer } from "./renderer";
import { numbers } from "./script";
import { fundamental, onsets, part } from "./signal";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const built = ["release", "dev"].map((preset) => join(root, "build", preset, "bin/feelem"));
const program = process.env.FEELEM_BINARY ?? built.find(existsSync);
const boiler = join(root, "examples/boiler/boiler.frd");
const RAYS = 100;

interface Heard {
  readonly range: ValueRange;
  /** Of each ray, where it meets the boiler. */
  readonly values: readonly number[];
}

/** Shoots rays from all sides at the boiler until a hundred of them have met it. */
async function shoot(file: string): Promise<Map<string, Heard>> {
  const bytes = readFileSync(file);
  const folder = join(file, "..");
  const scene = await openScene(
    bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer,
    async (uri) => {
      const side = readFileSync(join(folder, uri));
      return side.buffer.slice(side.byteOffset, side.byteOffset + side.byteLength) as ArrayBuffer;
    },
  );
  const picker = new Picker(scene.parts);
  await picker.build();
  const random = numbers(5);
  const [middle, size] = [new Vector3(1000, 0, 0), 1300];
  const places = [];
  while (places.length < RAYS) {
    const from = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).normalize();
    const aim = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).multiply(
      new Vector3(1900, 900, 900),
    );
    const origin = middle.clone().addScaledVector(from, 2 * size);
    const direction = aim.add(middle).sub(origin).normalize();
    const hit = picker.ray(new Ray(origin, direction), new Matrix4());
    if (hit) places.push(hit);
  }
  const doc = scene.extras.presentation as unknown as PresentationDoc;
  const step = scene.extras.steps[0]?.id ?? 0;
  const out = new Map<string, Heard>();
  for (const shown of presentedOf(doc, scene.extras)) {
    if (!shown.result) continue;
    const fields = await scene.loadField(shown.result, step);
    const values = places.map((place) => {
      const owner = scene.parts[place.part];
      if (!owner) throw new Error("no such part");
      return valueAt(owner, place, fields[place.part] ?? null, shown.componentIndex).value ?? Number.NaN;
    });
    out.set(shown.key, { range: rangeOf(shown, step, fields), values });
  }
  return out;
}

const shareOf = ({ range, values }: Heard, i: number) => normalise(values[i] ?? Number.NaN, range).u;
const least = (u: number) => Math.min(Math.max(u, 0), 1);

describe.skipIf(!canRender || !program || !existsSync(boiler))("blind listener", { timeout: 300_000 }, () => {
  let renderer: Renderer;
  let heard: Map<string, Heard>;
  const of = (key: string) => {
    const found = heard.get(key);
    if (!found) throw new Error(`the boiler shows no ${key}`);
    return found;
  };

  beforeAll(async () => {
    const folder = mkdtempSync(join(tmpdir(), "feelem-blind-"));
    const scene = join(folder, "boiler.glb");
    const present = ["--present", join(root, "examples/boiler/boiler.presentation.json")];
    execFileSync(program ?? "", ["convert", boiler, "-o", scene, "--length-unit", "mm", ...present], {
      stdio: "pipe",
    });
    heard = await shoot(scene);
    rmSync(folder, { recursive: true });
    renderer = await startRenderer();
  }, 300_000);
  afterAll(async () => renderer?.close());

  /** Each value sounds so long, one after the other. */
  const script = (seconds: number, frame: (i: number) => object) => ({
    seconds: RAYS * seconds,
    options: { master: 1, mono: true },
    steps: Array.from({ length: Math.floor(RAYS * seconds * 12) }, (_, n) => ({
      at: n / 12,
      update: frame(Math.min(Math.floor(n / 12 / seconds), RAYS - 1)),
    })),
  });

  test("the values along the rays differ", () => {
    for (const key of ["T", "U", "S"]) expect(new Set(of(key).values).size, key).toBeGreaterThan(50);
  });

  test("pitch alone says the displacement within 2 % of its range", async () => {
    const u = of("U");
    const [sound] = await renderer.render(
      script(0.5, (i) => toneOf(u.values[i] ?? 0, u.range, defaultPitch)),
    );
    let worst = 0;
    for (let i = 0; i < RAYS; ++i) {
      const hz = fundamental(part(sound, 0.5 * i + 0.2, 0.5 * i + 0.48));
      const said = least((12 * Math.log2(hz / 440) + 69 - 48) / 36);
      worst = Math.max(worst, Math.abs(said - shareOf(u, i)));
    }
    console.log(`pitch: worst ${(100 * worst).toFixed(3)} % of the range over ${RAYS} rays`);
    expect(worst).toBeLessThan(0.02);
  });

  test("ticks alone say the stress within one of 36 steps", async () => {
    const s = of("S");
    const seconds = 2.4;
    const [sound] = await renderer.render(
      script(seconds, (i) => ({ tickRate: tickRateOf(s.values[i] ?? 0, s.range, defaultTicks) })),
    );
    const times = onsets(sound, 0.05);
    let worst = 0;
    for (let i = 0; i < RAYS; ++i) {
      // The first beat still belongs to the value before.
      const own = times.filter((t) => t > seconds * i + 0.7 && t < seconds * (i + 1) - 0.02);
      const rate = (own.length - 1) / ((own.at(-1) ?? 0) - (own[0] ?? 0));
      const said = least(Math.log(rate / 1.5) / Math.log(8));
      worst = Math.max(worst, Math.abs(said - shareOf(s, i)));
    }
    console.log(`ticks: worst ${(100 * worst).toFixed(3)} % of the range over ${RAYS} rays`);
    expect(worst).toBeLessThan(1 / 36);
  });

  test("pulses alone say the stress, by strength and by rate, within their steps", () => {
    const s = of("S");
    let [byStrength, byRate] = [0, 0];
    for (let i = 0; i < RAYS; ++i) {
      const felt: { time: number; strength: number }[] = [];
      let now = 0;
      const haptics = createHaptics();
      haptics.setActuator({ pulse: (strength) => felt.push({ time: now, strength }) });
      const frame = pulseOf(s.values[i] ?? 0, s.range, defaultPulses);
      for (let n = 0; n < 5 * 72; ++n) {
        now = n / 72;
        haptics.update(frame);
        haptics.tick(now);
      }
      const span = (felt.at(-1)?.time ?? 0) - (felt[0]?.time ?? 0);
      const rate = (felt.length - 1) / span;
      const strength = felt[2]?.strength ?? 0;
      const u = shareOf(s, i);
      byStrength = Math.max(byStrength, Math.abs(least(1 - Math.log(strength) / Math.log(0.15)) - u));
      byRate = Math.max(byRate, Math.abs(least(Math.log(rate / 2) / Math.log(5)) - u));
    }
    console.log(
      `pulses: worst ${(100 * byStrength).toFixed(3)} % by strength, ${(100 * byRate).toFixed(3)} % by rate`,
    );
    // Seven steps of strength, nine of rate.
    expect(byStrength).toBeLessThan(1 / 7);
    expect(byRate).toBeLessThan(1 / 9);
  });
});
