// SPDX-License-Identifier: Apache-2.0
// The presentation as the page edits it: the JSON document itself, so that unknown keys survive. No DOM.
import type { ColourEffect, PitchEffect, PulseEffect, Rgb, TickEffect, ValueRange } from "../present";
import { differenceResult, type FeelemExtras, type SceneResult } from "../scene";

/** What a result can drive; each has room for one. */
export const SLOTS = ["colour", "pitch", "ticks", "pulses", "shape"] as const;
export type Slot = (typeof SLOTS)[number];

type Json = Record<string, unknown>;
export interface PresentationDoc extends Json {
  results?: Json[];
  effects?: Json[];
  deformation?: Json | null;
}

export type RangeMode = "auto" | "allSteps" | "percentile" | "manual";

/** A result of the presentation, found in the scene. */
export interface Presented {
  readonly key: string;
  readonly name: string;
  readonly component: string;
  readonly unit: string | null;
  /** For people: "von Mises stress". */
  readonly label: string;
  /** Null when the scene has no such result. */
  readonly result: SceneResult | null;
  readonly componentIndex: number;
  readonly rangeMode: RangeMode;
  readonly lo: number | null;
  readonly hi: number | null;
  readonly scale: ValueRange["scale"];
  readonly limit: number | null;
  /** Alarm above the limit, else below. */
  readonly limitIsUpper: boolean;
  readonly limitLabel: string;
}

const SENSE_OF: Record<Exclude<Slot, "shape">, { sense: string; type: string }> = {
  colour: { sense: "visual", type: "colour" },
  pitch: { sense: "audio", type: "pitch" },
  ticks: { sense: "audio", type: "ticks" },
  pulses: { sense: "touch", type: "pulses" },
};
const SCALES: Record<string, ValueRange["scale"]> = {
  lin: "linear",
  linear: "linear",
  log: "log",
  signed: "signed",
  symlog: "symlog",
};

const isObject = (value: unknown): value is Json =>
  typeof value === "object" && value !== null && !Array.isArray(value);
const text = (value: unknown, fallback = "") => (typeof value === "string" ? value : fallback);
const finite = (value: unknown): number | null =>
  typeof value === "number" && Number.isFinite(value) ? value : null;
const number = (value: unknown, fallback: number) => finite(value) ?? fallback;
const pair = (value: unknown, fallback: readonly [number, number]): readonly [number, number] =>
  Array.isArray(value) ? [number(value[0], fallback[0]), number(value[1], fallback[1])] : fallback;

function rgb(value: unknown, fallback: Rgb): Rgb {
  const hex = /^#([0-9a-f]{6})$/i.exec(text(value))?.[1];
  if (!hex) return fallback;
  const bits = Number.parseInt(hex, 16);
  return [bits >> 16, (bits >> 8) & 255, bits & 255];
}

function list(doc: PresentationDoc, key: "results" | "effects"): Json[] {
  const value = doc[key];
  return Array.isArray(value) ? value.filter(isObject) : [];
}

/** Which of several results of one name and component is meant; what is not said is left to the scene. */
export interface Variant {
  readonly averaging?: string;
  readonly layer?: string;
}

/** How well a result is what was meant, as src/convert/scene_target.cpp has it; 0: it is not. */
function fitness(result: SceneResult, wanted: Variant): number {
  if (wanted.layer && result.layer !== wanted.layer) return 0;
  let fits = 1;
  if (result.components.length === 1) fits += 1;
  if (wanted.averaging && result.averaging === wanted.averaging) fits += 2;
  if (!result.layer || wanted.layer) fits += 4;
  if (!result.complex) fits += 8;
  return fits;
}

/** The scene's result that a name and component mean: a scalar of its own before a part of a vector. */
export function findResult(
  extras: FeelemExtras,
  name: string,
  component: string,
  wanted: Variant = {},
): { result: SceneResult; index: number } | null {
  let found: { result: SceneResult; index: number } | null = null;
  let most = 0;
  for (const result of extras.results) {
    if (result.quantity !== name && result.id !== name) continue;
    let index = result.components.indexOf(component);
    if (index < 0 && result.components.length === 1 && component === "value") index = 0;
    const fits = index < 0 ? 0 : fitness(result, wanted);
    if (fits <= most) continue;
    most = fits;
    found = { result, index };
  }
  return found;
}

