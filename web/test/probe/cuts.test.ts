// SPDX-License-Identifier: Apache-2.0
// Rays meet what is left of the model: not hidden parts, not what a plane cut away, and no values in the opened inside.
import { Matrix4, Ray, Vector3 } from "three";
import { expect, test } from "vitest";
import { kept, Picker, placePoint } from "../../src/probe";
import { openScene } from "../../src/scene";
import { tinyScene } from "../support/tiny-scene";

const world = new Matrix4();
const scene = await openScene(tinyScene({ bars: 2 }).glb, () => Promise.reject(new Error("none")));

async function picker(): Promise<Picker> {
  const made = new Picker(scene.parts);
  await made.build();
  return made;
}
/** Along y through both bars: the first from y = 0 to 40, the second from 60 to 100. */
const through = new Ray(new Vector3(55, -50, 15), new Vector3(0, 1, 0));

test("what_a_plane_keeps_of_a_ray_is_between_where_it_enters_and_leaves", () => {
  const up = { x: 0, y: 0, z: 1 };
  const at = { x: 0, y: 0, z: -10 };

  expect(kept([], at, up)).toEqual({ enters: 0, leaves: Number.POSITIVE_INFINITY });
  expect(kept([{ normal: [0, 0, 1], offset: 5 }], at, up)).toEqual({ enters: 0, leaves: 15 });
  expect(kept([{ normal: [0, 0, -1], offset: -5 }], at, up)).toEqual({
    enters: 15,
    leaves: Number.POSITIVE_INFINITY,
  });
  expect(kept([{ normal: [1, 0, 0], offset: -1 }], at, up)).toBeNull();
});

test("rays_pass_hidden_parts_and_clear_ones_before_others", async () => {
  const made = await picker();

  expect(made.ray(through, world)?.part).toBe(0);
  made.setLooks(["hidden", "shown"]);
  expect(made.ray(through, world)?.part).toBe(1);
  made.setLooks(["clear", "shown"]);
  expect(made.ray(through, world)?.part).toBe(1);
  made.setLooks(["clear", "hidden"]);
  expect(made.ray(through, world)?.part).toBe(0);
  made.setLooks(["hidden", "hidden"]);
  expect(made.ray(through, world)).toBeNull();
});

test("behind_a_plane_the_opened_solid_has_a_place_but_no_values", async () => {
  const made = await picker();
  made.setCuts([{ normal: [0, -1, 0], offset: -25 }]);

  const { hit, inside } = made.cast(through, world);

  expect(hit).toBeNull();
  expect(inside?.toArray()).toEqual([55, 25, 15]);
});

test("a_plane_between_the_parts_leaves_the_second", async () => {
  const made = await picker();
  made.setCuts([{ normal: [0, -1, 0], offset: -50 }]);

  const { hit, inside } = made.cast(through, world);

  expect(inside).toBeNull();
  expect(placePoint(scene.parts[1]!, hit!, [0, 0, 0])[1]).toBeCloseTo(60, 4);
});

test("what_lies_past_a_plane_is_not_hit", async () => {
  const made = await picker();
  made.setCuts([{ normal: [0, 1, 0], offset: -1 }]);

  expect(made.cast(through, world)).toEqual({ hit: null, inside: null });
});
