// SPDX-License-Identifier: Apache-2.0
// The way to the largest value by ear: rank among the values there are, ticks from 1.5 to 12 a second.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { guideRate, rankOf } from "../../src/sense/guidance";

const sorted = Float32Array.from([1, 2, 2, 2, 5, 9, 9]);

test("rank_is_the_share_below_with_half_of_the_equal_and_one_at_the_top", () => {
  expect(rankOf(sorted, 0)).toBe(0);
  expect(rankOf(sorted, 2)).toBeCloseTo(2.5 / 7, 12);
  expect(rankOf(sorted, 7)).toBeCloseTo(5 / 7, 12);
  expect([rankOf(sorted, 9), rankOf(sorted, 10)]).toEqual([1, 1]);
  expect([rankOf(new Float32Array(), 3), rankOf(sorted, Number.NaN)]).toEqual([0, 0]);
});

test("ticks_grow_with_rank_from_slow_to_fast_mostly_near_the_top", () => {
  expect([guideRate(0), guideRate(1), guideRate(-1), guideRate(2)]).toEqual([1.5, 12, 1.5, 12]);
  for (let q = 0.01; q <= 1; q += 0.01) expect(guideRate(q)).toBeGreaterThan(guideRate(q - 0.01));
  expect(guideRate(0.5)).toBeLessThan(2);
  expect(guideRate(0.9)).toBeGreaterThan(6);
});

test("rank_and_rate_are_those_of_the_contract", () => {
  const { guide } = JSON.parse(
    readFileSync(new URL("../../../tests/contract/guide.json", import.meta.url), "utf8"),
  );
  expect(guide.length).toBeGreaterThan(5);
  for (const { sorted: values, value, rank, rate } of guide) {
    expect(rankOf(Float32Array.from(values), value)).toBeCloseTo(rank, 12);
    expect(guideRate(rank)).toBeCloseTo(rate, 9);
  }
});
