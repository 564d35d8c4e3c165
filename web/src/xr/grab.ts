// SPDX-License-Identifier: Apache-2.0
// Hands on the model: one grip carries it 1:1, two grips move, turn (about the vertical) and scale it. Maths only.
import { Matrix4, Quaternion, Vector3 } from "three";

/** Smallest and largest scale of the model against its start in metres. */
export const SCALE_LIMITS: readonly [number, number] = [1e-3, 1e3];

const UP = new Vector3(0, 1, 0);

/** Pose of one hand. */
export interface GripPose {
  readonly position: Vector3;
  readonly quaternion: Quaternion;
}

function poseMatrix(pose: GripPose): Matrix4 {
  return new Matrix4().compose(pose.position, pose.quaternion, new Vector3(1, 1, 1));
}

/** Model matrix after a hand that held it at `from` has come to `to`. */
export function carry(model: Matrix4, from: GripPose, to: GripPose): Matrix4 {
  return poseMatrix(to).multiply(poseMatrix(from).invert()).multiply(model);
}

/** Model matrix after two hands that held it at `from` have come to `to`; upright: it turns about the vertical alone. */
export function carryWithTwo(
  model: Matrix4,
  from: readonly [Vector3, Vector3],
  to: readonly [Vector3, Vector3],
  upright = true,
): Matrix4 {
  const middleFrom = from[0].clone().add(from[1]).multiplyScalar(0.5);
  const middleTo = to[0].clone().add(to[1]).multiplyScalar(0.5);
  const spanFrom = from[1].clone().sub(from[0]);
  const spanTo = to[1].clone().sub(to[0]);
  const before = new Vector3().setFromMatrixScale(model).x;
  const ratio = spanFrom.length() > 1e-6 ? spanTo.length() / spanFrom.length() : 1;
  const scale = Math.min(Math.max(before * ratio, SCALE_LIMITS[0]), SCALE_LIMITS[1]) / before;
  const yaw = Math.atan2(spanTo.x, spanTo.z) - Math.atan2(spanFrom.x, spanFrom.z);
  const turn = upright
    ? new Quaternion().setFromAxisAngle(UP, yaw)
    : new Quaternion().setFromUnitVectors(spanFrom.normalize(), spanTo.normalize());
  return new Matrix4()
    .makeTranslation(middleTo.x, middleTo.y, middleTo.z)
    .multiply(new Matrix4().makeRotationFromQuaternion(turn))
    .multiply(new Matrix4().makeScale(scale, scale, scale))
    .multiply(new Matrix4().makeTranslation(-middleFrom.x, -middleFrom.y, -middleFrom.z))
    .multiply(model);
}

/** What is held, as hands open, close and move. */
export class Grab {
  readonly #hands = new Map<string, GripPose>();
  #start: Matrix4 | null = null;

  get holding(): number {
    return this.#hands.size;
  }

  holds(hand: string): boolean {
    return this.#hands.has(hand);
  }

  take(hand: string, pose: GripPose, model: Matrix4): void {
    this.#hands.set(hand, copyPose(pose));
    this.#restart(model);
  }

  letGo(hand: string, model: Matrix4): void {
    if (this.#hands.delete(hand)) this.#restart(model);
  }

  letGoOfAll(): void {
    this.#hands.clear();
    this.#start = null;
  }

  /** From now on hands move what is here now, from where they are now. */
  #restart(model: Matrix4): void {
    this.#start = model.clone();
    for (const [hand, pose] of this.#latest) if (this.#hands.has(hand)) this.#hands.set(hand, copyPose(pose));
  }

  readonly #latest = new Map<string, GripPose>();

  /** Where the model is now, or null when nobody holds it. */
  move(poses: ReadonlyMap<string, GripPose>, upright = true): Matrix4 | null {
    for (const [hand, pose] of poses) this.#latest.set(hand, copyPose(pose));
    if (!this.#start) return null;
    const held = [...this.#hands].flatMap(([hand, from]) => {
      const to = poses.get(hand);
      return to ? [{ from, to }] : [];
    });
    const [a, b] = held;
    if (a && b)
      return carryWithTwo(
        this.#start,
        [a.from.position, b.from.position],
        [a.to.position, b.to.position],
        upright,
      );
    return a ? carry(this.#start, a.from, a.to) : null;
  }
}

function copyPose(pose: GripPose): GripPose {
  return { position: pose.position.clone(), quaternion: pose.quaternion.clone() };
}
