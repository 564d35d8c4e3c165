// SPDX-License-Identifier: Apache-2.0
// Lines of the model: whose node each end has, how long they are, and the ghost of the undeformed shape.
import { BufferAttribute, BufferGeometry, LineSegments } from "three";
import { firstVertices, type ScenePart } from "../scene";
import { featureEdges } from "./feature-edges";
import type { EdgeMaterial } from "./field-material";
import type { Slice } from "./merged";

/** For each edge vertex of the merged edges, a merged face vertex with the same node; -1 if none. */
export function edgeSources(faces: readonly Slice[], edges: readonly Slice[]): Int32Array {
  const out = new Int32Array(edges.reduce((sum, slice) => sum + slice.vertices, 0)).fill(-1);
  for (const { part, firstVertex } of edges) {
    const face = faces.find((slice) => slice.part === part);
    if (!face || !part.edges) continue;
    const vertexOf = firstVertices(part.nodeIds);
    for (let i = 0; i < part.edges.nodeIds.length; ++i) {
      const vertex = vertexOf(part.edges.nodeIds[i] ?? 0);
      if (vertex >= 0) out[firstVertex + i] = face.firstVertex + vertex;
    }
  }
  return out;
}

/** Edges that are looked at for the median. */
const SAMPLES = 1000;

/** Median length of the element edges, model units; 0 without edges. */
export function typicalEdge(parts: readonly ScenePart[]): number {
  const lengths: number[] = [];
  const all = parts.reduce((sum, { edges }) => sum + (edges?.indices.length ?? 0), 0);
  const step = Math.max(2, 2 * Math.floor(all / 2 / SAMPLES));
  for (const { edges } of parts) {
    if (!edges) continue;
    for (let i = 0; i + 1 < edges.indices.length; i += step) {
      const [a, b] = [3 * (edges.indices[i] ?? 0), 3 * (edges.indices[i + 1] ?? 0)];
      const d = (axis: number) => (edges.positions[a + axis] ?? 0) - (edges.positions[b + axis] ?? 0);
      lengths.push(Math.hypot(d(0), d(1), d(2)));
    }
  }
  lengths.sort((a, b) => a - b);
  return lengths[Math.floor(lengths.length / 2)] ?? 0;
}

/** Where the model was: its sharp edges, all parts in one draw call. */
export function makeGhost(parts: readonly ScenePart[], material: EdgeMaterial): LineSegments {
  const lists = parts.map(featureEdges);
  const count = lists.reduce((sum, list) => sum + list.length, 0);
  const positions = new Float32Array(3 * count);
  const owners = new Uint16Array(count);
  let at = 0;
  for (const [index, list] of lists.entries()) {
    const source = parts[index]?.positions;
    for (const vertex of list) {
      for (let c = 0; c < 3; ++c) positions[3 * at + c] = source?.[3 * vertex + c] ?? 0;
      owners[at] = index;
      at += 1;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("owner", new BufferAttribute(owners, 1));
  return new LineSegments(geometry, material);
}
