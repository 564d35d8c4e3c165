// SPDX-License-Identifier: Apache-2.0
// A place on a triangle -> ids and values: barycentric between nodes, the file's at them. No three.js.
import { INTERPOLATED, MISSING, type PartField, type ScenePart } from "../scene";
import type { SectionPlace } from "./sections";

export type Weights = readonly [number, number, number];

/** Where a pointer meets the skin. */
export interface Place {
  /** Position in the list of parts. */
  readonly part: number;
  readonly triangle: number;
  readonly weights: Weights;
  /** On the section that a plane opens: then `part` is -1, for no triangle of the skin is there. */
  readonly section?: SectionPlace;
}

export type ValueState = "solver" | "interpolated" | "missing";

export interface PlaceValue {
  /** Barycentric mean of the three corners; null when one of them has no value. */
  readonly value: number | null;
  /** The scene's value at the nearest node, bit for bit; null when it has none. */
  readonly nodeValue: number | null;
  readonly state: ValueState;
}

/** A pointer this near to a node (in parts of the triangle) is on the node. */
const ON_NODE = 1e-4;

/** Weights of a point in the plane of triangle abc, in double; negatives from rounding become 0. */
export function barycentric(
  p: ArrayLike<number>,
  a: ArrayLike<number>,
  b: ArrayLike<number>,
  c: ArrayLike<number>,
): Weights {
  const sub = (u: ArrayLike<number>, v: ArrayLike<number>) =>
    [(u[0] ?? 0) - (v[0] ?? 0), (u[1] ?? 0) - (v[1] ?? 0), (u[2] ?? 0) - (v[2] ?? 0)] as const;
  const dot = (u: readonly [number, number, number], v: readonly [number, number, number]) =>
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const e0 = sub(b, a);
  const e1 = sub(c, a);
  const d = sub(p, a);
  const [d00, d01, d11, d20, d21] = [dot(e0, e0), dot(e0, e1), dot(e1, e1), dot(d, e0), dot(d, e1)];
  const area = d00 * d11 - d01 * d01;
  if (!(area > 0)) return [1, 0, 0];
  const v = (d11 * d20 - d01 * d21) / area;
  const w = (d00 * d21 - d01 * d20) / area;
  return clampWeights([1 - v - w, v, w]);
}

function clampWeights(raw: Weights): Weights {
  const on = raw.findIndex((w) => w > 1 - ON_NODE);
  if (on >= 0) return [on === 0 ? 1 : 0, on === 1 ? 1 : 0, on === 2 ? 1 : 0];
  const positive = raw.map((w) => Math.max(w, 0)) as [number, number, number];
  const sum = positive[0] + positive[1] + positive[2];
  return [positive[0] / sum, positive[1] / sum, positive[2] / sum];
}

/** The three vertices of a triangle. */
export function cornersOf(part: ScenePart, triangle: number): readonly [number, number, number] {
  const at = 3 * triangle;
  return [part.indices[at] ?? 0, part.indices[at + 1] ?? 0, part.indices[at + 2] ?? 0];
}

/** The corner of largest weight that is a node of the solver; the smallest id on a tie; null if none is. */
export function nearestNode(part: ScenePart, place: Place): { id: number; vertex: number } | null {
  let best: { id: number; vertex: number; weight: number } | null = null;
  for (const [k, vertex] of cornersOf(part, place.triangle).entries()) {
    const id = part.nodeIds[vertex] ?? 0;
    const weight = place.weights[k] ?? 0;
    if (id === 0) continue;
    if (!best || weight > best.weight || (weight === best.weight && id < best.id))
      best = { id, vertex, weight };
  }
  return best && { id: best.id, vertex: best.vertex };
}

/** Undeformed position in model units. */
export function placePoint(
  part: ScenePart,
  place: Place,
  origin: ArrayLike<number>,
): [number, number, number] {
  const corners = cornersOf(part, place.triangle);
  return [0, 1, 2].map((axis) =>
    corners.reduce<number>(
      (sum, vertex, k) => sum + (place.weights[k] ?? 0) * (part.positions[3 * vertex + axis] ?? 0),
      origin[axis] ?? 0,
    ),
  ) as [number, number, number];
}

const NONE: PlaceValue = { value: null, nodeValue: null, state: "missing" };

/** One component of a result at a place. */
export function valueAt(
  part: ScenePart,
  place: Place,
  field: PartField | null,
  component: number,
): PlaceValue {
  if (!field) return NONE;
  const node = nearestNode(part, place);
  const nodeRaw = node ? field.values[node.vertex * field.components + component] : Number.NaN;
  const nodeValue = nodeRaw === undefined || Number.isNaN(nodeRaw) ? null : nodeRaw;
  let value = 0;
  let state: ValueState = "solver";
  for (const [k, vertex] of cornersOf(part, place.triangle).entries()) {
    const weight = place.weights[k] ?? 0;
    if (field.state[vertex] === MISSING) return { value: null, nodeValue, state: "missing" };
    if (field.state[vertex] === INTERPOLATED && weight > 0 && part.nodeIds[vertex] !== 0)
      state = "interpolated";
    if (weight > 0) value += weight * (field.values[vertex * field.components + component] ?? Number.NaN);
  }
  return { value, nodeValue, state };
}
