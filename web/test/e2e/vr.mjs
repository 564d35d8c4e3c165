// SPDX-License-Identifier: Apache-2.0
// The page in an emulated headset: rays, values, pulses, grips, and silence when the person lets go or leaves.
import assert from "node:assert/strict";
import { HEARD, listen, until } from "./harness.mjs";
import { resultIdOf, valueAtNode } from "./oracle.mjs";
import { aim, aimAtNode, button, enter, frames, pressPanel } from "./vr-hands.mjs";

const probe = () => window.feelem.lastProbe();

export const vrTests = [
  {
    name: "vr_ray_through_a_node_gives_the_files_values",
    async run({ browser, url, scene }) {
      const { page, context, foreign, problems } = await enter(browser, url);
      for (const [i, j, k] of [
        [6, 2, 3],
        [3, 1, 3],
        [9, 3, 3],
      ]) {
        const id = await aimAtNode(page, "right", i, j, k);
        const report = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
        assert.equal(report.pointer, "right-controller");
        for (const entry of report.results) {
          const wanted = valueAtNode(scene, resultIdOf(scene, entry), 1, id);
          assert.equal(entry.nodeValue, wanted);
          assert.equal(entry.value, wanted, `${entry.name} at node ${id}`);
        }
      }
      assert.deepEqual([foreign, problems], [[], []]);
      await context.close();
    },
  },
  {
    name: "vr_trigger_sounds_at_the_pitch_and_release_silences",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      await aimAtNode(page, "right", 8, 2, 3);
      await button(page, "right", "trigger", 1);
      const { hz } = await until(page, probe, (r) => r?.hz > 0, "a pitch");
      await until(
        page,
        listen,
        (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01,
        `a tone of ${hz} Hz`,
      );
      await button(page, "right", "trigger", 0);
      await until(page, listen, (h) => h.level < 1e-4, "silence after the release");
      await context.close();
    },
  },
  {
    name: "vr_pulses_rise_with_the_value_and_stop_on_release",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      const seen = [];
      // All below the limit: past it the pulses are those of the alarm.
      for (const i of [8, 6, 4]) {
        await aimAtNode(page, "right", i, 2, 3);
        const before = (await page.evaluate(() => window.feelem.pulses())).length;
        await button(page, "right", "trigger", 1);
        const all = await until(
          page,
          () => window.feelem.pulses(),
          (p) => p.length >= before + 3,
          "three pulses",
        );
        const report = await page.evaluate(probe);
        await button(page, "right", "trigger", 0);
        await frames(page, 4);
        const beats = all.slice(before).filter((p) => Math.abs(p.amplitude - report.pulse.amplitude) < 1e-9);
        assert.ok(beats.length >= 2, "pulses have the amplitude of the formula");
        const value = report.results.find((r) => r.key === "S").value;
        seen.push({ value, amplitude: report.pulse.amplitude, rate: report.pulse.rate });
        assert.ok(all.every((p) => p.pointer === "right-controller" && p.ms <= 200));
        const now = (await page.evaluate(() => window.feelem.pulses())).length;
        await frames(page, 20);
        assert.equal(
          (await page.evaluate(() => window.feelem.pulses())).length,
          now,
          "no pulse after the release",
        );
      }
      for (let n = 1; n < seen.length; ++n) {
        assert.ok(seen[n].value > seen[n - 1].value);
        assert.ok(seen[n].amplitude > seen[n - 1].amplitude && seen[n].rate > seen[n - 1].rate);
      }
      const felt = await page.evaluate(() => window.felt);
      const said = await page.evaluate(() => window.feelem.pulses());
      assert.equal(felt.length, said.length, "the actuator got what the page says");
      assert.ok(felt.every((p, n) => p.hand === "right" && Math.abs(p.value - said[n].amplitude) < 1e-9));
      await context.close();
    },
  },
  {
    name: "vr_menu_and_lost_controller_stop_everything",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      const start = async () => {
        await aimAtNode(page, "right", 4, 2, 3);
        await button(page, "right", "trigger", 1);
        await until(page, listen, (h) => h.level > HEARD, "sound");
      };
      const isStill = async (what) => {
        await until(page, listen, (h) => h.level < 1e-4, `silence after ${what}`);
        const count = (await page.evaluate(() => window.feelem.pulses())).length;
        await page.waitForTimeout(700);
        assert.equal(
          (await page.evaluate(() => window.feelem.pulses())).length,
          count,
          `pulses after ${what}`,
        );
      };
      await start();
      await page.evaluate(() => window.headset.updateVisibilityState("visible-blurred"));
      await isStill("the menu");
      await page.evaluate(() => window.headset.updateVisibilityState("visible"));
      await button(page, "right", "trigger", 0);
      await frames(page, 4);
      await start();
      await page.evaluate(() => {
        window.headset.controllers.right.connected = false;
      });
      await isStill("a lost controller");
      await context.close();
    },
  },
  {
    name: "vr_end_of_the_session_stops_everything_and_the_desk_is_back",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      await aimAtNode(page, "right", 4, 2, 3);
      await button(page, "right", "trigger", 1);
      await until(page, listen, (h) => h.level > HEARD, "sound");
      await page.evaluate(() => window.xrSession.end());
      await until(
        page,
        () => window.feelem.state().session,
        (s) => s === "none",
        "the desk",
      );
      await until(page, listen, (h) => h.level < 1e-4, "silence after the end");
      const count = (await page.evaluate(() => window.feelem.pulses())).length;
      await page.waitForTimeout(700);
      assert.equal((await page.evaluate(() => window.feelem.pulses())).length, count);
      await context.close();
    },
  },
  {
    name: "vr_one_grip_carries_and_two_grips_scale",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      // A ray straight down at the middle of the bar: where it hits tells where the bar is.
      const hitAt = async (x, z) => {
        await aim(page, "right", [x, 1.9, z], [x, 0, z - 0.0001]);
        return page.evaluate(probe);
      };
      await page.evaluate(() => document.querySelector(".segments button").click());
      const before = await hitAt(0, -1.2);
      assert.ok(Math.abs(before.point[0] - 60) < 0.5, `x is ${before.point[0]}`);
      await aim(page, "left", [-0.4, 1.2, -0.3], [-0.4, 1.2, -1.3]);
      await button(page, "left", "squeeze", 1);
      await frames(page, 3);
      await aim(page, "left", [-0.2, 1.2, -0.3], [-0.2, 1.2, -1.3]);
      await button(page, "left", "squeeze", 0);
      await frames(page, 3);
      const carried = await hitAt(0.2, -1.2);
      assert.ok(
        Math.abs(carried.point[0] - before.point[0]) < 0.5,
        `carried by 0.2 m: x is ${carried.point[0]}`,
      );
      // Two hands apart by twice as much about the bar's middle: everything is twice as large.
      await aim(page, "right", [0.4, 1, -0.5], [0.4, 1, -1.5]);
      await aim(page, "left", [0, 1, -0.5], [0, 1, -1.5]);
      await button(page, "left", "squeeze", 1);
      await button(page, "right", "squeeze", 1);
      await frames(page, 3);
      await aim(page, "right", [0.6, 1, -0.5], [0.6, 1, -1.5]);
      await aim(page, "left", [-0.2, 1, -0.5], [-0.2, 1, -1.5]);
      await button(page, "left", "squeeze", 0);
      await button(page, "right", "squeeze", 0);
      await frames(page, 3);
      const middle = await hitAt(0.2, -1.9);
      const aside = await hitAt(0.2 + 0.3, -1.9);
      const perMetre = (aside.point[0] - middle.point[0]) / 0.3;
      assert.ok(Math.abs(perMetre / 75 - 1) < 0.02, `mm of the bar a metre: ${perMetre}, wanted 75`);
      await context.close();
    },
  },
  {
    name: "vr_panel_assigns_a_result_to_another_sense",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      await pressPanel(page, "U:colour");
      const effect = () =>
        window.feelem.state().presentation.effects.find((e) => e.type === "colour")?.result;
      await until(page, effect, (key) => key === "U", "displacement as colour");
      await context.close();
    },
  },
  {
    name: "vr_panel_pages_cut_hide_and_find_by_the_ray",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2, times: 2 });
      const { page, context, problems } = await enter(browser, url);
      const state = () => window.feelem.state();
      const press = (id) => pressPanel(page, id);
      await press("tab:cuts");
      await press("cuts:x");
      await until(page, state, (s) => s.cuts[0]?.normal[0] === 1, "a plane across x");
      await press("cuts:flip");
      await until(page, state, (s) => s.cuts[0].normal[0] === -1, "the other side");
      await press("tab:parts");
      const { headset } = await page.evaluate(state);
      assert.equal(headset.page, "parts");
      await press("parts:show:0");
      await until(page, state, (s) => s.hidden.join() === "0", "the first part hidden");
      await press("parts:all");
      await until(page, state, (s) => s.hidden.length === 0, "all parts");
      await press("tab:hot-spots");
      await press("hot-spots:go:0");
      await until(page, probe, (r) => r?.nodeId > 0, "the largest value marked");
      await press("tab:listening");
      await press("listening:guide");
      await until(page, state, (s) => s.guide, "the guide");
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "vr_two_eyes_see_two_pictures",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url, { width: 640, height: 360 });
      const png = (await page.screenshot()).toString("base64");
      const differing = await page.evaluate(async (data) => {
        const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const drawing = canvas.getContext("2d");
        drawing.drawImage(bitmap, 0, 0);
        const half = bitmap.width / 2;
        const left = drawing.getImageData(0, 0, half, bitmap.height).data;
        const right = drawing.getImageData(half, 0, half, bitmap.height).data;
        let count = 0;
        for (let i = 0; i < left.length; i += 4) if (Math.abs(left[i] - right[i]) > 12) count += 1;
        return count / (left.length / 4);
      }, png);
      const near = await page.evaluate(() => window.xrSession.renderState.depthNear);
      assert.ok(near <= 0.06, `hands vanish nearer than ${near} m`);
      assert.ok(differing > 0.01 && differing < 0.6, `share of pixels that differ: ${differing}`);
      await context.close();
    },
  },
];
