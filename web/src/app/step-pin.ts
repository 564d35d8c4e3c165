// SPDX-License-Identifier: Apache-2.0
// Arrow keys: from the pinned node to the neighbour that lies in the arrow's direction on the screen.
import { findNode, nearestNode, type Place } from "../probe";
import type { Stage } from "../render";
import type { ModelView } from "./model-view";

export type Arrow = readonly [number, number];

/** Neighbours further off the arrow's direction than this are not meant. */
const WIDEST_COSINE = 0.35;

/** Ids of nodes that share a triangle with the node. */
export function neighbourIds(view: Pick<ModelView, "scene">, id: number): Set<number> {
  const ids = new Set<number>();
  for (const { indices, nodeIds } of view.scene.parts) {
    for (let i = 0; i + 2 < indices.length; i += 3) {
      const corners = [indices[i] ?? 0, indices[i + 1] ?? 0, indices[i + 2] ?? 0].map((v) => nodeIds[v] ?? 0);
      if (!corners.includes(id)) continue;
      for (const other of corners) if (other !== 0 && other !== id) ids.add(other);
    }
  }
  return ids;
}

/** The neighbour's place, or null when none lies that way. `arrow` is in screen pixels, y downwards. */
export function neighbourPlace(view: ModelView, stage: Stage, from: Place, arrow: Arrow): Place | null {
  const { parts } = view.scene;
  const part = parts[from.part];
  const node = part && nearestNode(part, from);
  if (!node) return null;
  const matrix = view.model.worldMatrix();
  const start = stage.project(view.picker.worldOf(findNode(parts, node.id) ?? from, matrix));
  if (!start) return null;
  let best: { place: Place; cosine: number } | null = null;
  for (const id of neighbourIds(view, node.id)) {
    const place = findNode(parts, id);
    const at = place && stage.project(view.picker.worldOf(place, matrix));
    if (!place || !at) continue;
    const [dx, dy] = [at.x - start.x, at.y - start.y];
    const length = Math.hypot(dx, dy);
    const cosine = length > 1e-6 ? (dx * arrow[0] + dy * arrow[1]) / length : -1;
    if (cosine > WIDEST_COSINE && (!best || cosine > best.cosine)) best = { place, cosine };
  }
  return best?.place ?? null;
}
