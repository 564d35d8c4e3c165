// SPDX-License-Identifier: Apache-2.0
// Which result drives which sense when nobody has said so. Twin of src/present/choose.cpp.
import type { Scale } from "./types";

/** One result that could be shown. */
export interface Candidate {
  /** "temperature" */
  readonly name: string;
  /** "value", "magnitude", "von_mises" */
  readonly component: string;
  readonly unit?: string | null;
  /** Values on both sides of zero. */
  readonly hasSign?: boolean;
  /** More than half of the values are exactly zero. */
  readonly mostlyZero?: boolean;
}

export type Slot = "colour" | "pitch" | "ticks" | "pulses";

export interface ChosenResult {
  readonly key: string;
  readonly candidate: Candidate;
  readonly rangeMode: "auto" | "percentile";
  readonly scale: Scale;
  readonly symmetric: boolean;
}
export interface ChosenEffect {
  readonly result: string;
  readonly slot: Slot;
  /** Colour only. */
  readonly map?: string;
  readonly invert: boolean;
}
export interface Choice {
  readonly results: readonly ChosenResult[];
  readonly effects: readonly ChosenEffect[];
  /** Key of the result that drives the shape. */
  readonly deformation: string | null;
}

interface Kind {
  readonly names: string;
  readonly components: string;
  readonly key: string;
  /** In order of preference. */
  readonly slots: readonly Slot[];
  /** p: range by percentile; s: the sign has a meaning; c: it is seen rather than anything below it. */
  readonly marks: string;
}
const kind = (names: string, components: string, key: string, slots: string, marks: string): Kind => ({
  names,
  components,
  key,
  slots: slots.split(" ") as Slot[],
  marks,
});
/** In order of importance; empty names or components mean any. */
const kinds: readonly Kind[] = [
  kind("temperature", "", "T", "colour pitch pulses", "c"),
  kind("displacement", "magnitude", "U", "pitch ticks colour", ""),
  kind("stress", "von_mises tresca", "S", "pulses ticks colour", "pc"),
  kind("utilisation", "", "UT", "ticks pulses colour", "c"),
  kind("safety_factor", "", "SF", "ticks pulses colour", "c"),
  kind("plastic_strain", "equivalent von_mises value", "PE", "ticks pulses colour", "pc"),
  kind("damage", "", "D", "ticks pulses colour", "c"),
  kind("contact_pressure", "", "CP", "pulses ticks colour", "pc"),
  kind("pressure", "", "P", "pitch colour", "sc"),
  kind("stress", "principal_1", "S", "pitch colour", "psc"),
  kind("stress", "", "S", "pitch colour", "psc"),
  kind("heat_flux", "magnitude", "Q", "ticks pitch colour", "pc"),
  kind("velocity acceleration", "magnitude", "", "ticks pitch colour", "c"),
  kind("electric_potential", "", "EP", "pitch colour", "sc"),
  kind("strain elastic_strain", "equivalent von_mises", "E", "pulses ticks colour", "pc"),
  kind("displacement", "", "U", "pitch colour", "s"),
  kind("", "magnitude", "", "ticks pitch colour", "c"),
  kind("", "value", "", "pitch colour", "sc"),
  kind("", "", "", "pitch colour", "psc"),
];
/** Ids and measures of the model itself: never a sound. */
const seenOnly = ["material", "part", "id", "status", "thickness", "density"];
const maxResults = 4;

interface Pick {
  readonly candidate: Candidate;
  readonly kind: number;
  readonly seenOnly: boolean;
}

const baseName = (candidate: Candidate) => candidate.name.split("@", 1)[0] ?? "";
const lists = (words: string, word: string) => words === "" || words.split(" ").includes(word);

function pickOf(candidate: Candidate): Pick {
  const name = baseName(candidate);
  return {
    candidate,
    kind: kinds.findIndex((k) => lists(k.names, name) && lists(k.components, candidate.component)),
    seenOnly: seenOnly.includes(name) || name.endsWith("_id") || name.endsWith("_status"),
  };
}

/** One a result name, the most telling first. */
function mostTelling(candidates: readonly Candidate[]): Pick[] {
  const byName = new Map<string, Pick>();
  for (const candidate of candidates) {
    const pick = pickOf(candidate);
    const same = byName.get(candidate.name);
    if (!same || pick.kind < same.kind) byName.set(candidate.name, pick);
  }
  const order = (p: Pick) => (p.seenOnly ? kinds.length : 0) + p.kind;
  return [...byName.values()].sort((a, b) => order(a) - order(b)).slice(0, maxResults);
}

const kindOf = (pick: Pick): Kind => kinds[pick.kind] as Kind;

function keyFor(pick: Pick, taken: readonly ChosenResult[]): string {
  const first = baseName(pick.candidate)[0] ?? "";
  const stem = kindOf(pick).key || (first >= "a" && first <= "z" ? first.toUpperCase() : "R");
  let key = stem;
  for (let number = 2; taken.some((r) => r.key === key); number++) key = stem + number;
  return key;
}

function resultFor(pick: Pick, taken: readonly ChosenResult[]): ChosenResult {
  const { marks } = kindOf(pick);
  const isSigned = marks.includes("s") && pick.candidate.hasSign === true;
  return {
    key: keyFor(pick, taken),
    candidate: pick.candidate,
    rangeMode: marks.includes("p") ? "percentile" : "auto",
    scale: isSigned ? "signed" : "linear",
    symmetric: isSigned,
  };
}

function effectFor(result: ChosenResult, slot: Slot): ChosenEffect {
  const effect = {
    result: result.key,
    slot,
    invert: slot !== "pitch" && result.candidate.name === "safety_factor",
  };
  return slot === "colour" ? { ...effect, map: result.scale === "signed" ? "cool_warm" : "batlow" } : effect;
}

/** Best first: signed results have no rate, mostly-zero ones prefer one, ids have colour only. */
function slotsFor(pick: Pick, result: ChosenResult): readonly Slot[] {
  if (pick.seenOnly) return ["colour"];
  const isRate = (slot: Slot) => slot === "ticks" || slot === "pulses";
  const { slots } = kindOf(pick);
  if (result.scale === "signed") return slots.filter((s) => !isRate(s));
  return pick.candidate.mostlyZero ? ["ticks", "pulses", ...slots.filter((s) => !isRate(s))] : slots;
}

/** Effects for the one to four most telling candidates; displacement also drives the shape. */
export function choosePresentation(candidates: readonly Candidate[]): Choice {
  const picks = mostTelling(candidates);
  const results: ChosenResult[] = [];
  for (const pick of picks) results.push(resultFor(pick, results));
  const shape = picks.findIndex((p) => baseName(p.candidate) === "displacement");
  const deformation = results[shape]?.key ?? null;
  const wantsColour = (p: Pick) => kindOf(p).marks.includes("c") && !p.seenOnly && !p.candidate.mostlyZero;
  const seen = Math.max(picks.findIndex(wantsColour), 0);
  const shown = results[seen];
  if (!shown) return { results, effects: [], deformation };

  const effects = [effectFor(shown, "colour")];
  picks.forEach((pick, i) => {
    const result = results[i];
    if (!result || i === seen) return;
    const slot = slotsFor(pick, result).find((s) => effects.every((e) => e.slot !== s));
    if (slot) effects.push(effectFor(result, slot));
  });
  // A single result is heard as well as seen.
  if (picks.length === 1 && !picks[0]?.seenOnly) effects.push(effectFor(shown, "pitch"));
  return { results, effects, deformation };
}
