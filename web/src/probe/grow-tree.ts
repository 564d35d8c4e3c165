// SPDX-License-Identifier: Apache-2.0
// Builds the hierarchy of boxes over triangles: in the worker for large models, on the page for small ones.
import { BufferAttribute, BufferGeometry } from "three";
import { MeshBVH } from "three-mesh-bvh";

/** Boxes over the triangles of one part, as three-mesh-bvh packs them (version 1 of its serial form). */
export interface TreeData {
  /**
   * 32 bytes a node, each followed by its first child: box (6 floats, low then high); a leaf's first triangle or how many
   * nodes on its second child stands; of a leaf the number of triangles and 0xffff.
   */
  readonly nodes: ArrayBuffer;
  /** Triangles in the order of the leaves. */
  readonly order: Uint32Array | Uint16Array;
}

export function growTree(positions: Float32Array, indices: Uint32Array): TreeData | null {
  if (indices.length === 0) return null;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }), { cloneBuffers: false });
  const [nodes] = tree.roots;
  const order = tree.indirectBuffer as Uint32Array | Uint16Array | null;
  if (!nodes || tree.roots.length !== 1 || !order) throw new Error("the hierarchy has another form");
  return { nodes: nodes as ArrayBuffer, order };
}
