// SPDX-License-Identifier: Apache-2.0
// How much of a limit is used: value over limit, or limit over value when at least so much is wanted.
import { expect, test } from "vitest";
import { isPast, utilisation } from "../../src/app/limits";

const atMost = { limit: 250, limitIsUpper: true };
const atLeast = { limit: 1.5, limitIsUpper: false };

test("use_of_an_upper_limit_is_value_over_limit", () => {
  expect(utilisation(125, atMost)).toBe(0.5);
  expect([isPast(250, atMost), isPast(250.1, atMost)]).toEqual([false, true]);
});

test("use_of_a_lower_limit_is_limit_over_value", () => {
  expect(utilisation(3, atLeast)).toBe(0.5);
  expect(utilisation(1, atLeast)).toBe(1.5);
  expect([isPast(1.5, atLeast), isPast(1.4, atLeast)]).toEqual([false, true]);
});

test("where_a_share_means_nothing_there_is_none", () => {
  expect(utilisation(null, atMost)).toBeNull();
  expect(utilisation(Number.NaN, atMost)).toBeNull();
  expect(utilisation(5, { limit: null, limitIsUpper: true })).toBeNull();
  expect(utilisation(5, { limit: 0, limitIsUpper: true })).toBeNull();
  expect(utilisation(-5, { limit: -10, limitIsUpper: true })).toBeNull();
  expect(utilisation(0, atLeast)).toBeNull();
});
