// SPDX-License-Identifier: Apache-2.0
// Rules of hands in the room: when a resting pinch is offered a note, how fast the world moves, where a palm looks.
import { Matrix4, Scene, Vector3 } from "three";
import { expect, test } from "vitest";
import { OFFER_SECONDS, PinchRest, REST_SECONDS } from "../../src/xr/pinch-rest";
import { palmOf } from "../../src/xr/vr-menu";
import { VrVignette, wayAbout } from "../../src/xr/vr-vignette";

const here = new Vector3(0.1, 1, -1);

test("a_pinch_that_rests_is_offered_a_note_for_a_while", () => {
  const rest = new PinchRest();
  rest.update(here, 10);

  expect(rest.update(here, 10 + REST_SECONDS - 0.01)).toBe(0);
  expect(rest.update(here, 10 + REST_SECONDS + 0.01)).toBeGreaterThan(0);
  expect(rest.update(here, 10 + REST_SECONDS + OFFER_SECONDS + 0.01)).toBe(0);
});

test("a_pinch_that_moves_on_or_leaves_the_model_begins_to_rest_anew", () => {
  const rest = new PinchRest();
  rest.update(here, 0);
  rest.update(here.clone().add(new Vector3(0.03, 0, 0)), 0.5);

  expect(rest.share(0.7)).toBe(0);
  expect(rest.share(1.2)).toBeGreaterThan(0);
  rest.update(null, 1.2);
  expect(rest.share(1.3)).toBe(0);
});

test("a_hand_that_trembles_rests", () => {
  const rest = new PinchRest();
  for (let i = 0; i < 8; ++i) rest.update(here.clone().add(new Vector3(0, 0.004 * (i % 2), 0)), 0.1 * i);

  expect(rest.share(0.8)).toBeGreaterThan(0);
});

test("turning_the_world_moves_what_is_far_from_the_axis_and_scaling_what_is_far_from_the_middle", () => {
  const head = new Vector3(0, 1.6, 2);
  const turned = new Matrix4().makeRotationY(Math.PI / 2);

  expect(wayAbout(head, new Matrix4(), turned)).toBeCloseTo(2 * Math.SQRT2, 9);
  expect(wayAbout(new Vector3(0, 1.6, 0), new Matrix4(), turned)).toBeCloseTo(0, 9);
  expect(wayAbout(head, new Matrix4(), new Matrix4().makeTranslation(0.3, 0, 0))).toBeCloseTo(0.3, 9);
});

test("palm_looks_away_from_the_back_of_the_hand", () => {
  const flat = palmOf(new Matrix4().toArray());
  const turned = palmOf(new Matrix4().makeRotationZ(Math.PI).toArray());

  expect(flat.y).toBeCloseTo(-1, 9);
  expect(turned.y).toBeCloseTo(1, 9);
});

test("vignette_heeds_speed_and_size_and_no_jump", () => {
  const vignette = new VrVignette(new Scene());
  const head = new Matrix4().setPosition(0, 1.6, 0);
  const at = (x: number) => new Matrix4().makeTranslation(x, 0, 0);
  const world = { radius: 4, distance: 2 };
  const thing = { radius: 0.4, distance: 1.3 };
  const after = (x: number, size: typeof world, strength = 1) => {
    vignette.update(0.1, head, at(x), size, strength);
    return vignette.alpha;
  };

  expect(after(0, world)).toBe(0);
  expect(after(0.02, world)).toBe(0);
  expect(after(0.5, thing)).toBe(0);
  vignette.jump();
  expect(after(5, world)).toBe(0);
  expect(after(5.1, world, 0)).toBe(0);
  expect(after(5.2, world)).toBeCloseTo(2 / 3, 9);
  expect(after(5.3, world, 0.5)).toBeCloseTo(0.5, 9);
  expect(after(5.3, world)).toBe(0);
});
