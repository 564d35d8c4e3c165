// SPDX-License-Identifier: Apache-2.0
// All parts as one geometry of faces and one of edges: two draw calls, however many parts there are.
import { BufferAttribute, BufferGeometry, Sphere } from "three";
import type { ScenePart } from "../scene";

/** Where a part stands in the merged arrays. */
export interface Slice {
  readonly part: ScenePart;
  readonly firstVertex: number;
  readonly vertices: number;
}

export interface Merged {
  readonly geometry: BufferGeometry;
  readonly slices: readonly Slice[];
}

/** The card has it: the page's own copy is let go. */
function letGo(this: BufferAttribute): void {
  (this as { array: ArrayLike<number> | null }).array = null;
}

const changing = (count: number, size: number) => new BufferAttribute(new Float32Array(count * size), size);

/** Normals where the scene has none: of each triangle, added up at its corners. */
function madeNormals(part: ScenePart): Float32Array {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(part.positions, 3));
  geometry.setIndex(new BufferAttribute(part.indices, 1));
  geometry.computeVertexNormals();
  return geometry.getAttribute("normal").array as Float32Array;
}

function join<T extends Float32Array | Uint32Array>(make: T, pieces: readonly T[], shifts?: number[]): T {
  let at = 0;
  for (const [i, piece] of pieces.entries()) {
    const shift = shifts?.[i] ?? 0;
    if (shift === 0) make.set(piece, at);
    else for (let k = 0; k < piece.length; ++k) make[at + k] = (piece[k] ?? 0) + shift;
    at += piece.length;
  }
  return make;
}

const total = (pieces: readonly { length: number }[]) => pieces.reduce((sum, p) => sum + p.length, 0);

function ownersOf(counts: readonly number[], numbers: readonly number[]): BufferAttribute {
  const owners = new Uint16Array(counts.reduce((sum, n) => sum + n, 0));
  let at = 0;
  for (const [i, count] of counts.entries()) {
    owners.fill(numbers[i] ?? 0, at, at + count);
    at += count;
  }
  return new BufferAttribute(owners, 1);
}

interface Piece {
  readonly part: ScenePart;
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
}

function merge(pieces: readonly Piece[], numbers: readonly number[]): Merged {
  const geometry = new BufferGeometry();
  const counts = pieces.map((p) => p.positions.length / 3);
  const slices: Slice[] = [];
  let first = 0;
  for (const [i, piece] of pieces.entries()) {
    slices.push({ part: piece.part, firstVertex: first, vertices: counts[i] ?? 0 });
    first += counts[i] ?? 0;
  }
  const [only] = pieces;
  const single = pieces.length === 1 && only !== undefined;
  const lists = pieces.map((p) => p.positions);
  const indices = pieces.map((p) => p.indices);
  const positions = single ? only.positions : join(new Float32Array(3 * first), lists);
  const shifts = slices.map((s) => s.firstVertex);
  const index = single ? only.indices : join(new Uint32Array(total(indices)), indices, shifts);
  const place = new BufferAttribute(positions, 3);
  const list = new BufferAttribute(index, 1);
  const owner = ownersOf(counts, numbers);
  if (!single) {
    place.onUpload(letGo);
    list.onUpload(letGo);
  }
  owner.onUpload(letGo);
  geometry.setAttribute("position", place);
  geometry.setAttribute("owner", owner);
  geometry.setAttribute("displacement", changing(first, 3));
  geometry.setIndex(list);
  // Asked for when it is drawn, to sort by it; nothing is culled, and the places are with the card by then.
  geometry.boundingSphere = new Sphere();
  return { geometry, slices };
}

/** Triangles of a level over the merged vertices; null: nothing of the part is left. */
export function mergeLevel(
  slices: readonly Slice[],
  lists: readonly (Uint32Array | null)[],
): BufferAttribute {
  const pieces = slices.map((_, i) => lists[i] ?? new Uint32Array(0));
  const shifts = slices.map((s) => s.firstVertex);
  const index = new BufferAttribute(join(new Uint32Array(total(pieces)), pieces, shifts), 1);
  index.onUpload(letGo);
  return index;
}

export function mergeFaces(parts: readonly ScenePart[]): Merged {
  const merged = merge(
    parts.map((part) => ({ part, positions: part.positions, indices: part.indices })),
    parts.map((_, i) => i),
  );
  const normals = parts.map((part) => part.normals ?? madeNormals(part));
  const [only] = normals;
  const { geometry } = merged;
  const normal = normals.length === 1 && only ? only : join(new Float32Array(total(normals)), normals);
  const attribute = new BufferAttribute(normal, 3);
  attribute.onUpload(letGo);
  // Only the card needs them.
  for (const part of parts) part.normals = null;
  const count = normal.length / 3;
  geometry.setAttribute("normal", attribute);
  geometry.setAttribute("value", changing(count, 1));
  geometry.setAttribute("missing", changing(count, 1));
  return merged;
}

/** Null when no part has edges. */
export function mergeEdges(parts: readonly ScenePart[]): Merged | null {
  const numbers: number[] = [];
  const pieces = parts.flatMap((part, i): Piece[] => {
    if (!part.edges) return [];
    numbers.push(i);
    return [{ part, positions: part.edges.positions, indices: part.edges.indices }];
  });
  return pieces.length > 0 ? merge(pieces, numbers) : null;
}
