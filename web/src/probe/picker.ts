// SPDX-License-Identifier: Apache-2.0
// Rays against the drawn skin, also while it moves: one hierarchy a part.
import { Matrix4, Ray, Triangle, Vector3 } from "three";
import type { ScenePart } from "../scene";
import { type Cut, isCutAway, kept } from "./cuts";
import { growTrees } from "./grow-trees";
import { drawnAt, MovingTree, type Shape } from "./moving-tree";
import { barycentric, cornersOf, type Place } from "./sample";
import { type DrawnSection, placeOnSections } from "./sections";

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
  tree: MovingTree | null;
}

const scratchInverse = new Matrix4();
const scratchRay = new Ray();
const scratchA = new Vector3();
const scratchSide = new Vector3();
const scratchNormal = new Vector3();
const scratchPlace = new Float64Array(3);
const scratchFrom = new Vector3();
const scratchAt = new Vector3();
const scratchTriangle = new Triangle();
const NOTHING: Cast = Object.freeze({ hit: null, inside: null });

export class Picker {
  readonly #targets: Target[];
  #displacements: readonly (Float32Array | null)[] = [];
  #displacementsIm: readonly (Float32Array | null)[] | null = null;
  #factor = 0;
  #factorIm = 0;
  #looks: readonly PickLook[] = [];
  #cuts: readonly Cut[] = [];
  #sections: readonly DrawnSection[] = [];

  constructor(parts: readonly ScenePart[]) {
    this.#targets = parts.map((part) => ({ part, tree: null }));
  }

