// SPDX-License-Identifier: Apache-2.0
// Arrows on the model: one kind of glyph is one draw call, however many there are.
import {
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  type Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

/** arrow: from its place on. outward, inward: through its place, with heads that pull or push. */
export type GlyphKind = "arrow" | "outward" | "inward";

export interface Glyph {
  readonly kind: GlyphKind;
  /** Model units, of the drawn shape. */
  readonly at: readonly [number, number, number];
  /** Along the glyph, as long as it is drawn. */
  readonly along: readonly [number, number, number];
}

const UP = new Vector3(0, 1, 0);
const HEAD = 0.28;

/** Along +y, of length 1 and of radius 1 where the heads are widest. */
function shapeOf(kind: GlyphKind): BufferGeometry {
  const bar = (from: number, to: number) =>
    new CylinderGeometry(0.36, 0.36, to - from, 8, 1).translate(0, (from + to) / 2, 0);
  const head = (tip: number, up: boolean) => {
    const cone = new ConeGeometry(1, HEAD, 10, 1);
    if (!up) cone.rotateX(Math.PI);
    return cone.translate(0, up ? tip - HEAD / 2 : tip + HEAD / 2, 0);
  };
  const pieces =
    kind === "arrow"
      ? [bar(0, 1 - HEAD), head(1, true)]
      : kind === "outward"
        ? [bar(-0.5 + HEAD, 0.5 - HEAD), head(0.5, true), head(-0.5, false)]
        : [
            bar(-0.5, 0.5),
            head(HEAD * 0.5, false).translate(0, -HEAD * 0.45, 0),
            head(-HEAD * 0.5, true).translate(0, HEAD * 0.45, 0),
          ];
  return mergeGeometries(pieces);
}

export class ArrowGlyphs {
  readonly #group: Group;
  readonly #meshes = new Map<GlyphKind, InstancedMesh<BufferGeometry, MeshBasicMaterial>>();

  constructor(group: Group) {
    this.#group = group;
  }

  /** `thickness`: radius of the heads, model units; a short glyph is as slim as it is short. */
  set(glyphs: readonly Glyph[], thickness: number, colours: Readonly<Record<GlyphKind, string>>): void {
    for (const kind of ["arrow", "outward", "inward"] as const) {
      const mine = glyphs.filter((glyph) => glyph.kind === kind);
      const mesh = this.#ready(kind, mine.length);
      if (!mesh) continue;
      mesh.material.color.set(colours[kind]);
      mesh.count = mine.length;
      const [matrix, turn, along, size] = [new Matrix4(), new Quaternion(), new Vector3(), new Vector3()];
      for (const [i, glyph] of mine.entries()) {
        const length = along.set(...glyph.along).length();
        turn.setFromUnitVectors(UP, along.divideScalar(length || 1));
        const wide = Math.min(thickness, 0.2 * length);
        mesh.setMatrixAt(i, matrix.compose(new Vector3(...glyph.at), turn, size.set(wide, length, wide)));
      }
      mesh.instanceMatrix.needsUpdate = true;
      mesh.visible = mine.length > 0;
    }
  }

  /** A mesh with room for so many; null: none is needed. */
  #ready(kind: GlyphKind, count: number) {
    const known = this.#meshes.get(kind);
    if (known && known.instanceMatrix.count >= count) return known;
    if (count === 0) return null;
    known?.removeFromParent();
    known?.dispose();
    const geometry = known?.geometry ?? shapeOf(kind);
    const material = known?.material ?? new MeshBasicMaterial({ toneMapped: false });
    const mesh = new InstancedMesh(geometry, material, count);
    mesh.frustumCulled = false;
    mesh.renderOrder = 3;
    this.#meshes.set(kind, mesh);
    this.#group.add(mesh);
    return mesh;
  }

  dispose(): void {
    for (const mesh of this.#meshes.values()) {
      mesh.removeFromParent();
      mesh.geometry.dispose();
      mesh.material.dispose();
      mesh.dispose();
    }
    this.#meshes.clear();
  }
}
