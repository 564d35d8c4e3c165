// SPDX-License-Identifier: Apache-2.0
// A scene that is still being made: its shape stands first, is never taken for the result, and nothing of what the person
// did is lost when results come.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { previewOf } from "../support/preview-scene.ts";
import { tinyScene } from "../support/tiny-scene.ts";
import { faults } from "./access.mjs";
import { tell } from "./binary.mjs";
import { startOf } from "./budget.mjs";
import { openPage, pixelsOf, until } from "./harness.mjs";
import { goTo } from "./keep.mjs";
import { BOILER, BOILER_OPTIONS, view, whyNot } from "./program.mjs";
import { serve } from "./server.mjs";
import { aim, enter, frames } from "./vr-hands.mjs";
import { watchPage } from "./watch-page.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const HINT = '<meta name="feelem-opening" content="opening" />';

/** A server as `feelem view` is one while it still makes its scene; `say` is its news. */
export async function growing(options = {}) {
  const { glb } = tinyScene({ bars: 2, ...options });
  let news = { state: "reading", version: 1, stage: "results", percent: 10, text: "" };
  const waiting = new Set();
  const asked = [];
  const opening = async (request, response) => {
    const after = Number(new URL(request.url, "http://x").searchParams.get("after"));
    asked.push(after);
    if (after === news.version && news.state === "reading") await new Promise((done) => waiting.add(done));
    response.writeHead(200, { "Content-Type": "application/json" });
    response.end(JSON.stringify(news));
  };
  const index = readFileSync(new URL("../../dist/index.html", import.meta.url), "utf8");
  const files = new Map([
    ["index.html", Buffer.from(index.replace("</title>", `</title>${HINT}`))],
    ["opening", opening],
    ["shape.glb", new Uint8Array(options.shape ?? previewOf(glb))],
    ["scene.glb", new Uint8Array(glb)],
  ]);
  const server = await serve(files);
  const say = (change) => {
    news = { ...news, ...change, version: news.version + 1 };
    for (const done of waiting) done();
    waiting.clear();
  };
  return { ...server, say, asked, files };
}

const isShape = () => typeof window.feelem.scene()?.certificate?.notes?.preview === "string";
const words = (page, selector) => page.locator(selector).innerText();

/** The page with the shape, ready to be used. */
async function openShape(browser, server, options = {}) {
  const opened = await openPage(browser, server.url, { early: true, ...options });
  await until(opened.page, isShape, Boolean, "the shape");
  await opened.page.locator(".reading").waitFor();
  await until(opened.page, () => document.querySelector(".topbar .vr")?.title ?? "", Boolean, "the start");
  return opened;
}

