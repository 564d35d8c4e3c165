// SPDX-License-Identifier: Apache-2.0
// Contrast of all that is written, computed from the colours that the browser uses: WCAG 2.2 AA in both themes.
import assert from "node:assert/strict";
import { BOARD_COLOURS } from "../../src/xr/board-colours.ts";
import { openPage } from "./harness.mjs";
import { goTo } from "./keep.mjs";
import { unfoldAll } from "./look.mjs";

/** Every text and every sign of the page with too little contrast against what lies behind it. Runs in the page. */
function pale(stage) {
  const canvas = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
  /** Any CSS colour as r, g, b, a in 0..1. */
  const channels = (css) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = css;
    canvas.fillRect(0, 0, 1, 1);
    const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
    return [r / 255, g / 255, b / 255, a / 255];
  };
  const over = (top, below) => [0, 1, 2].map((k) => top[k] * top[3] + below[k] * (1 - top[3])).concat(1);
  const light = (c) =>
    [0.2126, 0.7152, 0.0722].reduce((sum, weight, k) => {
      return sum + weight * (c[k] <= 0.04045 ? c[k] / 12.92 : ((c[k] + 0.055) / 1.055) ** 2.4);
    }, 0);
  const ratio = (a, b) => {
    const [x, y] = [light(a), light(b)];
    return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
  };
  /** What lies behind an element, and how much of it shows through its ancestors. */
  const behind = (element) => {
    const layers = [];
    let opacity = 1;
    for (let e = element; e; e = e.parentElement) {
      const style = getComputedStyle(e);
      layers.push(channels(style.backgroundColor));
      opacity *= Number(style.opacity);
      if (e.classList.contains("area-stage")) layers.push(channels(stage));
    }
    return { colour: layers.reverse().reduce((below, top) => over(top, below), [1, 1, 1, 1]), opacity };
  };
  const found = [];
  let counted = 0;
  const check = (element, css, least, what) => {
    const back = behind(element);
    const own = channels(css);
    const drawn = over([own[0], own[1], own[2], own[3] * back.opacity], back.colour);
    counted += 1;
    const has = ratio(drawn, back.colour);
    if (has < least - 0.005) found.push(`${what}: ${has.toFixed(2)} of ${least} (${css})`);
  };
  const isOff = (element) => element.closest(":disabled, [aria-disabled=true]") !== null;
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    const text = node.textContent.trim();
    if (!text || !element.checkVisibility({ visibilityProperty: true })) continue;
    if (element.closest("svg, option, script, style, .said")) continue;
    // What cannot be pressed now need not be read as well, but it must be seen.
    check(element, getComputedStyle(element).color, isOff(element) ? 3 : 4.5, `"${text.slice(0, 40)}"`);
  }
  for (const field of document.querySelectorAll(
    "input:not([type=checkbox], [type=range], [type=color]), select",
  )) {
    if (!field.checkVisibility()) continue;
    const name = field.getAttribute("aria-label") ?? field.name;
    check(field, getComputedStyle(field).color, isOff(field) ? 3 : 4.5, `field ${name}`);
    if (field.placeholder)
      check(field, getComputedStyle(field, "::placeholder").color, 4.5, `placeholder of ${name}`);
  }
  for (const sign of document.querySelectorAll("button svg.icon")) {
    const button = sign.closest("button");
    if (!sign.checkVisibility() || isOff(button)) continue;
    check(
      sign,
      getComputedStyle(sign).color,
      3,
      `sign of ${button.getAttribute("aria-label") ?? button.textContent}`,
    );
  }
  for (const text of document.querySelectorAll("svg text")) {
    if (!text.checkVisibility()) continue;
    const circle = text.closest(".axis")?.querySelector("circle");
    const { fill } = getComputedStyle(text);
    if (!circle) check(text, fill, 4.5, `"${text.textContent}"`);
    else if (ratio(channels(fill), channels(getComputedStyle(circle).fill)) < 4.495)
      found.push(
        `letter ${text.textContent}: ${ratio(channels(fill), channels(getComputedStyle(circle).fill)).toFixed(2)}`,
      );
  }
  return { found: [...new Set(found)], counted };
}

/** Everything that can be pressed, as it looks under the pointer and with the focus. */
async function inState(page, states) {
  const session = await page.context().newCDPSession(page);
  await session.send("DOM.enable");
  await session.send("CSS.enable");
  const { root } = await session.send("DOM.getDocument", { depth: -1 });
  const { nodeIds } = await session.send("DOM.querySelectorAll", {
    nodeId: root.nodeId,
    selector: "button, input, select, summary, [tabindex='0'], li[role=option]",
  });
  for (const nodeId of nodeIds)
    await session.send("CSS.forcePseudoState", { nodeId, forcedPseudoClasses: states }).catch(() => {});
  return session;
}

const luminance = (hex) =>
  [1, 3, 5]
    .map((at) => Number.parseInt(hex.slice(at, at + 2), 16) / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, k) => sum + [0.2126, 0.7152, 0.0722][k] * c, 0);
function ratioOf(a, b) {
  const [x, y] = [luminance(a), luminance(b)].sort((p, q) => q - p);
  return (x + 0.05) / (y + 0.05);
}

export const contrastTests = [
  ...[false, true].map((dark) => ({
    name: `contrast_of_every_text_and_sign_is_aa_${dark ? "dark" : "light"}`,
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2, times: 3 });
      const { page, context } = await openPage(browser, url, { dark, height: 900, width: 1280 });
      await page.keyboard.press("c");
      await goTo(page, await page.evaluate(() => window.feelem.scene().results[2].values[0].max.node));
      await page.keyboard.press("p");
      await unfoldAll(page);
      await page.locator(".legend-outside summary").click();
      await page.locator(".others summary").click();
      await page.getByLabel("colour map", { exact: true }).selectOption("ansys_rainbow");
      await page.keyboard.down("s");
      await page.waitForTimeout(300);
      const stage = await page.evaluate(() =>
        getComputedStyle(document.documentElement).getPropertyValue("--stage"),
      );
      const plain = await page.evaluate(pale, stage);
      assert.ok(plain.counted > 200, `${plain.counted} texts and signs`);
      assert.deepEqual(plain.found, []);
      for (const states of [["hover"], ["focus", "focus-visible"], ["hover", "active"]]) {
        const session = await inState(page, states);
        const { found, counted } = await page.evaluate(pale, stage);
        assert.ok(counted > 200);
        assert.deepEqual(found, [], states.join(" and "));
        await session.detach();
      }
      await page.keyboard.press("Control+k");
      assert.deepEqual((await page.evaluate(pale, stage)).found, []);
      await context.close();
      await close();
    },
  })),
  {
    name: "contrast_of_what_is_painted_on_boards_is_aa",
    async run() {
      const { panel, ink, soft, alarm, accent, accentInk, hover, faint } = BOARD_COLOURS;
      for (const [name, front, back, least] of [
        ["words", ink, panel, 4.5],
        ["less important words", soft, panel, 4.5],
        ["alarm", alarm, panel, 4.5],
        ["button that is on", accentInk, accent, 4.5],
        ["button under the ray", ink, hover, 4.5],
        ["button that cannot be pressed", faint, panel, 3],
      ])
        assert.ok(ratioOf(front, back) >= least, `${name}: ${ratioOf(front, back).toFixed(2)}`);
    },
  },
];
