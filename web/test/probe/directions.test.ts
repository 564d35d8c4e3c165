// SPDX-License-Identifier: Apache-2.0
import { expect, test } from "vitest";
import { principalOf, spacedVertices } from "../../src/probe";

const product = (t: readonly number[], v: readonly number[]) => {
  const [xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0] = t;
  const [x = 0, y = 0, z = 0] = v;
  return [xx * x + xy * y + zx * z, xy * x + yy * y + yz * z, zx * x + yz * y + zz * z];
};

test("principal values of a diagonal tensor are its entries, the largest first, along the axes", () => {
  const found = principalOf([-3, 7, 2, 0, 0, 0]);
  expect(found?.map((p) => p.value)).toEqual([7, 2, -3]);
  expect(found?.map((p) => p.axis.map(Math.abs))).toEqual([
    [0, 1, 0],
    [0, 0, 1],
    [1, 0, 0],
  ]);
});

test("pure shear pulls along one diagonal and pushes along the other", () => {
  const found = principalOf([0, 0, 0, 5, 0, 0]);
  expect(found?.map((p) => p.value)).toEqual([5, 0, -5].map((v) => expect.closeTo(v, 12)));
  const [x = 0, y = 0, z = 0] = found?.[0].axis ?? [];
  expect([x * y, z]).toEqual([expect.closeTo(0.5, 12), expect.closeTo(0, 12)]);
});

test("every principal direction is turned onto itself by the tensor, times its value", () => {
  let seed = 1;
  const random = () => {
    seed = (seed * 48271) % 2147483647;
    return seed / 2147483647 - 0.5;
  };
  for (let i = 0; i < 500; ++i) {
    const tensor = Array.from({ length: 6 }, () => 1000 * random());
    const found = principalOf(tensor) ?? [];
    expect(found).toHaveLength(3);
    for (const { value, axis } of found) {
      expect(Math.hypot(...axis)).toBeCloseTo(1, 12);
      for (const [k, v] of product(tensor, axis).entries()) expect(v).toBeCloseTo(value * (axis[k] ?? 0), 8);
    }
    const values = found.map((p) => p.value);
    expect(values).toEqual([...values].sort((a, b) => b - a));
  }
});

test("a tensor with a missing component has no principal values", () => {
  expect(principalOf([1, 2, 3, Number.NaN, 0, 0])).toBeNull();
});

test("each cube bears the node nearest to its middle, whatever part it is of", () => {
  const parts = [
    { positions: [0.1, 0.1, 0.1, 0.4, 0.5, 0.5, 1.5, 0.5, 0.5], nodeIds: [11, 12, 13] },
    { positions: [0.4, 0.5, 0.5, 0.5, 0.5, 0.5], nodeIds: [5, 0] },
  ];
  const all = spacedVertices(parts, 1, () => true);
  expect(all.map((v) => v.node)).toEqual([5, 13]);
  const some = spacedVertices(parts, 1, (part) => part === 0);
  expect(some.map((v) => v.node)).toEqual([12, 13]);
});

test("a node whose vertices lie in several cubes, as round a beam, bears one", () => {
  const parts = [{ positions: [0.9, 0.5, 0.5, 1.2, 0.5, 0.5, 2.5, 0.5, 0.5], nodeIds: [7, 7, 8] }];
  expect(spacedVertices(parts, 1, () => true)).toEqual([
    { part: 0, vertex: 1, node: 7 },
    { part: 0, vertex: 2, node: 8 },
  ]);
});
