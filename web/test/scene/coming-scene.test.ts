// SPDX-License-Identifier: Apache-2.0
// A scene that comes piece by piece is the same scene; what is drawn first is there first; what is cut off is said.
import { expect, test } from "vitest";
import { openScene, type SceneData, SceneError } from "../../src/scene";
import { tinyScene } from "../support/tiny-scene";

const noSide = () => Promise.reject(new Error("no side files here"));

function streamOf(bytes: ArrayBuffer, pieces: number): ReadableStream<Uint8Array> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at >= bytes.byteLength) controller.close();
      else controller.enqueue(new Uint8Array(bytes.slice(at, at + pieces)));
      at += pieces;
    },
  });
}

/** Gives what comes before `hold`, then waits until it is let go. */
function heldStream(bytes: ArrayBuffer, hold: number) {
  let letGo = () => {};
  const free = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  const stream = new ReadableStream<Uint8Array>({
    async start(controller) {
      controller.enqueue(new Uint8Array(bytes.slice(0, hold)));
      await free;
      controller.enqueue(new Uint8Array(bytes.slice(hold)));
      controller.close();
    },
  });
  return { stream, letGo };
}

async function contentOf(scene: SceneData) {
  await scene.edgesCame;
  const fields = await Promise.all(scene.extras.results.map((r) => scene.loadField(r, 1)));
  return { parts: scene.parts, fields, gaps: scene.gaps };
}

/** Where the bytes of a named accessor start in the file. */
function startOf(bytes: ArrayBuffer, name: string): number {
  const head = new DataView(bytes);
  const length = head.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length)));
  const view = json.accessors.find((a: { name?: string }) => a.name === name).bufferView;
  return 28 + length + json.bufferViews[view].byteOffset;
}

for (const pieces of [1, 7, 1000]) {
  test(`scene_in_pieces_of_${pieces}_bytes_is_the_scene_in_one`, async () => {
    const { glb } = tinyScene({ bars: 2, cells: [3, 2, 1] });
    const whole = await contentOf(await openScene(glb, noSide));
    const coming = await contentOf(await openScene(streamOf(glb, pieces), noSide));
    expect(coming).toEqual(whole);
    expect(whole.parts[1]?.edges?.indices.length).toBeGreaterThan(0);
  });
}

test("parts_are_there_while_edges_and_results_are_still_on_their_way", async () => {
  const { glb } = tinyScene();
  const { stream, letGo } = heldStream(glb, startOf(glb, "p0/edges/POSITION"));
  const scene = await openScene(stream, noSide);
  expect(scene.parts[0]?.indices.length).toBeGreaterThan(0);
  expect(scene.parts[0]?.edges).toBeNull();
  const result = scene.extras.results[0]!;
  let came = false;
  const field = scene.loadField(result, 1).then((f) => {
    came = true;
    return f;
  });
  await new Promise((later) => setTimeout(later, 20));
  expect(came).toBe(false);
  letGo();
  expect((await field)[0]?.values.length).toBeGreaterThan(0);
  await scene.edgesCame;
  expect(scene.parts[0]?.edges).not.toBeNull();
});

test("every_cut_of_a_coming_scene_is_said_and_nothing_waits_for_ever", async () => {
  const { glb } = tinyScene({ cells: [2, 1, 1] });
  for (let length = 0; length < glb.byteLength - 4; length += 211) {
    const cut = async () => {
      const scene = await openScene(streamOf(glb.slice(0, length), 500), noSide);
      await scene.edgesCame;
      for (const result of scene.extras.results)
        for (const { step } of result.values) await scene.loadField(result, step);
    };
    await expect(cut()).rejects.toBeInstanceOf(SceneError);
  }
});

test("field_without_gaps_is_the_files_own_array_and_one_with_gaps_leaves_it_alone", async () => {
  const tiny = tinyScene({ sideFiles: true });
  const scene = await openScene(tiny.glb, async (uri) => tiny.side.get(uri)!);
  const of = (id: string) => scene.extras.results.find((r) => r.id === id)!;
  const temperature = (await scene.loadField(of("temperature"), 2))[0]!;
  expect(temperature.values.buffer).toBe(tiny.side.get("tiny.d/temperature.2.bin"));
  const before = tiny.side.get("tiny.d/stress_von_mises.2.bin")!.slice(0);
  const stress = (await scene.loadField(of("stress_von_mises"), 2))[0]!;
  expect(stress.values.some(Number.isNaN)).toBe(true);
  expect(tiny.side.get("tiny.d/stress_von_mises.2.bin")).toEqual(before);
});

test("length_that_is_a_lie_is_refused_when_the_bytes_end", async () => {
  const { glb } = tinyScene({ cells: [2, 1, 1] });
  const jsonLength = new DataView(glb).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, 20, jsonLength)));
  const position = json.accessors.find((a: { name?: string }) => a.name === "p0/POSITION");
  position.count = 250_000_000;
  json.bufferViews[position.bufferView].byteLength = 3_000_000_000;
  const text = new TextEncoder().encode(JSON.stringify(json));
  const lie = new Uint8Array(28 + text.length + 100);
  const head = new DataView(lie.buffer);
  for (const [k, word] of [0x46546c67, 2, 4e9, text.length, 0x4e4f534a].entries())
    head.setUint32(4 * k, word, true);
  lie.set(text, 20);
  head.setUint32(20 + text.length, 3_900_000_000, true);
  head.setUint32(24 + text.length, 0x004e4942, true);
  const before = process.memoryUsage().arrayBuffers;
  await expect(openScene(streamOf(lie.buffer, 1000), noSide)).rejects.toThrow(/cut off/);
  expect(process.memoryUsage().arrayBuffers - before).toBeLessThan(100e6);
});

test("array_larger_than_the_first_room_comes_whole", async () => {
  const floats = 5_999_994;
  const json = {
    asset: { version: "2.0" },
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: "VEC3", name: "p0/POSITION" },
      { bufferView: 1, componentType: 5126, count: floats / 3, type: "VEC3", name: "p0/_U/1" },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 36 },
      { buffer: 0, byteOffset: 36, byteLength: 4 * floats },
    ],
    buffers: [{ byteLength: 36 + 4 * floats }],
    meshes: [{ primitives: [{ attributes: { POSITION: 1 } }] }],
    nodes: [{ mesh: 0, extras: { feelem: { role: "part", part: 0 } } }],
    scenes: [{ nodes: [0] }],
    extras: { feelem: { version: 1, parts: [{ id: 0, name: "p", kind: "solid" }], steps: [], results: [] } },
  };
  const text = new TextEncoder().encode(JSON.stringify(json));
  const file = new Uint8Array(28 + text.length + 36 + 4 * floats);
  const head = new DataView(file.buffer);
  for (const [k, word] of [0x46546c67, 2, file.length, text.length, 0x4e4f534a].entries())
    head.setUint32(4 * k, word, true);
  file.set(text, 20);
  head.setUint32(20 + text.length, 36 + 4 * floats, true);
  head.setUint32(24 + text.length, 0x004e4942, true);
  const start = 28 + text.length + 36;
  for (const i of [0, 4_194_303, 4_194_304, floats - 1]) head.setFloat32(start + 4 * i, i + 0.5, true);
  const { parts } = await openScene(streamOf(file.buffer, 1_000_003), noSide);
  for (const i of [0, 4_194_303, 4_194_304, floats - 1]) expect(parts[0]?.positions[i]).toBe(i + 0.5);
});
