// SPDX-License-Identifier: Apache-2.0
// Clip planes in the hand: a knob at the middle of each that a ray takes and drags, and the first plane carried whole.
import {
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Plane,
  type Ray,
  type Scene,
  SphereGeometry,
  Vector3,
} from "three";
import type { App } from "../app/app";
import type { Cuts } from "../app/features/cuts";
import type { VrPointer } from "./vr-pointers";

/** A ray that passes so near to a knob, metres, is on it. */
const NEAR_ENOUGH = 0.035;
const RADIUS = 0.018;

interface Drag {
  readonly index: number;
  /** Of the pointer along the plane's normal when the knob was taken, and the plane's offset then. */
  readonly along: number;
  readonly offset: number;
}

export class VrPlanes {
  readonly #app: App;
  readonly #scene: Scene;
  readonly #knobs: Mesh<SphereGeometry, MeshBasicMaterial>[] = [];
  readonly #drags = new Map<string, Drag>();

  constructor(app: App, scene: Scene) {
    this.#app = app;
    this.#scene = scene;
  }

  get #cuts(): Cuts {
    return this.#app.feature<Cuts>("cuts");
  }

  /** Where the knobs are, world metres; a plane that is off has none. */
  update(world: Matrix4): void {
    const places = this.#cuts.knobs();
    for (const [i, place] of places.entries()) {
      this.#knobs[i] ??= this.#make();
      const knob = this.#knobs[i];
      if (!knob) continue;
      knob.visible = place !== null;
      if (place) knob.position.copy(place).applyMatrix4(world);
    }
    for (const knob of this.#knobs.slice(places.length)) knob.visible = false;
  }

  #make() {
    const knob = new Mesh(
      new SphereGeometry(RADIUS, 20, 14),
      new MeshBasicMaterial({ color: 0xd0167f, depthTest: false }),
    );
    knob.renderOrder = 6;
    this.#scene.add(knob);
    return knob;
  }

  /** Place of the knobs, for reports. */
  get places(): readonly (readonly number[] | null)[] {
    return this.#knobs.map((knob) => (knob.visible ? knob.position.toArray() : null));
  }

  /** Takes the knob that the ray is on; how far along the ray it is, null when there is none. */
  take(pointer: VrPointer, world: Matrix4): number | null {
    const index = this.#knobs.findIndex(
      (knob) => knob.visible && pointer.ray.distanceToPoint(knob.position) < NEAR_ENOUGH,
    );
    const cut = this.#app.store.state.cuts[index];
    const knob = this.#knobs[index];
    if (!cut || !knob) return null;
    const along = this.#along(pointer.ray, index, world);
    this.#drags.set(pointer.name, { index, along, offset: cut.offset });
    return knob.position.distanceTo(pointer.ray.origin);
  }

  letGo(name: string): boolean {
    return this.#drags.delete(name);
  }

  /** The knob follows the ray at the distance that it was taken at. */
  drag(pointer: VrPointer, world: Matrix4): boolean {
    const drag = this.#drags.get(pointer.name);
    if (!drag) return false;
    this.#cuts.moveTo(drag.index, drag.offset + this.#along(pointer.ray, drag.index, world) - drag.along);
    return true;
  }

  /** Of the ray's nearest point to the line through the knob along the normal: how far along, model units. */
  #along(ray: Ray, index: number, world: Matrix4): number {
    const cut = this.#app.store.state.cuts[index];
    const knob = this.#knobs[index];
    if (!cut || !knob) return 0;
    const normal = new Vector3(...cut.normal).transformDirection(world);
    const middle = this.#app.view.model.box.getCenter(new Vector3()).applyMatrix4(world);
    const scale = new Vector3().setFromMatrixScale(world).x;
    const aside = ray.origin.clone().sub(middle);
    const b = ray.direction.dot(normal);
    const [d, e] = [ray.direction.dot(aside), normal.dot(aside)];
    // A ray along the normal moves the plane not at all.
    const square = 1 - b * b;
    return square < 1e-3 ? 0 : (e - b * d) / square / scale;
  }

  /** The first plane goes through the hand, square to where it points. */
  carry(pointer: VrPointer, world: Matrix4): void {
    const back = new Matrix4().copy(world).invert();
    const normal = pointer.ray.direction.clone().transformDirection(back);
    const at = pointer.ray.origin.clone().applyMatrix4(back);
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, at);
    this.#cuts.carry([plane.normal.x, plane.normal.y, plane.normal.z], -plane.constant);
  }

  dispose(): void {
    for (const knob of this.#knobs) {
      knob.geometry.dispose();
      knob.material.dispose();
      knob.removeFromParent();
    }
  }
}
