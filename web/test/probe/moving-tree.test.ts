// SPDX-License-Identifier: Apache-2.0
// Rays meet the skin where it is drawn, however it is moved: the hierarchy against every triangle one by one.
import { Matrix4, Ray, Triangle, Vector3 } from "three";
import { expect, test } from "vitest";
import { Picker } from "../../src/probe";
import type { ScenePart } from "../../src/scene";

/** Numbers between -1 and 1 that are the same each time. */
function randoms(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  };
}

/** A wavy sheet of n x n squares between -1 and 1. */
function sheet(n: number, index: number): ScenePart {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let j = 0; j <= n; ++j)
    for (let i = 0; i <= n; ++i) {
      const [x, y] = [(2 * i) / n - 1, (2 * j) / n - 1];
      positions.push(x, y, 0.2 * Math.sin(5 * x + index) * Math.cos(4 * y) - 0.5 * index);
    }
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < n; ++i) {
      const a = i + (n + 1) * j;
      indices.push(a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
    }
  const count = positions.length / 3;
  return {
    index,
    info: { id: index, name: `sheet ${index}`, kind: "shell" },
    positions: Float32Array.from(positions),
    normals: null,
    indices: Uint32Array.from(indices),
    nodeIds: Float64Array.from({ length: count }, (_, i) => i + 1),
    elementIds: null,
    edges: null,
  };
}

type Shape = { re: Float32Array | null; im: Float32Array | null; factorRe: number; factorIm: number };

/** Distance to the nearest of all triangles, each moved and asked by itself. */
function nearestOfAll(parts: readonly ScenePart[], shapes: readonly Shape[], ray: Ray): number {
  let best = Number.POSITIVE_INFINITY;
  const [a, b, c, at] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (const [k, part] of parts.entries()) {
    const { re, im, factorRe, factorIm } = shapes[k]!;
    const drawn = part.positions.map((x, i) => {
      const by = factorRe * (re?.[i] ?? 0) + factorIm * (im?.[i] ?? 0);
      return x + (Number.isNaN(by) ? 0 : by);
    });
    for (let t = 0; t < part.indices.length; t += 3) {
      for (const [n, v] of [a, b, c].entries()) v.fromArray(drawn, 3 * part.indices[t + n]!);
      const hit = ray.intersectTriangle(a, b, c, false, at);
      if (hit) best = Math.min(best, ray.origin.distanceTo(hit));
    }
  }
  return best;
}

const field = (part: ScenePart, random: () => number, size: number) =>
  part.positions.map((x, i) => size * Math.sin(3 * x + 7 * ((i * 0.618) % 1) + 2 * random()));

const CASES = [
  { name: "at_rest", factorRe: 0, factorIm: 0 },
  { name: "deformed", factorRe: 0.7, factorIm: 0 },
  { name: "swung_to_the_other_side", factorRe: -1.3, factorIm: 0 },
  { name: "of_a_turning_mode", factorRe: 0.5, factorIm: -0.8 },
];

for (const { name, factorRe, factorIm } of CASES) {
  test(`rays_meet_the_skin_${name}_where_all_triangles_say`, async () => {
    const random = randoms(7);
    const parts = [sheet(24, 0), sheet(17, 1)];
    const picker = new Picker(parts);
    await picker.build();
    const re = parts.map((part) => field(part, random, 0.3));
    const im = parts.map((part) => field(part, random, 0.2));
    picker.setShape(re, factorRe, im, factorIm);
    const shapes = parts.map((_, k) => ({ re: re[k]!, im: im[k]!, factorRe, factorIm }));
    let hits = 0;
    for (let n = 0; n < 300; ++n) {
      const origin = new Vector3(2.5 * random(), 2.5 * random(), 2 + random());
      const direction = new Vector3(random(), random(), random()).sub(origin).normalize();
      const ray = new Ray(origin, direction);
      const wanted = nearestOfAll(parts, shapes, ray);
      const hit = picker.ray(ray, new Matrix4());
      if (Number.isFinite(wanted)) {
        hits += 1;
        expect(hit?.distance).toBeCloseTo(wanted, 5);
        expect(picker.worldOf(hit!, new Matrix4()).distanceTo(hit!.world)).toBeLessThan(1e-5);
      } else expect(hit).toBeNull();
    }
    expect(hits).toBeGreaterThan(100);
  });
}