/** A result minus itself at a step, as an entry's `difference` words it; other viewers know no such name. */
function findDifference(extras: FeelemExtras, difference: Json, component: string, wanted: Variant) {
  const found = findResult(extras, text(difference.name), component, wanted);
  const step = extras.steps.find((s) => s.id === difference.minusStep);
  if (!found || !step) return null;
  const stepName = step.name?.trim() || `step ${(step.number ?? [step.id]).join(".")}`;
  return { result: differenceResult(found.result, step.id, stepName), index: found.index };
}

function labelOf(name: string, component: string, result: SceneResult | null): string {
  if (result?.components.length === 1) return result.name;
  const spelled = (result?.name ?? name).replace(/_/g, " ");
  return component === "value" ? spelled : `${spelled} ${component}`;
}

export function presentedOf(doc: PresentationDoc, extras: FeelemExtras): Presented[] {
  return list(doc, "results").map((entry) => {
    const name = text(entry.name);
    const component = text(entry.component, "value");
    const wanted = { averaging: text(entry.averaging), layer: text(entry.layer) };
    const found = isObject(entry.difference)
      ? findDifference(extras, entry.difference, component, wanted)
      : findResult(extras, name, component, wanted);
    const range = isObject(entry.range) ? entry.range : {};
    const limit = isObject(entry.limit) ? entry.limit : {};
    return {
      key: text(entry.key, name),
      name,
      component,
      // The file's unit; where it has none, the one the presentation declares.
      unit: found?.result.unit || text(entry.unit) || null,
      label: labelOf(name, component, found?.result ?? null),
      result: found?.result ?? null,
      componentIndex: found?.index ?? 0,
      rangeMode: text(range.mode, "auto") as RangeMode,
      lo: finite(range.lo),
      hi: finite(range.hi),
      scale: SCALES[text(range.scale, "lin")] ?? "linear",
      limit: finite(limit.value),
      limitIsUpper: text(limit.kind, "above") !== "below",
      limitLabel: text(limit.label),
    };
  });
}

function effectEntry(doc: PresentationDoc, slot: Slot): Json | null {
  if (slot === "shape") return isObject(doc.deformation) ? doc.deformation : null;
  return list(doc, "effects").find((e) => e.type === SENSE_OF[slot].type) ?? null;
}

/** Key of the result that drives a slot. */
export function drivenBy(doc: PresentationDoc, slot: Slot): string | null {
  return text(effectEntry(doc, slot)?.result) || null;
}

export function slotsOf(doc: PresentationDoc, key: string): Slot[] {
  return SLOTS.filter((slot) => drivenBy(doc, slot) === key);
}

/** The colour effect as the document has it. */
export function colourEntry(doc: PresentationDoc): Json | null {
  return effectEntry(doc, "colour");
}

export function colourEffect(doc: PresentationDoc): ColourEffect | null {
  const entry = effectEntry(doc, "colour");
  if (!entry) return null;
  return {
    map: text(entry.map, "batlow"),
    bands: Math.min(Math.max(Math.round(number(entry.bands, 9)), 0), 64),
    invert: entry.invert === true,
    above: rgb(entry.above, [255, 0, 255]),
    below: rgb(entry.below, [255, 255, 0]),
    missing: rgb(entry.nan, [128, 128, 128]),
  };
}

export function pitchEffect(doc: PresentationDoc): PitchEffect | null {
  const entry = effectEntry(doc, "pitch");
  if (!entry) return null;
  const [midiLow, midiHigh] = pair(entry.midi, [48, 84]);
  const quantise = text(entry.quantise, "none");
  return {
    midiLow,
    midiHigh,
    gamma: number(entry.gamma, 1),
    invert: entry.invert === true,
    quantise: quantise === "semitone" || quantise === "pentatonic" ? quantise : "none",
    signTimbre: entry.signTimbre !== false,
  };
}

export function pulseEffect(doc: PresentationDoc): PulseEffect | null {
  const entry = effectEntry(doc, "pulses");
  if (!entry) return null;
  const [rateLow, rateHigh] = pair(entry.rateHz, [2, 10]);
  return {
    rateLow,
    rateHigh,
    amplitudeMin: number(entry.ampMin, 0.15),
    milliseconds: Math.min(number(entry.pulseMs, 35), 200),
    invert: entry.invert === true,
  };
}

