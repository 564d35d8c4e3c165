// SPDX-License-Identifier: Apache-2.0
// The model as three.js draws it: positions once, value and displacement per step, parts by a table.
import { Box3, type BufferAttribute, Group, LineSegments, Matrix4, Mesh, Sphere, Vector3 } from "three";
import type { ColourEffect, ValueRange } from "../present";
import { MISSING, type PartField, type SceneData, type ScenePart } from "../scene";
import { CutCaps } from "./cut-caps";
import { edgeSources, makeGhost, typicalEdge } from "./edge-lines";
import {
  type CutPlane,
  EdgeMaterial,
  FieldMaterial,
  MAX_CUTS,
  setColourUniforms,
  setCutUniforms,
  setUniform,
  sharedUniforms,
  type Uniforms,
} from "./field-material";
import { InsideMesh, type InsideTriangles } from "./inside-mesh";
import { type Merged, mergeEdges, mergeFaces, mergeLevel } from "./merged";
import { type EdgeSum, openEdges } from "./open-edges";
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
  #cuts: readonly CutPlane[] = [];
  readonly #caps: CutCaps;
  #looks: readonly PartLook[] = [];
  /** Of each part, once a plane has asked; null: it encloses nothing. */
  #openEdges: readonly (EdgeSum | null)[] | null = null;
  /** Longest displacement of a vertex, real and imaginary, model units. */
  readonly #furthest: Record<string, number> = {};
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
    this.#caps = new CutCaps(this.#faces.geometry, this.#uniforms);
    this.group.add(...drawn, this.#caps.group);
    const diagonal = this.#diagonal;
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
    this.#fillCuts();
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
    let most = 0;
    for (let i = 0; i + 2 < moved.length; i += 3)
      most = Math.max(most, (moved[i] ?? 0) ** 2 + (moved[i + 1] ?? 0) ** 2 + (moved[i + 2] ?? 0) ** 2);
    this.#furthest[name] = Math.sqrt(most);
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
    this.#fillCuts();
  }

  /** 1: true colours; less: a lamp at the eye darkens what turns away, down to this share. */
  setShadeFloor(floor: number): void {
    setUniform(this.#uniforms, "shadeFloor", floor);
  }

  setLooks(looks: readonly PartLook[]): void {
    this.#table.set(looks);
    this.#clearMesh.visible = looks.includes("clear");
    this.#looks = looks;
    this.#fillCuts();
  }

  /** Planes in model units minus origin. */
  setCuts(planes: readonly CutPlane[]): void {
    setCutUniforms(this.#uniforms, planes);
    for (const material of [this.#shown, this.#clear, this.#edgeMaterial, this.#ghostMaterial])
      material.setCut(planes.length > 0);
    for (const { mesh } of this.#inside) mesh.material.setCut(planes.length > 0);
    this.#cuts = planes.slice(0, MAX_CUTS);
    this.#fillCuts();
  }

  get #diagonal(): number {
    return this.box.getSize(scratchScale).length();
  }

  /** The solids that are shown enclose volumes, all together. */
  get #isClosed(): boolean {
    this.#openEdges ??= this.#faces.slices.map(({ part, firstVertex }) =>
      part.info.kind === "solid" ? openEdges(part, firstVertex) : null,
    );
    const shown = this.#openEdges.filter((_, i) => (this.#looks[i] ?? "shown") === "shown");
    const sum = (k: 0 | 1) => shown.reduce((all, edges) => (all + (edges?.[k] ?? 0)) | 0, 0);
    return sum(0) === 0 && sum(1) === 0;
  }

  /** A reduced level keeps its rims, but nobody has counted them. */
  #fillCuts(): void {
    if (this.#cuts.length === 0 || this.#level > 0 || !this.#isClosed) {
      this.#caps.hide();
      return;
    }
    // Where the section is known it is the cap.
    const known = new Set([...this.#inside].map((inside) => inside.plane));
    const filled = this.#cuts.map((_, i) => !known.has(i));
    const by = (name: string) => Math.abs((this.#uniforms[name]?.value as number) ?? 0);
    const moved =
      by("factor") * (this.#furthest.displacement ?? 0) +
      by("factorIm") * (this.#furthest.displacementIm ?? 0);
    this.#caps.show(this.#cuts, filled, this.box.getCenter(new Vector3()), 0.51 * this.#diagonal + moved);
  }

  /** Triangles of the inside, drawn until they are removed. */
  addInside(triangles: InsideTriangles): InsideMesh {
    const made: InsideMesh = new InsideMesh(triangles, this.#uniforms, (gone) => {
      if (gone) this.#inside.delete(made);
      this.#fillCuts();
    });
    made.mesh.material.setCut(this.#cuts.length > 0);
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
    this.#caps.dispose();
    this.#table.dispose();
    for (const material of [this.#shown, this.#clear, this.#edgeMaterial, this.#ghostMaterial])
      material.dispose();
  }
}
