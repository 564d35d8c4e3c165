// SPDX-License-Identifier: Apache-2.0
// Averagings, layers and components of one quantity are told apart, and switched in the document alone.
import { expect, test } from "vitest";
import { nextOf } from "../../src/app/features/variants";
import {
  addResult,
  choicesOf,
  findResult,
  type PresentationDoc,
  presentedOf,
  setVariant,
} from "../../src/app/presentation-doc";
import type { FeelemExtras, SceneResult } from "../../src/scene";
import { averagingText, originText } from "../../src/ui/variant-list";

function stress(id: string, component: string, more: Partial<SceneResult>): SceneResult {
  const rest = { attribute: `_${id}`, location: "node", unit: "MPa", values: [] };
  return { id, name: id, quantity: "stress", components: [component], ...rest, ...more };
}

const extras: FeelemExtras = {
  version: 1,
  parts: [],
  steps: [],
  results: [
    stress("top", "von_mises", { averaging: "part", layer: "top" }),
    stress("bottom", "von_mises", { averaging: "part", layer: "bottom" }),
    stress("plain", "von_mises", { averaging: "part" }),
    stress("unaveraged", "von_mises", { averaging: "none", location: "element-node" }),
    stress("hoop", "hoop", { averaging: "part", system: "cylindrical:0,0,0,0,0,1" }),
  ],
};
const doc: PresentationDoc = {
  results: [{ key: "S", name: "stress", component: "von_mises", range: { mode: "manual", lo: 0, hi: 9 } }],
};
const shown = (of: PresentationDoc) => presentedOf(of, extras)[0]!;

test("nothing_said_means_no_layer_and_the_first_averaging", () => {
  expect(findResult(extras, "stress", "von_mises")?.result.id).toBe("plain");
  expect(findResult(extras, "stress", "von_mises", { averaging: "none" })?.result.id).toBe("unaveraged");
  expect(findResult(extras, "stress", "von_mises", { layer: "bottom" })?.result.id).toBe("bottom");
  expect(findResult(extras, "stress", "von_mises", { layer: "middle" })).toBeNull();
});

test("choices_are_those_that_the_scene_holds_beside_what_is_shown", () => {
  expect(choicesOf(shown(doc), extras)).toEqual({
    components: ["von_mises", "hoop"],
    averagings: ["part", "none"],
    layers: ["top", "bottom"],
  });
  const hoop = setVariant(doc, "S", { component: "hoop" });
  expect(choicesOf(shown(hoop), extras)).toEqual({
    components: ["von_mises", "hoop"],
    averagings: ["part"],
    layers: [],
  });
});

test("switching_changes_the_result_and_keeps_the_range_that_was_typed", () => {
  const next = setVariant(doc, "S", { averaging: "none" });

  expect(shown(next).result?.id).toBe("unaveraged");
  expect(shown(next)).toMatchObject({ rangeMode: "manual", lo: 0, hi: 9 });
  expect(shown(doc).result?.id).toBe("plain");
});

test("an_added_result_stays_the_one_that_was_added", () => {
  const bottom = extras.results[1]!;
  const added = addResult({ results: [] }, bottom, "von_mises");

  expect(presentedOf(added.doc, extras)[0]?.result).toBe(bottom);
});

test("the_legend_says_where_values_come_from", () => {
  expect(originText(extras.results[4]!)).toBe("at nodes · averaged in parts · about 0,0,0 along 0,0,1");
  expect(originText(extras.results[0]!)).toBe("at nodes · averaged in parts · top");
  expect(originText(null)).toBe("");
  expect(averagingText("none")).toBe("not averaged");
  expect(nextOf(["top", "bottom"], "bottom")).toBe("top");
});
