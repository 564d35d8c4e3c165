// SPDX-License-Identifier: Apache-2.0
// The palette finds a function by any of its words, the best first.
import { expect, test } from "vitest";
import { found, matching } from "../../src/ui/palette";

const entries = [
  "hide the part pointed at",
  "show all parts",
  "Temperature: seen as colour",
  "colour map: turbo",
].map((text) => ({ text, shown: "", run: () => undefined }));
const texts = (typed: string) => found(entries, typed).map((e) => e.text);

test("every_typed_word_must_be_there_and_beginnings_count", () => {
  expect(texts("part")).toEqual(["hide the part pointed at", "show all parts"]);
  expect(texts("colour temp")).toEqual(["Temperature: seen as colour"]);
  expect(texts("colour map")).toEqual(["colour map: turbo"]);
  expect(texts("nothing like it")).toEqual([]);
  expect(texts("")).toHaveLength(4);
});

test("whole_words_are_worth_more_than_beginnings_and_those_more_than_middles", () => {
  expect(matching("part", "part")).toBeGreaterThan(matching("parts", "part"));
  expect(matching("parts", "part")).toBeGreaterThan(matching("apart", "part"));
});
