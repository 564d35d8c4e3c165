// SPDX-License-Identifier: Apache-2.0
// Walks along the skin and slabs across it, on the tiny bar.
import { expect, test } from "vitest";
import { placeOnWalk, placePoint, slabsOf, walkThrough } from "../../src/probe";
import { openScene } from "../../src/scene";
import { FIRST_NODE_ID, tinyScene, tinyValues } from "../support/tiny-scene";

const open = async () => openScene(tinyScene().glb, async () => new ArrayBuffer(0));
/** Of the bar with 12 x 4 x 3 bricks of 10 mm. */
const nodeAt = (i: number, j: number, k: number) => FIRST_NODE_ID + i + 13 * (j + 5 * k);

test("a walk is the shortest way along edges and passes its nodes", async () => {
  const { parts } = await open();
  const walk = walkThrough(parts, [nodeAt(2, 1, 3), nodeAt(9, 1, 3), nodeAt(9, 4, 3)]);
  if (!walk || !parts[0]) throw new Error("no walk");
  expect(walk.length).toBeCloseTo(70 + 30, 4);
  const at = (share: number) =>
    placePoint(parts[0] as NonNullable<(typeof parts)[0]>, placeOnWalk(walk, share), [0, 0, 0]);
  for (const [share, x, y] of [
    [0, 20, 10],
    [0.35, 55, 10],
    [0.7, 90, 10],
    [1, 90, 40],
  ] as const) {
    expect(at(share)[0]).toBeCloseTo(x, 3);
    expect(at(share)[1]).toBeCloseTo(y, 3);
    expect(at(share)[2]).toBeCloseTo(30, 3);
  }
});

test("a walk goes round the edge of the bar, and not from one part to another", async () => {
  const { parts } = await open();
  const round = walkThrough(parts, [nodeAt(6, 0, 0), nodeAt(6, 0, 3)]);
  expect(round?.length).toBeCloseTo(30, 4);
  const two = await openScene(tinyScene({ bars: 2 }).glb, async () => new ArrayBuffer(0));
  expect(walkThrough(two.parts, [nodeAt(0, 0, 0), nodeAt(0, 0, 0) + 10_000])).toBeNull();
  expect(walkThrough(parts, [nodeAt(6, 0, 0)])).toBeNull();
});

test("slabs have the largest node's value and the mean over the area", async () => {
  const scene = await open();
  const temperature = scene.extras.results.find((r) => r.quantity === "temperature");
  if (!temperature) throw new Error("no temperature");
  const fields = await scene.loadField(temperature, 1);
  const query = {
    parts: scene.parts,
    fields,
    component: 0,
    hidden: () => false,
    axis: 0,
    count: 12,
  } as const;
  const slabs = slabsOf(query);
  expect(slabs).toHaveLength(12);
  for (const [i, slab] of slabs.entries()) {
    // The slab from 10 i to 10 i + 10 holds the nodes at its lower end; the last holds both ends.
    const x = i === 11 ? 120 : 10 * i;
    expect(slab.max).toBe(Math.fround(tinyValues.temperature(x, 40, 1)));
    if (i > 0 && i < 11) expect(slab.mean).toBeCloseTo(tinyValues.temperature(10 * i + 5, 20, 1), 3);
  }
  expect(slabsOf({ ...query, hidden: () => true })).toEqual([]);
});
