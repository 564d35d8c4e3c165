// SPDX-License-Identifier: Apache-2.0
// The legend's values and positions are each other's inverse, on every scale.
import { expect, test } from "vitest";
import type { ValueRange } from "../../src/present";
import { labelPositions, positionOf, valueAtPosition } from "../../src/ui/scale-axis";

const ranges: ValueRange[] = [
  { lo: -3, hi: 9, scale: "linear" },
  { lo: 0.01, hi: 1000, scale: "log" },
  { lo: -4, hi: 2, scale: "signed" },
  { lo: -50, hi: 800, scale: "symlog" },
  { lo: 0, hi: 800, scale: "log" },
];

test("value_at_a_position_stands_at_that_position", () => {
  for (const range of ranges) {
    for (const t of [0, 0.1, 0.35, 0.5, 0.9, 1]) {
      expect(positionOf(valueAtPosition(t, range), range)).toBeCloseTo(t, 9);
    }
  }
});

test("missing_value_has_no_position", () => {
  expect(positionOf(null, ranges[0]!)).toBeNull();
  expect(positionOf(Number.NaN, ranges[0]!)).toBeNull();
});

test("labels_stand_on_band_edges", () => {
  expect(labelPositions(4)).toEqual([0, 0.25, 0.5, 0.75, 1]);
  expect(labelPositions(9)).toHaveLength(10);
  for (const bands of [0, 20, 33, 64]) {
    const count = labelPositions(bands).length;
    expect(count).toBeGreaterThan(5);
    expect(count).toBeLessThan(16);
  }
});
