// SPDX-License-Identifier: Apache-2.0
// Places on sections and the values drawn there.
import { expect, test } from "vitest";
import { answerOf } from "../../src/app/inside-client";
import { type DrawnSection, placeOnSections, sectionValue } from "../../src/probe";

/** The square 0..2 x 0..2 at z = 5 as two triangles; values x + 10 y. */
function square(change: Partial<DrawnSection> = {}): DrawnSection {
  const positions = new Float32Array([0, 0, 5, 2, 0, 5, 2, 2, 5, 0, 2, 5]);
  const values = new Float32Array([0, 2, 22, 20]);
  const data = {
    positions,
    values,
    indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
    elementIds: new Float64Array([7, 8]),
    parts: new Uint32Array([0, 0]),
    area: 4,
    elements: 2,
    elementsWithoutPlace: 0,
  };
  return {
    plane: { normal: [0, 0, 1], offset: 5 },
    data,
    values: new Map([["T", values]]),
    isDrawn: () => true,
    ...change,
  };
}

test("a place of a section has the linear value of its triangle", () => {
  const place = placeOnSections([square()], [1.5, 0.5, 5]);
  expect(place?.triangle).toBe(0);
  expect(place && sectionValue(place, "T")).toBeCloseTo(6.5, 12);
  expect(place && sectionValue(place, "unknown")).toBeNull();
  const other = placeOnSections([square()], [0.5, 1.5, 5.0001]);
  expect(other?.triangle).toBe(1);
  expect(other && sectionValue(other, "T")).toBeCloseTo(15.5, 12);
});

test("off the plane, beside the triangles and on parts that are not drawn there is no place", () => {
  expect(placeOnSections([square()], [1, 1, 5.1])).toBeNull();
  expect(placeOnSections([square()], [2.2, 1, 5])).toBeNull();
  expect(placeOnSections([square({ isDrawn: () => false })], [1, 1, 5])).toBeNull();
  expect(placeOnSections([], [1, 1, 5])).toBeNull();
});

test("a missing corner leaves its triangle without a value", () => {
  const section = square({ values: new Map([["T", new Float32Array([0, 2, 22, Number.NaN])]]) });
  const whole = placeOnSections([section], [1.5, 0.5, 5]);
  const holed = placeOnSections([section], [0.5, 1.5, 5]);
  expect(whole && sectionValue(whole, "T")).toBeCloseTo(6.5, 12);
  expect(holed && sectionValue(holed, "T")).toBeNull();
});

test("the node of an answer is the one that counts most, the smaller number on a tie", () => {
  const answer = answerOf(
    {
      element: 12,
      type: "tet4",
      nodes: [44, 11, 33, 22],
      weights: [0.1, 0.4, 0.1, 0.4],
      results: [
        { value: 5, elemental: false, nodeValues: [1, 2, 3, null] },
        { value: null, elemental: true, nodeValues: [9, 9, 9, 9] },
      ],
    },
    ["T", "E"],
  );
  expect(answer.nodeId).toBe(11);
  expect(answer.values.get("T")).toEqual({ value: 5, nodeValue: 2 });
  expect(answer.values.get("E")).toEqual({ value: null, nodeValue: null });
  const outside = answerOf({ element: null, results: [{ value: null, elemental: false, nodeValues: [] }] }, [
    "T",
  ]);
  expect(outside).toMatchObject({ elementId: null, nodeId: null });
});
