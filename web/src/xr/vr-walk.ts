// SPDX-License-Identifier: Apache-2.0
// The person's own moves: thirty degrees at a time, and a step to a place of the floor. Never by itself.
import {
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  RingGeometry,
  type Scene,
  Vector3,
  type WebGLRenderer,
} from "three";
import type { VrPointer } from "./vr-pointers";

/** Metres that one can go at once. */
const FURTHEST = 6;
const UP = new Vector3(0, 1, 0);

export class VrWalk {
  readonly #renderer: WebGLRenderer;
  readonly #ring = new Mesh(
    new RingGeometry(0.18, 0.23, 40).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ color: 0x74c9c6, side: DoubleSide }),
  );

  constructor(renderer: WebGLRenderer, scene: Scene) {
    this.#renderer = renderer;
    this.#ring.visible = false;
    scene.add(this.#ring);
  }

  /** The floor's origin is from now on at a pose of the floor as it was. */
  #move(position: Vector3, turn: Quaternion): void {
    const { xr } = this.#renderer;
    const space = xr.getReferenceSpace();
    if (!space) return;
    const { x, y, z } = position;
    xr.setReferenceSpace(space.getOffsetReferenceSpace(new XRRigidTransform({ x, y, z }, turn)));
  }

  /** Degrees to the left, about where the head is. */
  turn(degrees: number, head: Vector3): void {
    // The floor's origin turns the other way about the head.
    const turn = new Quaternion().setFromAxisAngle(UP, (-degrees * Math.PI) / 180);
    const at = new Vector3(head.x, 0, head.z);
    this.#move(at.clone().sub(at.clone().applyQuaternion(turn)), turn);
  }

  /** Shows where the pointer's ray meets the floor. */
  aim(pointer: VrPointer): void {
    const { origin, direction } = pointer.ray;
    const far = direction.y < -1e-3 ? -origin.y / direction.y : Number.POSITIVE_INFINITY;
    this.#ring.visible = far < FURTHEST * 1.5;
    if (!this.#ring.visible) return;
    this.#ring.position.copy(direction).multiplyScalar(far).add(origin).setY(0.005);
  }

  /** Metres to the right and ahead of where the head looks. */
  step(right: number, ahead: number, yaw: number): void {
    this.#move(new Vector3(right, 0, -ahead).applyAxisAngle(UP, yaw).negate(), new Quaternion());
  }

  /** To the ring, if it is there; whether anybody went. */
  go(head: Vector3): boolean {
    if (!this.#ring.visible) return false;
    this.#ring.visible = false;
    const way = this.#ring.position.clone().sub(head).setY(0);
    way.clampLength(0, FURTHEST);
    this.#move(way.negate(), new Quaternion());
    return true;
  }

  dispose(): void {
    this.#ring.geometry.dispose();
    this.#ring.material.dispose();
    this.#ring.removeFromParent();
  }
}