export function tickEffect(doc: PresentationDoc): TickEffect | null {
  return tickEntry(effectEntry(doc, "ticks"));
}

/** Ticks that stand in for pulses where nothing vibrates; null when the presentation wants none. */
export function pulseFallback(doc: PresentationDoc): TickEffect | null {
  const entry = effectEntry(doc, "pulses");
  if (!entry || entry.fallback === null || entry.fallback === false) return null;
  return tickEntry(isObject(entry.fallback) ? entry.fallback : {});
}

function tickEntry(entry: Json | null): TickEffect | null {
  if (!entry) return null;
  const [rateLow, rateHigh] = pair(entry.rateHz, [1.5, 12]);
  return { rateLow, rateHigh, invert: entry.invert === true };
}

/** Lets a result drive a slot; what drove it before drives it no longer. */
export function assign(doc: PresentationDoc, key: string, slot: Slot): PresentationDoc {
  if (slot === "shape")
    return { ...doc, deformation: { ...(isObject(doc.deformation) ? doc.deformation : {}), result: key } };
  const entry = effectEntry(doc, slot);
  const next = { ...(entry ?? SENSE_OF[slot]), result: key };
  const effects = list(doc, "effects");
  return { ...doc, effects: entry ? effects.map((e) => (e === entry ? next : e)) : [...effects, next] };
}

/** Empties a slot; its settings go with it, but for the deformation's. */
export function release(doc: PresentationDoc, slot: Slot): PresentationDoc {
  if (slot === "shape")
    return { ...doc, deformation: { ...(isObject(doc.deformation) ? doc.deformation : {}), result: null } };
  const entry = effectEntry(doc, slot);
  return { ...doc, effects: list(doc, "effects").filter((e) => e !== entry) };
}

function editResult(doc: PresentationDoc, key: string, edit: (entry: Json) => Json): PresentationDoc {
  return {
    ...doc,
    results: list(doc, "results").map((entry) =>
      text(entry.key, text(entry.name)) === key ? edit(entry) : entry,
    ),
  };
}

/** A range typed by the user, or a mode that finds it. */
export function setRange(
  doc: PresentationDoc,
  key: string,
  change: { mode: RangeMode; lo?: number; hi?: number; scale?: string },
): PresentationDoc {
  return editResult(doc, key, (entry) => ({
    ...entry,
    range: { ...(isObject(entry.range) ? entry.range : {}), ...change },
  }));
}

/** What of the colour effect a person changes; the document's own words. */
export interface ColourChange {
  readonly map?: string;
  readonly bands?: number;
  readonly invert?: boolean;
  readonly isolines?: boolean;
  readonly above?: string;
  readonly below?: string;
  readonly nan?: string;
  readonly nanHatch?: boolean;
}

/** Null takes the limit away. */
export function setLimit(
  doc: PresentationDoc,
  key: string,
  limit: { value: number; kind: "above" | "below"; label: string } | null,
): PresentationDoc {
  return editResult(doc, key, (entry) => {
    if (limit) return { ...entry, limit: { ...(isObject(entry.limit) ? entry.limit : {}), ...limit } };
    const { limit: _, ...rest } = entry;
    return rest;
  });
}

export function setColour(doc: PresentationDoc, change: ColourChange): PresentationDoc {
  const entry = effectEntry(doc, "colour");
  return { ...doc, effects: list(doc, "effects").map((e) => (e === entry ? { ...e, ...change } : e)) };
}

/** Another component, averaging or layer of the same quantity; a range that was typed stays typed. */
export function setVariant(
  doc: PresentationDoc,
  key: string,
  change: { component?: string; averaging?: string; layer?: string },
): PresentationDoc {
  return editResult(doc, key, (entry) => ({ ...entry, ...change }));
}

/** What can be chosen of a presented result's quantity: more than one word where there is a choice. */
export interface Choices {
  readonly components: readonly string[];
  readonly averagings: readonly string[];
  readonly layers: readonly string[];
}

