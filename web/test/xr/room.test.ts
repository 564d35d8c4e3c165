// SPDX-License-Identifier: Apache-2.0
// The room is laid out before the person, wherever they stand and look.
import { Euler, Matrix4, Sphere, Vector3 } from "three";
import { expect, test } from "vitest";
import { onTable, placeBefore, standOf, TABLE_DISTANCE, TABLE_HEIGHT } from "../../src/xr/room";

const head = (x: number, z: number, yaw: number, pitch = 0) =>
  new Matrix4().makeRotationFromEuler(new Euler(pitch, yaw, 0, "YXZ")).setPosition(x, 1.6, z);
const round = (v: Vector3) => [v.x, v.y, v.z].map((c) => Math.round(c * 1e6) / 1e6 + 0);

test("model_stands_before_the_person_at_table_height", () => {
  const sphere = new Sphere(new Vector3(5, 6, 7), 0.4);

  const middle = sphere.center.clone().applyMatrix4(onTable(standOf(head(2, 3, 0)), sphere, 1));

  expect(round(middle)).toEqual([2, TABLE_HEIGHT, 3 - TABLE_DISTANCE]);
});

test("looking_to_the_left_puts_everything_to_the_left_and_looking_down_changes_nothing", () => {
  const level = standOf(head(0, 0, Math.PI / 2));
  const down = standOf(head(0, 0, Math.PI / 2, -0.7));

  expect(round(placeBefore(level, 0, 1, 2))).toEqual([-2, 1, 0]);
  expect(round(placeBefore(down, 0.5, 1, 2))).toEqual(round(placeBefore(level, 0.5, 1, 2)));
});

test("model_larger_than_the_room_does_not_stand_around_the_head", () => {
  const sphere = new Sphere(new Vector3(), 10);

  const middle = new Vector3().applyMatrix4(onTable(standOf(head(0, 0, 0)), sphere, 1));

  expect(-middle.z).toBeGreaterThan(10);
});
