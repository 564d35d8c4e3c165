// SPDX-License-Identifier: Apache-2.0
// The lines that show a shape: edges where the skin ends or bends sharply. No three.js.
import { nodeNumbers, type ScenePart } from "../scene";

/** Facets that meet at more than this bend sharply. */
const SHARP_COSINE = Math.cos((30 * Math.PI) / 180);

function normalOf(part: ScenePart, triangle: number, out: Float64Array): void {
  const p = part.positions;
  const [a, b, c] = [0, 1, 2].map((k) => 3 * (part.indices[3 * triangle + k] ?? 0)) as [
    number,
    number,
    number,
  ];
  const d = (to: number, axis: number) => (p[to + axis] ?? 0) - (p[a + axis] ?? 0);
  const x = d(b, 1) * d(c, 2) - d(b, 2) * d(c, 1);
  const y = d(b, 2) * d(c, 0) - d(b, 0) * d(c, 2);
  const z = d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0);
  const length = Math.hypot(x, y, z) || 1;
  out[0] = x / length;
  out[1] = y / length;
  out[2] = z / length;
}

/** Edges of triangles by the smaller of their nodes: an edge is three times its triangle plus its corner. */
function edgesByNode(part: ScenePart) {
  const { numbers, count } = nodeNumbers(part);
  const { indices } = part;
  const endOf = (i: number) => numbers[indices[i % 3 === 2 ? i - 2 : i + 1] ?? 0] ?? 0;
  const startOf = (i: number) => numbers[indices[i] ?? 0] ?? 0;
  const first = new Uint32Array(count + 1);
  // Edges to the made-up middle of a quad are none.
  const isEdge = (i: number) => startOf(i) !== 0 && endOf(i) !== 0;
  for (let i = 0; i < indices.length; ++i) if (isEdge(i)) first[Math.min(startOf(i), endOf(i)) + 1]! += 1;
  for (let n = 0; n < count; ++n) first[n + 1]! += first[n] ?? 0;
  const edges = new Uint32Array(first[count] ?? 0);
  const next = first.slice();
  for (let i = 0; i < indices.length; ++i) {
    if (!isEdge(i)) continue;
    const n = Math.min(startOf(i), endOf(i));
    edges[next[n] ?? 0] = i;
    next[n]! += 1;
  }
  return { first, edges, count, farOf: (i: number) => Math.max(startOf(i), endOf(i)) };
}

/** Pairs of vertices: edges of one triangle, and those where two meet sharply. */
export function featureEdges(part: ScenePart): Uint32Array {
  const { first, edges, count, farOf } = edgesByNode(part);
  const { indices } = part;
  const [one, two] = [new Float64Array(3), new Float64Array(3)];
  const kept: number[] = [];
  const keep = (i: number) => kept.push(indices[i] ?? 0, indices[i % 3 === 2 ? i - 2 : i + 1] ?? 0);
  /** Of the node at hand: the other end -> the edge that waits for its second triangle. */
  const waiting = new Map<number, number>();
  for (let n = 0; n < count; ++n) {
    waiting.clear();
    for (let k = first[n] ?? 0; k < (first[n + 1] ?? 0); ++k) {
      const edge = edges[k] ?? 0;
      const far = farOf(edge);
      const before = waiting.get(far);
      if (before === undefined) {
        waiting.set(far, edge);
        continue;
      }
      waiting.delete(far);
      normalOf(part, Math.floor(before / 3), one);
      normalOf(part, Math.floor(edge / 3), two);
      const cosine =
        (one[0] ?? 0) * (two[0] ?? 0) + (one[1] ?? 0) * (two[1] ?? 0) + (one[2] ?? 0) * (two[2] ?? 0);
      if (cosine < SHARP_COSINE) keep(edge);
    }
    for (const edge of waiting.values()) keep(edge);
  }
  return Uint32Array.from(kept);
}
