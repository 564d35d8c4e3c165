// SPDX-License-Identifier: Apache-2.0
// docs/senses.md and the tests name the same claims: each claim is tested where the table says, each test is in the table.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const root = fileURLToPath(new URL("../../", import.meta.url));
/** The claims that were promised; none may fall off the table. */
const PROMISED = [
  ...Array.from({ length: 12 }, (_, i) => `A${i + 1}`),
  ...["H1", "H2", "H3", "H4"],
  ...["V1", "V2", "V3", "V4", "V5", "V6"],
  ...["X1", "X2"],
];

const rows = readFileSync(join(root, "docs/senses.md"), "utf8")
  .split("\n")
  .filter((line) => /^\| [AHVX]\d+ \|/.test(line))
  .map((line) => line.split("|").map((cell) => cell.trim()))
  .map(([, claim = "", what = "", threshold = "", files = "", figure = ""]) => ({
    claim,
    complete: [what, threshold, figure].every((cell) => cell !== ""),
    files: [...files.matchAll(/`([^`]+)`/g)].map((match) => match[1] ?? ""),
  }));

/** Claims that the names of a file's tests begin with; a name may begin with several. */
function named(file: string): Set<string> {
  const text = readFileSync(join(root, file), "utf8");
  const names = /(?:test(?:\.each\([^)]*\))?\(\s*["'`]|name: ["'`]|TEST(?:_F)?\(\w+, )((?:[AHVX]\d+[ _])+)/g;
  return new Set([...text.matchAll(names)].flatMap((match) => match[1]?.match(/[AHVX]\d+/g) ?? []));
}

function filesUnder(folder: string): string[] {
  return readdirSync(join(root, folder), { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile() && /(\.test\.ts|\.mjs|_test\.cpp)$/.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name).slice(root.length));
}

test("the table holds every claim once, with threshold and figure", () => {
  expect(rows.map((row) => row.claim)).toEqual(PROMISED);
  for (const row of rows) expect(row.complete, row.claim).toBe(true);
});

test("each claim is tested by its name where the table says", () => {
  for (const { claim, files } of rows) {
    expect(files.length, claim).toBeGreaterThan(0);
    for (const file of files) expect([...named(file)], `${claim} in ${file}`).toContain(claim);
  }
});

test("each test that names a claim is in the table", () => {
  const found = ["web/test", "tests/present"]
    .flatMap(filesUnder)
    .flatMap((file) => [...named(file)].map((claim) => ({ claim, file })));
  expect(found.length).toBeGreaterThanOrEqual(PROMISED.length);
  for (const { claim, file } of found)
    expect(rows.find((row) => row.claim === claim)?.files, `${claim} in ${file}`).toContain(file);
});
