// SPDX-License-Identifier: Apache-2.0
// The page maps values as C++ does: every vector of tests/contract/senses.json.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import {
  automaticDeformationFactor,
  type Candidate,
  choosePresentation,
  colourMaps,
  colourOf,
  defaultColour,
  defaultPitch,
  defaultPulses,
  normalise,
  pulseOf,
  type Quantise,
  tickRateOf,
  toneOf,
  type ValueRange,
} from "../../src/present";

interface Vector {
  value: number | null;
  range: ValueRange;
}
interface Contract {
  normalise: (Vector & {
    u: number;
    position: number;
    sign: number;
    below: boolean;
    above: boolean;
    missing: boolean;
  })[];
  colour: (Vector & { map: string; bands: number; invert: boolean; colour: [number, number, number] })[];
  tone: (Vector & {
    midi: [number, number];
    gamma: number;
    invert: boolean;
    quantise: Quantise;
    signTimbre: boolean;
    hz: number;
    gain: number;
    negative: boolean;
  })[];
  ticks: (Vector & { rateHz: [number, number]; invert: boolean; tickRate: number })[];
  pulses: (Vector & {
    rateHz: [number, number];
    ampMin: number;
    invert: boolean;
    rate: number;
    amplitude: number;
  })[];
  deformation: { largestSide: number; largestDisplacement: number; factor: number }[];
}

const path = new URL("../../../tests/contract/senses.json", import.meta.url);
const contract = JSON.parse(readFileSync(path, "utf8")) as Contract;
const numberOf = (vector: Vector) => vector.value ?? Number.NaN;

/** Far nearer than any sense can tell: only the last digits of powers and logarithms may differ. */
function expectClose(found: number, wanted: number, what: unknown) {
  const error = Math.abs(found - wanted) / (Math.abs(wanted) || 1);
  expect(error, `${found} instead of ${wanted}: ${JSON.stringify(what)}`).toBeLessThanOrEqual(1e-12);
}

test("the contract has vectors of every kind", () => {
  expect(contract.normalise.length).toBeGreaterThan(60);
  expect(new Set(contract.colour.map((v) => v.map))).toEqual(new Set(colourMaps()));
  expect(contract.tone.length).toBe(5 * contract.normalise.length);
});

test("values lie where the contract says", () => {
  for (const v of contract.normalise) {
    const place = normalise(numberOf(v), v.range);
    expectClose(place.u, v.u, v);
    expectClose(place.position, v.position, v);
    expect([place.sign, place.below, place.above, place.missing]).toEqual([
      v.sign,
      v.below,
      v.above,
      v.missing,
    ]);
  }
});

test("colours are the contract's, bit for bit", () => {
  for (const v of contract.colour) {
    const effect = { ...defaultColour, map: v.map, bands: v.bands, invert: v.invert };
    expect(colourOf(numberOf(v), v.range, effect), JSON.stringify(v)).toEqual(v.colour);
  }
});

test("tones are the contract's", () => {
  for (const v of contract.tone) {
    const { gamma, invert, quantise, signTimbre } = v;
    const [midiLow, midiHigh] = v.midi;
    const tone = toneOf(numberOf(v), v.range, {
      ...defaultPitch,
      midiLow,
      midiHigh,
      gamma,
      invert,
      quantise,
      signTimbre,
    });
    expectClose(tone.hz, v.hz, v);
    expectClose(tone.gain, v.gain, v);
    expect(tone.negative).toBe(v.negative);
  }
});

test("tick rates are the contract's", () => {
  for (const v of contract.ticks) {
    const [rateLow, rateHigh] = v.rateHz;
    expectClose(tickRateOf(numberOf(v), v.range, { rateLow, rateHigh, invert: v.invert }), v.tickRate, v);
  }
});

test("pulses are the contract's", () => {
  for (const v of contract.pulses) {
    const [rateLow, rateHigh] = v.rateHz;
    const effect = { ...defaultPulses, rateLow, rateHigh, amplitudeMin: v.ampMin, invert: v.invert };
    const pulse = pulseOf(numberOf(v), v.range, effect);
    expectClose(pulse.rate, v.rate, v);
    expectClose(pulse.amplitude, v.amplitude, v);
  }
});

test("deformation factors are the contract's", () => {
  for (const v of contract.deformation) {
    expectClose(automaticDeformationFactor(v.largestSide, v.largestDisplacement), v.factor, v);
  }
});

interface ChoiceVector {
  candidates: Candidate[];
  results: { key: string; name: string; component: string; rangeMode: string; scale: string }[];
  effects: { result: string; slot: string; map: string; invert: boolean }[];
  deformation: string;
}

test("results are chosen and assigned as the contract says", () => {
  const choices = new URL("../../../tests/contract/choose.json", import.meta.url);
  const vectors = JSON.parse(readFileSync(choices, "utf8")) as ChoiceVector[];
  expect(vectors.length).toBeGreaterThan(100);
  for (const v of vectors) {
    const choice = choosePresentation(v.candidates);
    const results = choice.results.map(({ key, candidate: { name, component }, rangeMode, scale }) => {
      return { key, name, component, rangeMode, scale };
    });
    const effects = choice.effects.map((e) => ({ ...e, map: e.map ?? "" }));
    expect(results).toEqual(v.results);
    expect(effects).toEqual(v.effects);
    expect(choice.deformation ?? "").toBe(v.deformation);
  }
});
