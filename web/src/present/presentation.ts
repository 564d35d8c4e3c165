// SPDX-License-Identifier: Apache-2.0
// The presentation as typed values; a wrong key is named by its path. Twin of src/present/presentation_json.cpp.
import { colourMaps } from "./colour-map";
import {
  type ColourEffect,
  defaultColour,
  defaultPitch,
  defaultPulses,
  defaultTicks,
  type PitchEffect,
  type PulseEffect,
  type Rgb,
  type Scale,
  type TickEffect,
} from "./types";

export type RangeMode = "auto" | "allSteps" | "percentile" | "manual";

/** What the presentation says of a result. Numbers are in the result's unit. */
export interface PresentedResult {
  readonly key: string;
  readonly name: string;
  readonly component: string;
  readonly location: string;
  readonly averaging: string;
  readonly unit: string;
  readonly rangeMode: RangeMode;
  readonly lo: number | null;
  readonly hi: number | null;
  readonly scale: Scale;
  readonly symmetric: boolean;
  readonly percentile: readonly [number, number];
  readonly limit: { readonly value: number; readonly kind: "above" | "below"; readonly label: string } | null;
}

export type PresentedEffect = { readonly result: string } & (
  | { readonly type: "colour"; readonly colour: ColourEffect }
  | { readonly type: "pitch"; readonly pitch: PitchEffect }
  | { readonly type: "ticks"; readonly ticks: TickEffect }
  | { readonly type: "pulses"; readonly pulses: PulseEffect; readonly fallback: TickEffect | null }
  | { readonly type: "shape" }
);

export interface Presentation {
  readonly title: string;
  readonly results: readonly PresentedResult[];
  readonly effects: readonly PresentedEffect[];
  readonly card: readonly string[];
  /** Key; null: none. */
  readonly deformation: string | null;
  /** Null: 5 % of the largest side. */
  readonly deformationFactor: number | null;
  readonly step: { readonly input: number; readonly step: number; readonly substep: number } | null;
}

/** What is wrong in a presentation, and where: "effects[1].result". */
export class PresentationError extends Error {
  readonly path: string;
  constructor(path: string, text: string) {
    super(path ? `${path}: ${text}` : text);
    this.name = "PresentationError";
    this.path = path;
  }
}

const scales: Readonly<Record<string, Scale>> = {
  lin: "linear",
  log: "log",
  signed: "signed",
  symlog: "symlog",
};
const senseOf = {
  colour: "visual",
  pitch: "audio",
  ticks: "audio",
  pulses: "touch",
  shape: "visual",
} as const;
type EffectType = keyof typeof senseOf;
const rangeModes = ["auto", "allSteps", "percentile", "manual"] as const;
const maxItems = 1000;

function kindOf(value: unknown): string {
  if (value === null || value === undefined) return "null";
  return Array.isArray(value) ? "array" : typeof value;
}

/** A value of the document and where it stands; reading a wrong one throws. */
class Node {
  readonly #value: unknown;
  readonly #path: string;

  constructor(value: unknown, path = "") {
    this.#value = value;
    this.#path = path;
  }

