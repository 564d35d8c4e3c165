// SPDX-License-Identifier: Apache-2.0
// The handle bar under the model: whoever has no grip takes the model by it.
import {
  type Box3,
  CapsuleGeometry,
  type Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Ray,
  type Scene,
  Vector3,
} from "three";

const LENGTH = 0.2;
/** A ray that passes so near, metres, is on it. */
const NEAR_ENOUGH = 0.03;
const BELOW = 0.05;
const AHEAD = 0.04;
/** No nearer to the person. */
const ARM = 0.5;
/** Never under the floor. */
const LOWEST = 0.15;
const scratch = new Vector3();
const nearest = new Vector3();
const corner = new Vector3();

export class VrBar {
  readonly #mesh = new Mesh(
    new CapsuleGeometry(0.011, LENGTH, 6, 16).rotateZ(Math.PI / 2),
    new MeshBasicMaterial({ color: 0xa5b4bc }),
  );

  constructor(scene: Scene) {
    scene.add(this.#mesh);
  }

  /** Under the near edge of the box, so that the model does not hide it; turned to the eyes. */
  update(box: Box3, world: Matrix4, eye: Vector3): void {
    const { position } = this.#mesh;
    box.getCenter(position).applyMatrix4(world);
    const towards = scratch.copy(eye).sub(position).setY(0).normalize();
    let lowest = Number.POSITIVE_INFINITY;
    let nearer = 0;
    for (let i = 0; i < 8; ++i) {
      corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
      lowest = Math.min(lowest, corner.applyMatrix4(world).y);
      nearer = Math.max(nearer, corner.sub(position).dot(towards));
    }
    // A model round the person is taken by its near side, an arm's length away.
    const reach = Math.max(Math.hypot(eye.x - position.x, eye.z - position.z) - ARM, 0);
    position.addScaledVector(towards, Math.min(nearer + AHEAD, reach));
    position.y = Math.max(lowest - BELOW, LOWEST);
    this.#mesh.rotation.y = Math.atan2(towards.x, towards.z);
    this.#mesh.updateMatrixWorld(true);
  }

  /** Metres along the ray when it is on the bar. */
  hit(ray: Ray): number | null {
    const half = scratch.set(LENGTH / 2, 0, 0).applyQuaternion(this.#mesh.quaternion);
    const { position } = this.#mesh;
    const apart = ray.distanceSqToSegment(position.clone().sub(half), position.clone().add(half), nearest);
    return apart < NEAR_ENOUGH ** 2 ? nearest.distanceTo(ray.origin) : null;
  }

  get place(): readonly number[] {
    return this.#mesh.position.toArray();
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#mesh.material.dispose();
    this.#mesh.removeFromParent();
  }
}
