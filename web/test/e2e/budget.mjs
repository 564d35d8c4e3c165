// SPDX-License-Identifier: Apache-2.0
// What the page may take: first picture before all data, only what changed goes to the card, few draw calls, and the
// same readings however coarse the picture is. Counts, not times.
import assert from "node:assert/strict";
import { tinyScene } from "../support/tiny-scene.ts";
import { enterHeadset, openPage, pixelOf, until } from "./harness.mjs";
import { middle, unfold, viewFrom } from "./look.mjs";
import { readScene } from "./oracle.mjs";
import { serve } from "./server.mjs";
import { aimAtNode, enter } from "./vr-hands.mjs";
import { watchPage } from "./watch-page.mjs";

const CALLS = 60;
const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const sent = () => globalThis.watched.bufferBytes;

/** Where the bytes of a named accessor start in a .glb. */
export function startOf(bytes, name) {
  const length = new DataView(bytes).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length)));
  const { bufferView } = json.accessors.find((a) => a.name === name);
  return 28 + length + json.bufferViews[bufferView].byteOffset;
}

/** Draw calls of the busiest of the next frames. */
const busiest = (page, frames = 4) =>
  page.evaluate(
    (count) =>
      new Promise((resolve) => {
        let most = 0;
        let left = count;
        const canvas = document.querySelector("canvas");
        const next = () => {
          most = Math.max(most, globalThis.watched.calls);
          globalThis.watched.calls = 0;
          left -= 1;
          if (left < 0) return resolve(most);
          canvas.dispatchEvent(new WheelEvent("wheel", { deltaY: -1, cancelable: true }));
          requestAnimationFrame(next);
        };
        globalThis.watched.calls = 0;
        requestAnimationFrame(next);
      }),
    frames,
  );

/** Frames take as long as globalThis.slowBy says, for the page as for who measures. */
function slowFrames() {
  const own = window.requestAnimationFrame.bind(window);
  globalThis.slowBy = 0;
  window.requestAnimationFrame = (act) =>
    own(() => {
      const end = performance.now() + globalThis.slowBy;
      while (performance.now() < end);
      act(performance.now());
    });
}

/** Each side file that is asked for, with the step that was shown then, in globalThis.asked. */
function noteRequests() {
  globalThis.asked = [];
  const own = window.fetch.bind(window);
  window.fetch = (address, ...rest) => {
    const file = String(address).split("/").at(-1);
    if (file.endsWith(".bin")) globalThis.asked.push([file, window.feelem.state()?.step]);
    return own(address, ...rest);
  };
}

/** The pointer goes to and fro between two places, a move a frame, until the governor's report is as wanted. */
function jiggle(page, places, wanted) {
  return page.evaluate(
    ([points, least]) =>
      new Promise((resolve, reject) => {
        const canvas = document.querySelector(".area-stage canvas");
        const box = canvas.getBoundingClientRect();
        let left = 400;
        const next = () => {
          const [dx, dy] = points[left % points.length];
          const at = { clientX: box.left + dx, clientY: box.top + dy, bubbles: true };
          canvas.dispatchEvent(
            new PointerEvent("pointermove", { ...at, pointerType: "mouse", pointerId: 1 }),
          );
          const { governor } = window.feelem.state();
          left -= 1;
          if (governor.moving && governor.level >= least && (least === 0 || governor.resolution < 1))
            resolve(governor);
          else if (left < 0) reject(new Error(`level ${least} did not come: ${JSON.stringify(governor)}`));
          else requestAnimationFrame(next);
        };
        requestAnimationFrame(next);
      }),
    [places, wanted],
  );
}

