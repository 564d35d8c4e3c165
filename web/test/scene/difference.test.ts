// SPDX-License-Identifier: Apache-2.0
// The difference of two steps is a result: subtracted value by value, missing where either is.
import { expect, test } from "vitest";
import { addDifference, type PresentationDoc, presentedOf } from "../../src/app/presentation-doc";
import { MISSING, openScene } from "../../src/scene";
import { TINY_PRESENTATION, tinyScene, tinyValues } from "../support/tiny-scene";

const scene = await openScene(tinyScene().glb, () => Promise.reject(new Error("none")));
const doc = TINY_PRESENTATION as unknown as PresentationDoc;
const part = scene.parts[0]!;

test("difference_is_the_shown_step_minus_the_other_and_keeps_what_is_missing", async () => {
  const added = addDifference(doc, scene.extras, "S", 1)!;
  const { result } = presentedOf(added.doc, scene.extras).find((p) => p.key === added.key)!;

  const [field] = await scene.loadField(result!, 2);

  const stress = scene.extras.results.find((r) => r.id === "stress_von_mises")!;
  const plain = await scene.loadField(stress, 2);
  expect([...field!.state]).toEqual([...plain[0]!.state]);
  for (let i = 0; i < part.nodeIds.length; ++i) {
    if (field!.state[i] === MISSING || part.nodeIds[i] === 0) continue;
    const [x, z] = [part.positions[3 * i]!, part.positions[3 * i + 2]!];
    const of = (step: number) => Math.fround(tinyValues.vonMises(x, z, step));
    expect(field!.values[i]).toBe(Math.fround(of(2) - of(1)));
  }
});

test("difference_with_itself_is_zero_and_it_is_added_once", async () => {
  const once = addDifference(doc, scene.extras, "T", 1)!;
  const twice = addDifference(once.doc, scene.extras, "T", 1)!;
  const { result, label } = presentedOf(twice.doc, scene.extras).at(-1)!;

  expect(twice.doc.results).toHaveLength(4);
  expect(label).toBe("Temperature − Bending");
  expect((await scene.loadField(result!, 1))[0]!.values.every((v) => v === 0)).toBe(true);
});

test("other_viewers_find_no_result_of_that_name_rather_than_the_wrong_one", () => {
  const { doc: added } = addDifference(doc, scene.extras, "T", 1)!;
  const entry = added.results!.at(-1)!;

  expect(scene.extras.results.some((r) => r.quantity === entry.name || r.id === entry.name)).toBe(false);
  expect(addDifference(doc, scene.extras, "unknown", 1)).toBeNull();
});
