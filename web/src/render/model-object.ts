// SPDX-License-Identifier: Apache-2.0
// The parts of a scene as three.js objects: positions once, value and displacement per step.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Group,
  LineSegments,
  Matrix4,
  Mesh,
  Sphere,
  Vector3,
} from "three";
import type { ColourEffect, ValueRange } from "../present";
import { MISSING, type PartField, type SceneData, type ScenePart } from "../scene";
import { EdgeMaterial, FieldMaterial } from "./field-material";

interface Drawn {
  readonly part: ScenePart;
  readonly faces: BufferGeometry;
  readonly edges: BufferGeometry | null;
  /** For each edge vertex, a vertex of the part with the same node; -1 if none. */
  readonly edgeSource: Int32Array | null;
}

function edgeSources(part: ScenePart): Int32Array | null {
  if (!part.edges) return null;
  const vertexOf = new Map<number, number>();
  for (const [vertex, id] of part.nodeIds.entries()) {
    if (id !== 0 && !vertexOf.has(id)) vertexOf.set(id, vertex);
  }
  return Int32Array.from(part.edges.nodeIds, (id) => vertexOf.get(id) ?? -1);
}

function drawnOf(part: ScenePart): Drawn {
  const count = part.nodeIds.length;
  const faces = new BufferGeometry();
  faces.setAttribute("position", new BufferAttribute(part.positions, 3));
  if (part.normals) faces.setAttribute("normal", new BufferAttribute(part.normals, 3));
  faces.setAttribute("value", new BufferAttribute(new Float32Array(count), 1));
  faces.setAttribute("missing", new BufferAttribute(new Float32Array(count), 1));
  faces.setAttribute("displacement", new BufferAttribute(new Float32Array(3 * count), 3));
  faces.setIndex(new BufferAttribute(part.indices, 1));
  if (!part.normals) faces.computeVertexNormals();
  let edges: BufferGeometry | null = null;
  if (part.edges) {
    edges = new BufferGeometry();
    edges.setAttribute("position", new BufferAttribute(part.edges.positions, 3));
    edges.setAttribute("displacement", new BufferAttribute(new Float32Array(part.edges.positions.length), 3));
    edges.setIndex(new BufferAttribute(part.edges.indices, 1));
  }
  return { part, faces, edges, edgeSource: edgeSources(part) };
}

/** Median length of the element edges, model units; 0 without edges. */
function typicalEdge(parts: readonly ScenePart[]): number {
  const lengths: number[] = [];
  for (const { edges } of parts) {
    if (!edges) continue;
    const step = Math.max(2, 2 * Math.floor(edges.indices.length / 2000));
    for (let i = 0; i + 1 < edges.indices.length; i += step) {
      const [a, b] = [3 * (edges.indices[i] ?? 0), 3 * (edges.indices[i + 1] ?? 0)];
      const d = (axis: number) => (edges.positions[a + axis] ?? 0) - (edges.positions[b + axis] ?? 0);
      lengths.push(Math.hypot(d(0), d(1), d(2)));
    }
  }
  lengths.sort((a, b) => a - b);
  return lengths[Math.floor(lengths.length / 2)] ?? 0;
}

const scratchScale = new Vector3();

export class ModelObject {
  /** Carries the scene's matrix; put it under whatever moves the model. */
  readonly group = new Group();
  readonly material = new FieldMaterial();
  readonly edgeMaterial = new EdgeMaterial();
  /** Undeformed box, model units minus origin. */
  readonly box = new Box3();
  readonly #drawn: Drawn[];
  readonly #typicalEdge: number;
  #edgesWanted = true;

