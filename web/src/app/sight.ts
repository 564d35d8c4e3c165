// SPDX-License-Identifier: Apache-2.0
// Where the camera looks from: standard views, and turning until a place is in sight.
import { Ray, Vector3 } from "three";
import type { Place } from "../probe";
import type { Stage } from "../render";
import { modelDirection, type ViewName } from "../ui";
import type { ModelView } from "./model-view";

const scratchRay = new Ray();

export function fitModel(stage: Stage, view: ModelView): void {
  stage.orbit.fit(view.model.bounds());
}

export function lookFrom(stage: Stage, view: ModelView, name: ViewName): void {
  const { matrix } = view.model.group;
  if (name === "iso") {
    stage.orbit.lookFrom(modelDirection(matrix, [1, -1, 0]).add(new Vector3(0, 0.75, 0)));
  } else {
    const axis = { x: 0, y: 1, z: 2 }[name[1] as "x" | "y" | "z"];
    const direction: [number, number, number] = [0, 0, 0];
    direction[axis] = name[0] === "+" ? 1 : -1;
    stage.orbit.lookFrom(modelDirection(matrix, direction));
  }
  fitModel(stage, view);
}

/** Nothing of the model stands between the camera and the place. */
export function inSight(stage: Stage, view: ModelView, place: Place): boolean {
  const matrix = view.model.worldMatrix();
  const world = view.picker.worldOf(place, matrix);
  scratchRay.origin.setFromMatrixPosition(stage.camera.matrixWorld);
  scratchRay.direction.copy(world).sub(scratchRay.origin);
  const distance = scratchRay.direction.length();
  scratchRay.direction.normalize();
  const hit = view.picker.ray(scratchRay, matrix);
  return !hit || hit.distance > distance - 1e-3 * view.model.sphere().radius;
}

/** Turns the camera so that the place is in front, unless it is in sight already. */
export function turnTo(stage: Stage, view: ModelView, place: Place): void {
  if (inSight(stage, view, place)) return;
  const world = view.picker.worldOf(place, view.model.worldMatrix());
  const direction = world.sub(view.model.sphere().center);
  if (direction.lengthSq() > 0) stage.orbit.lookFrom(direction);
}

/** Brings the camera before a place, so near that its surroundings fill the view. */
export function flyTo(stage: Stage, view: ModelView, place: Place): void {
  turnTo(stage, view, place);
  const world = view.picker.worldOf(place, view.model.worldMatrix());
  stage.orbit.goTo(world, Math.min(stage.orbit.distance, 1.6 * view.model.sphere().radius));
}
