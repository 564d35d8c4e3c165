// SPDX-License-Identifier: Apache-2.0
// Small screens, fingers, and 200 % of zoom: nothing beside the screen, nothing over another, all large enough to press.
import assert from "node:assert/strict";
import { openPage } from "./harness.mjs";
import { unfold, unfoldAll } from "./look.mjs";

const state = () => window.feelem.state();

/** What is wrong with the places of all that can be pressed: [what, where]. Runs in the page. */
async function misplaced(least) {
  const found = [];
  const wide = document.documentElement.clientWidth;
  const app = document.querySelector("#app");
  if (document.documentElement.scrollWidth > wide || app.scrollWidth > wide)
    found.push(`the page is ${app.scrollWidth} pixels wide`);
  const able = "button:not(:disabled), input:not(:disabled), select:not(:disabled), summary, textarea";
  // Marks on the model are there for the mouse; lists and palette have the same.
  const all = [...document.querySelectorAll(able)].filter(
    (e) => e.checkVisibility({ visibilityProperty: true }) && !e.closest("dialog, .markers"),
  );
  const boxes = [];
  for (const control of all) {
    const label = control.getAttribute("aria-label") ?? control.textContent.trim().slice(0, 30);
    const name = label || control.closest("label")?.textContent.trim() || control.outerHTML.slice(0, 60);
    control.scrollIntoView({ block: "nearest", inline: "nearest" });
    await new Promise((done) => requestAnimationFrame(done));
    const box = control.getBoundingClientRect();
    if (box.left < -0.5 || box.right > wide + 0.5) found.push(`${name}: from ${box.left} to ${box.right}`);
    // A label around a field can be pressed as well.
    const target = control.type === "checkbox" ? control.closest("label").getBoundingClientRect() : box;
    const short = Math.min(target.width, target.height);
    if (short < least - 0.5) found.push(`${name}: ${target.width.toFixed(0)} by ${target.height.toFixed(0)}`);
    const top = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
    const reached =
      top && (control.contains(top) || top.contains(control) || top.closest("label")?.contains(control));
    if (!reached)
      found.push(`${name}: lies under ${top?.className || top?.tagName} at ${box.top.toFixed(0)}`);
    let shift = 0;
    for (let e = control.parentElement; e; e = e.parentElement) shift += e.scrollTop;
    boxes.push({
      name,
      control,
      left: box.left,
      right: box.right,
      top: box.top + shift,
      bottom: box.bottom + shift,
    });
  }
  const fixed = (e) => e.closest(".area-stage, .area-right");
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1)) {
      if (Boolean(fixed(a.control)) !== Boolean(fixed(b.control))) continue;
      const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (across > 1 && down > 1 && !a.control.contains(b.control))
        found.push(`${a.name} and ${b.name} overlap`);
    }
  return { found: found.slice(0, 15), counted: all.length };
}

const FINGER = { hasTouch: true, isMobile: true };

export const smallTests = [
  ...[
    ["320_pixels", { width: 320, height: 640 }, 24],
    ["320_pixels_under_a_finger", { width: 320, height: 640, device: FINGER }, 44],
    ["a_phone_on_its_side_under_a_finger", { width: 740, height: 360, device: FINGER }, 44],
    ["200_per_cent_of_zoom", { width: 720, height: 450, device: { deviceScaleFactor: 2 } }, 24],
    ["a_narrow_desk", { width: 900, height: 620 }, 24],
  ].map(([name, options, least]) => ({
    name: `small_page_is_usable_with_${name}`,
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2, times: 3 });
      const { page, context, problems } = await openPage(browser, url, options);
      if (options.device?.hasTouch)
        assert.ok(await page.evaluate(() => matchMedia("(pointer: coarse)").matches));
      await page.keyboard.press("c");
      await page.evaluate(() => document.querySelector(".legend-more").setAttribute("open", ""));
      assert.ok((await unfoldAll(page)).length >= 12);
      await page.locator(".legend-outside summary").click();
      await page.locator(".others summary").click();
      await page.locator(".help summary").click();
      const { found, counted } = await page.evaluate(misplaced, least);
      assert.ok(counted > 100, `${counted} controls`);
      assert.deepEqual(found, []);
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  })),
  {
    name: "small_page_keeps_the_model_and_its_scale_in_sight_while_it_runs",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url, { width: 320, height: 640 });
      const canvas = page.locator(".area-stage canvas");
      const first = await canvas.boundingBox();
      assert.ok(first.width === 320 && first.height >= 200, JSON.stringify(first));
      await unfold(page, "save");
      await page.locator("[data-section='save'] button").last().scrollIntoViewIfNeeded();
      const after = await canvas.boundingBox();
      assert.equal(after.y, 0);
      const scale = await page.locator(".legend-canvas").boundingBox();
      assert.ok(scale.y >= after.y + after.height && scale.y < 340, JSON.stringify(scale));
      const probe = await page.evaluate(() => {
        const { left, top, width, height } = document
          .querySelector(".area-stage canvas")
          .getBoundingClientRect();
        document.querySelector(".area-stage canvas").dispatchEvent(
          new PointerEvent("pointermove", {
            clientX: left + width / 2,
            clientY: top + height / 2,
            pointerId: 1,
          }),
        );
        const report = window.feelem.lastProbe();
        document
          .querySelector(".area-stage canvas")
          .dispatchEvent(new PointerEvent("pointermove", { clientX: -1e6, clientY: -1e6, pointerId: 1 }));
        return report;
      });
      assert.ok(probe, "the model is in the middle of its picture");
      await page.getByRole("button", { name: "commands" }).scrollIntoViewIfNeeded();
      await page.getByRole("button", { name: "commands" }).click();
      await page.getByRole("combobox", { name: "command" }).fill("1040");
      await page.keyboard.press("Enter");
      assert.equal((await page.evaluate(() => window.feelem.lastProbe()))?.nodeId, 1040);
      assert.equal((await page.evaluate(state)).session, "none");
      await context.close();
    },
  },
];
