// SPDX-License-Identifier: Apache-2.0
// The presentation is edited as the document it is: one result a slot, unknown keys survive.
import { expect, test } from "vitest";
import {
  addResult,
  assign,
  colourEffect,
  defaultPresentation,
  drivenBy,
  findResult,
  otherResults,
  type PresentationDoc,
  presentedOf,
  pulseFallback,
  release,
  setColour,
  setLimit,
  setRange,
  slotsOf,
} from "../../src/app/presentation-doc";
import { openScene } from "../../src/scene";
import { TINY_PRESENTATION, tinyScene } from "../support/tiny-scene";

const extras = (await openScene(tinyScene().glb, () => Promise.reject(new Error("none")))).extras;
const doc = TINY_PRESENTATION as unknown as PresentationDoc;

test("results_are_found_as_scalars_of_their_own_before_parts_of_vectors", () => {
  expect(findResult(extras, "displacement", "magnitude")?.result.id).toBe("displacement_magnitude");
  expect(findResult(extras, "displacement", "y")).toMatchObject({ index: 1 });
  expect(findResult(extras, "velocity", "x")).toBeNull();
});

test("assigning_moves_the_slot_and_keeps_its_settings_and_every_unknown_key", () => {
  const strange = { ...doc, later: { kept: [1, 2] } } as PresentationDoc;

  const next = assign(strange, "S", "colour");

  expect(drivenBy(next, "colour")).toBe("S");
  expect(next.effects?.filter((e) => e.type === "colour")).toHaveLength(1);
  expect(colourEffect(next)?.map).toBe("batlow");
  expect(next.later).toEqual({ kept: [1, 2] });
  expect(drivenBy(doc, "colour")).toBe("T");
});

test("one_result_may_have_several_slots_and_off_empties_them", () => {
  expect(slotsOf(doc, "U")).toEqual(["pitch", "shape"]);

  const off = slotsOf(doc, "U").reduce((d, slot) => release(d, slot), doc);

  expect(slotsOf(off, "U")).toEqual([]);
  expect(slotsOf(off, "T")).toEqual(["colour"]);
});

test("typed_range_and_bands_are_written_into_the_document", () => {
  const next = setColour(setRange(doc, "T", { mode: "manual", lo: -5, hi: 5 }), { bands: 7, invert: true });

  expect(presentedOf(next, extras)[0]).toMatchObject({ rangeMode: "manual", lo: -5, hi: 5 });
  expect(colourEffect(next)).toMatchObject({ bands: 7, invert: true });
});

test("added_results_get_keys_of_their_own_and_leave_the_others", () => {
  const result = extras.results.find((r) => r.id === "displacement")!;
  const before = otherResults(doc, extras).length;

  const first = addResult(doc, result, "x");
  const second = addResult(first.doc, result, "x");

  expect(first.key).toBe("displacement_x");
  expect(second.key).toBe("displacement_x_2");
  expect(otherResults(first.doc, extras)).toHaveLength(before - 1);
});

test("unit_is_the_files_and_else_the_one_the_presentation_declares", () => {
  const bare = { ...extras, results: extras.results.map((r) => ({ ...r, unit: null })) };

  expect(presentedOf(doc, extras)[0]?.unit).toBe("degC");
  expect(presentedOf(doc, bare)[0]?.unit).toBe("degC");
  expect(presentedOf({ results: [{ key: "T", name: "temperature" }] }, bare)[0]?.unit).toBeNull();
});

test("scene_without_presentation_is_seen_heard_and_felt", () => {
  const made = defaultPresentation(extras);
  const names = (["colour", "pitch", "pulses", "shape"] as const).map(
    (slot) => presentedOf(made, extras).find((p) => p.key === drivenBy(made, slot))?.result?.id,
  );

  expect(names).toEqual([
    "temperature",
    "displacement_magnitude",
    "stress_von_mises",
    "displacement_magnitude",
  ]);
});

test("odd_documents_give_defaults_and_no_crash", () => {
  const odd = {
    results: [null, { key: 5, range: "x", limit: 7 }],
    effects: [{ type: "colour", bands: "many", above: "red" }, 3],
  };

  expect(presentedOf(odd as unknown as PresentationDoc, extras)).toHaveLength(1);
  expect(colourEffect(odd as unknown as PresentationDoc)).toMatchObject({ bands: 9, above: [255, 0, 255] });
});

test("pulses_fall_back_to_ticks_unless_the_document_says_no", () => {
  const none = { ...doc, effects: [{ type: "pulses", result: "S", fallback: null }] } as PresentationDoc;

  expect(pulseFallback(doc)).toEqual({ rateLow: 1.5, rateHigh: 12, invert: false });
  expect(pulseFallback(none)).toBeNull();
});

test("a_limit_is_written_beside_what_else_the_document_says_of_it_and_taken_away_whole", () => {
  const noted = {
    ...doc,
    results: [{ key: "S", name: "stress", component: "von_mises", limit: { value: 300, note: "S235" } }],
  } as PresentationDoc;

  const set = setLimit(noted, "S", { value: 235, kind: "below", label: "yield" });

  expect(presentedOf(set, extras)[0]).toMatchObject({ limit: 235, limitIsUpper: false, limitLabel: "yield" });
  expect(set.results?.[0]?.limit).toMatchObject({ note: "S235" });
  expect("limit" in (setLimit(set, "S", null).results?.[0] ?? {})).toBe(false);
});