async function middle(page) {
  const box = await page.locator(".area-stage canvas").boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Colours over the middle of the stage. */
async function colours(page) {
  const { x, y } = await middle(page);
  const points = Array.from({ length: 121 }, (_, i) => [
    x - 100 + 20 * (i % 11),
    y - 100 + 20 * Math.floor(i / 11),
  ]);
  return pixelsOf(page, await page.screenshot(), points);
}
const spread = ([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b);

export const openingTests = [
  {
    name: "opening_shape_is_drawn_and_says_everywhere_that_results_are_still_read",
    async run({ browser }) {
      const server = await growing();
      const { page, context, problems } = await openShape(browser, server, { before: watchPage });
      server.say({ percent: 42 });
      await until(page, state, (s) => s.reading?.percent === 42 && s.reading.failed === null, "the state");
      await until(
        page,
        () => document.querySelector(".reading")?.textContent,
        (t) => /42 %/.test(t),
        "the progress",
      );
      const drawn = () => globalThis.watched.calls;
      await page.waitForTimeout(400);
      const calls = await page.evaluate(drawn);
      for (const percent of [50, 60, 70]) server.say({ percent });
      await until(page, state, (s) => s.reading?.percent === 70, "more news");
      await page.waitForTimeout(300);
      assert.equal(await page.evaluate(drawn), calls, "news alone draw no picture");
      for (const area of [".reading", ".legend", "section.results"])
        assert.match(await words(page, area), /results are still being read/i, area);
      assert.ok(
        !/no result|holds no results/i.test(await words(page, "#app")),
        "nothing says that there are none",
      );
      const { x, y } = await middle(page);
      await page.mouse.move(x, y);
      const report = await until(page, probe, Boolean, "the place");
      assert.deepEqual([report.results, report.nodeId > 0], [[], true]);
      await until(
        page,
        () => document.querySelector(".card")?.innerText ?? "",
        (t) => /No values\. Results are still/.test(t),
        "the card",
      );
      await page.mouse.move(3, 3);
      const seen = await colours(page);
      assert.ok(
        seen.every((c) => spread(c) < 30),
        "no colour that could be a value",
      );
      assert.ok(new Set(seen.map(String)).size > 1, "a shape before its background");
      await page.keyboard.press("4");
      assert.match(await words(page, ".toast"), /still being read/, "what needs results says so");
      assert.deepEqual(await faults(page), []);
      assert.equal(await page.evaluate(() => Promise.race([window.feelem.ready, "not yet"])), "not yet");
      assert.equal(await page.locator("table.assign").count(), 0);
      assert.deepEqual(problems, []);
      await context.close();
      await server.close();
    },
  },
  {
    name: "opening_results_come_in_place_with_camera_parts_and_notes_kept",
    async run({ browser }) {
      const server = await growing();
      const { page, context, problems } = await openShape(browser, server);
      const { x, y } = await middle(page);
      await page.mouse.move(x, y + 220);
      await page.mouse.down();
      await page.mouse.move(x + 90, y + 180, { steps: 5 });
      await page.mouse.up();
      await page.mouse.wheel(0, -300);
      const id = await page.evaluate(() => window.feelem.scene().parts.length && 1001);
      await goTo(page, id);
      for (const key of ["p", "e", "c"]) await page.keyboard.press(key);
      const size = () => {
        const { width, height } = document.querySelector(".area-stage canvas");
        return [width, height];
      };
      const drawnOn = await page.evaluate(size);
      const pick = ({ camera, pins, cuts, hidden }) => ({ camera, pins, cuts, hidden });
      const before = await page.evaluate(state);
      assert.ok(before.pins.length === 1 && before.cuts.length === 1, JSON.stringify(pick(before)));
      await page.evaluate(() => {
        globalThis.canvasBefore = document.querySelector(".area-stage canvas");
      });
      server.say({ state: "ready", percent: 100 });
      await page.evaluate(() => window.feelem.ready);
      const after = await page.evaluate(state);
      assert.deepEqual(pick(after), pick(before));
      assert.deepEqual(await page.evaluate(size), drawnOn, "the picture stays where it is");
      assert.ok(
        await page.evaluate(() => globalThis.canvasBefore === document.querySelector(".area-stage canvas")),
      );
      assert.equal(await page.locator(".reading").count(), 0);
      assert.ok((await page.evaluate(() => window.feelem.scene())).results.length > 0);
      assert.ok(!/still being read/i.test(await words(page, "#app")));
      await page.keyboard.press("Control+z");
      assert.equal((await page.evaluate(state)).cuts.length, 0, "what the person did can be undone");
      assert.deepEqual(
        (await page.evaluate(state)).presentation,
        after.presentation,
        "the scene's own cannot",
      );
      // The same as who opens the scene when it is finished.
      const hash = await until(
        page,
        () => location.hash,
        (h) => h.startsWith("#view="),
        "the address",
      );
      await page.waitForTimeout(900);
      server.files.set("index.html", readFileSync(new URL("../../dist/index.html", import.meta.url)));
      const link = await page.evaluate(() => location.hash);
      assert.ok(hash.length > 0);
      const other = await context.newPage();
      await other.goto(`${server.url}?antialias=0&governor=0${link}`);
      await other.evaluate(() => window.feelem.ready);
      await until(other, probe, (r) => r?.nodeId === id, "the node of the link");
      await until(page, probe, (r) => r?.nodeId === id && r.results.length > 0, "the values");
      const [a, b] = [await page.evaluate(probe), await other.evaluate(probe)];
      assert.deepEqual(a.results, b.results);
      for (const p of [page, other]) {
        await p.mouse.move(3, 3);
        await p.waitForTimeout(300);
      }
      const [mine, theirs] = [await colours(page), await colours(other)];
      assert.ok(
        mine.some((c) => spread(c) > 60),
        "coloured",
      );
      assert.deepEqual(mine, theirs);
      assert.deepEqual(problems, []);
      await context.close();
      await server.close();
    },
  },
  {
    name: "opening_link_to_a_view_is_kept_until_its_results_are_there",
    async run({ browser }) {
      const server = await growing();
      const { page, context } = await openPage(browser, `${server.url.replace(/\/$/, "")}/`, { early: true });
      server.say({ state: "ready" });
      await page.evaluate(() => window.feelem.ready);
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      await page.keyboard.press(".");
      await page.waitForTimeout(900);
      const wanted = await page.evaluate(state);
      const link = await page.evaluate(() => location.hash);
      assert.equal(wanted.step, 2);
      await context.close();
      await server.close();

      const again = await growing();
      const opened = await openPage(browser, `${again.url}${link}`, { early: true });
      await until(opened.page, isShape, Boolean, "the shape");
      await opened.page.waitForTimeout(900);
      assert.equal(await opened.page.evaluate(() => location.hash), link, "the address waits");
      again.say({ state: "ready" });
      await opened.page.evaluate(() => window.feelem.ready);
      const seen = await opened.page.evaluate(state);
      assert.deepEqual([seen.step, seen.presentation], [2, wanted.presentation]);
      assert.deepEqual(opened.problems, []);
      await opened.context.close();
      await again.close();
    },
  },
  {
    name: "opening_that_fails_says_why_and_never_looks_finished",
    async run({ browser }) {
      const server = await growing();
      const { page, context } = await openShape(browser, server);
      server.say({ state: "failed", text: "boiler.frd:1234: the block ends too early" });
      await assert.rejects(
        page.evaluate(() => window.feelem.ready),
        /ends too early/,
      );
      const banner = page.locator(".reading-failed");
      await banner.waitFor();
      assert.match(
        await banner.innerText(),
        /Only the shape is shown.*boiler\.frd:1234: the block ends too early/s,
      );
      assert.equal(await banner.locator("button").count(), 0, "it stays");
      for (const area of [".legend", "section.results"])
        assert.match(await words(page, area), /could not be read/, area);
      assert.equal(await page.locator(".reading").count(), 0);
      await context.close();
      await server.close();
    },
  },
  {
    name: "opening_whose_server_goes_says_that_it_was_ended",
    async run({ browser }) {
      const server = await growing();
      const { page, context } = await openShape(browser, server);
      await server.close();
      await page.locator(".reading-failed").waitFor();
      assert.match(await words(page, ".reading-failed"), /was ended/);
      await context.close();
    },
  },
  {
    name: "opening_of_another_shape_than_announced_shows_the_scene_itself",
    async run({ browser }) {
      const { glb } = tinyScene({ cells: [6, 2, 2] });
      const server = await growing({ shape: previewOf(glb) });
      const { page, context, problems } = await openShape(browser, server);
      server.say({ state: "ready" });
      await page.evaluate(() => window.feelem.ready);
      assert.ok((await page.evaluate(() => window.feelem.scene())).results.length > 0);
      await goTo(page, 1001);
      await until(page, probe, (r) => r?.nodeId === 1001 && r.results.length > 0, "values");
      assert.deepEqual(problems, []);
      await context.close();
      await server.close();
    },
  },
  {
    name: "opening_in_the_headset_goes_on_when_results_come",
    async run({ browser }) {
      const server = await growing({ bars: 1 });
      const { page, context, problems } = await enter(browser, server.url, { early: true });
      const { headset } = await page.evaluate(state);
      assert.ok(isShapeReport(headset), JSON.stringify(headset).slice(0, 400));
      await page.evaluate(() => {
        window.ended = 0;
        window.xrSession.addEventListener("end", () => {
          window.ended += 1;
        });
      });
      await aim(page, "right", [0, 1.2, -0.2], [0, 1, -1.2]);
      await until(page, probe, (r) => r?.pointer === "right-controller", "the ray on the shape");
      assert.deepEqual((await page.evaluate(probe)).results, []);
      server.say({ state: "ready" });
      await page.evaluate(() => window.feelem.ready);
      await frames(page, 4);
      const report = await until(page, probe, (r) => r?.results.length > 0, "values under the same ray");
      assert.equal(report.pointer, "right-controller");
      const after = await page.evaluate(state);
      assert.deepEqual([after.session, await page.evaluate(() => window.ended)], ["immersive-vr", 0]);
      assert.ok(
        after.headset.panel.buttons.some(({ id }) => /:colour$/.test(id)),
        "the table has results",
      );
      assert.deepEqual(problems, []);
      await context.close();
      await server.close();
    },
  },
  {
    name: "opening_values_that_are_on_their_way_are_not_taken_for_missing",
    async run({ browser }) {
      const { glb } = tinyScene({ bars: 2 });
      for (const first of ["p0/_TEMPERATURE/1", "p0/_STRESS_VON_MISES/1"]) {
        const server = await growing();
        let letGo = () => {};
        const free = new Promise((resolve) => {
          letGo = resolve;
        });
        server.files.set("scene.glb", { whole: new Uint8Array(glb), hold: startOf(glb, first), free });
        const { page, context, problems } = await openShape(browser, server);
        await goTo(page, 1001);
        server.say({ state: "ready", percent: 100 });
        await until(
          page,
          () => window.feelem.scene().results.length,
          (n) => n > 0,
          "the scene's head",
        );
        await page.waitForTimeout(600);
        const { x, y } = await middle(page);
        await page.mouse.move(x + 1, y);
        const report = await until(page, probe, Boolean, "the place");
        const seen = await words(page, "#app");
        assert.deepEqual(report.results, [], `nothing is read of what has not come, ${first}`);
        for (const area of [".legend", ".card:not(.inside)"])
          assert.match(await words(page, area), /still being read/, area);
        assert.ok(!/no results?\b|not in this scene/i.test(seen), seen);
        letGo();
        await page.evaluate(() => window.feelem.ready);
        await until(page, probe, (r) => r?.results.length > 0 && r.results[0].value !== null, "the values");
        await until(
          page,
          () => document.querySelector("#app").innerText,
          (text) => !/still being read/i.test(text),
          "the last word of reading",
        );
        assert.deepEqual(problems, []);
        await context.close();
        await server.close();
      }
    },
  },
  {
    name: "opening_that_ends_badly_says_nothing_over_another_scene",
    async run({ browser }) {
      const server = await growing();
      const { page, context } = await openShape(browser, server);
      const { glb } = tinyScene();
      await page.evaluate(
        (bytes) => {
          const data = new DataTransfer();
          data.items.add(new File([new Uint8Array(bytes)], "other.glb"));
          window.dispatchEvent(new DragEvent("drop", { dataTransfer: data }));
        },
        [...new Uint8Array(glb)],
      );
      await until(page, isShape, (is) => is === false, "the other scene");
      await page.locator("table.assign").waitFor();
      await server.close();
      await page.waitForTimeout(3000);
      assert.equal(await page.locator(".banner").count(), 0);
      assert.ok(!/was ended/.test(await words(page, "#app")), "it is not about this scene");
      await context.close();
    },
  },
  {
    name: "opening_of_a_kept_shape_does_not_wait_for_results",
    async run({ browser }) {
      const server = await growing();
      server.files.set("kept.glb", server.files.get("shape.glb"));
      const { page, context } = await openPage(browser, server.url, { query: "scene=kept.glb" });
      assert.match(await words(page, ".reading-failed"), /made before they were/);
      assert.ok(!/still being read/.test(await words(page, "#app")));
      await context.close();
      await server.close();
    },
  },
  {
    name: "opening_of_a_model_by_the_program_ends_in_the_scene_that_convert_makes",
    skip: whyNot,
    async run({ browser }) {
      const folder = mkdtempSync(join(tmpdir(), "feelem-e2e-"));
      const made = join(folder, "boiler.glb");
      tell("convert", `${BOILER}/boiler.frd`, "-o", made, ...BOILER_OPTIONS);
      const wanted = readFileSync(made);
      const { url, end } = await view(folder, `${BOILER}/boiler.frd`, ...BOILER_OPTIONS);
      try {
        const served = Buffer.from(await (await fetch(`${url}scene.glb`)).arrayBuffer());
        assert.ok(served.equals(wanted), "the same bytes");
        const { page, context, problems } = await openPage(browser, url);
        assert.ok((await page.evaluate(() => window.feelem.scene())).results.length > 0);
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        end();
      }
    },
  },
];

/** The table has no rows to press yet. */
function isShapeReport(headset) {
  return headset.panel.buttons.every(({ id }) => !/:colour$/.test(id));
}
