// SPDX-License-Identifier: Apache-2.0
// A turntable camera: turn about the world's up axis, zoom to a point, pan in the screen's plane. No DOM.
import { type Box3, Euler, type PerspectiveCamera, Quaternion, Vector3 } from "three";

const HALF_TURN = Math.PI / 2;
/** Room left round the model. */
const MARGIN = 1.12;
const scratch = new Vector3();
const scratchTurn = new Quaternion();
const scratchEuler = new Euler(0, 0, 0, "YXZ");

export class Orbit {
  readonly target = new Vector3();
  yaw = Math.PI / 5;
  pitch = 0.42;
  distance = 1;
  readonly #camera: PerspectiveCamera;
  #radius = 1;
  #changed: () => void;
  readonly #moved = new Set<() => void>();
  /** What was fitted last, while nobody has moved the camera since. */
  #fitted: Box3 | null = null;

  constructor(camera: PerspectiveCamera, changed: () => void) {
    this.#camera = camera;
    this.#changed = changed;
  }

  /** Metres that one pixel covers at the target. */
  pixelSize(height: number): number {
    return (2 * this.distance * Math.tan((this.#camera.fov * Math.PI) / 360)) / Math.max(height, 1);
  }

  turn(radiansX: number, radiansY: number): void {
    this.#fitted = null;
    this.yaw -= radiansX;
    this.pitch = Math.min(Math.max(this.pitch + radiansY, -HALF_TURN), HALF_TURN);
    this.apply();
  }

  pan(pixelsX: number, pixelsY: number, height: number): void {
    this.#fitted = null;
    const size = this.pixelSize(height);
    scratch.setFromMatrixColumn(this.#camera.matrix, 0);
    this.target.addScaledVector(scratch, -pixelsX * size);
    scratch.setFromMatrixColumn(this.#camera.matrix, 1);
    this.target.addScaledVector(scratch, pixelsY * size);
    this.apply();
  }

  /** Metres to the right and ahead, level with the floor. */
  walk(right: number, ahead: number): void {
    this.#fitted = null;
    const [sin, cos] = [Math.sin(this.yaw), Math.cos(this.yaw)];
    this.target.x += right * cos - ahead * sin;
    this.target.z += -right * sin - ahead * cos;
    this.apply();
  }

  /** `at` keeps its place on the screen; null: the target does. */
  zoom(scale: number, at: Vector3 | null): void {
    this.#fitted = null;
    const next = Math.min(Math.max(this.distance * scale, this.#radius * 0.01), this.#radius * 60);
    const share = next / this.distance;
    if (at) this.target.sub(at).multiplyScalar(share).add(at);
    this.distance = next;
    this.apply();
  }

  /** The whole box (world metres) fills the view; the direction stays. */
  fit(box: Box3): void {
    this.#fitted = box;
    this.#radius = Math.max(box.getSize(scratch).length() / 2, 1e-9);
    box.getCenter(this.target);
    this.apply();
    const vertical = Math.tan((this.#camera.fov * Math.PI) / 360);
    const horizontal = vertical * this.#camera.aspect;
    let distance = this.#radius * 0.1;
    for (let corner = 0; corner < 8; ++corner) {
      scratch.set(
        corner & 1 ? box.max.x : box.min.x,
        corner & 2 ? box.max.y : box.min.y,
        corner & 4 ? box.max.z : box.min.z,
      );
      scratch.sub(this.target).applyQuaternion(scratchTurn.copy(this.#camera.quaternion).invert());
      const reach = Math.max(Math.abs(scratch.x) / horizontal, Math.abs(scratch.y) / vertical) * MARGIN;
      distance = Math.max(distance, reach + scratch.z);
    }
    this.distance = distance;
    this.apply();
  }

  onMove(listener: () => void): void {
    this.#moved.add(listener);
  }

  /** Target, yaw, pitch and distance as `target`, `yaw` … once were. */
  place([x, y, z, yaw, pitch, distance]: readonly [number, number, number, number, number, number]): void {
    this.#fitted = null;
    this.target.set(x, y, z);
    this.yaw = yaw;
    this.pitch = Math.min(Math.max(pitch, -HALF_TURN), HALF_TURN);
    this.distance = distance;
    this.apply();
  }

  /** Looks at a point from so far; the direction stays. */
  goTo(point: Vector3, distance: number): void {
    this.#fitted = null;
    this.target.copy(point);
    this.distance = distance;
    this.apply();
  }

  /** The window has another shape: what filled it fills it again. */
  reshaped(): void {
    if (this.#fitted) this.fit(this.#fitted);
    else this.apply();
  }

  /** Looks at the model from this direction (world axes, need not be of unit length). */
  lookFrom(direction: Vector3): void {
    scratch.copy(direction).normalize();
    this.pitch = Math.asin(Math.min(Math.max(scratch.y, -1), 1));
    if (Math.hypot(scratch.x, scratch.z) > 1e-6) this.yaw = Math.atan2(scratch.x, scratch.z);
    this.apply();
  }

  apply(): void {
    const camera = this.#camera;
    scratchEuler.set(-this.pitch, this.yaw, 0);
    camera.quaternion.setFromEuler(scratchEuler);
    scratch.set(0, 0, 1).applyQuaternion(camera.quaternion);
    camera.position.copy(this.target).addScaledVector(scratch, this.distance);
    camera.near = Math.max(this.distance - 3 * this.#radius, this.distance * 0.01, this.#radius * 1e-4);
    camera.far = this.distance + 4 * this.#radius;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.#changed();
    for (const listener of this.#moved) listener();
  }
}
