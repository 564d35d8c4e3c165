// SPDX-License-Identifier: Apache-2.0
// A path on the skin: from node to node by the shortest way along edges of elements. No three.js.
import { nodeNumbers, type ScenePart } from "../scene";
import type { Place, Weights } from "./sample";

/** One edge of a triangle, walked from one corner to another. */
interface Leg {
  readonly triangle: number;
  readonly from: number;
  readonly to: number;
  /** Way behind it, model units. */
  readonly start: number;
  readonly length: number;
}

export interface Walk {
  /** Position in the list of parts. */
  readonly part: number;
  readonly legs: readonly Leg[];
  /** Model units. */
  readonly length: number;
}

/** Half-edges by the node they leave, each way; a half-edge is three times a triangle plus a corner, or its bitwise not. */
interface Net {
  readonly numbers: ArrayLike<number>;
  readonly first: Uint32Array;
  readonly edges: Int32Array;
}

const after = (i: number) => (i % 3 === 2 ? i - 2 : i + 1);

function netOf(part: ScenePart): Net {
  const { numbers, count } = nodeNumbers(part);
  const { indices } = part;
  const first = new Uint32Array(count + 1);
  const ends = (i: number) => [numbers[indices[i] ?? 0] ?? 0, numbers[indices[after(i)] ?? 0] ?? 0] as const;
  for (let i = 0; i < indices.length; ++i) {
    const [a, b] = ends(i);
    if (a === 0 || b === 0) continue;
    first[a + 1] = (first[a + 1] ?? 0) + 1;
    first[b + 1] = (first[b + 1] ?? 0) + 1;
  }
  for (let n = 0; n < count; ++n) first[n + 1] = (first[n + 1] ?? 0) + (first[n] ?? 0);
  const edges = new Int32Array(first[count] ?? 0);
  const next = first.slice();
  for (let i = 0; i < indices.length; ++i) {
    const [a, b] = ends(i);
    if (a === 0 || b === 0) continue;
    edges[next[a] ?? 0] = i;
    next[a] = (next[a] ?? 0) + 1;
    edges[next[b] ?? 0] = ~i;
    next[b] = (next[b] ?? 0) + 1;
  }
  return { numbers, first, edges };
}

/** Waiting nodes, the nearest first. */
class Queue {
  readonly #items: { node: number; way: number }[] = [];

  push(node: number, way: number): void {
    const items = this.#items;
    let i = items.length;
    items.push({ node, way });
    while (i > 0) {
      const up = (i - 1) >> 1;
      const parent = items[up];
      if (!parent || parent.way <= way) break;
      items[i] = parent;
      items[up] = { node, way };
      i = up;
    }
  }

  pop(): { node: number; way: number } | undefined {
    const items = this.#items;
    const top = items[0];
    const last = items.pop();
    if (!last || items.length === 0) return top;
    let i = 0;
    for (;;) {
      let least = 2 * i + 1;
      if (least >= items.length) break;
      if ((items[least + 1]?.way ?? Number.POSITIVE_INFINITY) < (items[least]?.way ?? 0)) least += 1;
      const child = items[least];
      if (!child || child.way >= last.way) break;
      items[i] = child;
      i = least;
    }
    items[i] = last;
    return top;
  }
}

/** The edges of the shortest way between two nodes' numbers; null when there is none. */
function shortest(part: ScenePart, net: Net, from: number, to: number): Omit<Leg, "start">[] | null {
  const { indices, positions } = part;
  const way = new Float64Array(net.first.length - 1).fill(Number.POSITIVE_INFINITY);
  const came = new Int32Array(way.length);
  const legOf = (edge: number): Omit<Leg, "start"> & { far: number; near: number } => {
    const i = edge < 0 ? ~edge : edge;
    const [a, b] = edge < 0 ? [after(i), i] : [i, after(i)];
    const [va, vb] = [indices[a] ?? 0, indices[b] ?? 0];
    const apart = [0, 1, 2].map((k) => (positions[3 * va + k] ?? 0) - (positions[3 * vb + k] ?? 0));
    const triangle = Math.floor(i / 3);
    const ends = { near: net.numbers[va] ?? 0, far: net.numbers[vb] ?? 0 };
    return { triangle, from: a % 3, to: b % 3, length: Math.hypot(...apart), ...ends };
  };
  const queue = new Queue();
  way[from] = 0;
  queue.push(from, 0);
  for (let top = queue.pop(); top && top.node !== to; top = queue.pop()) {
    if (top.way > (way[top.node] ?? 0)) continue;
    for (let e = net.first[top.node] ?? 0; e < (net.first[top.node + 1] ?? 0); ++e) {
      const edge = net.edges[e] ?? 0;
      const { far, length } = legOf(edge);
      const longer = top.way + length;
      if (longer >= (way[far] ?? 0)) continue;
      way[far] = longer;
      came[far] = edge;
      queue.push(far, longer);
    }
  }
  if (!Number.isFinite(way[to] ?? Number.NaN)) return null;
  const legs: Omit<Leg, "start">[] = [];
  for (let node = to; node !== from; ) {
    const { near, far: _, ...leg } = legOf(came[node] ?? 0);
    legs.push(leg);
    node = near;
  }
  return legs.reverse();
}

/** The walk through nodes in their order; null when they are not joined by the skin of one part. */
export function walkThrough(parts: readonly ScenePart[], nodes: readonly number[]): Walk | null {
  const index = parts.findIndex((p) => nodes.every((id) => p.nodeIds.includes(id)));
  const part = parts[index];
  if (!part || nodes.length < 2) return null;
  const net = netOf(part);
  const numberOf = (id: number) => net.numbers[part.nodeIds.indexOf(id)] ?? 0;
  const legs: Leg[] = [];
  let start = 0;
  for (let n = 1; n < nodes.length; ++n) {
    const found = shortest(part, net, numberOf(nodes[n - 1] ?? 0), numberOf(nodes[n] ?? 0));
    if (!found) return null;
    for (const leg of found) {
      legs.push({ ...leg, start });
      start += leg.length;
    }
  }
  return legs.length > 0 ? { part: index, legs, length: start } : null;
}

/** The place after a share of the way, 0..1. */
export function placeOnWalk(walk: Walk, share: number): Place {
  const way = Math.min(Math.max(share, 0), 1) * walk.length;
  const later = walk.legs.findIndex((leg) => leg.start + leg.length >= way);
  const leg = walk.legs[later < 0 ? walk.legs.length - 1 : later];
  if (!leg) return { part: walk.part, triangle: 0, weights: [1, 0, 0] };
  const along = leg.length > 0 ? Math.min(Math.max((way - leg.start) / leg.length, 0), 1) : 0;
  const weights: [number, number, number] = [0, 0, 0];
  weights[leg.from] = 1 - along;
  weights[leg.to] = along;
  return { part: walk.part, triangle: leg.triangle, weights: weights as Weights };
}
