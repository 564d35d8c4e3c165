// SPDX-License-Identifier: Apache-2.0
// Whether a part encloses a volume, by its edges.
import { expect, test } from "vitest";
import { openEdges } from "../../src/render/open-edges";
import { openScene, type ScenePart } from "../../src/scene";
import { tinyScene } from "../support/tiny-scene";

const open = async (bars = 1) =>
  (await openScene(tinyScene({ bars }).glb, () => Promise.reject(new Error("none")))).parts;

const without = (part: ScenePart, triangles: number): ScenePart => ({
  ...part,
  indices: part.indices.slice(0, part.indices.length - 3 * triangles),
});

test("edges_of_a_bar_cancel_and_those_of_an_open_one_do_not", async () => {
  const [bar] = await open();

  expect(openEdges(bar!, 0)).toEqual([0, 0]);
  expect(openEdges(without(bar!, 1), 0)).not.toEqual([0, 0]);
});

test("two_pieces_of_a_skin_that_meet_at_their_nodes_are_closed_together", async () => {
  const [bar] = await open();
  const half = 3 * Math.floor(bar!.indices.length / 6);
  const one = openEdges({ ...bar!, indices: bar!.indices.slice(0, half) }, 0);
  const two = openEdges({ ...bar!, indices: bar!.indices.slice(half) }, 0);

  expect(one).not.toEqual([0, 0]);
  expect([(one[0] + two[0]) | 0, (one[1] + two[1]) | 0]).toEqual([0, 0]);
});

test("middles_of_quads_of_two_parts_are_not_the_same_vertex", async () => {
  const [bar] = await open();
  const turned = { ...bar!, indices: bar!.indices.slice(0, 3) };
  const back = { ...bar!, indices: Uint32Array.of(bar!.indices[0]!, bar!.indices[2]!, bar!.indices[1]!) };
  const sum = (first: number) => {
    const [a, b] = [openEdges(turned, 0), openEdges(back, first)];
    return [(a[0] + b[0]) | 0, (a[1] + b[1]) | 0];
  };

  expect(sum(0)).toEqual([0, 0]);
  expect(sum(5000)).not.toEqual([0, 0]);
});
