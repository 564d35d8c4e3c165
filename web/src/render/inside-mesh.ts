// SPDX-License-Identifier: Apache-2.0
// Triangles of the inside, drawn with the skin's colours: same palette, range, parts and planes.
import { BufferAttribute, BufferGeometry, Mesh } from "three";
import { FieldMaterial, OWN_PLANE, setUniform, type Uniforms } from "./field-material";

export interface InsideTriangles {
  /** Model units minus origin. */
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
  /** One a vertex; NaN: missing. */
  readonly values: Float32Array;
  /** Index of the drawn part of each vertex. */
  readonly owners: Uint16Array;
  /** Where all triangles of a section look; null: of a surface, which bends and is seen through clear parts. */
  readonly normal: readonly [number, number, number] | null;
}

/** What a surface keeps of its light where it turns away. */
const SURFACE_SHADE = 0.35;

export class InsideMesh {
  readonly mesh: Mesh<BufferGeometry, FieldMaterial>;
  readonly #changed: (gone: boolean) => void;
  #plane: number = OWN_PLANE.skin;

  /** `changed` is told when it lies in another plane, and when it is gone. */
  constructor(triangles: InsideTriangles, uniforms: Uniforms, changed: (gone: boolean) => void) {
    this.#changed = changed;
    const geometry = new BufferGeometry();
    const count = triangles.positions.length / 3;
    geometry.setAttribute("position", new BufferAttribute(triangles.positions, 3));
    geometry.setAttribute("owner", new BufferAttribute(triangles.owners, 1));
    geometry.setIndex(new BufferAttribute(triangles.indices, 1));
    const value = new Float32Array(count);
    const missing = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
      const given = triangles.values[i] ?? Number.NaN;
      missing[i] = Number.isNaN(given) ? 1 : 0;
      value[i] = Number.isNaN(given) ? 0 : given;
    }
    geometry.setAttribute("value", new BufferAttribute(value, 1));
    geometry.setAttribute("missing", new BufferAttribute(missing, 1));
    if (triangles.normal) {
      const normals = new Float32Array(3 * count);
      for (let i = 0; i < 3 * count; ++i) normals[i] = triangles.normal[i % 3] ?? 0;
      geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    } else geometry.computeVertexNormals();
    // Already where the shape is drawn: factors of displacement find nothing to move.
    geometry.setAttribute("displacement", new BufferAttribute(new Float32Array(3 * count), 3));
    const { normal } = triangles;
    // A surface has one value, so that shade tells its form and no colour.
    const own = normal ? uniforms : { ...uniforms, shadeFloor: { value: SURFACE_SHADE } };
    this.mesh = new Mesh(geometry, new FieldMaterial(own, normal ? "shown" : "both"));
    if (!normal) this.lieIn(OWN_PLANE.surface);
    this.mesh.frustumCulled = false;
  }

  get plane(): number {
    return this.#plane;
  }

  /** The plane that it lies in does not cut it. */
  lieIn(plane: number): void {
    if (plane === this.#plane) return;
    this.#plane = plane;
    this.#changed(false);
    setUniform(this.mesh.material.uniforms, "ownPlane", plane);
  }

  remove(): void {
    this.mesh.removeFromParent();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.#changed(true);
  }
}
