// SPDX-License-Identifier: Apache-2.0
// The model as three.js draws it: positions once, value and displacement per step, parts by a table.
import { Box3, type BufferAttribute, Group, LineSegments, Matrix4, Mesh, Sphere, Vector3 } from "three";
import type { ColourEffect, ValueRange } from "../present";
import { MISSING, type PartField, type SceneData, type ScenePart } from "../scene";
import { edgeSources, makeGhost, typicalEdge } from "./edge-lines";
import {
  type CutPlane,
  EdgeMaterial,
  FieldMaterial,
  setColourUniforms,
  setCutUniforms,
  setUniform,
  sharedUniforms,
  type Uniforms,
} from "./field-material";
import { InsideMesh, type InsideTriangles } from "./inside-mesh";
import { type Merged, mergeEdges, mergeFaces, mergeLevel } from "./merged";
import type { Palette } from "./palette";
import { type PartLook, PartTable } from "./part-table";

const scratchScale = new Vector3();

export class ModelObject {
  /** Carries the scene's matrix; put it under whatever moves the model. */
  readonly group = new Group();
  /** Undeformed box, model units minus origin. */
  readonly box = new Box3();
  readonly #parts: readonly ScenePart[];
  readonly #table: PartTable;
  readonly #uniforms: Uniforms;
  readonly #faces: Merged;
  #edges: Merged | null = null;
  /** For each edge vertex, a vertex of the faces with the same node; -1 if none. */
  #edgeSource: Int32Array | null = null;
  readonly #shown: FieldMaterial;
  readonly #clear: FieldMaterial;
  readonly #clearMesh: Mesh;
  readonly #edgeMaterial: EdgeMaterial;
  readonly #ghostMaterial: EdgeMaterial;
  #typicalEdge = 0;
  #ghost: LineSegments | null = null;
  #edgesWanted = true;
  #edgesAllowed = true;
  readonly #inside = new Set<InsideMesh>();
  #isCut = false;
  #palette: Palette | null = null;
  /** Lists of triangles by level; 0: all of them. */
  readonly #levels = new Map<number, BufferAttribute>();
  #level = 0;

