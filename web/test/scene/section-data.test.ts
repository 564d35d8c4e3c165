// SPDX-License-Identifier: Apache-2.0
// The bytes of a section as the server writes them.
import { expect, test } from "vitest";
import { readSection } from "../../src/scene";

/** One triangle of element 4711, part 2, around (1000, 2000, 3000). */
function bytesOf(change: (view: DataView) => void = () => {}, more = 0): ArrayBuffer {
  const bytes = new ArrayBuffer(64 + 3 * 16 + 24 + more);
  const view = new DataView(bytes);
  for (const [i, letter] of [..."FLIN"].entries()) view.setUint8(i, letter.charCodeAt(0));
  view.setUint32(4, 1, true);
  view.setUint32(8, 3, true);
  view.setUint32(12, 1, true);
  view.setFloat64(16, 2.5, true);
  view.setBigUint64(24, 7n, true);
  view.setBigUint64(32, 1n, true);
  for (const [i, v] of [1000, 2000, 3000].entries()) view.setFloat64(40 + 8 * i, v, true);
  view.setFloat64(64, 4711, true);
  for (const [i, v] of [0, 0, 0, 1, 0, 0, 0, 2, 0].entries()) view.setFloat32(72 + 4 * i, v, true);
  for (const [i, v] of [10, 20, Number.NaN].entries()) view.setFloat32(108 + 4 * i, v, true);
  for (const i of [0, 1, 2]) view.setUint32(120 + 4 * i, i, true);
  view.setUint32(132, 2, true);
  change(view);
  return bytes;
}

test("a section is read with its places minus the scene's origin", () => {
  const section = readSection(bytesOf(), [999, 2000, 0]);
  expect([...section.positions]).toEqual([1, 0, 3000, 2, 0, 3000, 1, 2, 3000]);
  expect([...section.values]).toEqual([10, 20, Number.NaN]);
  expect([...section.indices]).toEqual([0, 1, 2]);
  expect([...section.elementIds]).toEqual([4711]);
  expect([...section.parts]).toEqual([2]);
  expect([section.area, section.elements, section.elementsWithoutPlace]).toEqual([2.5, 7, 1]);
});

test("what is no section, newer or cut short is refused", () => {
  const origin = [0, 0, 0] as const;
  expect(() => readSection(new ArrayBuffer(10), origin)).toThrow("not a section");
  expect(() =>
    readSection(
      bytesOf((view) => view.setUint8(0, 65)),
      origin,
    ),
  ).toThrow("not a section");
  expect(() =>
    readSection(
      bytesOf((view) => view.setUint32(4, 2, true)),
      origin,
    ),
  ).toThrow("newer");
  expect(() =>
    readSection(
      bytesOf((view) => view.setUint32(8, 4_000_000_000, true)),
      origin,
    ),
  ).toThrow("cut short");
  expect(() => readSection(bytesOf(undefined, 4), origin)).toThrow("cut short");
});