export const budgetTests = [
  {
    name: "budget_shape_is_drawn_while_results_are_held_back_and_nothing_can_be_read_before_they_come",
    async run({ browser }) {
      const { glb } = tinyScene();
      let letGo = () => {};
      const free = new Promise((resolve) => {
        letGo = resolve;
      });
      const held = { whole: new Uint8Array(glb), hold: startOf(glb, "p0/edges/POSITION"), free };
      const { url, close } = await serve(new Map([["scene.glb", held]]));
      const { page, context, problems } = await openPage(browser, url, { before: watchPage, early: true });
      const { x, y } = await until(
        page,
        () => globalThis.watched?.largestDraw ?? 0,
        (n) => n > 500,
        "the first picture",
      ).then(() => middle(page));
      await page.waitForTimeout(300);
      const plain = await pixelOf(page, await page.screenshot(), x, y);
      assert.ok(Math.max(...plain) - Math.min(...plain) < 24, `grey, not ${plain}`);
      await page.mouse.move(x, y);
      assert.equal(await page.evaluate(probe), null, "nothing is read of what has not come");
      letGo();
      await page.evaluate(() => window.feelem.ready);
      await page.mouse.move(x + 1, y);
      await until(page, probe, (r) => r?.results[0].value !== null && r?.nodeId > 0, "the values");
      const coloured = await pixelOf(page, await page.screenshot(), x, y);
      assert.ok(Math.max(...coloured) - Math.min(...coloured) > 24, `a colour, not ${coloured}`);
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "budget_scene_that_is_cut_off_on_its_way_is_said",
    async run({ browser }) {
      const { glb } = tinyScene();
      const cut = new Uint8Array(glb).subarray(0, startOf(glb, "p0/_TEMPERATURE/1") + 8);
      const { url, close } = await serve(new Map([["scene.glb", cut]]));
      const { page, context } = await openPage(browser, url);
      const said = () => document.querySelector(".area-stage, body").ownerDocument.body.textContent;
      await until(page, said, (text) => text.includes("cut off"), "the word that the scene is cut off");
      await context.close();
      await close();
    },
  },
  {
    name: "budget_another_step_sends_its_own_fields_to_the_card_and_nothing_else",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ cells: [30, 10, 8], sideFiles: true });
      const scene = readScene(bytes);
      const vertices = scene.parts[0].nodeIds.length;
      const { page, context } = await openPage(browser, url, { before: watchPage });
      await page.waitForTimeout(300);
      await page.evaluate(() => {
        globalThis.watched.bufferBytes = 0;
        globalThis.watched.sizes = [];
      });
      await page.locator(".stepbar").getByLabel("next step").click();
      await until(page, state, (s) => s.step === 2, "the step");
      await until(page, sent, (n) => n >= 20 * vertices, "its fields");
      await page.waitForTimeout(400);
      // A value and its mask, a displacement; the displacement of the edges' own vertices.
      const edges = (await page.evaluate(sent)) - 20 * vertices;
      const drawn = await page.evaluate(() => globalThis.watched.sizes);
      assert.deepEqual(
        drawn.sort((a, b) => a - b),
        [4 * vertices, 4 * vertices, 12 * vertices, edges].sort((a, b) => a - b),
      );
      await page.evaluate(() => {
        globalThis.watched.sizes = [];
      });
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      await until(
        page,
        () => globalThis.watched.sizes.length,
        (n) => n >= 2,
        "the other result",
      );
      await page.waitForTimeout(400);
      assert.deepEqual(await page.evaluate(() => globalThis.watched.sizes), [4 * vertices, 4 * vertices]);
      await context.close();
      await close();
    },
  },
  {
    name: "budget_playing_reads_the_next_step_while_this_one_is_looked_at_and_none_twice",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ sideFiles: true, times: 4 });
      const { page, context, problems } = await openPage(browser, url, { before: noteRequests });
      await page.locator(".step-select").selectOption("3");
      const asked = () => globalThis.asked;
      const has = (list, name) => list.some(([file]) => file === name);
      await until(page, asked, (list) => has(list, "temperature.3.bin"), "the step");
      for (let k = 0; k < 3; ++k) await page.keyboard.press("-");
      assert.ok(!has(await page.evaluate(asked), "temperature.4.bin"), "nothing ahead while nothing plays");
      await page.locator(".stepbar").getByLabel("play").click();
      const list = await until(page, asked, (l) => has(l, "temperature.6.bin"), "two steps");
      // Each was asked for while the one before it was shown; playing itself begins with a step.
      for (const step of [5, 6])
        assert.equal(list.find(([file]) => file === `temperature.${step}.bin`)[1], step - 1);
      assert.equal(new Set(list.map(([file]) => file)).size, list.length, "nothing is asked for twice");
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "budget_two_hundred_parts_with_edges_ghost_clear_parts_and_both_eyes_stay_within_the_calls",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 200, cells: [2, 1, 1] });
      const options = { width: 480, height: 620, headset: true, before: watchPage };
      const { page, context, problems } = await openPage(browser, url, options);
      await page.keyboard.press("u");
      await page.evaluate(() => document.querySelector("canvas").focus());
      const section = await unfold(page, "parts");
      await section.getByLabel("see through bar 2", { exact: true }).click();
      await section.getByLabel("see through bar 150", { exact: true }).click();
      await until(page, state, (s) => s.clear.length === 2 && s.ghost, "clear parts and the ghost");
      const desk = await busiest(page);
      // Faces, clear faces, edges, ghost.
      assert.ok(desk >= 3 && desk <= 8, `${desk} draw calls at the desk`);
      await enterHeadset(page);
      await page.waitForTimeout(1500);
      const eyes = await busiest(page, 6);
      assert.ok(eyes > desk && eyes <= CALLS, `${eyes} draw calls for two eyes`);
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "budget_one_of_two_hundred_parts_is_hidden_for_eye_and_ray_and_no_geometry_is_sent",
    async run({ browser, serveTiny }) {
      // An odd number: one bar lies in the middle.
      const { url, close } = await serveTiny({ bars: 201, cells: [2, 1, 1] });
      const { page, context } = await openPage(browser, url, { before: watchPage });
      for (const key of ["x", "e", "0"]) await page.keyboard.press(key);
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      await page.mouse.move(x, y);
      for (let k = 0; k < 9; ++k) await page.mouse.wheel(0, -240);
      await page.mouse.move(x + 1, y);
      const seen = await until(page, probe, (r) => r !== null, "the bar in the middle");
      const bar = Math.floor(seen.nodeId / 10_000) + 1;
      assert.equal(bar, 101);
      const colour = async () => {
        await page.mouse.move(5, 5);
        await page.waitForTimeout(300);
        return pixelOf(page, await page.screenshot(), x, y);
      };
      const shown = await colour();
      await page.evaluate(() => {
        globalThis.watched.bufferBytes = 0;
      });
      const section = await unfold(page, "parts");
      await section.getByLabel(`show bar ${bar}`, { exact: true }).click();
      await until(page, state, (s) => s.hidden.length === 1, "the part hidden");
      const hidden = await colour();
      assert.notDeepEqual(hidden, shown);
      const corner = await middle(page, -190, -200);
      assert.deepEqual(hidden, await pixelOf(page, await page.screenshot(), corner.x, corner.y));
      await page.mouse.move(x, y);
      await page.waitForTimeout(200);
      assert.equal(await page.evaluate(probe), null);
      await section.getByLabel(`show bar ${bar}`, { exact: true }).click();
      assert.deepEqual(await colour(), shown);
      assert.equal(await page.evaluate(sent), 0);
      await context.close();
      await close();
    },
  },
  {
    name: "budget_pointer_on_a_node_reads_that_node_deformed_and_while_the_mode_swings",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      const atMarker = () =>
        page.evaluate(() => {
          const mark = document.querySelector(".marker-note");
          const canvas = document.querySelector(".area-stage canvas");
          const box = canvas.getBoundingClientRect();
          const [dx, dy] = mark.style.transform.match(/-?[\d.]+/g).map(Number);
          const hidden = mark.classList.contains("hidden-behind");
          const at = { clientX: box.left + dx, clientY: box.top + dy, bubbles: true, pointerId: 1 };
          canvas.dispatchEvent(new PointerEvent("pointermove", { ...at, pointerType: "mouse" }));
          const { nodeId } = window.feelem.lastProbe() ?? {};
          return { nodeId, hidden, dx, dy };
        });
      // In the middle of the upper side.
      const node = 1228;
      await page.fill(".goto input", String(node));
      await page.keyboard.press("Enter");
      await page.locator(".area-stage canvas").focus();
      await page.keyboard.press("p");
      await until(page, state, (s) => s.pins.length === 1, "the note");
      await page.fill("input[aria-label='deformation factor']", "12");
      await page.keyboard.press("Enter");
      await until(page, state, (s) => s.deformationFactor === 12, "the factor");
      await page.waitForTimeout(400);
      const still = await atMarker();
      assert.equal(still.nodeId, node);
      await page.locator(".stepbar").getByLabel("next step").click();
      await until(page, state, (s) => s.step === 2, "the mode");
      await page.locator(".stepbar").getByLabel("play").click();
      const seen = [];
      for (let k = 0; k < 14; ++k) {
        await page.waitForTimeout(90);
        seen.push(await atMarker());
      }
      const places = new Set(seen.map(({ dx, dy }) => `${dx} ${dy}`));
      assert.ok(places.size > 4, "the node moves on the screen");
      for (const { nodeId, hidden } of seen) if (!hidden) assert.equal(nodeId, node);
      assert.ok(seen.filter(({ hidden }) => !hidden).length > 4);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "budget_readings_are_the_same_at_every_level_of_the_governor_and_rest_is_fine",
    async run({ browser, url }) {
      const options = { width: 480, height: 300, before: slowFrames, governed: true };
      const { page, context, problems } = await openPage(browser, url, options);
      const { x, y } = await middle(page);
      const box = await page.locator(".area-stage canvas").boundingBox();
      const places = [
        [x - box.x, y - box.y],
        [x - box.x + 9, y - box.y + 4],
      ];
      const read = async () => {
        await page.mouse.move(x + 9, y + 4);
        await page.mouse.move(x, y);
        const values = await until(page, probe, (r) => r?.pointer === "mouse", "a reading");
        const legend = await page.locator(".area-right").innerText();
        return { values, legend };
      };
      const size = () => document.querySelector(".area-stage canvas").width;
      const rest = () => until(page, state, (s) => !s.governor.moving, "rest");
      const wanted = await read();
      assert.ok(wanted.values.results.every((r) => typeof r.nodeValue === "number"));
      await rest();
      const full = await page.evaluate(size);
      await page.evaluate(() => {
        globalThis.slowBy = 45;
      });
      for (const least of [1, 2, 3, 4]) {
        await jiggle(page, places, least);
        assert.deepEqual(await read(), wanted, `at level ${least} or coarser`);
      }
      const { level, resolution, edges } = await jiggle(page, places, 4);
      assert.deepEqual([level, resolution, edges], [4, 0.33, false]);
      assert.ok((await page.evaluate(size)) < 0.5 * full, "fewer pixels are drawn");
      await rest();
      assert.equal(await page.evaluate(size), full, "fine at rest, although frames are slow");
      assert.deepEqual(await read(), wanted);
      await page.evaluate(() => {
        globalThis.slowBy = 0;
      });
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "budget_headset_gets_a_smaller_picture_when_frames_are_slow_and_the_same_readings",
    async run({ browser, url }) {
      const options = { width: 480, height: 300, before: slowFrames, governed: true };
      const { page, context, problems } = await enter(browser, url, options);
      await page.evaluate(() => {
        globalThis.asked = new Set();
        const { prototype } = globalThis.XRView;
        const request = prototype.requestViewportScale;
        prototype.requestViewportScale = function (scale) {
          globalThis.asked.add(scale);
          return request.call(this, scale);
        };
      });
      const id = await aimAtNode(page, "right", 6, 2, 3);
      const wanted = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
      await page.evaluate(() => {
        globalThis.slowBy = 60;
      });
      const coarse = await until(page, state, (s) => s.governor.level === 4, "the coarsest level");
      assert.ok(Math.abs(coarse.governor.budgetMs - 1000 / 90) < 6, `${coarse.governor.budgetMs} ms`);
      assert.ok((await page.evaluate(() => [...globalThis.asked])).includes(0.33));
      assert.deepEqual(await page.evaluate(probe), wanted);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