  constructor(scene: SceneData) {
    this.group.matrixAutoUpdate = false;
    this.group.matrix.fromArray([...scene.matrix]);
    this.#parts = scene.parts;
    this.#table = new PartTable(scene.parts.map((part) => part.info.kind === "solid"));
    this.#uniforms = sharedUniforms(this.#table);
    this.#shown = new FieldMaterial(this.#uniforms, "shown");
    this.#clear = new FieldMaterial(this.#uniforms, "clear");
    this.#edgeMaterial = new EdgeMaterial(this.#uniforms, 0x0b0d10);
    this.#ghostMaterial = new EdgeMaterial(this.#uniforms, 0x6a7880, true);
    for (const { positions } of scene.parts) {
      for (let i = 0; i + 2 < positions.length; i += 3)
        this.box.expandByPoint(
          scratchScale.set(positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0),
        );
    }
    this.#faces = mergeFaces(scene.parts);
    this.#levels.set(0, this.#faces.geometry.getIndex() as BufferAttribute);
    const shown = new Mesh(this.#faces.geometry, this.#shown);
    this.#clearMesh = new Mesh(this.#faces.geometry, this.#clear);
    this.#clearMesh.visible = false;
    this.#clearMesh.renderOrder = 2;
    const drawn = [shown, this.#clearMesh];
    for (const mesh of drawn) mesh.frustumCulled = false;
    this.group.add(...drawn);
    const diagonal = this.box.getSize(new Vector3()).length();
    setUniform(this.#uniforms, "hatchScale", diagonal > 0 ? 60 / diagonal : 1);
    setUniform(this.#uniforms, "capHatch", diagonal > 0 ? 90 / diagonal : 1);
  }

  /** The level of detail that is drawn; 0: all triangles. */
  get level(): number {
    return this.#level;
  }

  hasLevel(level: number): boolean {
    return this.#levels.has(level);
  }

  /** Fewer triangles of the same vertices, one list a part. */
  addLevel(level: number, lists: readonly (Uint32Array | null)[]): void {
    this.#levels.set(level, mergeLevel(this.#faces.slices, lists));
  }

  setLevel(level: number): void {
    const index = this.#levels.get(level);
    if (!index || level === this.#level) return;
    this.#level = level;
    this.#faces.geometry.setIndex(index);
  }

  /** Element edges, which come after the faces. */
  addEdges(parts: readonly ScenePart[]): void {
    const edges = mergeEdges(parts);
    if (!edges || this.#edges) return;
    this.#typicalEdge = typicalEdge(parts);
    this.#edges = edges;
    this.#edgeSource = edgeSources(this.#faces.slices, edges.slices);
    for (const name of ["displacement", "displacementIm"]) {
      if (!this.#faces.geometry.hasAttribute(name)) continue;
      const own = edges.geometry.getAttribute("displacement");
      edges.geometry.setAttribute(name, name === "displacement" ? own : own.clone());
      this.#moveLines(name);
    }
    this.#addLines(new LineSegments(edges.geometry, this.#edgeMaterial), 1);
  }

  #addLines(lines: LineSegments, order: number): void {
    lines.frustumCulled = false;
    lines.renderOrder = order;
    this.group.add(lines);
  }

  get palette(): Palette | null {
    return this.#palette;
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
    this.#palette = setColourUniforms(this.#uniforms, effect, range);
  }

  /** Lines at the borders of bands; the limit's line: sign 1 for an upper limit, -1 for a lower, 0 for none. */
  setLines(lines: { isolines: boolean; limit: number; limitSign: number; missingHatch: boolean }): void {
    for (const [name, value] of Object.entries(lines)) setUniform(this.#uniforms, name, value);
  }

  /** Values to colour by; null: none. */
  setValues(fields: readonly (PartField | null)[] | null, component: number): void {
    const value = this.#faces.geometry.getAttribute("value") as BufferAttribute;
    const missing = this.#faces.geometry.getAttribute("missing") as BufferAttribute;
    const [known, gone] = [value.array as Float32Array, missing.array as Float32Array];
    for (const [index, { firstVertex, vertices }] of this.#faces.slices.entries()) {
      const field = fields?.[index];
      if (!field) {
        known.fill(0, firstVertex, firstVertex + vertices);
        gone.fill(1, firstVertex, firstVertex + vertices);
        continue;
      }
      const { values, state, components } = field;
      for (let i = 0; i < vertices; ++i) {
        const none = state[i] === MISSING;
        known[firstVertex + i] = none ? 0 : (values[i * components + component] ?? 0);
        gone[firstVertex + i] = none ? 1 : 0;
      }
    }
    value.needsUpdate = true;
    missing.needsUpdate = true;
  }

  /** Displacement vectors a part, model units, 3 a vertex; a vertex without one stays. `im`: of a complex mode. */
  setDisplacements(
    displacements: readonly (Float32Array | null)[],
    im: readonly (Float32Array | null)[] | null = null,
  ): void {
    this.#displace("displacement", displacements);
    if (im) this.#displace("displacementIm", im);
    else setUniform(this.#uniforms, "factorIm", 0);
  }

  #displace(name: string, displacements: readonly (Float32Array | null)[]): void {
    const faces = this.#faces.geometry;
    if (!faces.hasAttribute(name)) {
      for (const merged of [this.#faces, this.#edges])
        merged?.geometry.setAttribute(name, merged.geometry.getAttribute("displacement").clone());
    }
    const target = faces.getAttribute(name) as BufferAttribute;
    const moved = target.array as Float32Array;
    for (const [index, { firstVertex, vertices }] of this.#faces.slices.entries()) {
      const source = displacements[index];
      const [from, to] = [3 * firstVertex, 3 * (firstVertex + vertices)];
      if (source) moved.set(source.subarray(0, to - from), from);
      else moved.fill(0, from, to);
    }
    for (let i = 0; i < moved.length; ++i) if (Number.isNaN(moved[i])) moved[i] = 0;
    target.needsUpdate = true;
    this.#moveLines(name);
  }

  #moveLines(name: string): void {
    const target = this.#faces.geometry.getAttribute(name) as BufferAttribute;
    const lines = this.#edges?.geometry.getAttribute(name) as BufferAttribute | undefined;
    if (!lines || !this.#edgeSource) return;
    const [to, from] = [lines.array as Float32Array, target.array as Float32Array];
    for (let i = 0; i < this.#edgeSource.length; ++i) {
      const vertex = this.#edgeSource[i] ?? -1;
      for (let c = 0; c < 3; ++c) to[3 * i + c] = vertex < 0 ? 0 : (from[3 * vertex + c] ?? 0);
    }
    lines.needsUpdate = true;
  }

  setFactor(factor: number, factorIm = 0): void {
    setUniform(this.#uniforms, "factor", factor);
    setUniform(this.#uniforms, "factorIm", factorIm);
  }

  /** 1: true colours; less: a lamp at the eye darkens what turns away, down to this share. */
  setShadeFloor(floor: number): void {
    setUniform(this.#uniforms, "shadeFloor", floor);
  }

  setLooks(looks: readonly PartLook[]): void {
    this.#table.set(looks);
    this.#clearMesh.visible = looks.includes("clear");
  }

  /** Planes in model units minus origin. */
  setCuts(planes: readonly CutPlane[]): void {
    setCutUniforms(this.#uniforms, planes);
    for (const material of [this.#shown, this.#clear, this.#edgeMaterial, this.#ghostMaterial])
      material.setCut(planes.length > 0);
    for (const { mesh } of this.#inside) mesh.material.setCut(planes.length > 0);
    this.#isCut = planes.length > 0;
  }

  /** Triangles of the inside, drawn until they are removed. */
  addInside(triangles: InsideTriangles): InsideMesh {
    const made: InsideMesh = new InsideMesh(triangles, this.#uniforms, () => this.#inside.delete(made));
    made.mesh.material.setCut(this.#isCut);
    this.#inside.add(made);
    this.group.add(made.mesh);
    return made;
  }

  setEdges(wanted: boolean): void {
    this.#edgesWanted = wanted;
  }

  /** False while the picture moves too slowly. */
  allowEdges(allowed: boolean): void {
    this.#edgesAllowed = allowed;
  }

  /** The shape before it moved, as lines. */
  setGhost(wanted: boolean): void {
    if (wanted && !this.#ghost) {
      this.#ghost = makeGhost(this.#parts, this.#ghostMaterial);
      this.#addLines(this.#ghost, 3);
    }
    if (this.#ghost) this.#ghost.visible = wanted;
    this.#ghostMaterial.setOpacity(0.75);
  }

  /** Edges fade out from 20 to 2 pixels a segment, so that a fine mesh seen whole shows its colours, not its
   * lines; `pixelSize` is metres a pixel at the model. */
  fadeEdges(pixelSize: number): void {
    const scale = scratchScale.setFromMatrixScale(this.group.matrixWorld).x;
    const pixels = pixelSize > 0 ? (this.#typicalEdge * scale) / pixelSize : 0;
    const share = Math.min(Math.max((pixels - 2) / 18, 0), 1);
    this.#edgeMaterial.setOpacity(this.#edgesWanted && this.#edgesAllowed ? 0.55 * share : 0);
  }

  /** Model units to world. */
  worldMatrix(target = new Matrix4()): Matrix4 {
    this.group.updateWorldMatrix(true, false);
    return target.copy(this.group.matrixWorld);
  }

  dispose(): void {
    this.group.removeFromParent();
    this.#faces.geometry.dispose();
    this.#edges?.geometry.dispose();
    this.#ghost?.geometry.dispose();
    (this.#uniforms.palette?.value as { dispose(): void } | null)?.dispose();
    for (const inside of [...this.#inside]) inside.remove();
    this.#table.dispose();
    for (const material of [this.#shown, this.#clear, this.#edgeMaterial, this.#ghostMaterial])
      material.dispose();
  }
}
