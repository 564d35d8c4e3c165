// SPDX-License-Identifier: Apache-2.0
// Rays find the triangle, its element and its place, also after the model is deformed.
import { Matrix4, Ray, Vector3 } from "three";
import { expect, test } from "vitest";
import { findElement, findNode, Picker, placePoint } from "../../src/probe";
import { openScene } from "../../src/scene";
import { tinyScene, tinyValues } from "../support/tiny-scene";

const open = () => openScene(tinyScene().glb, () => Promise.reject(new Error("none")));
const none = new Matrix4();

test("ray_from_above_hits_the_top_where_it_points", async () => {
  const scene = await open();
  const picker = new Picker(scene.parts);
  await picker.build();

  const hit = picker.ray(new Ray(new Vector3(33, 17, 100), new Vector3(0, 0, -1)), none);

  const [x, y, z] = placePoint(scene.parts[0]!, hit!, [0, 0, 0]);
  expect([x, y, z].map((v) => Number(v.toFixed(4)))).toEqual([33, 17, 30]);
  expect(hit?.distance).toBeCloseTo(70, 4);
});

test("ray_meets_the_deformed_skin_but_the_place_is_undeformed", async () => {
  const scene = await open();
  const picker = new Picker(scene.parts);
  await picker.build();
  const result = scene.extras.results.find((r) => r.id === "displacement")!;
  const moved = (await scene.loadField(result, 1)).map((f) => f?.values ?? null);
  picker.setShape(moved, 5);

  const hit = picker.ray(new Ray(new Vector3(100, 20, 100), new Vector3(0, 0, -1)), none);

  expect(placePoint(scene.parts[0]!, hit!, [0, 0, 0])[2]).toBeCloseTo(30, 4);
  expect(hit?.world.z).toBeCloseTo(30 + 5 * tinyValues.displacement(100, 1)[2], 3);
});

test("ray_beside_the_model_hits_nothing", async () => {
  const picker = new Picker((await open()).parts);
  await picker.build();

  expect(picker.ray(new Ray(new Vector3(500, 0, 100), new Vector3(0, 0, -1)), none)).toBeNull();
});

test("node_and_element_are_found_by_id_and_unknown_ones_are_not", async () => {
  const { parts } = await open();
  const part = parts[0]!;
  const id = part.nodeIds[40]!;

  const place = findNode(parts, id)!;
  const corner = part.indices[3 * place.triangle + place.weights.indexOf(1)]!;

  expect(part.nodeIds[corner]).toBe(id);
  expect(part.elementIds?.[findElement(parts, part.elementIds[5]!)!.triangle]).toBe(part.elementIds?.[5]);
  expect(findNode(parts, 999_999)).toBeNull();
  expect(findNode(parts, 0)).toBeNull();
  expect(findElement(parts, 999_999)).toBeNull();
});

test("nearest_place_of_a_point_is_found_within_reach_on_the_deformed_skin", async () => {
  const scene = await open();
  const picker = new Picker(scene.parts);
  await picker.build();
  const result = scene.extras.results.find((r) => r.id === "displacement")!;
  picker.setShape(
    (await scene.loadField(result, 1)).map((f) => f?.values ?? null),
    5,
  );
  const sag = 5 * tinyValues.displacement(100, 1)[2];
  // Metres where the model is in millimetres, and standing somewhere in the room.
  const world = new Matrix4().makeTranslation(1, 2, 3).scale(new Vector3(0.001, 0.001, 0.001));
  const over = (height: number) => new Vector3(100, 20, 30 + sag + height).applyMatrix4(world);

  const touched = picker.near(over(20), 0.03, world);

  expect(placePoint(scene.parts[0]!, touched!, [0, 0, 0])[2]).toBeCloseTo(30, 4);
  // The bar is bent: straight up is not quite the shortest way.
  expect(touched?.distance).toBeGreaterThan(0.018);
  expect(touched?.distance).toBeLessThan(0.02);
  expect(picker.near(over(40), 0.03, world)).toBeNull();
});

test("nearest_place_is_neither_cut_away_nor_hidden", async () => {
  const { parts } = await open();
  const picker = new Picker(parts);
  await picker.build();
  const above = new Vector3(100, 20, 32);
  const at = () => {
    const hit = picker.near(above, 100, none);
    return hit && placePoint(parts[0]!, hit, [0, 0, 0]).map((v) => Math.round(v));
  };

  expect(at()).toEqual([100, 20, 30]);
  picker.setCuts([{ normal: [1, 0, 0], offset: 80 }]);
  expect(at()![0]).toBeLessThanOrEqual(80);
  picker.setCuts([]);
  picker.setLooks(["hidden"]);
  expect(at()).toBeNull();
});

test("a_ray_through_a_slab_between_planes_meets_the_material_and_passes_where_there_is_none", async () => {
  const { parts } = await open();
  const picker = new Picker(parts);
  await picker.build();
  picker.setCuts([
    { normal: [1, 0, 0], offset: 65 },
    { normal: [-1, 0, 0], offset: -55 },
  ]);
  const along = new Vector3(-1, 0, 0);

  const { hit, inside } = picker.cast(new Ray(new Vector3(200, 17, 11), along), none);
  expect(hit).toBeNull();
  expect(inside?.toArray()).toEqual([65, 17, 11]);
  expect(picker.cast(new Ray(new Vector3(200, 57, 11), along), none).inside).toBeNull();
  picker.setLooks(["hidden"]);
  expect(picker.cast(new Ray(new Vector3(200, 17, 11), along), none).inside).toBeNull();
});
