// SPDX-License-Identifier: Apache-2.0
// Listening along a path, through the model and to a beacon; setting up ears and hands. All by what the page reports.
import assert from "node:assert/strict";
import { FIRST_NODE_ID, tinyValues } from "../support/tiny-scene.ts";
import { HEARD, listen, openPage, until } from "./harness.mjs";
import { unfold, viewFrom } from "./look.mjs";
import { resultIdOf, valueAtNode, valueAtPoint } from "./oracle.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const both = () => ({ state: window.feelem.state(), probe: window.feelem.lastProbe() });
/** Of the bar with 12 x 4 x 3 bricks of 10 mm. */
const nodeAt = (i, j, k) => FIRST_NODE_ID + i + 13 * (j + 5 * k);

async function goTo(page, node) {
  await page.fill(".goto input", String(node));
  await page.keyboard.press("Enter");
  await until(page, probe, (r) => r?.nodeId === node, `node ${node}`);
  await page.locator(".area-stage canvas").focus();
}

export const listeningTests = [
  {
    name: "path_is_walked_along_edges_and_every_value_on_it_is_heard",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await openPage(browser, url);
      for (const node of [nodeAt(1, 1, 3), nodeAt(9, 1, 3), nodeAt(9, 3, 3)]) {
        await goTo(page, node);
        await page.keyboard.press("2");
      }
      const { path } = await page.evaluate(state);
      assert.deepEqual(path.nodes, [nodeAt(1, 1, 3), nodeAt(9, 1, 3), nodeAt(9, 3, 3)]);
      assert.ok(Math.abs(path.length - 100) < 1e-3, `${path.length} mm`);
      await page.keyboard.press("3");
      const seen = [];
      let loudest = 0;
      for (;;) {
        const now = await page.evaluate(both);
        if (now.state.path.at === null && seen.length > 0) break;
        if (now.state.path.at !== null) seen.push({ ...now.probe, at: now.state.path.at });
        loudest = Math.max(loudest, (await page.evaluate(listen)).level);
        await page.waitForTimeout(60);
      }
      assert.ok(seen.length >= 6, `${seen.length} places`);
      for (const [n, place] of seen.entries()) {
        if (n > 0) assert.ok(place.at >= seen[n - 1].at);
        const way = 100 * place.at;
        const wanted = way <= 80 ? [10 + way, 10, 30] : [90, way - 70, 30];
        for (const [k, x] of wanted.entries())
          assert.ok(Math.abs(place.point[k] - x) < 0.02, `${place.point}`);
        for (const entry of place.results) {
          const there = valueAtPoint(scene, resultIdOf(scene, entry), 1, place.elementId, place.point);
          const apart = Math.abs(entry.value - there.value);
          assert.ok(apart <= 1e-5 * Math.max(1, Math.abs(there.value)), `${entry.name} at ${place.point}`);
        }
      }
      assert.ok(loudest > 0.002, "the walk is heard");
      await until(page, listen, (h) => h.level < 1e-4, "silence at the end");
      // At its end the marker stays, and the caption says how far it is and what is there.
      const end = await page.evaluate(probe);
      assert.equal(end.nodeId, nodeAt(9, 3, 3));
      const said = await page.locator(".toast").textContent();
      assert.ok(said.startsWith("100 mm: "), said);
      await page.keyboard.press("3");
      await until(page, state, (s) => s.path.at > 0, "another walk");
      await page.evaluate(() => window.dispatchEvent(new Event("blur")));
      await until(page, state, (s) => s.path.at === null, "a walk that ends when the person leaves");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "sweep_goes_through_the_model_with_the_largest_value_of_each_slab",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await openPage(browser, url);
      await page.keyboard.press("4");
      const seen = new Map();
      await until(page, state, (s) => s.sweep.slab !== null, "the first slab");
      for (;;) {
        const { sweep } = await page.evaluate(state);
        if (sweep.slab === null) break;
        const { nodeId } = (await page.evaluate(probe)) ?? {};
        seen.set(sweep.slab, { ...sweep, nodeId });
        await page.waitForTimeout(70);
      }
      assert.ok(seen.size >= 6, `${seen.size} slabs`);
      const id = resultIdOf(scene, { name: "displacement", component: "magnitude" });
      for (const { slab, slabs, max, mean, at } of seen.values()) {
        assert.equal(slabs, 12);
        assert.ok(Math.abs(at - (10 * slab + 5)) < 1e-3);
        const i = slab === 11 ? 12 : slab;
        assert.equal(max, valueAtNode(scene, id, 1, nodeAt(i, 0, 3)));
        const x = 10 * slab + 5;
        if (slab > 0 && slab < 11) {
          const middle = Math.hypot(...tinyValues.displacement(x, 1));
          assert.ok(Math.abs(mean - middle) < 0.02 * 5.76, `mean ${mean}, at the middle ${middle}`);
        }
      }
      await until(page, listen, (h) => h.level < 1e-4, "silence after the sweep");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "beacon_ticks_from_where_the_hot_spot_is_also_behind_the_model",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      // The hottest node is at x = 120, y = 40: from +x it is in sight, from -x behind the bar.
      await viewFrom(page, "+x");
      await page.keyboard.press("6");
      const near = await until(page, state, (s) => s.beacon !== null, "the beacon");
      const hottest = nodeAt(12, 4, 0);
      assert.equal(near.beacon.node, hottest);
      assert.ok(!near.beacon.words.includes("far side"), near.beacon.words);
      const [right, , back] = near.beacon.direction;
      assert.ok(back < 0 && right > 0, `from +x, y goes to the right: ${near.beacon.direction}`);
      await until(page, listen, (h) => h.level > HEARD, "ticks");
      await viewFrom(page, "-x");
      const far = await until(
        page,
        state,
        (s) => s.beacon?.words.includes("far side"),
        "words: behind the model",
      );
      assert.ok(far.beacon.direction[0] < 0, "from -x, y goes to the left");
      // Pointing at the place itself is the fastest.
      await viewFrom(page, "+x");
      await page.keyboard.press("6");
      await until(page, state, (s) => s.beacon === null, "no beacon");
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      const canvas = await page.locator(".area-stage canvas").boundingBox();
      const mark = await page.locator(".marker-max").first().boundingBox();
      await page.keyboard.press("6");
      await page.mouse.move(mark.x + 4, Math.min(mark.y + 12, canvas.y + canvas.height - 2));
      const beside = await until(page, state, (s) => s.beacon !== null, "the beacon again");
      assert.ok(beside.beacon.rate > 6 && beside.beacon.rate <= 12, `${beside.beacon.rate} ticks a second`);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "calibration_finds_who_needs_a_wider_scale_and_keeps_it_on_the_device",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      await goTo(page, nodeAt(6, 2, 3));
      const before = (await page.evaluate(probe)).hz;
      const section = await unfold(page, "calibration");
      const press = (name) => section.getByRole("button", { name, exact: true }).click();
      const at = (step) => until(page, state, (s) => s.calibration?.step === step, `the step ${step}`);
      await press("Begin");
      await at("level");
      await section.getByLabel("volume while setting up").fill("0.7");
      await until(page, state, (s) => s.person.master === 0.7, "the volume");
      await press("Play");
      await until(page, listen, (h) => h.level > 0.001, "the tones");
      await press("Next");
      await at("ears");
      await press("Same in both");
      await until(page, state, (s) => s.person.mono, "the same in both ears");
      await press("Next");
      for (let pair = 0; pair < 3; ++pair) {
        const { calibration } = await until(page, state, (s) => s.calibration?.pair === pair, `pair ${pair}`);
        await press(calibration.higher === "first" ? "The second" : "The first");
      }
      await at("touch");
      const { person } = await page.evaluate(state);
      assert.equal(person.wide, true, "three wrong answers need a wider scale");
      await press("Next");
      await at("colour");
      await section.getByRole("button", { name: "cividis" }).click();
      await at("try");
      const map = (s) => s.presentation.effects.find((e) => e.type === "colour").map;
      assert.equal(map(await page.evaluate(state)), "cividis");
      await press("Done");
      // Four octaves from the same lowest tone: the distance from it is larger by a third.
      const after = await until(page, probe, (r) => r.hz !== before, "a wider scale");
      const semitones = (hz) => 12 * Math.log2(hz / 130.8127826502993);
      assert.ok(Math.abs(semitones(after.hz) / semitones(before) - 48 / 36) < 1e-6);
      await page.reload();
      await page.evaluate(() => window.feelem.ready);
      const kept = await page.evaluate(state);
      assert.deepEqual([kept.person.wide, kept.person.master, kept.person.mono], [true, 0.7, true]);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "device_says_what_it_can_do_measured_and_copied",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      await context.grantPermissions(["clipboard-read", "clipboard-write"]);
      const section = await unfold(page, "device");
      await section.getByRole("button", { name: "Measure" }).click();
      const { device } = await until(page, state, (s) => s.device !== null, "the measurement");
      const read = (what) => new RegExp(`^${what}: (.*)$`, "m").exec(device)?.[1];
      assert.equal(read("browser"), await page.evaluate(() => navigator.userAgent));
      assert.match(read("graphics"), /SwiftShader/);
      const again = await openPage(browser, `${url}#diag`, { smooth: true });
      await until(again.page, state, (s) => s.device !== null, "the measurement by address");
      assert.deepEqual(again.problems, []);
      await again.context.close();
      assert.equal(read("secure page"), "yes");
      assert.match(read("sound"), /^(44100|48000) Hz/);
      assert.ok(Number(/within ([\d.]+) ms/.exec(read("frames"))[1]) > 0);
      await section.getByRole("button", { name: "Copy" }).click();
      await until(
        page,
        () => navigator.clipboard.readText(),
        (text) => text === device,
        "the copy",
      );
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
