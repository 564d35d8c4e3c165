// SPDX-License-Identifier: Apache-2.0
// Rays against the drawn skin: one hierarchy a part, rebuilt to the deformed shape only when it is asked.
import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Ray, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { GenerateMeshBVHWorker } from "three-mesh-bvh/worker";
import type { ScenePart } from "../scene";
import { type Cut, kept } from "./cuts";
import { barycentric, cornersOf, type Place } from "./sample";

/** Triangles above which the hierarchy is built in a worker, so that the page stays awake. */
const WORKER_FROM = 150_000;

export interface Hit extends Place {
  /** Metres along the ray. */
  readonly distance: number;
  /** On the drawn (deformed) skin, metres, world axes. */
  readonly world: Vector3;
}

/** What a ray meets: a place of the skin, or the material that a cut has opened, of which a skin knows no values. */
export interface Cast {
  readonly hit: Hit | null;
  /** Metres, world axes. */
  readonly inside: Vector3 | null;
}

/** Rays pass hidden parts, and clear ones where there is something behind. */
export type PickLook = "shown" | "clear" | "hidden";

interface Target {
  readonly part: ScenePart;
  readonly geometry: BufferGeometry;
  tree: MeshBVH | null;
  stale: boolean;
}

/** The drawn positions; a worker that builds a hierarchy puts another array in their place. */
function positionsOf(target: Target): Float32Array {
  return target.geometry.getAttribute("position").array as Float32Array;
}

const scratchInverse = new Matrix4();
const scratchRay = new Ray();
const scratchA = new Vector3();
const scratchB = new Vector3();
const scratchC = new Vector3();
const scratchSide = new Vector3();
const scratchNormal = new Vector3();
const NOTHING: Cast = Object.freeze({ hit: null, inside: null });

export class Picker {
  readonly #targets: Target[];
  #displacements: readonly (Float32Array | null)[] = [];
  #displacementsIm: readonly (Float32Array | null)[] | null = null;
  #factor = 0;
  #factorIm = 0;
  #looks: readonly PickLook[] = [];
  #cuts: readonly Cut[] = [];

  constructor(parts: readonly ScenePart[]) {
    this.#targets = parts.map((part) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(part.positions.slice(), 3));
      geometry.setIndex(new BufferAttribute(part.indices.slice(), 1));
      return { part, geometry, tree: null, stale: false };
    });
  }

  /** Builds the hierarchies; rays miss until it is done. */
  async build(): Promise<void> {
    for (const target of this.#targets) {
      if (target.part.indices.length / 3 >= WORKER_FROM) {
        const worker = new GenerateMeshBVHWorker();
        target.tree = await worker.generate(target.geometry, { indirect: true });
        worker.dispose();
      } else {
        target.tree = new MeshBVH(target.geometry, { indirect: true });
      }
    }
  }

  /** The shape that is drawn: displacement (3 floats a vertex) times factor, per part; `im` of a complex mode. */
  setShape(
    displacements: readonly (Float32Array | null)[],
    factor: number,
    im: readonly (Float32Array | null)[] | null = null,
    factorIm = 0,
  ): void {
    this.#displacements = displacements;
    this.#displacementsIm = im;
    this.#factor = factor;
    this.#factorIm = factorIm;
    for (const target of this.#targets) target.stale = true;
  }

  setLooks(looks: readonly PickLook[]): void {
    this.#looks = looks;
  }

  setCuts(cuts: readonly Cut[]): void {
    this.#cuts = cuts;
  }

  #refresh(index: number, target: Target): void {
    target.stale = false;
    const { part } = target;
    const positions = positionsOf(target);
    const re = this.#displacements[index];
    const im = this.#displacementsIm?.[index];
    for (let i = 0; i < positions.length; ++i) {
      const moved = (re?.[i] ?? 0) * this.#factor + (im?.[i] ?? 0) * this.#factorIm;
      positions[i] = (part.positions[i] ?? 0) + (Number.isNaN(moved) ? 0 : moved);
    }
    target.tree?.refit();
  }

  /** First hit of a ray in world metres; `world` is the matrix from model units to world. */
  ray(ray: Ray, world: Matrix4): Hit | null {
    return this.cast(ray, world).hit;
  }

  cast(ray: Ray, world: Matrix4): Cast {
    scratchInverse.copy(world).invert();
    scratchRay.copy(ray).applyMatrix4(scratchInverse);
    scratchRay.direction.normalize();
    const range = kept(this.#cuts, scratchRay.origin, scratchRay.direction);
    if (!range) return NOTHING;
    scratchRay.origin.addScaledVector(scratchRay.direction, range.enters);
    const reach = range.leaves - range.enters;
    const shown = this.#nearest("shown", reach);
    const found = shown ?? this.#nearest("clear", reach);
    if (!found) return NOTHING;
    const { index, target, triangle, point } = found;
    const corners = cornersOf(target.part, triangle);
    const positions = positionsOf(target);
    const [a, b, c] = [scratchA, scratchB, scratchC].map((v, k) =>
      v.fromArray(positions, 3 * (corners[k] ?? 0)),
    );
    if (!a || !b || !c) return NOTHING;
    if (range.enters > 0 && target.part.info.kind === "solid" && this.#fromBehind(a, b, c)) {
      const inside = scratchRay.origin.clone().applyMatrix4(world);
      return { hit: null, inside };
    }
    const weights = barycentric(point.toArray(), a.toArray(), b.toArray(), c.toArray());
    point.applyMatrix4(world);
    const distance = point.distanceTo(ray.origin);
    return { hit: { part: index, triangle, weights, distance, world: point }, inside: null };
  }

  #fromBehind(a: Vector3, b: Vector3, c: Vector3): boolean {
    scratchNormal.copy(b).sub(a).cross(scratchSide.copy(c).sub(a));
    return scratchNormal.dot(scratchRay.direction) > 0;
  }

  /** In model units, along the scratch ray. */
  #nearest(look: PickLook, reach: number) {
    let best: { index: number; target: Target; triangle: number; point: Vector3; distance: number } | null =
      null;
    for (let index = 0; index < this.#targets.length; ++index) {
      const target = this.#targets[index];
      if (!target?.tree || (this.#looks[index] ?? "shown") !== look) continue;
      if (target.stale) this.#refresh(index, target);
      const hit = target.tree.raycastFirst(scratchRay, DoubleSide);
      if (!hit || hit.faceIndex === undefined || hit.faceIndex === null || hit.distance > reach) continue;
      if (best && best.distance <= hit.distance) continue;
      best = { index, target, triangle: hit.faceIndex, point: hit.point, distance: hit.distance };
    }
    return best;
  }

  /** A place on the drawn skin, world metres. */
  worldOf(place: Place, world: Matrix4): Vector3 {
    const target = this.#targets[place.part];
    const point = new Vector3();
    if (!target) return point;
    if (target.stale) this.#refresh(place.part, target);
    for (const [k, vertex] of cornersOf(target.part, place.triangle).entries()) {
      point.addScaledVector(scratchA.fromArray(positionsOf(target), 3 * vertex), place.weights[k] ?? 0);
    }
    return point.applyMatrix4(world);
  }

  dispose(): void {
    for (const target of this.#targets) target.geometry.dispose();
  }
}
