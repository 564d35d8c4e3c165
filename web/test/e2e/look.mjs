// SPDX-License-Identifier: Apache-2.0
// Looking at the model: parts, hot spots, limits, sections, notes. Everything by its values and by what is drawn.
import assert from "node:assert/strict";
import { openPage, pixelOf, until } from "./harness.mjs";
import { readScene } from "./oracle.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();

export async function unfold(page, id) {
  const section = page.locator(`details[data-section='${id}']`);
  if (!(await section.evaluate((e) => e.open))) await section.locator("summary").click();
  return section;
}

/** The stage seen from above or from the front, in plain view. */
export async function viewFrom(page, axis) {
  await page
    .locator(`.triad [aria-label='view from ${axis}']`)
    .evaluate((e) => e.dispatchEvent(new Event("click")));
  await page.waitForTimeout(200);
}

export async function middle(page, dx = 0, dy = 0) {
  const box = await page.locator(".area-stage canvas").boundingBox();
  return { x: Math.round(box.x + box.width / 2 + dx), y: Math.round(box.y + box.height / 2 + dy) };
}

export const lookTests = [
  {
    name: "parts_are_hidden_isolated_and_cleared_for_eye_and_ray_alike",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2 });
      const { page, context } = await openPage(browser, url);
      await viewFrom(page, "-y");
      const { x, y } = await middle(page);
      await page.mouse.move(x, y);
      // From -y the first bar stands before the second.
      const first = await until(page, probe, (r) => r !== null, "the first bar");
      assert.ok(first.elementId < 10_000);
      const section = await unfold(page, "parts");
      await section.getByLabel("show bar", { exact: true }).click();
      assert.deepEqual((await page.evaluate(state)).hidden, [0]);
      await page.mouse.move(x + 1, y);
      const second = await until(page, probe, (r) => r?.elementId > 10_000, "the second bar");
      assert.ok(second.point[1] >= 60);
      await page.mouse.move(5, 5);
      await section.getByLabel("only bar 2").click();
      await section.getByRole("button", { name: "Show everything" }).click();
      await section.getByLabel("see through bar", { exact: true }).click();
      assert.deepEqual((await page.evaluate(state)).clear, [0]);
      await page.mouse.move(x, y);
      await until(page, probe, (r) => r?.elementId > 10_000, "the bar behind the clear one");
      await page.keyboard.press("h");
      assert.deepEqual((await page.evaluate(state)).hidden, [1]);
      await page.mouse.move(x + 1, y);
      await until(page, probe, (r) => r && r.elementId < 10_000, "the clear bar alone");
      await page.keyboard.press("a");
      const all = await page.evaluate(state);
      assert.deepEqual([all.hidden, all.clear], [[], []]);
      await context.close();
      await close();
    },
  },
  {
    name: "parts_that_are_hidden_are_not_drawn",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2 });
      const { page, context } = await openPage(browser, url);
      await page.keyboard.press("x");
      await page.keyboard.press("e");
      await viewFrom(page, "+z");
      const at = await middle(page, 0, 60);
      const colour = async () => pixelOf(page, await page.screenshot(), at.x, at.y);
      const before = await colour();
      await (await unfold(page, "parts")).getByLabel("show bar", { exact: true }).click();
      await page.waitForTimeout(200);
      const after = await colour();
      const corner = await middle(page, -190, -190);
      const background = await pixelOf(page, await page.screenshot(), corner.x, corner.y);
      assert.notDeepEqual(before, after);
      assert.deepEqual(after, background);
      await context.close();
      await close();
    },
  },
  {
    name: "hot_spots_are_listed_by_value_and_gone_to",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      const section = await unfold(page, "hot-spots");
      await section.getByLabel("how many places").fill("3");
      await page.keyboard.press("Enter");
      const { hotSpots } = await until(page, state, (s) => s.hotSpots?.length === 3, "three places");
      const values = scene.extras.results.find((r) => r.id === "stress_von_mises").values[0];
      assert.deepEqual([hotSpots[0].value, hotSpots[0].node], [values.max.value, values.max.node]);
      assert.equal(hotSpots[0].utilisation, values.max.value / 300);
      await section.getByRole("button", { name: "2", exact: true }).click();
      const report = await until(page, probe, (r) => r?.nodeId === hotSpots[1].node, "the second place");
      assert.equal(report.results.find((r) => r.key === "S").nodeValue, hotSpots[1].value);
      await page.locator(".area-stage canvas").focus();
      await page.keyboard.press("n");
      await until(page, probe, (r) => r?.nodeId === hotSpots[0].node, "the first place by key");
      await section.getByLabel("by", { exact: true }).selectOption("utilisation");
      const by = await until(page, state, (s) => s.hotSpots?.[0]?.utilisation > 1, "by utilisation");
      assert.equal(by.hotSpots[0].key, "S");
      await context.close();
    },
  },
  {
    name: "two_hundred_parts_are_drawn_in_a_few_calls",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ bars: 200, cells: [2, 1, 1] });
      assert.equal(readScene(bytes).parts.length, 200);
      const { page, context } = await openPage(browser, url);
      const calls = await page.evaluate(
        () =>
          new Promise((resolve) => {
            const names = ["drawElements", "drawArrays"];
            const { prototype } = WebGL2RenderingContext;
            let count = 0;
            for (const name of names) {
              const draw = prototype[name];
              prototype[name] = function (...given) {
                count += 1;
                return draw.apply(this, given);
              };
            }
            window.dispatchEvent(new KeyboardEvent("keydown", { key: "e" }));
            setTimeout(() => resolve(count), 600);
          }),
      );
      assert.ok(calls >= 1 && calls <= 6, `${calls} draw calls`);
      await context.close();
      await close();
    },
  },
];
