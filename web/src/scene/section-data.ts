// SPDX-License-Identifier: Apache-2.0
// Triangles of the inside as the server sends them (docs/serving.md): little-endian arrays behind a head of 64 bytes.

/** Triangles through the inside, in model units minus the scene's origin. */
export interface SectionData {
  readonly positions: Float32Array;
  /** One a vertex, NaN where missing. */
  readonly values: Float32Array;
  readonly indices: Uint32Array;
  /** Solver's number of the element of each triangle. */
  readonly elementIds: Float64Array;
  /** Of each triangle: the part of the model (`modelPart` of the scene's parts). */
  readonly parts: Uint32Array;
  /** Model units squared. */
  readonly area: number;
  readonly elements: number;
  /** Solids that have a corner without coordinates and are not cut. */
  readonly elementsWithoutPlace: number;
}

const HEAD = 64;
const MAGIC = 0x4e494c46; // "FLIN"

export function readSection(bytes: ArrayBuffer, origin: readonly [number, number, number]): SectionData {
  const view = new DataView(bytes);
  if (bytes.byteLength < HEAD || view.getUint32(0, true) !== MAGIC)
    throw new Error("the answer is not a section");
  if (view.getUint32(4, true) !== 1) throw new Error("the section is of a newer kind than this page knows");
  const [vertices, triangles] = [view.getUint32(8, true), view.getUint32(12, true)];
  if (bytes.byteLength !== HEAD + 16 * vertices + 24 * triangles) throw new Error("the section is cut short");
  let at = HEAD;
  const after = (size: number) => {
    at += size;
    return at - size;
  };
  const elementIds = new Float64Array(bytes, after(8 * triangles), triangles);
  const positions = new Float32Array(bytes, after(12 * vertices), 3 * vertices);
  const values = new Float32Array(bytes, after(4 * vertices), vertices);
  const indices = new Uint32Array(bytes, after(12 * triangles), 3 * triangles);
  const parts = new Uint32Array(bytes, after(4 * triangles), triangles);
  const shift = [0, 1, 2].map((axis) => view.getFloat64(40 + 8 * axis, true) - (origin[axis] ?? 0));
  for (let i = 0; i < positions.length; ++i) positions[i] = (positions[i] ?? 0) + (shift[i % 3] ?? 0);
  return {
    positions,
    values,
    indices,
    elementIds,
    parts,
    area: view.getFloat64(16, true),
    elements: Number(view.getBigUint64(24, true)),
    elementsWithoutPlace: Number(view.getBigUint64(32, true)),
  };
}
