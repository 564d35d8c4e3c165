// SPDX-License-Identifier: Apache-2.0
// Hands on the model: 1:1 with one, move, turn and scale with two, and no jump when a hand comes or goes.
import { Matrix4, Quaternion, Vector3 } from "three";
import { expect, test } from "vitest";
import { carryWithTwo, Grab, type GripPose } from "../../src/xr/grab";

const pose = (x: number, y: number, z: number, turn = 0): GripPose => ({
  position: new Vector3(x, y, z),
  quaternion: new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), turn),
});
const at = (matrix: Matrix4, x: number, y: number, z: number) => {
  const p = new Vector3(x, y, z).applyMatrix4(matrix);
  return [p.x, p.y, p.z].map((v) => Math.round(v * 1e6) / 1e6 + 0);
};

test("one_hand_carries_one_to_one", () => {
  const grab = new Grab();
  grab.move(new Map([["right", pose(0, 1, 0)]]));
  grab.take("right", pose(0, 1, 0), new Matrix4());

  const moved = grab.move(new Map([["right", pose(0.3, 1.2, -0.1)]]))!;

  expect(at(moved, 0, 0, 0)).toEqual([0.3, 0.2, -0.1]);
});

test("turning_the_hand_turns_the_model_round_the_hand", () => {
  const grab = new Grab();
  grab.take("right", pose(1, 0, 0), new Matrix4());

  const moved = grab.move(new Map([["right", pose(1, 0, 0, Math.PI / 2)]]))!;

  expect(at(moved, 2, 0, 0)).toEqual([1, 0, -1]);
});

test("two_hands_scale_about_their_middle_and_turn_about_the_vertical_only", () => {
  const wider = carryWithTwo(
    new Matrix4(),
    [new Vector3(-0.1, 1, 0), new Vector3(0.1, 1, 0)],
    [new Vector3(-0.2, 1, 0), new Vector3(0.2, 1, 0)],
  );
  const tilted = carryWithTwo(
    new Matrix4(),
    [new Vector3(-1, 1, 0), new Vector3(1, 1, 0)],
    [new Vector3(-1, 0.5, 0), new Vector3(1, 1.5, 0)],
  );

  expect(at(wider, 0.1, 1, 0)).toEqual([0.2, 1, 0]);
  expect(at(wider, 0, 1, 0)).toEqual([0, 1, 0]);
  expect(at(tilted, 0, 2, 0)[0]).toBe(0);
});

test("second_hand_and_letting_go_do_not_make_the_model_jump", () => {
  const grab = new Grab();
  const hands = (a: GripPose, b: GripPose) =>
    new Map([
      ["left", a],
      ["right", b],
    ]);
  let model = new Matrix4();
  grab.move(hands(pose(0, 1, 0), pose(1, 1, 0)));
  grab.take("left", pose(0, 1, 0), model);
  model = grab.move(hands(pose(0.5, 1, 0), pose(1, 1, 0)))!;
  grab.take("right", pose(1, 1, 0), model);

  expect(at(grab.move(hands(pose(0.5, 1, 0), pose(1, 1, 0)))!, 0, 0, 0)).toEqual(at(model, 0, 0, 0));

  model = grab.move(hands(pose(0.25, 1, 0), pose(1.25, 1, 0)))!;
  grab.letGo("left", model);
  expect(at(grab.move(hands(pose(0, 0, 0), pose(1.25, 1, 0)))!, 1, 2, 3)).toEqual(at(model, 1, 2, 3));
  grab.letGo("right", model);
  expect(grab.move(hands(pose(0, 0, 0), pose(0, 0, 0)))).toBeNull();
});

test("two_hands_tilt_the_model_only_where_that_is_wanted", () => {
  const from = [new Vector3(-1, 1, 0), new Vector3(1, 1, 0)] as const;
  const to = [new Vector3(0, 0, 0), new Vector3(0, 2, 0)] as const;

  const free = carryWithTwo(new Matrix4(), from, to, false);
  const upright = carryWithTwo(new Matrix4(), from, to, true);

  expect(at(free, 1, 1, 0)).toEqual([0, 2, 0]);
  expect(at(upright, 0, 2, 0)).toEqual([0, 2, 0]);
});
