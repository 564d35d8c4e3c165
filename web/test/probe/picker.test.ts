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
