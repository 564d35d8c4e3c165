// SPDX-License-Identifier: Apache-2.0
// Whether parts enclose volumes: each edge of a triangle must be met once the other way round. No three.js.
import type { ScenePart } from "../scene";

/** Two sums of 32 bits over the edges of a part, each with its direction's sign: edges that meet their like cancel. */
export type EdgeSum = readonly [number, number];

/** All bits of the result depend on all bits of `x` (the last step of MurmurHash3). */
function scattered(x: number): number {
  const once = Math.imul(x ^ (x >>> 16), 0x85ebca6b);
  const twice = Math.imul(once ^ (once >>> 13), 0xc2b2ae35);
  return twice ^ (twice >>> 16);
}

const HIGH = 2 ** 32;

/** Of one part; `first`: its first vertex among those of all parts. A vertex without node is itself. */
export function openEdges(part: ScenePart, first: number): EdgeSum {
  const { nodeIds, indices } = part;
  const [one, two] = [new Int32Array(nodeIds.length), new Int32Array(nodeIds.length)];
  for (let v = 0; v < nodeIds.length; ++v) {
    const id = nodeIds[v] || -(first + v + 1);
    const high = Math.floor(id / HIGH);
    one[v] = scattered((id | 0) ^ scattered(high ^ 0x5bd1e995));
    two[v] = scattered(((id | 0) + 0x3c6ef372) ^ scattered(high ^ 0x1b873593));
  }
  let [sumOne, sumTwo] = [0, 0];
  for (let i = 0; i < indices.length; ++i) {
    const a = indices[i] ?? 0;
    const b = indices[i % 3 === 2 ? i - 2 : i + 1] ?? 0;
    const [a1, a2, b1, b2] = [one[a] ?? 0, two[a] ?? 0, one[b] ?? 0, two[b] ?? 0];
    if (a1 === b1 && a2 === b2) continue;
    const forth = a1 < b1 || (a1 === b1 && a2 < b2);
    const edgeOne = forth ? scattered(a1 ^ scattered(b1 + 1)) : scattered(b1 ^ scattered(a1 + 1));
    const edgeTwo = forth ? scattered(a2 ^ scattered(b2 + 1)) : scattered(b2 ^ scattered(a2 + 1));
    sumOne = (forth ? sumOne + edgeOne : sumOne - edgeOne) | 0;
    sumTwo = (forth ? sumTwo + edgeTwo : sumTwo - edgeTwo) | 0;
  }
  return [sumOne, sumTwo];
}
