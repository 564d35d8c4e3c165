// SPDX-License-Identifier: Apache-2.0
// Hot spots are peaks of the solver's values, apart from one another, never of what nobody sees.
import { expect, test } from "vitest";
import { type HotSpot, hotSpots } from "../../src/probe";
import { openScene, type PartField } from "../../src/scene";
import { FIRST_NODE_ID, tinyScene } from "../support/tiny-scene";

const scene = await openScene(tinyScene({ bars: 2 }).glb, () => Promise.reject(new Error("none")));
const { parts } = scene;
const stress = scene.extras.results.find((r) => r.id === "stress_von_mises")!;
const fields = await scene.loadField(stress, 1);
const query = {
  parts,
  fields,
  component: 0,
  hidden: () => false,
  cuts: [],
  count: 6,
  separation: 5,
  largest: true,
};
const place = (spot: HotSpot) => [0, 1, 2].map((a) => parts[spot.part]!.positions[3 * spot.vertex + a]!);

test("largest_values_stand_first_and_the_smaller_node_id_on_a_tie", () => {
  const found = hotSpots(query);

  expect(found).toHaveLength(6);
  expect(found[0]).toMatchObject({ value: 361, node: FIRST_NODE_ID, part: 0 });
  // |z - 15| (120 - x) / 5 + 1 is largest along both edges at x = 0.
  for (const spot of found) expect([place(spot)[0], Math.abs(place(spot)[2]! - 15)]).toEqual([0, 15]);
});

test("places_are_at_least_so_far_apart", () => {
  const found = hotSpots({ ...query, count: 50, separation: 25 });

  expect(found.length).toBeGreaterThan(3);
  for (const a of found)
    for (const b of found) {
      const [p, q] = [place(a), place(b)];
      if (a !== b) expect(Math.hypot(...p.map((v, i) => v - q[i]!))).toBeGreaterThanOrEqual(25);
    }
});

test("hidden_parts_and_what_is_cut_away_have_none", () => {
  const second = hotSpots({ ...query, hidden: (part) => part === 0 });
  const upper = hotSpots({ ...query, cuts: [{ normal: [0, 0, -1], offset: -20 }] });

  expect(second.every((spot) => spot.part === 1 && spot.node > 10_000)).toBe(true);
  expect(upper.length).toBeGreaterThan(0);
  expect(upper.every((spot) => place(spot)[2]! >= 20)).toBe(true);
});

test("smallest_values_are_found_the_same_way", () => {
  const [first] = hotSpots({ ...query, largest: false });

  // The bar's rows of nodes are at z = 0, 10, 20, 30: |z - 15| is 5, and no value is known past x = 108.
  expect(first?.value).toBe(Math.fround(5 * (120 - 100) * 0.2 + 1));
});

test("a_ring_around_a_peak_is_no_peak_and_missing_values_are_none", () => {
  const part = parts[0]!;
  const one = part.nodeIds.indexOf(FIRST_NODE_ID + 6);
  const values = part.nodeIds.length;
  const made: PartField = {
    components: 1,
    values: Float32Array.from({ length: values }, (_, i) => {
      const d = [0, 1, 2].map((a) => part.positions[3 * i + a]! - part.positions[3 * one + a]!);
      return 100 - Math.hypot(...d);
    }),
    state: new Uint8Array(values).fill(1),
  };
  const found = hotSpots({ ...query, fields: [made, null], separation: 1 });

  expect(found.map((spot) => spot.node)).toEqual([FIRST_NODE_ID + 6]);

  made.state.fill(0);
  expect(hotSpots({ ...query, fields: [made, null] })).toEqual([]);
});
