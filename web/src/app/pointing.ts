// SPDX-License-Identifier: Apache-2.0
// Where the person's head is and where they point: the ray of the hand that counts, else the line of sight.
import { Matrix4, Vector3 } from "three";
import type { App } from "./app";

export interface VrPose {
  /** World metres. */
  readonly origin: Vector3;
  readonly direction: Vector3;
  /** World to head: x right, y up, z back. */
  readonly toHead: Matrix4;
}

export function pointingOf(app: App): VrPose {
  const { renderer, camera } = app.stage;
  const eye = renderer.xr.isPresenting ? renderer.xr.getCamera() : camera;
  const origin = new Vector3().setFromMatrixPosition(eye.matrixWorld);
  const direction = new Vector3(0, 0, -1).transformDirection(eye.matrixWorld);
  const toHead = new Matrix4().copy(eye.matrixWorld).invert();
  const place = app.probing.current()?.place;
  // At the desk the mouse points from the eye through the place that it is on.
  if (place && app.probing.current()?.name !== "pin") {
    const at = app.view.picker.worldOf(place, app.view.model.worldMatrix());
    direction.copy(at).sub(origin).normalize();
  }
  return { origin, direction, toHead };
}
