// SPDX-License-Identifier: Apache-2.0
// The page writes numbers as C++ does: every line of tests/contract/numbers.json.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { axisTexts, boundText, numberText, type StepLike, stepText, unitText } from "../../src/ui/format";

interface Contract {
  numbers: { value: number | null; digits: number; text: string }[];
  axes: { values: number[]; texts: string[] }[];
  units: { unit: string; text: string }[];
  bounds: { bound: number; text: string }[];
  steps: { step: StepLike; text: string }[];
}

const path = new URL("../../../tests/contract/numbers.json", import.meta.url);
const contract = JSON.parse(readFileSync(path, "utf8")) as Contract;

test("numbers_read_as_every_viewer_agreed", () => {
  expect(contract.numbers.length).toBeGreaterThan(500);
  for (const { value, digits, text } of contract.numbers) {
    expect(numberText(value, digits), `${value} with ${digits} digits`).toBe(text);
  }
});

test("axes_units_bounds_and_steps_read_as_every_viewer_agreed", () => {
  for (const { values, texts } of contract.axes) expect(axisTexts(values)).toEqual(texts);
  for (const { unit, text } of contract.units) expect(unitText(unit)).toBe(text);
  for (const { bound, text } of contract.bounds) expect(boundText(bound)).toBe(text);
  for (const { step, text } of contract.steps) expect(stepText(step)).toBe(text);
});