export function choicesOf(presented: Presented, extras: FeelemExtras): Choices {
  const now = presented.result;
  if (!now) return { components: [], averagings: [], layers: [] };
  const same = extras.results.filter(
    (r) => r.quantity === now.quantity && (r.complex || "") === (now.complex || ""),
  );
  const alike = same.filter((r) => r.components.includes(presented.component));
  const words = (values: (string | null | undefined)[]) => [
    ...new Set(values.filter((v): v is string => !!v)),
  ];
  return {
    components: words(same.flatMap((r) => r.components)),
    averagings: words(alike.filter((r) => (r.layer ?? null) === (now.layer ?? null)).map((r) => r.averaging)),
    layers: words(alike.map((r) => r.layer)),
  };
}

/** Adds a result of the scene; gives its key. */
export function addResult(
  doc: PresentationDoc,
  result: SceneResult,
  component: string,
): { doc: PresentationDoc; key: string } {
  const taken = new Set(list(doc, "results").map((entry) => text(entry.key)));
  const stem =
    component === "value"
      ? result.id
      : result.components.length === 1
        ? result.id
        : `${result.id}_${component}`;
  let key = stem;
  for (let n = 2; taken.has(key); ++n) key = `${stem}_${n}`;
  const entry = {
    key,
    name: result.quantity ?? result.id,
    component,
    location: result.location,
    ...(result.averaging ? { averaging: result.averaging } : {}),
    ...(result.layer ? { layer: result.layer } : {}),
    unit: result.unit ?? "",
    range: { mode: "auto", lo: null, hi: null, scale: "lin" },
  };
  return { doc: { ...doc, results: [...list(doc, "results"), entry] }, key };
}

/** Adds a shown result minus itself at a step; gives its key. Null when there is no such result. */
export function addDifference(
  doc: PresentationDoc,
  extras: FeelemExtras,
  key: string,
  step: number,
): { doc: PresentationDoc; key: string } | null {
  const of = presentedOf(doc, extras).find((p) => p.key === key);
  if (!of?.result) return null;
  const added = `${key}_minus_${step}`;
  const taken = list(doc, "results").some((entry) => text(entry.key) === added);
  const entry = {
    key: added,
    name: `${of.name} minus step ${step}`,
    component: of.component,
    location: of.result.location,
    // Of the same averaging and layer as what it is the difference of.
    ...(of.result.averaging ? { averaging: of.result.averaging } : {}),
    ...(of.result.layer ? { layer: of.result.layer } : {}),
    unit: of.unit ?? "",
    range: { mode: "auto", lo: null, hi: null, scale: "signed" },
    difference: { name: of.name, minusStep: step },
  };
  return { doc: taken ? doc : { ...doc, results: [...list(doc, "results"), entry] }, key: added };
}

/** Every scalar the scene offers that the presentation does not show. */
export function otherResults(
  doc: PresentationDoc,
  extras: FeelemExtras,
): { result: SceneResult; component: string }[] {
  const shown = presentedOf(doc, extras);
  return extras.results.flatMap((result) =>
    result.components
      .map((component) => ({ result, component }))
      .filter(({ component }) => !shown.some((p) => p.result === result && p.component === component)),
  );
}

/** What a scene without a presentation shows: temperature seen, displacement heard, stress felt. */
export function defaultPresentation(extras: FeelemExtras): PresentationDoc {
  let doc: PresentationDoc = {
    format: "feelem-presentation",
    version: 1,
    title: extras.title ?? "",
    results: [],
    effects: [],
  };
  const wanted: [string, string, Slot][] = [
    ["temperature", "value", "colour"],
    ["displacement", "magnitude", "pitch"],
    ["stress", "von_mises", "pulses"],
  ];
  for (const [name, component, slot] of wanted) {
    const found = findResult(extras, name, component);
    if (!found) continue;
    const added = addResult(doc, found.result, component);
    doc = assign(added.doc, added.key, slot);
    if (name === "displacement") doc = assign(doc, added.key, "shape");
  }
  const first = extras.results[0];
  if (list(doc, "results").length === 0 && first) {
    const added = addResult(doc, first, first.components[0] ?? "value");
    doc = assign(added.doc, added.key, "colour");
  } else if (!drivenBy(doc, "colour")) {
    const key = text(list(doc, "results")[0]?.key);
    if (key) doc = assign(doc, key, "colour");
  }
  return doc;
}
