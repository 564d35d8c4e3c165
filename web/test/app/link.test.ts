// SPDX-License-Identifier: Apache-2.0
// A view goes into an address and comes back the same; what is wrong in an address is left out or refused.
import { expect, test } from "vitest";
import { decodeView, encodeView, snapshotOf } from "../../src/app/link";
import { TINY_PRESENTATION } from "../support/tiny-scene";

const view = {
  doc: TINY_PRESENTATION,
  step: 2,
  deformMode: "factor",
  typedFactor: 12.5,
  edges: false,
  hidden: [3],
  clear: [1, 2],
  hot: { count: 7, share: 0.1, by: "utilisation", end: "smallest", marks: false },
  cuts: [{ normal: [0, 0.6, 0.8], offset: -3.25, on: true }],
  pins: [{ id: 1, node: 20_000_001, note: "Schweißnaht σ > 1" }],
  ruler: [5, 6],
  camera: [0.1, 0.2, 0.3, 1, -0.4, 2.5],
  node: 77,
};

test("a_view_comes_back_as_it_went_in_by_letters_that_addresses_allow", async () => {
  const text = await encodeView(view);

  expect(text).toMatch(/^[A-Za-z0-9_-]+$/);
  expect(text.length).toBeLessThan(1500);
  expect(await decodeView(text)).toEqual(view);
  const { camera, node, ...state } = view;
  expect(snapshotOf(view)).toEqual({ state, camera, node });
});

test("wrong_keys_are_left_out_and_numbers_stay_within_bounds", () => {
  const { state, camera, node } = snapshotOf({
    step: -1,
    deformMode: "sideways",
    typedFactor: "7",
    hidden: [1, "2", Number.NaN, 4],
    hot: { count: 1e9, share: 7 },
    cuts: [{ normal: [9, 0, 0], offset: 1 }, { normal: [1, 0, 0], offset: 1 }, 5, ...Array(9).fill(null)],
    pins: [{ id: 1, node: 2, note: "x".repeat(9999) }, { id: "1" }],
    camera: [1, 2, 3, 4, 5, -1],
    node: 1.5,
    session: "immersive-vr",
    problem: "hostile",
  });

  expect(state).toEqual({
    hidden: [1, 4],
    hot: { count: 50, share: 1, by: "value", end: "largest", marks: true },
    cuts: [{ normal: [1, 0, 0], offset: 1, on: true }],
    pins: [{ id: 1, node: 2, note: "x".repeat(500) }],
  });
  expect([camera, node]).toEqual([null, null]);
});

test("a_wrong_presentation_is_refused_with_the_place_of_the_fault", () => {
  const doc = { ...TINY_PRESENTATION, effects: [{ type: "colour", result: "X" }] };

  expect(() => snapshotOf({ doc })).toThrow("effects[0].result");
});

test("garbage_and_bombs_are_refused", async () => {
  await expect(decodeView("!!")).rejects.toThrow();
  await expect(decodeView("AAAA")).rejects.toThrow();
  const bomb = await encodeView({ zeros: "0".repeat(900_000) });
  expect((await decodeView(bomb)) as object).toHaveProperty("zeros");
  const large = await encodeView({ zeros: "0".repeat(1_100_000) });
  await expect(decodeView(large)).rejects.toThrow("more than a view");
});
