// SPDX-License-Identifier: Apache-2.0
// Values as a table of text: every number by the fewest digits that give its float32 again. No DOM.

export type Cell = string | number | null;
export type Separator = "," | ";" | "\t";

/** The shortest decimal that reads back as the same float32. */
export function floatText(value: number): string {
  for (let digits = 1; digits <= 9; ++digits) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === Math.fround(value)) return String(Number(text));
  }
  return String(value);
}

function cellText(cell: Cell, separator: Separator): string {
  if (cell === null) return "";
  if (typeof cell === "number") {
    // A coordinate far from the origin is a double: it keeps all its digits.
    if (Number.isInteger(cell) || Math.fround(cell) !== cell) return String(cell);
    return floatText(cell);
  }
  // What a spreadsheet would take for a formula stays a text.
  const text = /^[=+\-@\t]/.test(cell) ? `'${cell}` : cell;
  return text.includes(separator) || /["\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Rows one after the other, so that a large table never is one long string. */
export function* tableLines(
  head: readonly string[],
  rows: Iterable<readonly Cell[]>,
  separator: Separator,
): Generator<string> {
  const line = (cells: readonly Cell[]) => `${cells.map((c) => cellText(c, separator)).join(separator)}\r\n`;
  yield line(head);
  for (const row of rows) yield line(row);
}

/** Pieces of about a megabyte for a Blob. */
export function tablePieces(lines: Iterable<string>): string[] {
  const pieces: string[] = [];
  let piece = "";
  for (const line of lines) {
    piece += line;
    if (piece.length < 1_000_000) continue;
    pieces.push(piece);
    piece = "";
  }
  return [...pieces, piece];
}
