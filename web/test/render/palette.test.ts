// SPDX-License-Identifier: Apache-2.0
// The table of colours of mesh and legend says what the mapping says.
import { expect, test } from "vitest";
import { colourOf, defaultColour } from "../../src/present";
import { makePalette, texelOf } from "../../src/render/palette";

const range = { lo: 100, hi: 300, scale: "linear" } as const;
const read = (bands: number, value: number) => {
  const palette = makePalette({ ...defaultColour, bands });
  const texel = texelOf((value - range.lo) / (range.hi - range.lo), palette);
  return [...palette.texels.subarray(4 * texel, 4 * texel + 3)];
};

test("banded_table_equals_the_mapping_exactly", () => {
  for (let value = 100; value <= 300; value += 0.37) {
    expect(read(9, value)).toEqual([...colourOf(value, range, { ...defaultColour, bands: 9 })]);
  }
});

test("smooth_table_is_within_a_step_of_the_mapping", () => {
  for (let value = 100; value <= 300; value += 0.37) {
    const wanted = colourOf(value, range, { ...defaultColour, bands: 0 });
    read(0, value).forEach((channel, i) => {
      expect(Math.abs(channel - wanted[i]!)).toBeLessThanOrEqual(1);
    });
  }
});

test("ends_of_the_range_take_the_outer_texels", () => {
  const palette = makePalette({ ...defaultColour, bands: 5 });

  expect([texelOf(0, palette), texelOf(1, palette), texelOf(-0.1, palette), texelOf(1.1, palette)]).toEqual([
    0, 4, 0, 4,
  ]);
});
