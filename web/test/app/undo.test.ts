// SPDX-License-Identifier: Apache-2.0
// Undo takes back what a person changed, one change at a time; a slider's many are one.
import { expect, test } from "vitest";
import { firstState } from "../../src/app/first-state";
import { Store } from "../../src/app/store";
import { Undo } from "../../src/app/undo";
import { openScene } from "../../src/scene";
import { tinyScene } from "../support/tiny-scene";

const scene = await openScene(tinyScene().glb, () => Promise.reject(new Error("none")));

function made() {
  const store = new Store(firstState(scene));
  const clock = { now: 0 };
  const undo = new Undo(store, () => clock.now);
  const at = (seconds: number, change: Parameters<Store["set"]>[0]) => {
    clock.now = 1000 * seconds;
    store.set(change);
  };
  return { store, undo, at };
}

test("changes_are_taken_back_in_turn_and_made_again", () => {
  const { store, undo, at } = made();
  at(1, { hidden: [1] });
  at(5, { ghost: true });

  expect(undo.undo()).toBe(true);
  expect([store.state.ghost, store.state.hidden]).toEqual([false, [1]]);
  expect(undo.undo()).toBe(true);
  expect(store.state.hidden).toEqual([]);
  expect(undo.undo()).toBe(false);
  expect([undo.redo(), undo.redo(), undo.redo()]).toEqual([true, true, false]);
  expect([store.state.ghost, store.state.hidden]).toEqual([true, [1]]);
});

test("quick_changes_of_one_thing_are_one_and_of_two_things_are_two", () => {
  const { store, undo, at } = made();
  const cut = (offset: number) => ({ cuts: [{ normal: [1, 0, 0] as const, offset, on: true }] });
  at(1, cut(1));
  at(1.1, cut(2));
  at(1.2, cut(3));
  at(1.3, { edges: false });

  undo.undo();
  expect(store.state.cuts[0]?.offset).toBe(3);
  undo.undo();
  expect(store.state.cuts).toEqual([]);
});

test("steps_sections_and_messages_are_nothing_to_undo_and_a_new_change_ends_redo", () => {
  const { store, undo, at } = made();
  at(1, { step: 2, open: ["parts"], problem: "x" });
  expect(undo.canUndo).toBe(false);
  at(2, { edges: false });
  undo.undo();
  expect(store.state.step).toBe(2);
  at(9, { ghost: true });

  expect(undo.canRedo).toBe(false);
});

test("what_came_by_itself_is_not_undone_and_stays_through_undo_and_redo", () => {
  const { store, undo, at } = made();
  at(1, { hidden: [1] });
  at(5, { edges: false });
  undo.undo();
  const doc = { ...store.state.doc, title: "results" };
  undo.settle({ doc, step: 2, reading: null });
  expect([store.state.doc, store.state.step, undo.canUndo, undo.canRedo]).toEqual([doc, 2, true, true]);
  expect(undo.redo()).toBe(true);
  expect([store.state.doc, store.state.edges]).toEqual([doc, false]);
  expect([undo.undo(), undo.undo(), undo.undo()]).toEqual([true, true, false]);
  expect([store.state.doc, store.state.hidden]).toEqual([doc, []]);
});
