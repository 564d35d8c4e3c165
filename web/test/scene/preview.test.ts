// SPDX-License-Identifier: Apache-2.0
// The scene of a shape alone, and the finished scene that takes its place.
import { expect, test } from "vitest";
import { isPreview, onShape, openScene } from "../../src/scene";
import { changedScene, previewOf } from "../support/preview-scene";
import { type TinyOptions, tinyScene } from "../support/tiny-scene";

const noSide = () => Promise.reject(new Error("none"));
const open = (glb: ArrayBuffer) => openScene(glb, noSide);
const both = async (options: TinyOptions = {}, other: TinyOptions = options) => {
  const drawn = await open(previewOf(tinyScene(options).glb));
  const finished = await open(tinyScene(other).glb);
  return { drawn, finished };
};

test("only_a_scene_whose_certificate_says_so_is_a_preview", async () => {
  const { drawn, finished } = await both();
  expect([isPreview(drawn.extras), isPreview(finished.extras)]).toEqual([true, false]);
  expect(isPreview({ version: 1, parts: [], steps: [], results: [] })).toBe(false);
});

test("finished_scene_keeps_the_drawn_parts_and_reads_its_own_results", async () => {
  const { drawn, finished } = await both({ bars: 2 });
  const scene = onShape(drawn, finished);
  expect(scene?.parts).toBe(drawn.parts);
  expect(scene?.extras).toBe(finished.extras);
  const temperature = finished.extras.results.find((r) => r.id === "temperature");
  if (!scene || !temperature) throw new Error("no temperature");
  const fields = await scene.loadField(temperature, 1);
  expect(fields.map((f) => f?.values.length)).toEqual(drawn.parts.map((p) => p.nodeIds.length));
});

test("arrays_that_the_finished_scene_came_with_are_let_go", async () => {
  const { drawn, finished } = await both();
  onShape(drawn, finished);
  await finished.edgesCame;
  await Promise.resolve();
  expect(finished.parts[0]?.positions).toBe(drawn.parts[0]?.positions);
  expect(finished.parts[0]?.indices).toBe(drawn.parts[0]?.indices);
  expect(finished.parts[0]?.edges).toBe(null);
  expect(drawn.parts[0]?.edges).not.toBe(null);
});

test("another_shape_is_refused", async () => {
  const fewer = await both({ cells: [12, 4, 3] }, { cells: [6, 4, 3] });
  expect(onShape(fewer.drawn, fewer.finished)).toBe(null);
  const more = await both({ bars: 1 }, { bars: 2 });
  expect(onShape(more.drawn, more.finished)).toBe(null);
});

test("one_number_that_differs_makes_another_shape", async () => {
  for (const name of ["positions", "indices", "nodeIds", "elementIds"] as const) {
    const { drawn, finished } = await both();
    const array = finished.parts[0]?.[name];
    if (!array) throw new Error(name);
    array[5] = (array[5] ?? 0) + 1;
    expect(onShape(drawn, finished), name).toBe(null);
  }
  const { drawn } = await both();
  const moved = await open(
    changedScene(tinyScene().glb, (extras) => {
      extras.origin = [1, 2, 3];
    }),
  );
  expect(onShape(drawn, moved)).toBe(null);
});