  fail(text: string): never {
    throw new PresentationError(this.#path, text);
  }
  /** Not there at all; `missing` also when it is null. */
  get absent(): boolean {
    return this.#value === undefined;
  }
  get missing(): boolean {
    return this.#value === undefined || this.#value === null;
  }

  at(key: string): Node {
    if (!this.missing && kindOf(this.#value) !== "object") {
      this.fail(`expected an object, found ${kindOf(this.#value)}`);
    }
    const object = (this.#value ?? {}) as Record<string, unknown>;
    const value = Object.hasOwn(object, key) ? object[key] : undefined;
    return new Node(value, this.#path ? `${this.#path}.${key}` : key);
  }
  items(): Node[] {
    if (this.missing) return [];
    if (!Array.isArray(this.#value) || this.#value.length > maxItems) {
      return this.fail(`expected an array of at most ${maxItems} items, found ${kindOf(this.#value)}`);
    }
    return this.#value.map((value, i) => new Node(value, `${this.#path}[${i}]`));
  }
  text(fallback = ""): string {
    if (this.missing) return fallback;
    if (typeof this.#value !== "string") return this.fail(`expected a text, found ${kindOf(this.#value)}`);
    return this.#value;
  }
  flag(fallback: boolean): boolean {
    if (this.missing) return fallback;
    if (typeof this.#value !== "boolean") {
      return this.fail(`expected true or false, found ${kindOf(this.#value)}`);
    }
    return this.#value;
  }
  number(lowest = Number.NEGATIVE_INFINITY, highest = Number.POSITIVE_INFINITY): number | null {
    if (this.missing) return null;
    const value = this.#value;
    if (typeof value !== "number" || !Number.isFinite(value)) {
      return this.fail(`expected a number, found ${kindOf(value)}`);
    }
    if (value < lowest || value > highest) this.fail(`${value} is not within ${lowest} to ${highest}`);
    return value;
  }
  integer(fallback: number, lowest: number, highest: number): number {
    const value = this.number(lowest, highest) ?? fallback;
    return Number.isInteger(value) ? value : this.fail(`expected a whole number, found ${value}`);
  }
  pair(fallback: readonly [number, number], lowest: number, highest: number): readonly [number, number] {
    if (this.missing) return fallback;
    const [first, second, ...more] = this.items();
    if (!first || !second || more.length > 0) return this.fail("expected two numbers");
    const low = first.number(lowest, highest) ?? fallback[0];
    const high = second.number(lowest, highest) ?? fallback[1];
    if (!(low < high))
      this.fail(`${low} must be less than ${high}; to turn the direction round use "invert"`);
    return [low, high];
  }
  word<Word extends string>(words: readonly Word[], fallback: Word): Word {
    if (this.missing) return fallback;
    const found = this.text();
    return words.find((w) => w === found) ?? this.fail(`'${found}' is none of: ${words.join(" ")}`);
  }
  colour(fallback: Rgb): Rgb {
    if (this.missing) return fallback;
    const hex = /^#([0-9a-f]{6})$/i.exec(this.text())?.[1];
    if (!hex) return this.fail(`expected a colour like #ff00ff, found '${this.text()}'`);
    const bits = Number.parseInt(hex, 16);
    return [bits >> 16, (bits >> 8) & 255, bits & 255];
  }
}

function readResult(node: Node): PresentedResult {
  const key = node.at("key").text();
  const name = node.at("name").text();
  if (!key) node.at("key").fail('every result needs a key, a short name of its own like "T"');
  if (!name) node.at("name").fail('every result needs a name, like "temperature"');
  const range = node.at("range");
  const limit = node.at("limit");
  const value = limit.at("value").number();
  const result: PresentedResult = {
    key,
    name,
    component: node.at("component").text("value"),
    location: node.at("location").text("nodal"),
    averaging: node.at("averaging").text(),
    unit: node.at("unit").text(),
    rangeMode: range.at("mode").word(rangeModes, "auto"),
    scale: scales[range.at("scale").word(Object.keys(scales), "lin")] ?? "linear",
    symmetric: range.at("symmetric").flag(false),
    percentile: range.at("p").pair([0.5, 99.5], 0, 100),
    lo: range.at("lo").number(),
    hi: range.at("hi").number(),
    limit:
      value === null
        ? null
        : {
            value,
            kind: limit.at("kind").word(["above", "below"], "above"),
            label: limit.at("label").text(),
          },
  };
  if (result.rangeMode === "manual" && (result.lo === null || result.hi === null)) {
    range.fail("a manual range needs lo and hi");
  }
  if (result.lo !== null && result.hi !== null && result.lo > result.hi) {
    range.fail(`lo ${result.lo} is above hi ${result.hi}`);
  }
  return result;
}

function readTicks(node: Node): TickEffect {
  const { rateLow, rateHigh } = defaultTicks;
  const [low, high] = node.at("rateHz").pair([rateLow, rateHigh], 0.1, 12.5);
  return { rateLow: low, rateHigh: high, invert: node.at("invert").flag(false) };
}

function readPulses(node: Node): PulseEffect {
  const { rateLow, rateHigh, amplitudeMin, milliseconds } = defaultPulses;
  const [low, high] = node.at("rateHz").pair([rateLow, rateHigh], 0.1, 12.5);
  return {
    rateLow: low,
    rateHigh: high,
    amplitudeMin: node.at("ampMin").number(0.01, 1) ?? amplitudeMin,
    milliseconds: node.at("pulseMs").number(5, 200) ?? milliseconds,
    invert: node.at("invert").flag(false),
  };
}

function readPitch(node: Node): PitchEffect {
  const [midiLow, midiHigh] = node.at("midi").pair([defaultPitch.midiLow, defaultPitch.midiHigh], 0, 127);
  return {
    midiLow,
    midiHigh,
    gamma: node.at("gamma").number(0.5, 2) ?? defaultPitch.gamma,
    invert: node.at("invert").flag(false),
    quantise: node.at("quantise").word(["none", "semitone", "pentatonic"], "none"),
    signTimbre: node.at("signTimbre").flag(true),
  };
}

function readColour(node: Node): ColourEffect {
  return {
    map: node.at("map").word(colourMaps(), defaultColour.map),
    bands: node.at("bands").integer(defaultColour.bands, 0, 100),
    invert: node.at("invert").flag(false),
    above: node.at("above").colour(defaultColour.above),
    below: node.at("below").colour(defaultColour.below),
    missing: node.at("nan").colour(defaultColour.missing),
  };
}

function readEffect(node: Node): PresentedEffect {
  const result = node.at("result").text();
  const types = Object.keys(senseOf) as EffectType[];
  if (node.at("type").missing) node.at("type").fail(`an effect needs a type, one of: ${types.join(" ")}`);
  const type = node.at("type").word(types, "colour");
  const sense = node.at("sense").text(senseOf[type]);
  if (sense !== senseOf[type])
    node.at("sense").fail(`'${type}' is of sense '${senseOf[type]}', not '${sense}'`);
  switch (type) {
    case "colour":
      return { result, type, colour: readColour(node) };
    case "pitch":
      return { result, type, pitch: readPitch(node) };
    case "ticks":
      return { result, type, ticks: readTicks(node) };
    case "pulses": {
      const fallback = node.at("fallback");
      fallback.at("type").word(["ticks"], "ticks");
      const ticks = readTicks(fallback);
      return {
        result,
        type,
        pulses: readPulses(node),
        fallback: fallback.absent || !fallback.missing ? ticks : null,
      };
    }
    case "shape":
      return { result, type };
  }
}

/** The result that a key of the document names. */
function named(results: readonly PresentedResult[], key: Node): PresentedResult {
  const wanted = key.text();
  return results.find((r) => r.key === wanted) ?? key.fail(`no result has the key '${wanted}'`);
}

/** One result a sense, signed results without a rate, and limits that can be told apart. */
function checkRules(
  root: Node,
  results: readonly PresentedResult[],
  effects: readonly PresentedEffect[],
): void {
  root
    .at("effects")
    .items()
    .forEach((node, i) => {
      const type = effects[i]?.type;
      const { scale } = named(results, node.at("result"));
      const other = effects.findIndex((e) => e.type === type);
      if (other < i) node.at("type").fail(`effects[${other}] already uses '${type}'; one result at a time`);
      if (scale === "signed" && (type === "ticks" || type === "pulses")) {
        node.at("type").fail("a signed result cannot be told by a rate; give it colour or pitch");
      }
    });
  root
    .at("results")
    .items()
    .forEach((node, i) => {
      for (const [j, other] of results.slice(0, i).entries()) {
        const one = results[i];
        if (one?.key === other.key) node.at("key").fail(`results[${j}] already has the key '${other.key}'`);
        if (one?.limit && other.limit?.label === one.limit.label) {
          node.at("limit").fail(`results[${j}] has a limit of the same label '${one.limit.label}'`);
        }
      }
    });
}

/** Reads a document as JSON.parse gives it. Throws PresentationError. */
export function parsePresentation(document: unknown): Presentation {
  const root = new Node(document);
  if (kindOf(document) !== "object") root.fail(`expected an object, found ${kindOf(document)}`);
  const format = root.at("format").text("feelem-presentation");
  if (format !== "feelem-presentation")
    root.at("format").fail(`expected feelem-presentation, found '${format}'`);
  const version = root.at("version").integer(1, 1, 1e6);
  if (version !== 1) root.at("version").fail(`this program reads version 1, found ${version}`);
  const title = root.at("title").text();
  const step = root.at("step");
  const shownStep = step.missing
    ? null
    : {
        input: step.at("input").integer(0, 0, 1e9),
        step: step.at("step").integer(1, -1e9, 1e9),
        substep: step.at("substep").integer(1, -1e9, 1e9),
      };
  const results = root.at("results").items().map(readResult);
  const effects = root.at("effects").items().map(readEffect);
  checkRules(root, results, effects);
  const card = root.at("probe").at("card").items();
  const deformation = root.at("deformation");
  const mode = deformation.at("mode").word(["auto5percent", "manual", "none"], "auto5percent");
  const factor = deformation.at("factor").number();
  const shape = deformation.at("result");
  const presentation: Presentation = {
    title,
    results,
    effects,
    card: card.map((node) => named(results, node).key),
    deformation: shape.missing || mode === "none" ? null : named(results, shape).key,
    deformationFactor: factor,
    step: shownStep,
  };
  if (mode === "manual" && factor === null)
    deformation.at("factor").fail("a manual deformation needs a factor");
  return presentation;
}
