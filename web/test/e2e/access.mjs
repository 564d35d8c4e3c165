// SPDX-License-Identifier: Apache-2.0
// For everybody: axe finds nothing serious in either theme, 320 pixels are enough, keys reach everything, ears are led.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { listen, openPage, until } from "./harness.mjs";
import { goTo } from "./keep.mjs";
import { unfold, unfoldAll } from "./look.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const state = () => window.feelem.state();

/** What axe finds serious. */
export async function faults(page) {
  await page.evaluate(AXE);
  const found = await page.evaluate(async () => {
    const { violations, passes } = await globalThis.axe.run(document, {
      runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"],
    });
    // A check that looked at nothing would find nothing.
    if (passes.length < 15) return [`only ${passes.length} rules had something to look at`];
    return violations
      .filter((v) => v.impact === "serious" || v.impact === "critical")
      .map(
        (v) =>
          `${v.id}: ${v.nodes
            .map((n) => `${n.target.join(" ")} (${n.any[0]?.message ?? ""})`)
            .slice(0, 4)
            .join("; ")}`,
      );
  });
  return found;
}

/** By the palette, which every size of the page has. */
async function pinAt(page, id) {
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "command" }).fill(String(id));
  await page.keyboard.press("Enter");
  await until(
    page,
    () => window.feelem.lastProbe()?.nodeId,
    (node) => node === id,
    `node ${id}`,
  );
}

export const accessTests = [
  ...[
    ["light", {}],
    ["dark", { dark: true }],
    ["light_at_320_pixels", { width: 320, height: 640 }],
    ["dark_at_320_pixels", { width: 320, height: 640, dark: true }],
  ].map(([name, options]) => ({
    name: `axe_finds_nothing_serious_${name}`,
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2, times: 3 });
      const { page, context } = await openPage(browser, url, options);
      await page.keyboard.press("c");
      const id = await page.evaluate(() => window.feelem.scene().results[0].values[0].max.node);
      await pinAt(page, id);
      await page.keyboard.press("p");
      assert.ok((await unfoldAll(page)).length >= 9);
      await page.evaluate(() => document.querySelector(".legend-more").setAttribute("open", ""));
      await page.locator(".legend-outside summary").click();
      await page.waitForTimeout(400);
      assert.deepEqual(await faults(page), []);
      await page.keyboard.press("Control+k");
      assert.deepEqual(await faults(page), []);
      await context.close();
      await close();
    },
  })),
  {
    name: "page_is_usable_at_320_pixels",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url, { width: 320, height: 640 });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 320, `${wide} pixels wide`);
      const box = await page.locator(".area-stage canvas").boundingBox();
      assert.ok(box.width >= 180 && box.height >= 150, JSON.stringify(box));
      for (const name of ["fit", "commands", "play", "undeformed"]) {
        const at = await page.getByRole("button", { name, exact: true }).first().boundingBox();
        assert.ok(at && at.x >= 0 && at.x + at.width <= 320, `${name} is at ${JSON.stringify(at)}`);
        assert.ok(at.width >= 24 && at.height >= 24);
      }
      const section = await unfold(page, "cuts");
      await section.getByRole("button", { name: "Add a plane" }).click();
      assert.equal((await page.evaluate(state)).cuts.length, 1);
      await context.close();
    },
  },
  {
    name: "tab_reaches_every_control_and_never_sticks",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      await unfoldAll(page);
      const wanted = await page.evaluate(() => {
        const able =
          "button:not(:disabled), input:not(:disabled), select:not(:disabled), summary, [tabindex='0']";
        const all = [...document.querySelectorAll(able)].filter(
          (e) => e.tabIndex >= 0 && e.checkVisibility() && !e.closest("dialog"),
        );
        globalThis.reached = new Set();
        document.addEventListener("focusin", (e) => globalThis.reached.add(e.target));
        globalThis.wanted = all;
        document.body.focus();
        return all.length;
      });
      for (let i = 0; i < wanted + 12; ++i) await page.keyboard.press("Tab");
      const missed = await page.evaluate(() =>
        globalThis.wanted
          .filter((e) => !globalThis.reached.has(e) && e.isConnected)
          .map((e) => e.outerHTML.slice(0, 90)),
      );
      assert.deepEqual(missed, []);
      await context.close();
    },
  },
  {
    name: "legend_is_heard_and_marked_and_captions_say_what_it_is",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const section = await unfold(page, "listening");
      await section.locator("[data-legend='pitch']").click();
      const seen = await page.evaluate(
        () =>
          new Promise((resolve) => {
            const places = new Set();
            const timer = setInterval(() => {
              const { legendAt } = window.feelem.state();
              if (legendAt !== null) places.add(legendAt);
            }, 15);
            setTimeout(() => {
              clearInterval(timer);
              resolve([...places]);
            }, 1500);
          }),
      );
      assert.ok(
        seen.length >= 2 && seen.every((u) => [0, 0.25, 0.5, 0.75, 1].includes(u)),
        JSON.stringify(seen),
      );
      assert.ok((await page.locator(".toast").textContent()).includes("Displacement magnitude"));
      await until(page, listen, (h) => h.level < 1e-4, "silence after the legend");
      assert.equal((await page.evaluate(state)).legendAt, null);
      await context.close();
    },
  },
  {
    name: "ticks_lead_to_the_largest_value",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      await page.keyboard.press("z");
      const { min, max } = scene.extras.results.find((r) => r.id === "temperature").values[0];
      const rates = [];
      for (const { node } of [min, max]) {
        await goTo(page, node);
        await page.keyboard.down("s");
        const { guideRate } = await until(page, state, (s) => s.guideRate > 0, "guiding ticks");
        rates.push(guideRate);
        if (node === max.node) await page.locator(".toast", { hasText: "largest value" }).waitFor();
        await page.keyboard.up("s");
        await until(page, state, (s) => s.guideRate === 0, "silence");
      }
      assert.ok(rates[0] < 1.6, `${rates}`);
      assert.ok(rates[1] === 12, `${rates}`);
      await context.close();
    },
  },
  {
    name: "what_a_person_chose_is_remembered_and_mirrors_the_page",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const section = await unfold(page, "listening");
      await section.getByLabel("same sound in both ears").check();
      await section.getByLabel("left-handed").check();
      const x = async (p, area) => (await p.locator(area).boundingBox()).x;
      assert.ok((await x(page, ".area-left")) > (await x(page, ".area-right")));
      await page.reload();
      await page.evaluate(() => window.feelem.ready);
      const { person } = await page.evaluate(state);
      assert.deepEqual([person.mono, person.leftHanded], [true, true]);
      assert.ok((await x(page, ".area-left")) > (await x(page, ".area-right")));
      await context.close();
    },
  },
];
