// SPDX-License-Identifier: Apache-2.0
// Ranges: the solver's extremes of the step, of all steps, or what was typed.
import { expect, test } from "vitest";
import { type PresentationDoc, presentedOf, setRange } from "../../src/app/presentation-doc";
import { rangeOf, skinRange, statedExtremes } from "../../src/app/ranges";
import { openScene } from "../../src/scene";
import { TINY_PRESENTATION, tinyScene } from "../support/tiny-scene";

const scene = await openScene(tinyScene().glb, () => Promise.reject(new Error("none")));
const doc = TINY_PRESENTATION as unknown as PresentationDoc;
const shown = (d: PresentationDoc, key: string) => presentedOf(d, scene.extras).find((p) => p.key === key)!;

test("automatic_range_follows_the_step", () => {
  expect(rangeOf(shown(doc, "T"), 1, [])).toEqual({ lo: 20, hi: 160, scale: "linear" });
  expect(rangeOf(shown(doc, "T"), 2, [])).toEqual({ lo: 50, hi: 190, scale: "linear" });
});

test("range_over_all_steps_holds_every_step", () => {
  const all = setRange(doc, "T", { mode: "allSteps" });

  expect(rangeOf(shown(all, "T"), 1, [])).toMatchObject({ lo: 20, hi: 190 });
});

test("typed_range_is_taken_as_it_is", () => {
  const typed = setRange(doc, "T", { mode: "manual", lo: 7, hi: 3 });

  expect(rangeOf(shown(typed, "T"), 2, [])).toMatchObject({ lo: 7, hi: 3 });
});

test("range_whose_ends_are_left_open_is_the_results_own", () => {
  for (const mode of ["percentile", "manual"])
    for (const ends of [{}, { lo: 40 }, { hi: 90 }]) {
      const results = doc.results!.map((r) => (r.key === "T" ? { ...r, range: { mode, ...ends } } : r));
      const open = { ...doc, results } as PresentationDoc;

      expect(rangeOf(shown(open, "T"), 2, []), mode).toMatchObject({ lo: 50, hi: 190 });
    }
  const found = setRange(doc, "T", { mode: "percentile", lo: 40, hi: 90 });

  expect(rangeOf(shown(found, "T"), 2, [])).toMatchObject({ lo: 40, hi: 90 });
});

test("component_without_stated_extremes_takes_those_of_the_skin_and_leaves_missing_out", async () => {
  const stress = scene.extras.results.find((r) => r.id === "stress_von_mises")!;
  const vector = scene.extras.results.find((r) => r.id === "displacement")!;

  expect(statedExtremes(vector, 1)).toBeNull();
  expect(skinRange(await scene.loadField(vector, 1), 2)?.lo).toBe(Math.fround(-0.0004 * 120 * 120));
  expect(skinRange(await scene.loadField(stress, 1), 0)?.hi).toBe(361);
});
