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
