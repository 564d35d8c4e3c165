// SPDX-License-Identifier: Apache-2.0
// Steps, modes and shapes over time: history of a node, the ghost, complex modes.
import assert from "node:assert/strict";
import { openPage, until } from "./harness.mjs";
import { unfold } from "./look.mjs";
import { readScene, valueAtNode } from "./oracle.mjs";

const state = () => window.feelem.state();

export const timeTests = [
  {
    name: "history_of_a_node_shows_every_step_and_a_press_goes_there",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ times: 5 });
      const scene = readScene(bytes);
      const { page, context } = await openPage(browser, url);
      const id = scene.parts[0].nodeIds.find((n) => n > 0);
      await page.fill(".goto input", String(id));
      await page.keyboard.press("Enter");
      const section = await unfold(page, "history");
      const read = (s) => s.history?.results.find((r) => r.key === "T")?.points ?? [];
      const { history } = await until(page, state, (s) => read(s).length === 7, "seven steps");
      assert.equal(history.node, id);
      for (const { step, value } of history.results[0].points)
        assert.equal(value, valueAtNode(scene, "temperature", step, id));
      const plot = section.locator(".history svg").first();
      const box = await plot.boundingBox();
      await plot.click({ position: { x: box.width - 12, y: box.height / 2 } });
      await until(page, state, (s) => s.step === 7, "the last step");
      await context.close();
      await close();
    },
  },
  {
    name: "ghost_is_drawn_where_the_model_was",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      for (const key of ["x", "e"]) await page.keyboard.press(key);
      await page.mouse.move(5, 5);
      await page.waitForTimeout(300);
      const without = (await page.screenshot()).toString("base64");
      await page.keyboard.press("u");
      await until(page, state, (s) => s.ghost === true, "the ghost");
      await page.waitForTimeout(300);
      assert.notEqual((await page.screenshot()).toString("base64"), without);
      await page.keyboard.press("0");
      await page.waitForTimeout(300);
      const flat = (await page.screenshot()).toString("base64");
      await page.keyboard.press("u");
      await page.waitForTimeout(300);
      assert.equal(
        (await page.screenshot()).toString("base64"),
        flat,
        "no ghost of a shape that has not moved",
      );
      await context.close();
    },
  },
  {
    name: "complex_mode_turns_and_comes_to_rest",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ complex: true });
      const { page, context, problems } = await openPage(browser, url);
      await page.locator(".stepbar").getByLabel("next step").click();
      await until(page, state, (s) => s.step === 2, "the mode");
      await page.locator(".area-stage canvas").focus();
      await page.mouse.move(5, 5);
      await page.waitForTimeout(400);
      // Within the ring that a key draws round the model.
      const box = await page.locator(".area-stage canvas").boundingBox();
      const clip = { x: box.x + 6, y: box.y + 6, width: box.width - 12, height: box.height - 12 };
      const picture = async () => (await page.screenshot({ clip })).toString("base64");
      const still = await picture();
      await page.keyboard.press(" ");
      const angles = await page.evaluate(
        () =>
          new Promise((resolve) => {
            const seen = [];
            const timer = setInterval(() => {
              const { re, im } = window.feelem.state().swing;
              seen.push([re, im]);
              if (seen.length === 12) {
                clearInterval(timer);
                resolve(seen);
              }
            }, 120);
          }),
      );
      // Re and Im are factor cos and -factor sin: together they stay on a circle, and Im is not always 0.
      const radius = angles.map(([re, im]) => Math.hypot(re, im));
      assert.ok(Math.max(...radius) - Math.min(...radius) < 1e-9 * radius[0]);
      assert.ok(new Set(angles.map(([, im]) => im)).size > 4);
      await page.keyboard.press(" ");
      await page.waitForTimeout(400);
      assert.equal(await picture(), still);
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
];
