// SPDX-License-Identifier: Apache-2.0
// By keyboard alone: every control is reached, named, seen with the focus and pressed; every function is run.
import assert from "node:assert/strict";
import { openPage, until } from "./harness.mjs";
import { unfoldAll } from "./look.mjs";

const state = () => window.feelem.state();

/** Remembers what can be pressed, and keeps what keys press from having effects. */
function watchControls() {
  const able =
    "button:not(:disabled), input:not(:disabled), select:not(:disabled), textarea, summary, a[href], [tabindex='0']";
  globalThis.wanted = new Set(
    [...document.querySelectorAll(able)].filter(
      (e) => e.tabIndex >= 0 && e.checkVisibility() && !e.closest("dialog"),
    ),
  );
  globalThis.pressed = null;
  for (const kind of ["click", "input", "change"])
    window.addEventListener(
      kind,
      (event) => {
        globalThis.pressed = event.target;
        event.stopImmediatePropagation();
        event.preventDefault();
      },
      true,
    );
  return globalThis.wanted.size;
}

/** Of what has the focus: its name, and what is wrong with how that is seen. */
function focused() {
  const e = document.activeElement;
  if (!e || e === document.body) return null;
  globalThis.wanted.delete(e);
  const label = e.closest("label")?.textContent ?? "";
  const name = (e.getAttribute("aria-label") ?? (e.textContent.trim() || e.title || label)).trim();
  const style = getComputedStyle(e);
  const box = e.getBoundingClientRect();
  const wrong = [];
  if (!name) wrong.push("has no name");
  if (style.outlineStyle === "none" || Number.parseFloat(style.outlineWidth) < 2) wrong.push("shows no ring");
  if (box.bottom <= 0 || box.top >= innerHeight || box.right <= 0 || box.left >= innerWidth)
    wrong.push("is out of sight");
  else {
    const x = Math.min(Math.max((box.left + box.right) / 2, 1), innerWidth - 2);
    const y = Math.min(Math.max((box.top + box.bottom) / 2, 1), innerHeight - 2);
    const top = document.elementFromPoint(x, y);
    if (e.localName !== "canvas" && !(e.contains(top) || top?.contains(e)))
      wrong.push(`is under ${top?.className}`);
  }
  const kind = e.localName === "input" ? e.type : e.localName;
  const area = e.closest("[class^='area-']")?.className;
  // Whether the key after the last Tab pressed what had the focus then.
  const beforePressed = globalThis.pressed !== null && globalThis.pressed === globalThis.last;
  globalThis.pressed = null;
  globalThis.last = e;
  return { name: name.slice(0, 60), kind, wrong, area, beforePressed, html: e.outerHTML.slice(0, 80) };
}

/** Which key presses such a control. */
const KEY = {
  button: "Space",
  checkbox: "Space",
  summary: "Enter",
  range: "ArrowRight",
  select: "ArrowDown",
};