  /** Builds the hierarchies; rays miss until it is done, and until `from` has come. */
  async build(from: Promise<unknown> = Promise.resolve()): Promise<void> {
    const [trees] = await Promise.all([growTrees(this.#targets.map((t) => t.part)), from]);
    for (const [i, target] of this.#targets.entries()) {
      const data = trees[i];
      target.tree = data ? new MovingTree(target.part, data) : null;
      target.tree?.setShape(this.#shapeOf(i));
    }
  }

  #shapeOf(part: number): Shape {
    const re = this.#displacements[part] ?? null;
    const im = this.#displacementsIm?.[part] ?? null;
    return { re, im, factorRe: this.#factor, factorIm: this.#factorIm };
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
    for (const [i, target] of this.#targets.entries()) target.tree?.setShape(this.#shapeOf(i));
  }

  setLooks(looks: readonly PickLook[]): void {
    this.#looks = looks;
  }

  setCuts(cuts: readonly Cut[]): void {
    this.#cuts = cuts;
  }

  /** Sections that are drawn where the planes open solids. */
  setSections(sections: readonly DrawnSection[]): void {
    this.#sections = sections;
  }

  /** What a ray meets where it enters the material through a plane. */
  #onSection(distance: number, world: Matrix4): Cast {
    const at = scratchRay.origin;
    const inside = at.clone().applyMatrix4(world);
    const section = placeOnSections(this.#sections, [at.x, at.y, at.z]);
    if (!section) return { hit: null, inside };
    return {
      hit: { part: -1, triangle: -1, weights: [1, 0, 0], section, distance, world: inside },
      inside: null,
    };
  }

  /** Whether a place of a part can be seen from anywhere: the part is not hidden, no plane has cut it away. Model units. */
  isThere(part: number, x: number, y: number, z: number): boolean {
    return this.#looks[part] !== "hidden" && !isCutAway(this.#cuts, x, y, z);
  }

  /** Where a vertex is drawn, model units. */
  drawn(part: number, vertex: number, out: Float64Array): void {
    const target = this.#targets[part];
    if (target) drawnAt(target.part, this.#shapeOf(part), vertex, out);
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
    const onSection = () =>
      this.#onSection(scratchRay.origin.clone().applyMatrix4(world).distanceTo(ray.origin), world);
    const shown = this.#nearest("shown", reach);
    if (!shown && range.enters > 0 && Number.isFinite(reach)) {
      // In a slab between planes a ray meets no skin: what it would meet behind them tells where it is.
      const behind = this.#nearest("shown", Number.POSITIVE_INFINITY);
      if (behind && this.#isBackOfSolid(behind)) return onSection();
    }
    const found = shown ?? this.#nearest("clear", reach);
    if (!found) return NOTHING;
    const { index, triangle, distance: along } = found;
    if (range.enters > 0 && this.#isBackOfSolid(found)) return onSection();
    const point = scratchRay.at(along, new Vector3());
    const { a, b, c } = this.#drawnTriangle(index, triangle);
    const weights = barycentric(point.toArray(), a.toArray(), b.toArray(), c.toArray());
    point.applyMatrix4(world);
    const distance = point.distanceTo(ray.origin);
    return { hit: { part: index, triangle, weights, distance, world: point }, inside: null };
  }

  /** The place of the drawn skin that is nearest to a point, no further than `reach` (both world metres). */
  near(point: Vector3, reach: number, world: Matrix4): Hit | null {
    const scale = scratchSide.setFromMatrixScale(world).x;
    const from = scratchFrom.copy(point).applyMatrix4(scratchInverse.copy(world).invert());
    const found = this.#closest("shown", from, reach / scale) ?? this.#closest("clear", from, reach / scale);
    if (!found) return null;
    const { index, triangle } = found;
    const { a, b, c } = this.#drawnTriangle(index, triangle);
    const at = scratchTriangle.closestPointToPoint(from, new Vector3());
    const weights = barycentric(at.toArray(), a.toArray(), b.toArray(), c.toArray());
    at.applyMatrix4(world);
    return { part: index, triangle, weights, distance: at.distanceTo(point), world: at };
  }

  /** In model units; what planes have cut away is not there. */
  #closest(look: PickLook, from: Vector3, reach: number) {
    let best: { index: number; triangle: number } | null = null;
    let within = reach;
    for (const [index, { tree }] of this.#targets.entries()) {
      if (!tree || (this.#looks[index] ?? "shown") !== look) continue;
      const found = tree.closest([from.x, from.y, from.z], within, (triangle) => {
        this.#drawnTriangle(index, triangle).closestPointToPoint(from, scratchAt);
        const gone = isCutAway(this.#cuts, scratchAt.x, scratchAt.y, scratchAt.z);
        return gone ? Number.POSITIVE_INFINITY : scratchAt.distanceTo(from);
      });
      if (!found) continue;
      within = found.distance;
      best = { index, triangle: found.triangle };
    }
    return best;
  }

  /** As it is drawn now, model units; valid until the next call. */
  #drawnTriangle(index: number, triangle: number): Triangle {
    const target = this.#targets[index];
    if (!target) return scratchTriangle;
    const shape = this.#shapeOf(index);
    const { a, b, c } = scratchTriangle;
    for (const [k, vertex] of cornersOf(target.part, triangle).entries()) {
      drawnAt(target.part, shape, vertex, scratchPlace);
      [a, b, c][k]?.fromArray(scratchPlace);
    }
    return scratchTriangle;
  }

  /** A triangle that the scratch ray meets from within. */
  #isBackOfSolid({ index, target, triangle }: { index: number; target: Target; triangle: number }): boolean {
    if (target.part.info.kind !== "solid") return false;
    const { a, b, c } = this.#drawnTriangle(index, triangle);
    scratchNormal.copy(b).sub(a).cross(scratchSide.copy(c).sub(a));
    return scratchNormal.dot(scratchRay.direction) > 0;
  }

  /** In model units, along the scratch ray. */
  #nearest(look: PickLook, reach: number) {
    let best: { index: number; target: Target; triangle: number; distance: number } | null = null;
    const { origin, direction } = scratchRay;
    const from = [origin.x, origin.y, origin.z] as const;
    const along = [direction.x, direction.y, direction.z] as const;
    for (const [index, target] of this.#targets.entries()) {
      if (!target.tree || (this.#looks[index] ?? "shown") !== look) continue;
      const hit = target.tree.cast(from, along, best?.distance ?? reach);
      if (hit && !(best && best.distance <= hit.distance)) best = { index, target, ...hit };
    }
    return best;
  }

  /** A place on the drawn skin, world metres. */
  worldOf(place: Place, world: Matrix4): Vector3 {
    const target = this.#targets[place.part];
    const point = new Vector3();
    if (place.section) return point.set(...place.section.point).applyMatrix4(world);
    if (!target) return point;
    const shape = this.#shapeOf(place.part);
    for (const [k, vertex] of cornersOf(target.part, place.triangle).entries()) {
      drawnAt(target.part, shape, vertex, scratchPlace);
      point.addScaledVector(scratchA.fromArray(scratchPlace), place.weights[k] ?? 0);
    }
    return point.applyMatrix4(world);
  }
}
