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

/** Pairs of vertices; edges to the made-up middle of a quad are none. */
export function featureEdges(part: ScenePart): Uint32Array {
  const { numbers, count } = nodeNumbers(part);
  /** Edge by its two node numbers -> first triangle, or -1 once it is settled. */
  const first = new Map<number, number>();
  const place = new Map<number, readonly [number, number]>();
  const [one, two] = [new Float64Array(3), new Float64Array(3)];
  const kept: number[] = [];
  for (let t = 0; 3 * t < part.indices.length; ++t) {
    for (let k = 0; k < 3; ++k) {
      const a = part.indices[3 * t + k] ?? 0;
      const b = part.indices[3 * t + ((k + 1) % 3)] ?? 0;
      const [na, nb] = [numbers[a] ?? 0, numbers[b] ?? 0];
      if (na === 0 || nb === 0) continue;
      const key = Math.min(na, nb) * count + Math.max(na, nb);
      const before = first.get(key);
      if (before === undefined) {
        first.set(key, t);
        place.set(key, [a, b]);
      } else {
        first.delete(key);
        place.delete(key);
        normalOf(part, before, one);
        normalOf(part, t, two);
        const cosine =
          (one[0] ?? 0) * (two[0] ?? 0) + (one[1] ?? 0) * (two[1] ?? 0) + (one[2] ?? 0) * (two[2] ?? 0);
        if (cosine < SHARP_COSINE) kept.push(a, b);
      }
    }
  }
  for (const [a, b] of place.values()) kept.push(a, b);
  return Uint32Array.from(kept);
}