export const keyboardTests = [
  ...[
    ["at_the_desk", { width: 1280, height: 800 }],
    ["at_320_pixels", { width: 320, height: 640 }],
  ].map(([name, options]) => ({
    name: `keys_reach_name_show_and_press_every_control_${name}`,
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2, times: 3 });
      const { page, context, problems } = await openPage(browser, url, options);
      await page.keyboard.press("c");
      await page.evaluate(() => document.querySelector(".legend-more").setAttribute("open", ""));
      await unfoldAll(page);
      await page.locator(".legend-outside summary").click();
      await page.locator(".others summary").click();
      await page.evaluate(() => document.activeElement.blur());
      await page.mouse.move(2, 2);
      const wanted = await page.evaluate(watchControls);
      assert.ok(wanted > 100, `${wanted} controls`);
      const areas = [];
      const wrong = [];
      let pressing = null;
      for (let i = 0; i < wanted + 6; ++i) {
        await page.keyboard.press("Tab");
        const at = await page.evaluate(focused);
        if (!at) continue;
        if (at.wrong.length > 0) wrong.push(`${at.name || at.html}: ${at.wrong.join(", ")}`);
        if (areas.at(-1) !== at.area) areas.push(at.area);
        const key = KEY[at.kind];
        if (pressing && !at.beforePressed) wrong.push(`${pressing}: its key does not press it`);
        pressing = key && at.kind !== "select" ? at.name : null;
        if (key) await page.keyboard.press(key);
      }
      const missed = await page.evaluate(() =>
        [...globalThis.wanted].filter((e) => e.isConnected).map((e) => e.outerHTML.slice(0, 90)),
      );
      assert.deepEqual({ missed, wrong: wrong.slice(0, 15) }, { missed: [], wrong: [] });
      // One area after the other, none twice but where the walk begins anew.
      assert.ok(areas.length <= 7, areas.join(" "));
      await page.keyboard.press("Shift+Tab");
      await page.keyboard.press("Shift+Tab");
      assert.ok(await page.evaluate(focused), "the way back");
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  })),
  {
    name: "keys_find_every_function_in_the_palette_and_run_it",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2, times: 3 });
      const { page, context, problems } = await openPage(browser, url, { width: 480, height: 300 });
      await page.evaluate(() => {
        // Files that are asked for or given are no part of this.
        HTMLInputElement.prototype.click = () => {};
        HTMLAnchorElement.prototype.click = () => {};
      });
      // Letter by letter until nothing new is offered.
      const known = new Map();
      await page.keyboard.press("Control+k");
      const field = page.getByRole("combobox", { name: "command" });
      for (const typed of [
        "",
        ..."abcdefghijklmnopqrstuvwxyz",
        ..."+-",
        "vi",
        "co",
        "st",
        "sa",
        "ma",
        "se",
        "li",
        "no",
        "ne",
        "he",
        "be",
      ]) {
        await field.fill(typed);
        for (const text of await page
          .locator("dialog li[role=option]")
          .evaluateAll((all) => all.map((e) => e.firstElementChild.textContent)))
          known.set(text, true);
      }
      await page.keyboard.press("Escape");
      // What has a key is there, but for what is held or steered.
      const keys = await page.locator(".help dl").evaluate((list) =>
        [...list.querySelectorAll("dt:has(kbd)")].map((dt) => ({
          key: dt.textContent,
          text: dt.nextElementSibling.textContent,
        })),
      );
      assert.ok(keys.length >= 35, `${keys.length} keys`);
      const steered = keys.filter(
        ({ key, text }) => !known.has(text) && !/[←]|^S$|^Ctrl K$|^[GM]$/.test(key),
      );
      assert.deepEqual(
        steered.filter(({ text }) => !/^hold/.test(text)),
        [],
      );
      assert.ok(known.size >= 60, `${known.size} functions`);
      await page.keyboard.press("Control+k");
      const places = await page.evaluate(
        (texts) => {
          const input = document.querySelector("dialog input");
          return texts.map((text) => {
            input.value = text;
            input.dispatchEvent(new Event("input", { bubbles: true }));
            const offered = [...document.querySelectorAll("dialog li[role=option]")];
            return offered.findIndex((e) => e.firstElementChild.textContent === text);
          });
        },
        [...known.keys()],
      );
      await page.keyboard.press("Escape");
      const lost = [...known.keys()].filter((_, i) => places[i] < 0);
      assert.deepEqual(lost, [], "functions that their own words do not find");
      const runs = [...known.keys()].filter(
        (text, i) => i % 3 === 0 && !/^(open a scene|enter VR)/.test(text),
      );
      let before = "nothing";
      for (const text of runs) {
        await page.keyboard.press("Control+k");
        assert.equal(await page.locator("dialog[open]").count(), 1, `the palette opens after: ${before}`);
        before = text;
        await field.fill(text);
        for (let i = 0; i < places[[...known.keys()].indexOf(text)]; ++i)
          await page.keyboard.press("ArrowDown");
        await page.keyboard.press("Enter");
        const open = () => document.querySelector("dialog[open] input")?.value ?? null;
        await until(page, open, (typed) => typed === null, `the end of the palette after: ${text}`, 8000);
        assert.deepEqual(problems, [], text);
      }
      assert.equal((await page.evaluate(state)).session, "none");
      await context.close();
      await close();
    },
  },
  {
    name: "keys_turn_move_and_zoom_the_camera",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const camera = async () => {
        const [x, y, z, yaw, pitch, distance] = (await page.evaluate(state)).camera;
        return { target: [x, y, z], yaw, pitch, distance };
      };
      const before = await camera();
      await page.keyboard.press("Shift+ArrowRight");
      const turned = await camera();
      assert.ok(Math.abs(Math.abs(turned.yaw - before.yaw) - Math.PI / 12) < 1e-5, JSON.stringify(turned));
      await page.keyboard.press("Shift+ArrowUp");
      assert.ok(Math.abs((await camera()).pitch - before.pitch) > 0.2);
      await page.keyboard.press("PageUp");
      assert.ok(Math.abs((await camera()).distance / before.distance - 0.8) < 1e-5);
      await page.keyboard.press("PageDown");
      assert.ok(Math.abs((await camera()).distance / before.distance - 1) < 1e-5);
      await page.keyboard.press("Control+ArrowLeft");
      const moved = await camera();
      assert.ok(
        moved.target.some((c, k) => Math.abs(c - before.target[k]) > 1e-4),
        JSON.stringify(moved),
      );
      await page.keyboard.press("f");
      const fitted = await camera();
      assert.ok(fitted.target.every((c, k) => Math.abs(c - before.target[k]) < 1e-5));
      await context.close();
    },
  },
  {
    name: "wishes_of_the_system_for_less_motion_and_more_contrast_are_kept",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url, {
        device: { reducedMotion: "reduce", forcedColors: "active" },
      });
      const id = await page.evaluate(() => window.feelem.scene().results[0].values[0].max.node);
      await page.keyboard.press("n");
      await until(
        page,
        () => window.feelem.lastProbe()?.nodeId,
        (node) => node === id,
        "the hottest node at once",
      );
      const moving = await page.evaluate(
        () =>
          [...document.querySelectorAll("*")].filter((e) => {
            const { animationName, transitionDuration } = getComputedStyle(e);
            return (
              animationName !== "none" || transitionDuration.split(", ").some((t) => Number.parseFloat(t) > 0)
            );
          }).length,
      );
      assert.equal(moving, 0);
      // Colours of values stay; what is on has a border of the system's colour.
      const special = await page
        .locator(".legend-special i")
        .first()
        .evaluate((e) => getComputedStyle(e).backgroundColor);
      assert.equal(special, "rgb(255, 0, 255)");
      const border = (selector) =>
        page
          .locator(selector)
          .first()
          .evaluate((e) => getComputedStyle(e).borderTopColor);
      assert.notEqual(
        await border(".cell[aria-pressed='true']"),
        await border(".cell[aria-pressed='false']:enabled"),
      );
      await context.close();
    },
  },
];
