// SPDX-License-Identifier: Apache-2.0
// The places of largest or smallest value: peaks among their neighbours, so far apart, largest first. No three.js.
import { nodeNumbers, type PartField, type ScenePart, SOLVER } from "../scene";
import { type Cut, isCutAway } from "./cuts";

export interface HotSpot {
  /** Position in the list of parts. */
  readonly part: number;
  readonly vertex: number;
  readonly node: number;
  readonly value: number;
}

export interface HotSpotQuery {
  readonly parts: readonly ScenePart[];
  readonly fields: readonly (PartField | null)[];
  readonly component: number;
  /** Parts that nobody sees have no spots. */
  readonly hidden: (part: number) => boolean;
  readonly cuts: readonly Cut[];
  readonly count: number;
  /** Model units; nearer ones than this count as the same place. */
  readonly separation: number;
  readonly largest: boolean;
}

/** Nodes of one part that no neighbour outdoes; the solver's own values only. */
function peaks(query: HotSpotQuery, index: number): HotSpot[] {
  const part = query.parts[index];
  const field = query.fields[index];
  if (!part || !field) return [];
  const { numbers, count } = nodeNumbers(part);
  const sign = query.largest ? 1 : -1;
  const read = (vertex: number) =>
    sign * (field.values[vertex * field.components + query.component] ?? Number.NaN);
  const outdone = new Uint8Array(count);
  for (let i = 0; i < part.indices.length; ++i) {
    const a = part.indices[i] ?? 0;
    const b = part.indices[i % 3 === 2 ? i - 2 : i + 1] ?? 0;
    const [va, vb] = [read(a), read(b)];
    if (va < vb) outdone[numbers[a] ?? 0] = 1;
    else if (vb < va) outdone[numbers[b] ?? 0] = 1;
  }
  const best = new Int32Array(count).fill(-1);
  for (let vertex = 0; vertex < numbers.length; ++vertex) {
    const number = numbers[vertex] ?? 0;
    if (number === 0 || outdone[number] || field.state[vertex] !== SOLVER || Number.isNaN(read(vertex)))
      continue;
    const p = 3 * vertex;
    const [x, y, z] = [part.positions[p] ?? 0, part.positions[p + 1] ?? 0, part.positions[p + 2] ?? 0];
    if (isCutAway(query.cuts, x, y, z)) continue;
    const before = best[number] ?? -1;
    if (before < 0 || read(vertex) > read(before)) best[number] = vertex;
  }
  const out: HotSpot[] = [];
  for (const vertex of best)
    if (vertex >= 0)
      out.push({ part: index, vertex, node: part.nodeIds[vertex] ?? 0, value: sign * read(vertex) });
  return out;
}

/** The first `count` places, the most extreme first; the smaller node id first on a tie. */
export function hotSpots(query: HotSpotQuery): HotSpot[] {
  const sign = query.largest ? -1 : 1;
  const all = query.parts.flatMap((_, i) => (query.hidden(i) ? [] : peaks(query, i)));
  all.sort((a, b) => sign * (a.value - b.value) || a.node - b.node);
  const chosen: HotSpot[] = [];
  const at = (spot: HotSpot, axis: number) => query.parts[spot.part]?.positions[3 * spot.vertex + axis] ?? 0;
  for (const spot of all) {
    if (chosen.length >= query.count) break;
    const near = chosen.some(
      (other) =>
        Math.hypot(at(spot, 0) - at(other, 0), at(spot, 1) - at(other, 1), at(spot, 2) - at(other, 2)) <
        query.separation,
    );
    if (!near) chosen.push(spot);
  }
  return chosen;
}
