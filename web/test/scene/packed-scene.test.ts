// SPDX-License-Identifier: Apache-2.0
// Compressed scenes hold the same numbers; steps become values; lies about sizes are refused before memory is taken.
import { expect, test } from "vitest";
import { openScene, SceneError } from "../../src/scene";
import { unpack } from "../../src/scene/unpack";
import { packScene, readGlb, writeGlb } from "../support/packed-scene";
import { tinyScene } from "../support/tiny-scene";

const noSide = () => Promise.reject(new Error("no side files here"));
const streamOf = (glb: ArrayBuffer) => new Blob([glb]).stream();

async function contentOf(glb: ArrayBuffer | ReadableStream<Uint8Array>) {
  const scene = await openScene(glb, noSide, unpack);
  await scene.edgesCame;
  const fields = [];
  for (const result of scene.extras.results)
    for (const { step } of result.values) fields.push(await scene.loadField(result, step));
  return { parts: scene.parts, fields };
}

test("packed_scene_holds_the_same_numbers", async () => {
  const { glb } = tinyScene({ bars: 2 });
  const packed = await packScene(glb);
  expect(packed.byteLength).toBeLessThan(glb.byteLength);
  const plain = await contentOf(glb);

  expect(await contentOf(packed)).toEqual(plain);
  expect(await contentOf(streamOf(packed))).toEqual(plain);
});

test("numbers_of_steps_become_values_rounded_once", async () => {
  const { json, bin } = readGlb(tinyScene().glb);
  const accessor = json.accessors.find((a) => a.name === "p0/_TEMPERATURE/1") as (typeof json.accessors)[0];
  const start = json.bufferViews[accessor.bufferView]?.byteOffset ?? 0;
  const steps = { offset: 20.1, step: -0.1 };
  const numbers = Int32Array.from({ length: accessor.count }, (_, i) => (i % 7) - 3);
  bin.set(new Uint8Array(numbers.buffer), start);
  Object.assign(accessor, { componentType: 5125, extras: { feelem: steps } });
  const scene = await openScene(writeGlb(json, bin), noSide);

  const field = (await scene.loadField(scene.extras.results.find((r) => r.id === "temperature")!, 1))[0]!;

  for (const [i, n] of numbers.entries()) expect(field.values[i]).toBe(Math.fround(20.1 + -0.1 * n));
});

test("a_packed_array_that_says_too_much_is_refused_before_memory_is_taken", async () => {
  const { json, bin } = readGlb(await packScene(tinyScene().glb));
  const view = json.bufferViews.find((v) => v.extensions)!;
  const packed = view.extensions?.EXT_meshopt_compression as Record<string, unknown>;
  const lies = [
    { count: 2 ** 40, length: 2 ** 42 },
    { count: -1, length: 4 },
    { count: 1.5, length: 6 },
    { byteStride: 0, length: 0 },
    { mode: "SOMETHING", length: view.byteLength },
    { byteLength: 2 ** 50, length: view.byteLength },
  ];
  for (const { length, ...lie } of lies) {
    const told = structuredClone(json);
    const there = told.bufferViews[json.bufferViews.indexOf(view)]!;
    there.byteLength = length;
    there.extensions = { EXT_meshopt_compression: { ...packed, ...lie } };
    await expect(openScene(writeGlb(told, bin), noSide, unpack), JSON.stringify(lie)).rejects.toBeInstanceOf(
      SceneError,
    );
  }
});

test("damaged_bytes_of_a_packed_array_are_an_error_and_not_a_hang", async () => {
  const glb = await packScene(tinyScene().glb);
  let refused = 0;
  for (let at = 28; at < glb.byteLength; at += Math.ceil(glb.byteLength / 40)) {
    const damaged = glb.slice(0);
    const bytes = new Uint8Array(damaged);
    bytes[at] = (bytes[at] ?? 0) ^ 0xff;
    refused += await contentOf(damaged).then(
      () => 0,
      (error: unknown) => {
        expect(error).toBeInstanceOf(SceneError);
        return 1;
      },
    );
  }
  expect(refused).toBeGreaterThan(5);
});
