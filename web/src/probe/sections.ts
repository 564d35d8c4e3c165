// SPDX-License-Identifier: Apache-2.0
// Where a place is on the section that a plane opens, and the values there. No three.js.
import type { SectionData } from "../scene";
import type { Cut } from "./cuts";
import type { Weights } from "./sample";

/** A section that is drawn: values of results by their key, as many a vertex as are known. */
export interface DrawnSection {
  readonly plane: Cut;
  readonly data: SectionData;
  /** By the result's key in the presentation; NaN where missing. */
  readonly values: ReadonlyMap<string, Float32Array>;
  /** Whether a triangle belongs to a part that is drawn. */
  readonly isDrawn: (triangle: number) => boolean;
}

/** What the server says of one place inside, by the element's own shape functions. */
export interface InteriorAnswer {
  readonly elementId: number | null;
  readonly elementType: string;
  /** The node that counts most there, the smallest number on a tie. */
  readonly nodeId: number | null;
  /** By the result's key. */
  readonly values: ReadonlyMap<string, { readonly value: number | null; readonly nodeValue: number | null }>;
}

/** A place on a section. */
export interface SectionPlace {
  readonly section: DrawnSection;
  readonly triangle: number;
  readonly weights: Weights;
  /** Model units minus the scene's origin, of the shape that is drawn. */
  readonly point: readonly [number, number, number];
  /** Once the server has answered for this very place. */
  exact: InteriorAnswer | null;
}

/** So far outside of a triangle, in parts of it, a place still counts: float32 corners are not quite in line. */
const SLACK = 1e-3;
/** Of the farthest place of the section: so near to the plane a place is on it. */
const ON_PLANE = 1e-4;

/** The triangle that a place of the plane is in. */
export function locate(
  section: DrawnSection,
  point: readonly [number, number, number],
): { triangle: number; weights: Weights } | null {
  const { positions, indices } = section.data;
  const n = section.plane.normal;
  // Seen along the axis that the normal is nearest to.
  const drop = [0, 1, 2].reduce((best, i) => (Math.abs(n[i] ?? 0) > Math.abs(n[best] ?? 0) ? i : best), 0);
  const [u, v] = [(drop + 1) % 3, (drop + 2) % 3];
  const [px, py] = [point[u] ?? 0, point[v] ?? 0];
  let best: { triangle: number; weights: Weights } | null = null;
  let inside = -SLACK;
  for (let t = 0; 3 * t < indices.length; ++t) {
    const [a, b, c] = [
      3 * (indices[3 * t] ?? 0),
      3 * (indices[3 * t + 1] ?? 0),
      3 * (indices[3 * t + 2] ?? 0),
    ];
    const [ax, ay] = [positions[a + u] ?? 0, positions[a + v] ?? 0];
    const [bx, by] = [(positions[b + u] ?? 0) - ax, (positions[b + v] ?? 0) - ay];
    const [cx, cy] = [(positions[c + u] ?? 0) - ax, (positions[c + v] ?? 0) - ay];
    const area = bx * cy - by * cx;
    if (area === 0) continue;
    const wb = ((px - ax) * cy - (py - ay) * cx) / area;
    const wc = (bx * (py - ay) - by * (px - ax)) / area;
    const least = Math.min(wb, wc, 1 - wb - wc);
    if (!(least > inside) || !section.isDrawn(t)) continue;
    inside = least;
    const weights = [1 - wb - wc, wb, wc].map((w) => Math.max(w, 0)) as [number, number, number];
    const sum = weights[0] + weights[1] + weights[2];
    best = { triangle: t, weights: [weights[0] / sum, weights[1] / sum, weights[2] / sum] };
    if (least >= 0) break;
  }
  return best;
}

/** Which of the sections has a place, and where. */
export function placeOnSections(
  sections: readonly DrawnSection[],
  point: readonly [number, number, number],
): SectionPlace | null {
  const far = Math.max(...point.map(Math.abs), 1e-30);
  for (const section of sections) {
    const { normal, offset } = section.plane;
    const off = normal[0] * point[0] + normal[1] * point[1] + normal[2] * point[2] - offset;
    const scale = Math.max(far, Math.abs(offset));
    if (Math.abs(off) > ON_PLANE * scale) continue;
    const found = locate(section, point);
    if (found) return { section, ...found, point, exact: null };
  }
  return null;
}

/** As drawn: linear on the triangle; null when a corner has none, or the result is not known there yet. */
export function sectionValue(place: SectionPlace, key: string): number | null {
  const values = place.section.values.get(key);
  if (!values) return null;
  let sum = 0;
  for (let k = 0; k < 3; ++k) {
    const value = values[place.section.data.indices[3 * place.triangle + k] ?? 0] ?? Number.NaN;
    if (Number.isNaN(value)) return null;
    sum += (place.weights[k] ?? 0) * value;
  }
  return sum;
}
