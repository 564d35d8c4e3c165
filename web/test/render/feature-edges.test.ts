// SPDX-License-Identifier: Apache-2.0
// The ghost's lines are the edges of the shape; merged parts keep their triangles and know whose each vertex is.
import type { BufferAttribute } from "three";
import { expect, test } from "vitest";
import { featureEdges } from "../../src/render";
import { mergeEdges, mergeFaces } from "../../src/render/merged";
import { openScene } from "../../src/scene";
import { tinyScene } from "../support/tiny-scene";

const scene = await openScene(tinyScene({ bars: 2 }).glb, () => Promise.reject(new Error("none")));
const { parts } = scene;

test("a_bar_has_the_twelve_edges_of_a_box_and_no_line_within_a_face", () => {
  for (const part of parts) {
    const pairs = featureEdges(part);
    let length = 0;
    for (let i = 0; i < pairs.length; i += 2) {
      const at = (k: number, axis: number) => part.positions[3 * pairs[i + k]! + axis]!;
      length += Math.hypot(...[0, 1, 2].map((axis) => at(0, axis) - at(1, axis)));
    }
    expect(length).toBeCloseTo(4 * (120 + 40 + 30), 3);
    expect(pairs.length / 2).toBe(4 * (12 + 4 + 3));
  }
});

test("merged_parts_keep_their_places_triangles_and_owners", () => {
  const { geometry, slices } = mergeFaces(parts);
  const position = geometry.getAttribute("position") as BufferAttribute;
  const owner = geometry.getAttribute("owner") as BufferAttribute;
  const index = geometry.getIndex()!;
  let at = 0;
  for (const [k, { part, firstVertex, vertices }] of slices.entries()) {
    expect(part).toBe(parts[k]);
    expect(position.array.slice(3 * firstVertex, 3 * (firstVertex + vertices))).toEqual(part.positions);
    for (let i = 0; i < vertices; ++i) expect(owner.getX(firstVertex + i)).toBe(k);
    for (const vertex of part.indices) {
      expect(index.getX(at) - firstVertex).toBe(vertex);
      at += 1;
    }
  }
  expect(at).toBe(index.count);
});

test("edges_belong_to_the_part_they_are_of_also_when_another_has_none", () => {
  const [first, second] = parts as [(typeof parts)[0], (typeof parts)[0]];
  const owner = mergeEdges([{ ...first, edges: null }, second])!.geometry.getAttribute("owner");

  expect([owner.getX(0), owner.getX(owner.count - 1)]).toEqual([1, 1]);
  expect(mergeEdges([{ ...first, edges: null }])).toBeNull();
});
