// SPDX-License-Identifier: Apache-2.0
// Tables hold every float32 as it is, and nothing that a spreadsheet would run.
import { expect, test } from "vitest";
import { floatText, tableLines, tablePieces } from "../../src/app/table";

const text = (head: string[], rows: (string | number | null)[][], separator: "," | ";" | "\t" = ",") =>
  [...tableLines(head, rows, separator)].join("");

test("a_number_is_as_short_as_it_can_be_and_reads_back_as_the_same_float", () => {
  expect([0.1, 1 / 3, 235.154, 1e-20, 6.02e23].map((v) => floatText(Math.fround(v)))).toEqual([
    "0.1",
    "0.33333334",
    "235.154",
    "1e-20",
    "6.02e+23",
  ]);
  let seed = 7;
  const bits = new DataView(new ArrayBuffer(4));
  for (let i = 0; i < 5000; ++i) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    bits.setUint32(0, seed);
    const value = bits.getFloat32(0);
    if (Number.isFinite(value)) expect(Math.fround(Number(floatText(value)))).toBe(value);
  }
});

test("a_missing_value_is_an_empty_cell_and_ids_are_whole", () => {
  expect(text(["node", "T"], [[20_000_001, null]])).toBe("node,T\r\n20000001,\r\n");
});

test("a_number_that_no_float_holds_keeps_all_its_digits", () => {
  expect(text(["x"], [[500_000.123]])).toBe("x\r\n500000.123\r\n");
});

test("texts_with_separators_are_quoted_and_formulas_stay_texts", () => {
  expect(text(["a"], [['say "x", y']])).toBe('a\r\n"say ""x"", y"\r\n');
  expect(text(["a", "b"], [["=1+1", "x;y"]], ";")).toBe('a;b\r\n\'=1+1;"x;y"\r\n');
});

test("a_long_table_comes_in_pieces_that_lose_nothing", () => {
  const lines = Array.from({ length: 30_000 }, (_, i) => `${i},`.padEnd(90, "x"));

  const pieces = tablePieces(lines);

  expect(pieces.length).toBeGreaterThan(2);
  expect(pieces.join("")).toBe(lines.join(""));
});
