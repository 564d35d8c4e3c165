// SPDX-License-Identifier: Apache-2.0
// Asking a server how far its scene is.
import { afterEach, expect, test, vi } from "vitest";
import { Opening, stageText } from "../../src/app/opening";

const NEWS = { state: "reading", version: 3, stage: "results", percent: 40, text: "" };
const noPause = () => Promise.resolve();
afterEach(() => vi.unstubAllGlobals());

function answers(...given: (() => Promise<Response>)[]) {
  const asked: string[] = [];
  vi.stubGlobal("fetch", (address: string) => {
    asked.push(address);
    const next = given.shift();
    return next ? next() : Promise.reject(new TypeError("gone"));
  });
  return asked;
}

test("news_since_a_version_are_asked_for", async () => {
  const asked = answers(() => Promise.resolve(Response.json(NEWS)));
  expect(await new Opening("opening", noPause).ask(2)).toEqual(NEWS);
  expect(asked).toEqual(["opening?after=2"]);
});

test("a_stumble_of_the_network_is_no_end", async () => {
  const asked = answers(
    () => Promise.reject(new TypeError("lost")),
    () => Promise.resolve(new Response("", { status: 503 })),
    () => Promise.resolve(Response.json(NEWS)),
  );
  expect(await new Opening("opening", noPause).ask(0)).toEqual(NEWS);
  expect(asked.length).toBe(3);
});

test("a_server_that_does_not_answer_has_ended", async () => {
  answers();
  await expect(new Opening("opening", noPause).ask(0)).rejects.toThrow("was ended");
});

test("stages_are_said_in_words", () => {
  expect(stageText({ stage: "write", percent: 5, failed: null })).toBe("making the scene, 5 %");
  expect(stageText({ stage: "whatever", percent: 0, failed: null })).toBe("reading results, 0 %");
});
