// SPDX-License-Identifier: Apache-2.0
// Numbers keep six digits and invent none.
import { expect, test } from "vitest";
import { axisTexts, numberText, stepText, unitText, withUnit } from "../../src/ui/format";

test("numbers_have_at_most_six_significant_digits", () => {
  expect(numberText(31.2)).toBe("31.2");
  expect(numberText(Math.fround(0.1))).toBe("0.1");
  expect(numberText(123456.789)).toBe("123457");
  expect(numberText(-0.000012345678)).toBe("-1.23457e-5");
  expect(numberText(7.85e9)).toBe("7.85e9");
  expect(numberText(0)).toBe("0");
  expect(numberText(null)).toBe("no value");
});

test("units_are_printed_as_people_write_them_and_never_made_up", () => {
  expect(unitText("degC")).toBe("°C");
  expect(unitText("um")).toBe("µm");
  expect(unitText("N/mm2")).toBe("N/mm²");
  expect(unitText(null)).toBe("");
  expect(withUnit(250, "MPa")).toBe("250 MPa");
});

test("labels_of_an_axis_tell_neighbours_apart", () => {
  for (const values of [
    [0, 0.001, 0.002],
    [131.143, 142.7, 154.3],
    [1e-7, 2e-7, 3e-7],
    [-5e8, 0, 5e8],
    [100, 100.01],
  ]) {
    expect(new Set(axisTexts(values)).size).toBe(values.length);
  }
});

test("steps_say_name_kind_and_value", () => {
  expect(stepText({ id: 4, kind: "mode", number: [1, 4], value: 76.66, unit: "Hz", name: "Mode 4" })).toBe(
    "Mode 4 · 76.66 Hz",
  );
  expect(stepText({ id: 1, kind: "static", number: [1, 1], value: 1, unit: null, name: "" })).toBe(
    "Step 1.1 · static",
  );
});
