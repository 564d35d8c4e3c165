// SPDX-License-Identifier: Apache-2.0
// What a person chose is kept within its bounds, whatever the storage says.
import { expect, test } from "vitest";
import { DEFAULT_PERSON, personOf } from "../../src/app/person";

test("right_choices_are_taken_and_wrong_ones_fall_back", () => {
  const chosen = {
    master: 0.2,
    mono: true,
    captions: false,
    strength: 1.5,
    leftHanded: true,
    wide: true,
    weakest: 0.2,
    vignette: 0.5,
    upright: false,
    byTouch: true,
    walkKeys: true,
  };

  expect(personOf(chosen)).toEqual(chosen);
  expect(personOf({ master: 7, mono: "yes", strength: -1, weakest: 0.9, vignette: 2, other: 1 })).toEqual(
    DEFAULT_PERSON,
  );
  expect(personOf(null)).toEqual(DEFAULT_PERSON);
  expect(personOf({ master: "loud" }, chosen)).toEqual(chosen);
});
