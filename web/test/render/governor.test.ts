// SPDX-License-Identifier: Apache-2.0
// The governor: coarser when frames are slow, finer when they are quick, never to and fro, and fine at rest.
import { expect, test } from "vitest";
import {
  AT_FIRST,
  type Governor,
  govern,
  HEADSET_TRIANGLES,
  LEVELS,
  levelWithin,
  type Pace,
  ROUND,
} from "../../src/render/governor";
import { Quality } from "../../src/render/quality";

const pace: Pace = { budget: 33, interval: 16.7 };

/** Frames whose time depends on the level that is drawn. */
function run(from: Governor, frames: number, cost: (level: number) => number, at = pace) {
  let governor = from;
  const levels: number[] = [];
  for (let i = 0; i < frames; ++i) {
    governor = govern(governor, cost(governor.level), at);
    levels.push(governor.level);
  }
  return { governor, levels };
}

/** All time goes into pixels, as fast as the display shows at most. */
const pixelBound = (full: number) => (level: number) =>
  Math.max(16.7, full * (LEVELS[level]?.resolution ?? 1) ** 2);

test("quick_frames_leave_the_picture_at_its_finest", () => {
  const { levels } = run(AT_FIRST, 100, () => 16.7);
  expect(new Set(levels)).toEqual(new Set([0]));
});

test("slow_frames_make_the_picture_coarser_until_they_are_in_time", () => {
  const cost = pixelBound(80);
  const { governor } = run(AT_FIRST, 60, cost);
  expect(governor.level).toBeGreaterThan(0);
  expect(cost(governor.level)).toBeLessThanOrEqual(1.25 * pace.budget);
  expect(cost(governor.level - 1)).toBeGreaterThan(pace.budget);
});

test("frames_that_are_far_too_slow_skip_a_level", () => {
  const { levels } = run(AT_FIRST, ROUND, () => 500);
  expect(levels.at(-1)).toBe(2);
});

test("one_slow_frame_changes_nothing", () => {
  let governor = AT_FIRST;
  for (let i = 0; i < 60; ++i) governor = govern(governor, i % ROUND === 3 ? 400 : 17, pace);
  expect(governor.level).toBe(0);
});

test("picture_gets_fine_again_when_frames_get_quick", () => {
  const slow = run(AT_FIRST, 60, () => 200).governor;
  expect(slow.level).toBe(LEVELS.length - 1);
  expect(run(slow, 200, () => 16.7).governor.level).toBe(0);
});

test("picture_does_not_go_to_and_fro_where_one_level_is_too_slow_and_the_next_is_quick", () => {
  // Costs nothing by pixels: each finer level is tried in vain.
  const cost = (level: number) => (level >= 2 ? 16.7 : 60);
  const { levels } = run(AT_FIRST, 3000, cost);
  const late = levels.slice(1000);
  const changes = late.filter((level, i) => i > 0 && level !== late[i - 1]).length;
  expect(late.filter((level) => level === 2).length).toBeGreaterThan(0.9 * late.length);
  expect(changes).toBeLessThan(50);
});

test("picture_stays_where_it_is_between_the_bounds", () => {
  const { governor } = run(AT_FIRST, 30, pixelBound(80));
  const { levels } = run(governor, 500, () => 30);
  expect(new Set(levels)).toEqual(new Set([governor.level]));
});

test("headset_that_shows_every_frame_is_left_at_its_finest_and_comes_back_to_it", () => {
  const headset: Pace = { budget: 13.9, interval: 13.9 };
  expect(run(AT_FIRST, 100, () => 13.9, headset).governor.level).toBe(0);
  const slow = run(AT_FIRST, 40, () => 27.8, headset).governor;
  expect(slow.level).toBeGreaterThan(0);
  expect(run(slow, 200, () => 13.9, headset).governor.level).toBe(0);
});

test("page_that_was_asleep_is_not_taken_for_a_slow_one", () => {
  const { governor } = run(AT_FIRST, 20, () => 60_000);
  expect(governor).toEqual(AT_FIRST);
});

test("single_changes_are_drawn_at_the_finest_motion_is_coarse_and_rest_is_fine_again", () => {
  const quality = new Quality(true);
  let now = 0;
  for (let i = 0; i < 40; ++i) {
    now += 0.2;
    quality.next(now, true);
  }
  expect(quality.report()).toMatchObject({ moving: true, edges: false });
  expect(quality.drawn.resolution).toBeLessThan(1);
  expect(quality.next(now + 0.1, false)).toBe(false);
  expect(quality.next(now + 0.3, false)).toBe(true);
  expect(quality.drawn.resolution).toBe(1);
  expect(quality.next(now + 0.4, false)).toBe(false);
  // Long after: the level is remembered, a single change does not need it.
  quality.next(now + 5, true);
  expect(quality.drawn.resolution).toBe(1);
  quality.next(now + 5.2, true);
  expect(quality.drawn.resolution).toBeLessThan(1);
});

test("page_that_is_not_governed_is_always_at_its_finest", () => {
  const quality = new Quality(false);
  for (let i = 0; i < 50; ++i) quality.next(i, true);
  expect(quality.drawn.resolution).toBe(1);
});

test("the_finest_level_within_the_budget_is_drawn_and_the_coarsest_where_none_fits", () => {
  const levels = [500_000, 125_000];
  expect(levelWithin(Number.POSITIVE_INFINITY, 2_000_000, levels)).toBe(0);
  expect(levelWithin(HEADSET_TRIANGLES, 2_000_000, levels)).toBe(1);
  expect(levelWithin(HEADSET_TRIANGLES, 400_000, levels)).toBe(0);
  expect(levelWithin(130_000, 2_000_000, levels)).toBe(2);
  expect(levelWithin(1000, 2_000_000, levels)).toBe(2);
  expect(levelWithin(1000, 2_000_000, [])).toBe(0);
});

test("no_coarser_level_draws_more_triangles", () => {
  for (const [i, { triangles }] of LEVELS.entries())
    expect(triangles).toBeLessThanOrEqual(LEVELS[i - 1]?.triangles ?? Number.POSITIVE_INFINITY);
});
