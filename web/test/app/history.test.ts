// SPDX-License-Identifier: Apache-2.0
// A node's history is what the scene's arrays hold at each step, and what is kept of results stays within its room.
import { expect, test } from "vitest";
import { type HistoryPoint, readHistory, stepPositions } from "../../src/app/history-data";
import { openScene } from "../../src/scene";
import { FieldCache } from "../../src/scene/field-cache";
import { tinyScene, tinyValues } from "../support/tiny-scene";

const made = tinyScene({ times: 8, sideFiles: true });
const fetched: string[] = [];
const scene = await openScene(made.glb, (uri) => {
  fetched.push(uri);
  const bytes = made.side.get(uri);
  return bytes ? Promise.resolve(bytes) : Promise.reject(new Error("lost"));
});
const part = scene.parts[0]!;
const vertex = part.nodeIds.findIndex((id, i) => id > 0 && part.positions[3 * i] === 60);
const [x, y] = [part.positions[3 * vertex]!, part.positions[3 * vertex + 1]!];
const find = (id: string) => scene.extras.results.find((r) => r.id === id)!;

async function history(id: string, at: number): Promise<readonly HistoryPoint[]> {
  let last: readonly HistoryPoint[] = [];
  await readHistory(scene, { result: find(id), component: 0, part: 0, vertex: at }, (points) => {
    last = points;
    return true;
  });
  return last;
}

test("history_is_the_value_of_every_step_in_order", async () => {
  const points = await history("temperature", vertex);

  expect(points.map((p) => p.step)).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  for (const { step, value } of points) expect(value).toBe(Math.fround(tinyValues.temperature(x, y, step)));
});

test("missing_value_and_lost_file_are_gaps", async () => {
  const end = part.nodeIds.findIndex((id, i) => id > 0 && part.positions[3 * i] === 120);
  expect((await history("stress_von_mises", end)).every((p) => p.value === null)).toBe(true);

  made.side.delete("tiny.d/displacement_magnitude.4.bin");
  const points = await history("displacement_magnitude", vertex);
  expect(points.filter((p) => p.value === null).map((p) => p.step)).toEqual([4]);
});

test("reading_ends_when_nobody_wants_it_any_more", async () => {
  let calls = 0;
  await readHistory(scene, { result: find("temperature"), component: 0, part: 0, vertex }, () => {
    calls += 1;
    return calls < 3;
  });

  expect(calls).toBe(3);
});

test("steps_stand_at_their_time_when_it_grows_and_else_at_their_number", () => {
  const steps = (...values: (number | null)[]) => values.map((value, i) => ({ id: 10 + i, value }));

  expect([...stepPositions(steps(0.5, 1, 4)).values()]).toEqual([0.5, 1, 4]);
  expect([...stepPositions(steps(1, 76, 5)).values()]).toEqual([1, 2, 3]);
  expect([...stepPositions(steps(1, null)).values()]).toEqual([1, 2]);
});

test("kept_results_stay_within_their_room_and_the_oldest_goes_first", async () => {
  const field = () => [{ components: 1, values: new Float32Array(100), state: new Uint8Array(100) }];
  const cache = new FieldCache(1200);
  const reads: string[] = [];
  const get = (key: string) =>
    cache.get(key, () => {
      reads.push(key);
      return Promise.resolve(field());
    });
  for (const key of ["a", "b", "a", "c", "a", "b"]) await get(key);

  expect(reads).toEqual(["a", "b", "c", "b"]);
  expect(cache.bytes).toBeLessThanOrEqual(1200);
});

test("side_file_that_parts_share_counts_once_and_what_stays_anyway_counts_nothing", async () => {
  const file = new ArrayBuffer(800);
  const own = new ArrayBuffer(800);
  const part = (buffer: ArrayBuffer, at: number) => ({
    components: 1,
    values: new Float32Array(buffer, at, 100),
    state: new Uint8Array(own),
  });
  const cache = new FieldCache(10_000, (buffer) => buffer !== own);

  await cache.get("a", () => Promise.resolve([part(file, 0), part(file, 400)]));
  await cache.get("b", () => Promise.resolve([part(own, 0), part(own, 400)]));

  expect(cache.bytes).toBe(800);
});
