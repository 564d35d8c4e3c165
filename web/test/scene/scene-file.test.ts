// SPDX-License-Identifier: Apache-2.0
// Scenes come back bit for bit, missing stays missing, and damaged bytes give a SceneError.
import { expect, test } from "vitest";
import { MISSING, openScene, SceneError, SOLVER } from "../../src/scene";
import { FIRST_ELEMENT_ID, MISSING_FROM_X, tinyScene, tinyValues } from "../support/tiny-scene";

const noSide = () => Promise.reject(new Error("no side files here"));

test("values_ids_and_units_come_back_bit_for_bit", async () => {
  const scene = await openScene(tinyScene().glb, noSide);
  const part = scene.parts[0]!;
  const result = scene.extras.results.find((r) => r.id === "temperature")!;

  const field = (await scene.loadField(result, 1))[0]!;

  expect(scene.extras.lengthUnit).toEqual({ name: "mm", metres: 0.001 });
  expect(part.elementIds?.[0]).toBe(FIRST_ELEMENT_ID);
  let checked = 0;
  for (const [i, id] of part.nodeIds.entries()) {
    if (id === 0) continue;
    const [x, y] = [part.positions[3 * i]!, part.positions[3 * i + 1]!];
    expect(field.values[i]).toBe(Math.fround(tinyValues.temperature(x, y, 1)));
    checked += 1;
  }
  expect(checked).toBeGreaterThan(100);
});

test("masked_values_come_back_as_missing_and_never_as_a_number", async () => {
  const scene = await openScene(tinyScene().glb, noSide);
  const part = scene.parts[0]!;
  const result = scene.extras.results.find((r) => r.id === "stress_von_mises")!;

  const field = (await scene.loadField(result, 1))[0]!;

  for (const [i, id] of part.nodeIds.entries()) {
    if (id === 0) continue;
    const gone = part.positions[3 * i]! > MISSING_FROM_X;
    expect(field.state[i]).toBe(gone ? MISSING : SOLVER);
    expect(Number.isNaN(field.values[i])).toBe(gone);
  }
});

test("levels_of_detail_come_when_they_are_asked_for_and_hold_the_parts_own_vertices", async () => {
  const scene = await openScene(tinyScene({ levels: true, bars: 2 }).glb, noSide);
  const lists = await scene.loadLevel(0);

  expect(scene.extras.levels?.[0]?.triangles).toBe(24);
  expect(lists.map((list) => list?.length)).toEqual([36, 36]);
  for (const [i, part] of scene.parts.entries())
    for (const corner of lists[i]!) expect(part.nodeIds[corner]).toBeGreaterThan(0);
});

test("a_level_of_other_vertices_or_without_data_is_refused", async () => {
  const { glb } = tinyScene({ levels: true });
  const length = new DataView(glb).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, 20, length)));
  const named = json.accessors.find((a: { name: string }) => a.name === "p0/indices/lod1");
  const start = 28 + length + json.bufferViews[named.bufferView].byteOffset;
  new DataView(glb).setUint32(start, 1_000_000, true);
  const scene = await openScene(glb, noSide);

  await expect(scene.loadLevel(0)).rejects.toThrow(SceneError);
  expect(await scene.loadLevel(1)).toEqual([null]);
});

test("side_files_are_fetched_once_and_only_when_asked_for", async () => {
  const tiny = tinyScene({ sideFiles: true });
  const asked: string[] = [];
  const scene = await openScene(tiny.glb, async (uri) => {
    asked.push(uri);
    return tiny.side.get(uri)!;
  });
  const result = scene.extras.results.find((r) => r.id === "displacement")!;
  expect(asked).toEqual([]);

  await scene.loadField(result, 2);
  const field = (await scene.loadField(result, 2))[0]!;

  expect(asked).toEqual(["tiny.d/displacement.2.bin"]);
  expect(field.components).toBe(3);
});

test("missing_side_file_is_an_error_of_that_result_only", async () => {
  const scene = await openScene(tinyScene({ sideFiles: true }).glb, noSide);
  const result = scene.extras.results.find((r) => r.id === "temperature")!;

  await expect(scene.loadField(result, 2)).rejects.toThrow(/tiny\.d\/temperature\.2\.bin/);
  expect((await scene.loadField(result, 1))[0]?.values.length).toBeGreaterThan(0);
});

test("every_cut_of_a_scene_is_refused_with_a_scene_error", async () => {
  const bytes = tinyScene({ cells: [2, 1, 1] }).glb;
  for (let length = 0; length < bytes.byteLength; length += 97) {
    await expect(openScene(bytes.slice(0, length), noSide)).rejects.toBeInstanceOf(SceneError);
  }
});

test("counts_that_the_file_cannot_hold_are_refused", async () => {
  const text = JSON.stringify({
    asset: { version: "2.0" },
    accessors: [{ bufferView: 0, componentType: 5126, count: 4e9, type: "VEC3" }],
    bufferViews: [{ buffer: 0, byteLength: 12 }],
    buffers: [{ uri: "a.bin", byteLength: 12 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    nodes: [{ mesh: 0, extras: { feelem: { role: "part", part: 0 } } }],
    scenes: [{ nodes: [0] }],
    extras: { feelem: { version: 1, parts: [{ id: 0, name: "p", kind: "solid" }], steps: [], results: [] } },
  });
  const bytes = new TextEncoder().encode(text);
  const opening = openScene(bytes.buffer as ArrayBuffer, async () => new ArrayBuffer(12));
  await expect(opening).rejects.toThrow(/more than the file holds/);
});
