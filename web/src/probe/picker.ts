// SPDX-License-Identifier: Apache-2.0
// Rays against the drawn skin: one hierarchy a part, rebuilt to the deformed shape only when it is asked.
import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Ray, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { GenerateMeshBVHWorker } from "three-mesh-bvh/worker";
import type { ScenePart } from "../scene";
import { barycentric, cornersOf, type Place } from "./sample";

/** Triangles above which the hierarchy is built in a worker, so that the page stays awake. */
const WORKER_FROM = 150_000;

export interface Hit extends Place {
  /** Metres along the ray. */
  readonly distance: number;
  /** On the drawn (deformed) skin, metres, world axes. */
  readonly world: Vector3;
}

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

export class Picker {
  readonly #targets: Target[];
  #displacements: readonly (Float32Array | null)[] = [];
  #factor = 0;

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

  /** The shape that is drawn: displacement (3 floats a vertex) times factor, per part. */
  setShape(displacements: readonly (Float32Array | null)[], factor: number): void {
    this.#displacements = displacements;
    this.#factor = factor;
    for (const target of this.#targets) target.stale = true;
  }

  #refresh(index: number, target: Target): void {
    target.stale = false;
    const { part } = target;
    const positions = positionsOf(target);
    const displacement = this.#displacements[index];
    for (let i = 0; i < positions.length; ++i) {
      const moved = displacement ? (displacement[i] ?? 0) * this.#factor : 0;
      positions[i] = (part.positions[i] ?? 0) + (Number.isNaN(moved) ? 0 : moved);
    }
    target.tree?.refit();
  }

  /** First hit of a ray in world metres; `world` is the matrix from model units to world. */
  ray(ray: Ray, world: Matrix4): Hit | null {
    scratchInverse.copy(world).invert();
    scratchRay.copy(ray).applyMatrix4(scratchInverse);
    scratchRay.direction.normalize();
    let best: Hit | null = null;
    for (const [index, target] of this.#targets.entries()) {
      if (!target.tree) continue;
      if (target.stale) this.#refresh(index, target);
      const hit = target.tree.raycastFirst(scratchRay, DoubleSide);
      if (!hit || hit.faceIndex === undefined || hit.faceIndex === null) continue;
      const point = hit.point.clone().applyMatrix4(world);
      const distance = point.distanceTo(ray.origin);
      if (best && best.distance <= distance) continue;
      const positions = positionsOf(target);
      const [a, b, c] = cornersOf(target.part, hit.faceIndex);
      const weights = barycentric(
        hit.point.toArray(),
        scratchA.fromArray(positions, 3 * a).toArray(),
        scratchB.fromArray(positions, 3 * b).toArray(),
        scratchC.fromArray(positions, 3 * c).toArray(),
      );
      best = { part: index, triangle: hit.faceIndex, weights, distance, world: point };
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
