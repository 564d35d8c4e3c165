// SPDX-License-Identifier: Apache-2.0
// Values at a place: barycentric between nodes, the file's at a node, nothing where a corner has none.
import { expect, test } from "vitest";
import { barycentric, nearestNode, placePoint, valueAt } from "../../src/probe/sample";
import { INTERPOLATED, MISSING, type PartField, type ScenePart, SOLVER } from "../../src/scene";

function onePart(nodeIds: number[]): ScenePart {
  return {
    index: 0,
    info: { id: 0, name: "p", kind: "solid" },
    positions: Float32Array.of(0, 0, 0, 4, 0, 0, 0, 2, 0),
    normals: null,
    indices: Uint32Array.of(0, 1, 2),
    nodeIds: Float64Array.from(nodeIds),
    elementIds: Uint32Array.of(77),
    edges: null,
  };
}
const scalars = (values: number[], state: number[] = [SOLVER, SOLVER, SOLVER]): PartField => ({
  components: 1,
  values: Float32Array.from(values),
  state: Uint8Array.from(state),
});
const at = (weights: readonly [number, number, number]) => ({ part: 0, triangle: 0, weights });

test("weights_add_up_and_meet_the_point", () => {
  const part = onePart([11, 12, 13]);
  const corners = [0, 1, 2].map((v) => part.positions.subarray(3 * v, 3 * v + 3));

  const weights = barycentric([1, 0.5, 0], corners[0]!, corners[1]!, corners[2]!);

  expect(weights[0] + weights[1] + weights[2]).toBeCloseTo(1, 14);
  expect(placePoint(part, at(weights), [100, 0, 0])).toEqual([101, 0.5, 0]);
});

test("point_a_hair_from_a_node_is_on_the_node", () => {
  expect(barycentric([1e-5, 1e-5, 0], [0, 0, 0], [4, 0, 0], [0, 2, 0])).toEqual([1, 0, 0]);
  expect(barycentric([0.01, 0, 0], [0, 0, 0], [4, 0, 0], [0, 2, 0])[0]).toBeLessThan(1);
});

test("triangle_without_area_gives_its_first_corner", () => {
  expect(barycentric([1, 1, 1], [0, 0, 0], [1, 0, 0], [2, 0, 0])).toEqual([1, 0, 0]);
});

test("value_is_the_weighted_mean_and_the_node_keeps_its_own", () => {
  const read = valueAt(onePart([11, 12, 13]), at([0.5, 0.3, 0.2]), scalars([10, 20, 30]), 0);

  expect(read.value).toBeCloseTo(17, 12);
  expect(read).toMatchObject({ nodeValue: 10, state: "solver" });
});

test("value_on_a_node_is_the_files_bit_for_bit", () => {
  const field = scalars([0.1, 7e30, Number.NaN]);

  expect(valueAt(onePart([11, 12, 13]), at([1, 0, 0]), field, 0).value).toBe(Math.fround(0.1));
});

test("triangle_with_a_missing_corner_is_missing_whole_but_the_node_still_says_its_value", () => {
  const field = scalars([10, 20, Number.NaN], [SOLVER, SOLVER, MISSING]);

  const read = valueAt(onePart([11, 12, 13]), at([0.9, 0.1, 0]), field, 0);

  expect(read).toEqual({ value: null, nodeValue: 10, state: "missing" });
});

test("filled_mid_side_node_is_interpolated_but_the_centre_of_a_quad_is_not", () => {
  const field = scalars([10, 20, 30], [SOLVER, SOLVER, INTERPOLATED]);
  const place = at([0.4, 0.4, 0.2]);

  expect(valueAt(onePart([11, 12, 13]), place, field, 0).state).toBe("interpolated");
  expect(valueAt(onePart([11, 12, 0]), place, field, 0).state).toBe("solver");
  expect(valueAt(onePart([11, 12, 13]), at([0.5, 0.5, 0]), field, 0).state).toBe("solver");
});

test("nearest_node_takes_the_smaller_id_on_a_tie_and_never_a_centre", () => {
  expect(nearestNode(onePart([12, 11, 13]), at([0.4, 0.4, 0.2]))?.id).toBe(11);
  expect(nearestNode(onePart([12, 11, 0]), at([0.1, 0.2, 0.7]))?.id).toBe(11);
  expect(nearestNode(onePart([0, 0, 0]), at([1, 0, 0]))).toBeNull();
});