/** Distance from a point to the nearest of all triangles, as they are drawn. */
function awayFromAll(parts: readonly ScenePart[], shapes: readonly Shape[], point: Vector3): number {
  let best = Number.POSITIVE_INFINITY;
  const [triangle, at] = [new Triangle(), new Vector3()];
  for (const [k, part] of parts.entries()) {
    const { re, im, factorRe, factorIm } = shapes[k]!;
    const drawn = part.positions.map((x, i) => x + factorRe * (re?.[i] ?? 0) + factorIm * (im?.[i] ?? 0));
    for (let t = 0; t < part.indices.length; t += 3) {
      const corner = (n: number) => new Vector3().fromArray(drawn, 3 * part.indices[t + n]!);
      triangle.set(corner(0), corner(1), corner(2)).closestPointToPoint(point, at);
      best = Math.min(best, at.distanceTo(point));
    }
  }
  return best;
}

for (const { name, factorRe, factorIm } of CASES) {
  test(`nearest_place_of_the_skin_${name}_is_where_all_triangles_say`, async () => {
    const random = randoms(3);
    const parts = [sheet(12, 0), sheet(9, 1)];
    const picker = new Picker(parts);
    await picker.build();
    const re = parts.map((part) => field(part, random, 0.3));
    const im = parts.map((part) => field(part, random, 0.2));
    picker.setShape(re, factorRe, im, factorIm);
    const shapes = parts.map((_, k) => ({ re: re[k]!, im: im[k]!, factorRe, factorIm }));
    let found = 0;
    for (let n = 0; n < 120; ++n) {
      const point = new Vector3(1.5 * random(), 1.5 * random(), random());
      const wanted = awayFromAll(parts, shapes, point);
      const hit = picker.near(point, 0.2, new Matrix4());
      if (wanted > 0.2) {
        expect(hit).toBeNull();
        continue;
      }
      found += 1;
      expect(hit?.distance).toBeCloseTo(wanted, 5);
      // Weights on the slivers of a crumpled sheet keep fewer digits than the place itself.
      expect(picker.worldOf(hit!, new Matrix4()).distanceTo(hit!.world)).toBeLessThan(1e-4);
    }
    expect(found).toBeGreaterThan(15);
    expect(found).toBeLessThan(120);
  });
}

test("ray_still_meets_the_skin_when_the_step_brings_other_displacements", async () => {
  const part = sheet(10, 0);
  const picker = new Picker([part]);
  await picker.build();
  const down = new Ray(new Vector3(0.31, 0.27, 50), new Vector3(0, 0, -1));
  for (const lift of [0, 3, -20]) {
    const moved = part.positions.map((_, i) => (i % 3 === 2 ? lift : 0));
    picker.setShape([moved], 1);
    const flat = nearestOfAll([part], [{ re: null, im: null, factorRe: 0, factorIm: 0 }], down);
    expect(picker.ray(down, new Matrix4())?.distance).toBeCloseTo(flat - lift, 4);
  }
});

test("vertex_without_displacement_stays_and_is_met_where_it_is", async () => {
  const part = sheet(10, 0);
  const picker = new Picker([part]);
  await picker.build();
  picker.setShape([new Float32Array(part.positions.length).fill(Number.NaN)], 5);
  const down = new Ray(new Vector3(0.31, 0.27, 50), new Vector3(0, 0, -1));
  const still = nearestOfAll([part], [{ re: null, im: null, factorRe: 0, factorIm: 0 }], down);
  expect(picker.ray(down, new Matrix4())?.distance).toBeCloseTo(still, 4);
});
