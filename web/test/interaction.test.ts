// SPDX-License-Identifier: Apache-2.0
// The table of interactions names a browser test for each cell, and each of them exists.
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const page = readFileSync(here("../../docs/interaction.md"), "utf8");
// A file that nobody runs holds no test.
const runner = readFileSync(here("e2e/run.mjs"), "utf8");
const known = new Set(
  readdirSync(here("e2e"))
    .filter((file) => runner.includes(`from "./${file}"`))
    .flatMap((file) => [...readFileSync(here(`e2e/${file}`), "utf8").matchAll(/^ {4}name: "(\w+)",$/gm)])
    .map(([, name]) => name),
);

/** Cells of the rows of the table that begins with this heading; names in a cell are its tests. */
function rowsOf(heading: string): string[][] {
  const lines = page.split("\n");
  const start = lines.findIndex((line) => line.startsWith(heading));
  const rows = [];
  for (let i = start + 2; lines[i]?.startsWith("|"); ++i)
    rows.push(
      (lines[i] ?? "")
        .split("|")
        .slice(1, -1)
        .map((cell) => cell.trim()),
    );
  return rows;
}
const namesIn = (cell: string) =>
  [...cell.matchAll(/`([A-Za-z0-9]+(?:_[A-Za-z0-9]+){2,})`/g)].map(([, name]) => name);

test("the table has every row and every kind of input", () => {
  const rows = rowsOf("| what | mouse | keyboard | touch | controllers | hands | transient pinch |");

  expect(rows.length).toBe(12);
  for (const row of rows) expect(row.length, row[0]).toBe(7);
});

test("each cell that is not empty by intent names a test that exists", () => {
  const faults = [];
  for (const [what, ...cells] of rowsOf("| what | mouse")) {
    for (const [i, cell] of cells.entries()) {
      if (cell === "–") continue;
      const names = namesIn(cell);
      if (names.length === 0) faults.push(`${what}, column ${i + 1}: no test`);
      for (const name of names) if (!known.has(name)) faults.push(`${what}: there is no test ${name}`);
    }
  }

  expect(faults).toEqual([]);
});

test("each rule names a test that exists", () => {
  const rows = rowsOf("| rule | test |");

  expect(rows.length).toBeGreaterThanOrEqual(6);
  for (const [rule, tests] of rows) {
    const names = namesIn(tests ?? "");
    expect(names.length, rule).toBeGreaterThan(0);
    for (const name of names) expect(known.has(name), `${rule}: ${name}`).toBe(true);
  }
});
