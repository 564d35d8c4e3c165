// SPDX-License-Identifier: Apache-2.0
// What a person keeps: notes, distances, differences, pictures, tables.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { openPage, until } from "./harness.mjs";
import { unfold } from "./look.mjs";
import { readScene, valueAtNode } from "./oracle.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();

async function goTo(page, id) {
  await page.fill(".goto input", String(id));
  await page.keyboard.press("Enter");
  await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
  await page.locator(".area-stage canvas").focus();
}

async function saved(page, press) {
  const [download] = await Promise.all([page.waitForEvent("download"), press()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

export const keepTests = [
  {
    name: "notes_stay_at_their_nodes_and_the_ruler_measures_between_two",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const { positions, nodeIds } = scene.parts[0];
      const at = (x, y, z) =>
        nodeIds.find((n, i) => n > 0 && [x, y, z].every((c, k) => Math.abs(positions[3 * i + k] - c) < 1e-3));
      const [a, b] = [at(0, 0, 30), at(120, 40, 30)];
      await goTo(page, a);
      await page.keyboard.press("p");
      await page.keyboard.press("k");
      await goTo(page, b);
      await page.keyboard.press("k");
      const { pins, ruler } = await until(page, state, (s) => s.ruler?.nodes.length === 2, "two ends");
      assert.deepEqual(pins, [{ id: 1, node: a, note: "" }]);
      assert.deepEqual(ruler.nodes, [a, b]);
      assert.ok(Math.abs(ruler.undeformed - Math.hypot(120, 40)) < 1e-4);
      // At x = 120 the bar of step 1 has come down by 5.76 mm.
      assert.ok(Math.abs(ruler.deformed - Math.hypot(120, 40, 5.76)) < 1e-4);
      const section = await unfold(page, "notes");
      await section.getByLabel("text of note 1").fill("weld");
      await page.keyboard.press("Enter");
      await until(page, state, (s) => s.pins[0].note === "weld", "the note");
      await page.locator(".marker-note button", { hasText: "weld" }).waitFor();
      await section.getByLabel("go to note 1").click();
      await until(page, probe, (r) => r?.nodeId === a, "the note's node");
      await section.getByLabel("remove note 1").click();
      assert.deepEqual((await page.evaluate(state)).pins, []);
      const box = await page.locator(".area-stage canvas").boundingBox();
      await page.keyboard.press("f");
      await page.mouse.dblclick(box.x + box.width / 2, box.y + box.height / 2);
      const twice = await until(page, state, (s) => s.pins.length === 1, "a note by a double press");
      assert.equal(twice.pins[0].node, (await page.evaluate(probe)).nodeId);
      await context.close();
    },
  },
  {
    name: "difference_of_two_steps_is_a_result_like_any_other",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const section = await unfold(page, "difference");
      await section.getByLabel("step to subtract").selectOption({ index: 0 });
      await section.getByRole("button", { name: "See the difference" }).click();
      await page.locator(".stepbar").getByLabel("next step").click();
      await until(page, state, (s) => s.step === 2, "the second step");
      const id = scene.parts[0].nodeIds.find((n) => n > 0);
      await goTo(page, id);
      const { results } = await until(page, probe, (r) => r?.results.length === 4, "four results");
      const wanted = valueAtNode(scene, "temperature", 2, id) - valueAtNode(scene, "temperature", 1, id);
      assert.equal(results[3].nodeValue, Math.fround(wanted));
      assert.ok((await page.locator(".legend h2").textContent()).includes("Temperature − Bending"));
      await context.close();
    },
  },
  {
    name: "tables_hold_the_files_values_and_the_picture_holds_the_legend",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const section = await unfold(page, "save");
      const table = await saved(page, () =>
        section.getByRole("button", { name: "All visible nodes" }).click(),
      );
      assert.equal(table.name, "Bar-nodes.csv");
      const [head, ...lines] = table.bytes
        .toString("utf8")
        .trimEnd()
        .split("\r\n")
        .map((l) => l.split(","));
      assert.deepEqual(head.slice(0, 6), [
        "node",
        "part",
        "x [mm]",
        "y [mm]",
        "z [mm]",
        "Temperature [degC]",
      ]);
      const ids = new Set(scene.parts[0].nodeIds.filter((n) => n > 0));
      assert.equal(lines.length, ids.size);
      for (const line of lines) {
        for (const [column, id] of [
          [5, "temperature"],
          [7, "stress_von_mises"],
        ]) {
          const wanted = valueAtNode(scene, id, 1, Number(line[0]));
          assert.equal(line[column] === "" ? null : Math.fround(Number(line[column])), wanted);
        }
      }
      await section.getByLabel("columns parted by").selectOption("\t");
      const tabs = await saved(page, () =>
        section.getByRole("button", { name: "Notes and hot spots" }).click(),
      );
      assert.equal(tabs.name, "Bar-places.tsv");
      assert.ok(tabs.bytes.toString("utf8").startsWith("what\tnode\tnote\t"));
      const picture = await saved(page, () => page.keyboard.press("w"));
      assert.equal(picture.name, "Bar.png");
      const [width, colours] = await page.evaluate(async (data) => {
        const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const drawing = canvas.getContext("2d");
        drawing.drawImage(bitmap, 0, 0);
        const pixels = drawing.getImageData(0, 0, bitmap.width, bitmap.height).data;
        const seen = new Set();
        for (let i = 0; i < pixels.length; i += 4)
          seen.add((pixels[i] << 16) | (pixels[i + 1] << 8) | pixels[i + 2]);
        return [bitmap.width, [...seen]];
      }, picture.bytes.toString("base64"));
      const stage = await page.locator(".area-stage canvas").boundingBox();
      assert.ok(width > stage.width + 100, "the legend stands beside the model");
      // The lowest and the highest band of batlow.
      assert.ok(colours.includes(0x011959) && colours.includes(0xfaccfa));
      await context.close();
    },
  },
];

export { goTo, readScene, saved };
