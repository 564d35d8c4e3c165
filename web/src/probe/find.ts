// SPDX-License-Identifier: Apache-2.0
// Node or element id -> a place on the skin.
import type { ScenePart } from "../scene";
import type { Place } from "./sample";

const CORNERS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

/** A triangle corner at the node, or null when the node is not on the skin. */
export function findNode(parts: readonly ScenePart[], id: number): Place | null {
  if (id === 0) return null;
  for (const [index, part] of parts.entries()) {
    for (let i = 0; i < part.indices.length; ++i) {
      if (part.nodeIds[part.indices[i] ?? 0] === id) {
        return { part: index, triangle: Math.floor(i / 3), weights: CORNERS[i % 3] ?? CORNERS[0] };
      }
    }
  }
  return null;
}

/** The middle of the first triangle of the element, or null when none of its facets is on the skin. */
export function findElement(parts: readonly ScenePart[], id: number): Place | null {
  for (const [index, part] of parts.entries()) {
    const triangle = part.elementIds?.indexOf(id) ?? -1;
    if (triangle >= 0) return { part: index, triangle, weights: [1 / 3, 1 / 3, 1 / 3] };
  }
  return null;
}

/** A triangle corner at a vertex; null when no triangle has it. */
export function placeOfVertex(parts: readonly ScenePart[], part: number, vertex: number): Place | null {
  const i = parts[part]?.indices.indexOf(vertex) ?? -1;
  return i < 0 ? null : { part, triangle: Math.floor(i / 3), weights: CORNERS[i % 3] ?? CORNERS[0] };
}

/** The vertex of largest weight at a place. */
export function placeVertex(parts: readonly ScenePart[], place: Place): number {
  const k = place.weights.indexOf(Math.max(...place.weights));
  return parts[place.part]?.indices[3 * place.triangle + k] ?? -1;
}
