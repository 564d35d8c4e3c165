// SPDX-License-Identifier: Apache-2.0
// The visible skin in slabs across an axis: of each the largest value with its node, and the mean over the area.
import type { PartField, ScenePart } from "../scene";
import { MISSING } from "../scene";

export interface Slab {
  /** Middle of the slab along the axis, model units minus the scene's origin. */
  readonly at: number;
  /** NaN: nobody has a value here. */
  readonly max: number;
  readonly part: number;
  readonly vertex: number;
  /** Of the triangles whose middle lies here, by their area; NaN: none. */
  readonly mean: number;
}

export interface SlabQuery {
  readonly parts: readonly ScenePart[];
  readonly fields: readonly (PartField | null)[];
  readonly component: number;
  readonly hidden: (part: number) => boolean;
  readonly axis: 0 | 1 | 2;
  readonly count: number;
}

type Triple = readonly [number, number, number];

function areaOf(p: Triple, q: Triple, r: Triple): number {
  const [a, b] = [q, r].map((end) => end.map((v, k) => v - (p[k] ?? 0)));
  const side = (i: number, j: number) => (a?.[i] ?? 0) * (b?.[j] ?? 0) - (a?.[j] ?? 0) * (b?.[i] ?? 0);
  return Math.hypot(side(1, 2), side(2, 0), side(0, 1)) / 2;
}

export function slabsOf(query: SlabQuery): Slab[] {
  const { parts, fields, component, axis, count } = query;
  let [lo, hi] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  const seen = parts.map((_, i) => fields[i] && !query.hidden(i));
  for (const [i, part] of parts.entries()) {
    if (!seen[i]) continue;
    for (let v = axis; v < part.positions.length; v += 3) {
      lo = Math.min(lo, part.positions[v] ?? 0);
      hi = Math.max(hi, part.positions[v] ?? 0);
    }
  }
  if (!(hi >= lo)) return [];
  const slabs = Array.from({ length: count }, (_, i) => ({
    at: lo + ((i + 0.5) * (hi - lo)) / count,
    max: Number.NaN,
    part: -1,
    vertex: -1,
    mean: Number.NaN,
    sum: 0,
    area: 0,
  }));
  const slabAt = (x: number) => {
    const place = hi > lo ? Math.floor(((x - lo) / (hi - lo)) * count) : 0;
    return slabs[Math.min(Math.max(place, 0), count - 1)];
  };
  for (const [index, part] of parts.entries()) {
    const field = fields[index];
    if (!seen[index] || !field) continue;
    const readAt = (v: number) =>
      field.state[v] === MISSING
        ? Number.NaN
        : (field.values[v * field.components + component] ?? Number.NaN);
    const placeOf = (v: number): Triple => [
      part.positions[3 * v] ?? 0,
      part.positions[3 * v + 1] ?? 0,
      part.positions[3 * v + 2] ?? 0,
    ];
    for (let i = 0; i + 2 < part.indices.length; i += 3) {
      const corners = [0, 1, 2].map((k) => part.indices[i + k] ?? 0);
      for (const v of corners) {
        const slab = slabAt(part.positions[3 * v + axis] ?? 0);
        const value = part.nodeIds[v] === 0 ? Number.NaN : readAt(v);
        if (!slab || Number.isNaN(value) || value <= slab.max) continue;
        Object.assign(slab, { max: value, part: index, vertex: v });
      }
      const [p, q, r] = corners.map(placeOf);
      if (!p || !q || !r) continue;
      const mean = corners.reduce((sum, v) => sum + readAt(v) / 3, 0);
      const slab = slabAt(((p[axis] ?? 0) + (q[axis] ?? 0) + (r[axis] ?? 0)) / 3);
      const area = areaOf(p, q, r);
      if (!slab || Number.isNaN(mean)) continue;
      slab.sum += mean * area;
      slab.area += area;
    }
  }
  return slabs.map(({ sum, area, ...slab }) => ({ ...slab, mean: area > 0 ? sum / area : Number.NaN }));
}
