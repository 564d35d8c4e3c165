// SPDX-License-Identifier: Apache-2.0
// Where things stand in the room: the model on an imagined table, panel to the left, legend to the right. Maths only.
import { Matrix4, Quaternion, type Sphere, Vector3 } from "three";

/** Largest side of the model on the table, metres. */
export const TABLE_SIZE = 0.8;
export const TABLE_DISTANCE = 1.2;
/** Height of the model's middle. */
export const TABLE_HEIGHT = 1;

const UP = new Vector3(0, 1, 0);

/** Where the person stands and looks, level with the floor. */
export interface Stand {
  readonly position: Vector3;
  readonly yaw: number;
}

export function standOf(head: Matrix4): Stand {
  const position = new Vector3().setFromMatrixPosition(head);
  const forward = new Vector3(0, 0, -1).transformDirection(head);
  return { position, yaw: Math.atan2(-forward.x, -forward.z) };
}

/** A place before the person: metres to the right, above the floor, ahead. */
export function placeBefore(stand: Stand, right: number, height: number, ahead: number): Vector3 {
  return new Vector3(right, 0, -ahead)
    .applyAxisAngle(UP, stand.yaw)
    .add(new Vector3(stand.position.x, height, stand.position.z));
}

/** Matrix that puts a model (bounds in its own metres) on the table before the person; scale 1: as large as it is. */
export function onTable(stand: Stand, sphere: Sphere, scale: number): Matrix4 {
  const at = placeBefore(stand, 0, TABLE_HEIGHT, TABLE_DISTANCE);
  // At a scale where the model is larger than the table it starts behind the person's toes, not around the head.
  const ahead = Math.max(0, sphere.radius * scale + 0.4 - TABLE_DISTANCE);
  at.add(new Vector3(0, 0, -ahead).applyAxisAngle(UP, stand.yaw));
  return new Matrix4()
    .makeTranslation(at.x, Math.max(at.y, sphere.radius * scale * 0.6), at.z)
    .multiply(new Matrix4().makeRotationFromQuaternion(new Quaternion().setFromAxisAngle(UP, stand.yaw)))
    .multiply(new Matrix4().makeScale(scale, scale, scale))
    .multiply(new Matrix4().makeTranslation(-sphere.center.x, -sphere.center.y, -sphere.center.z));
}
