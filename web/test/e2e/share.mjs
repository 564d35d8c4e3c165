// SPDX-License-Identifier: Apache-2.0
// Views that travel: links, undo, presentations, dropped scenes, the palette.
import assert from "node:assert/strict";
import { openPage, until } from "./harness.mjs";
import { goTo, saved } from "./keep.mjs";
import { unfold } from "./look.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();

/** Files as if they were dropped on the page. */
async function drop(page, files) {
  await page.evaluate((given) => {
    const data = new DataTransfer();
    for (const { name, base64 } of given) {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      data.items.add(new File([bytes], name));
    }
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, files);
}
const base64 = (bytes) => Buffer.from(bytes).toString("base64");

export const shareTests = [
  {
    name: "a_link_holds_the_whole_view",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const id = scene.parts[0].nodeIds.find((n) => n > 0);
      await goTo(page, id);
      for (const key of ["p", "c", "]", "u", ".", "e"]) await page.keyboard.press(key);
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      await page.fill("input[aria-label='deformation factor']", "3");
      await page.keyboard.press("Enter");
      await page.locator(".area-stage canvas").focus();
      const hash = await until(
        page,
        () => location.hash,
        (h) => h.startsWith("#view="),
        "the address",
      );
      await page.waitForTimeout(900);
      const last = await page.evaluate(() => location.hash);
      assert.ok(last.length >= hash.length / 2);
      const keys = ["presentation", "step", "deformationFactor", "cuts", "pins", "ghost", "hidden"];
      const pick = (s) => Object.fromEntries(keys.map((k) => [k, s[k]]));
      const wanted = pick(await page.evaluate(state));
      assert.equal(wanted.step, 2);
      const before = await page.evaluate(probe);
      const other = await context.newPage();
      await other.goto(`${url}?antialias=0${last}`);
      await other.evaluate(() => window.feelem.ready);
      await until(other, state, (s) => s.step === 2, "the step of the link");
      await other.waitForTimeout(300);
      assert.deepEqual(pick(await other.evaluate(state)), wanted);
      assert.equal((await other.evaluate(probe)).nodeId, before.nodeId);
      const camera = (p) => p.evaluate(() => window.feelem.state().camera);
      const [a, b] = [await camera(page), await camera(other)];
      for (const [i, v] of a.entries()) assert.ok(Math.abs(v - b[i]) < 1e-6, `camera ${a} and ${b}`);
      await other.goto(`${url}?antialias=0#view=broken`);
      await other.reload();
      await other.evaluate(() => window.feelem.ready);
      assert.ok((await other.locator(".banner").textContent()).includes("link"));
      await context.close();
    },
  },
  {
    name: "undo_and_redo_follow_what_was_changed",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      await page.keyboard.press("c");
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      const colour = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      await page.keyboard.press("Control+z");
      await until(page, state, (s) => colour(s) === "T" && s.cuts.length === 1, "the colour taken back");
      await page.keyboard.press("Control+z");
      await until(page, state, (s) => s.cuts.length === 0, "the plane taken back");
      await page.keyboard.press("Control+y");
      await page.keyboard.press("Control+Shift+z");
      await until(page, state, (s) => colour(s) === "S" && s.cuts.length === 1, "both again");
      await context.close();
    },
  },
  {
    name: "palette_finds_functions_results_steps_and_nodes",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const run = async (text) => {
        await page.keyboard.press("Control+k");
        await page.getByRole("combobox", { name: "command" }).fill(text);
        await page.keyboard.press("Enter");
      };
      await run("mises colour");
      const colour = (s) => s.presentation.effects.find((e) => e.type === "colour");
      await until(page, state, (s) => colour(s).result === "S", "stress as colour");
      await run("step mode");
      await until(page, state, (s) => s.step === 2, "the mode");
      const id = scene.parts[0].nodeIds.find((n) => n > 0);
      await run(String(id));
      await until(page, probe, (r) => r?.nodeId === id, "the node");
      await run("map turbo");
      await until(page, state, (s) => colour(s).map === "turbo", "the map");
      await run("section parts");
      await page.locator("details[data-section='parts'][open]").waitFor();
      await page.keyboard.press("Control+k");
      await page.keyboard.press("Escape");
      assert.equal(await page.locator("dialog[open]").count(), 0);
      await context.close();
    },
  },
  {
    name: "a_presentation_is_saved_and_opened_with_its_view",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      await page.keyboard.press("c");
      const section = await unfold(page, "save");
      const file = await saved(page, () => section.getByRole("button", { name: "Presentation" }).click());
      assert.equal(file.name, "Bar.presentation.json");
      assert.equal(JSON.parse(file.bytes.toString("utf8")).format, "feelem-presentation");
      await context.close();
      const again = await openPage(browser, url);
      await drop(again.page, [{ name: file.name, base64: base64(file.bytes) }]);
      const colour = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      await until(again.page, state, (s) => colour(s) === "S" && s.cuts.length === 1, "the presentation");
      await drop(again.page, [
        { name: "x.json", base64: btoa('{"effects":[{"type":"colour","result":"Q"}]}') },
      ]);
      const said = await until(
        again.page,
        () => document.querySelector(".banner")?.textContent ?? "",
        (t) => t !== "",
        "a word",
      );
      assert.ok(said.includes("effects[0]"), said);
      assert.equal(colour(await again.page.evaluate(state)), "S");
      await again.context.close();
    },
  },
  {
    name: "a_dropped_scene_with_its_side_files_takes_the_place_of_the_other",
    async run({ browser, url, serveTiny }) {
      const made = await serveTiny({ bars: 2, sideFiles: true });
      const { page, context, problems } = await openPage(browser, url);
      const files = [...made.files].map(([name, bytes]) => ({
        name: name.split("/").at(-1),
        base64: base64(bytes),
      }));
      await drop(page, files);
      await until(
        page,
        () => window.feelem.scene()?.parts.length,
        (n) => n === 2,
        "two parts",
      );
      await until(page, state, (s) => s !== null && s.step === 1, "the new scene");
      await page.keyboard.press(".");
      await until(page, state, (s) => s.step === 2, "its second step");
      await page.waitForTimeout(300);
      assert.equal(await page.locator(".banner").count(), 0);
      assert.equal(await page.locator("canvas.legend-canvas").count(), 1);
      await drop(page, [{ name: "notes.txt", base64: btoa("hello") }]);
      await page.locator(".banner").waitFor();
      assert.ok((await page.locator(".banner").textContent()).includes("feelem convert"));
      assert.deepEqual(problems, []);
      await context.close();
      await made.close();
    },
  },
];