  constructor(scene: SceneData) {
    this.group.matrixAutoUpdate = false;
    this.group.matrix.fromArray([...scene.matrix]);
    this.#drawn = scene.parts.map(drawnOf);
    for (const drawn of this.#drawn) {
      drawn.faces.computeBoundingBox();
      if (drawn.faces.boundingBox) this.box.union(drawn.faces.boundingBox);
      const mesh = new Mesh(drawn.faces, this.material);
      mesh.frustumCulled = false;
      this.group.add(mesh);
      if (drawn.edges) {
        const lines = new LineSegments(drawn.edges, this.edgeMaterial);
        lines.frustumCulled = false;
        lines.renderOrder = 1;
        this.group.add(lines);
      }
    }
    this.#typicalEdge = typicalEdge(scene.parts);
    this.material.setHatchSpacing(this.box.getSize(new Vector3()).length() / 60);
  }

  /** Longest side of the undeformed box, model units. */
  get largestSide(): number {
    const size = this.box.getSize(new Vector3());
    return Math.max(size.x, size.y, size.z);
  }

  /** Bounds in the space the group stands in (metres). */
  bounds(): Box3 {
    return this.box.clone().applyMatrix4(this.group.matrix);
  }

  sphere(): Sphere {
    return this.bounds().getBoundingSphere(new Sphere());
  }

  setColour(effect: ColourEffect | null, range: ValueRange | null): void {
    this.material.setColour(effect, range);
  }

  /** Values to colour by; null: none. */
  setValues(fields: readonly (PartField | null)[] | null, component: number): void {
    for (const [index, { faces }] of this.#drawn.entries()) {
      const value = faces.getAttribute("value") as BufferAttribute;
      const missing = faces.getAttribute("missing") as BufferAttribute;
      const field = fields?.[index] ?? null;
      for (let i = 0; i < value.count; ++i) {
        const gone = !field || field.state[i] === MISSING;
        value.array[i] = gone ? 0 : (field.values[i * field.components + component] ?? 0);
        missing.array[i] = gone ? 1 : 0;
      }
      value.needsUpdate = true;
      missing.needsUpdate = true;
    }
  }

  /** Displacement vectors, model units, 3 a vertex; a vertex without one stays in its place. */
  setDisplacements(displacements: readonly (Float32Array | null)[]): void {
    for (const [index, { faces, edges, edgeSource }] of this.#drawn.entries()) {
      const source = displacements[index] ?? null;
      const target = faces.getAttribute("displacement") as BufferAttribute;
      for (let i = 0; i < target.array.length; ++i) {
        const moved = source?.[i] ?? 0;
        target.array[i] = Number.isNaN(moved) ? 0 : moved;
      }
      target.needsUpdate = true;
      if (!edges || !edgeSource) continue;
      const lines = edges.getAttribute("displacement") as BufferAttribute;
      for (const [i, vertex] of edgeSource.entries()) {
        for (let c = 0; c < 3; ++c)
          lines.array[3 * i + c] = vertex < 0 ? 0 : (target.array[3 * vertex + c] ?? 0);
      }
      lines.needsUpdate = true;
    }
  }

  setFactor(factor: number): void {
    this.material.setFactor(factor);
    this.edgeMaterial.setFactor(factor);
  }

  setEdges(wanted: boolean): void {
    this.#edgesWanted = wanted;
  }

  /** Edges fade out from 20 to 2 pixels a segment, so that a fine mesh seen whole shows its colours, not its
   * lines; `pixelSize` is metres a pixel at the model. */
  fadeEdges(pixelSize: number): void {
    const scale = scratchScale.setFromMatrixScale(this.group.matrixWorld).x;
    const pixels = pixelSize > 0 ? (this.#typicalEdge * scale) / pixelSize : 0;
    const share = Math.min(Math.max((pixels - 2) / 18, 0), 1);
    this.edgeMaterial.setOpacity(this.#edgesWanted ? 0.55 * share : 0);
  }

  /** Model units to world. */
  worldMatrix(target = new Matrix4()): Matrix4 {
    this.group.updateWorldMatrix(true, false);
    return target.copy(this.group.matrixWorld);
  }

  dispose(): void {
    for (const { faces, edges } of this.#drawn) {
      faces.dispose();
      edges?.dispose();
    }
    this.material.dispose();
    this.edgeMaterial.dispose();
  }
}
