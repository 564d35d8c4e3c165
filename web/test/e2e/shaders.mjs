// SPDX-License-Identifier: Apache-2.0
// What the shaders draw where triangles are smaller than a pixel and where planes leave a slab, by pixels of real pictures.
import assert from "node:assert/strict";
import { openPage, pixelOf, until } from "./harness.mjs";
import { middle, unfold, viewFrom } from "./look.mjs";
import { settled } from "./read-back.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();

/** How many pixels of the stage have a share of pure green, or of pure blue, that no band of the palette has. */
async function beyond(page) {
  // The axes have such colours too; their buttons still turn the view.
  await page.locator(".triad").evaluate((triad) => {
    triad.style.opacity = "0";
  });
  await settled(page);
  const png = await page.locator(".area-stage canvas").screenshot();
  return page.evaluate(async (data) => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const all = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    const found = { above: 0, below: 0 };
    for (let i = 0; i < all.length; i += 4) {
      const [r, g, b] = [all[i], all[i + 1], all[i + 2]];
      if (g > 140 && g > r + 30 && g > b + 30) found.above += 1;
      if (b > 150 && b > r + 40 && b > g + 40) found.below += 1;
    }
    return found;
  }, png.toString("base64"));
}

/** Green above and blue below the range; no marks, no edges, no deformation. */
async function plainColours(page, range = null) {
  for (const key of ["x", "e", "0"]) await page.keyboard.press(key);
  await page.locator(".legend-outside summary").click();
  await page.getByLabel("colour of above").fill("#00ff00");
  await page.getByLabel("colour of below").fill("#0000ff");
  if (!range) return;
  for (const [end, value] of Object.entries(range)) {
    await page.getByLabel(`${end} end of the range`).fill(String(value));
    await page.keyboard.press("Enter");
  }
}

export const shaderTests = [
  {
    name: "shaders_show_no_value_beyond_the_range_where_one_value_is_the_end_of_it",
    async run({ browser, serveTiny }) {
      for (const [ball, ends] of [
        [160, { lower: 159.999, upper: 160 }],
        [0.1, { lower: 0.1, upper: 0.1000005 }],
      ]) {
        const { url, close } = await serveTiny({ cells: [120, 60, 60], ball });
        for (const smooth of [false, true]) {
          const { page, context } = await openPage(browser, url, { smooth });
          await plainColours(page, ends);
          for (const axis of ["+z", "-y"]) {
            await viewFrom(page, axis);
            assert.deepEqual(await beyond(page), { above: 0, below: 0 }, `${ball} ${smooth} ${axis}`);
          }
          await context.close();
        }
        await close();
      }
    },
  },
  {
    name: "shaders_take_no_value_from_beyond_a_triangle_at_its_silhouette",
    async run({ browser, serveTiny }) {
      // The stress is largest along the upper and the lower edge of the end of the bar, and falls steeply from there.
      const { url, close } = await serveTiny({ cells: [12, 4, 3] });
      const { page, context } = await openPage(browser, url, { smooth: true });
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      await plainColours(page);
      assert.deepEqual(await beyond(page), { above: 0, below: 0 }, "aslant");
      for (const axis of ["-x", "-y", "+z"]) {
        await viewFrom(page, axis);
        assert.deepEqual(await beyond(page), { above: 0, below: 0 }, axis);
      }
      // The same model with a range that leaves values out has both colours.
      await page.getByLabel("upper end of the range").fill("200");
      await page.keyboard.press("Enter");
      await page.getByLabel("lower end of the range").fill("60");
      await page.keyboard.press("Enter");
      await viewFrom(page, "-y");
      const seen = await beyond(page);
      assert.ok(seen.above > 1000 && seen.below > 1000, JSON.stringify(seen));
      await context.close();
      await close();
    },
  },
  {
    name: "shaders_leave_no_slab_between_two_planes_to_be_seen_through",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2 });
      const { page, context } = await openPage(browser, url);
      for (const key of ["x", "e", "0"]) await page.keyboard.press(key);
      await viewFrom(page, "+x");
      const section = await unfold(page, "cuts");
      // Ten millimetres of the bars' middle are left: seen from their end no skin lies in between.
      for (const [plane, offset] of [
        [1, 65],
        [2, 55],
      ]) {
        await section.getByRole("button", { name: "Add a plane" }).click();
        await section.getByLabel(`normal of plane ${plane}`).fill("1 0 0");
        await page.keyboard.press("Enter");
        await section.getByLabel(`place of plane ${plane}, typed`).fill(String(offset));
        await page.keyboard.press("Enter");
      }
      await section.getByLabel("other side of plane 2").click();
      const { cuts } = await until(page, state, (s) => s.cuts[1]?.normal[0] === -1, "the slab");
      assert.deepEqual(
        cuts.map((cut) => cut.offset),
        [65, -55],
      );
      await page.mouse.move(5, 5);
      const colourAt = async (dx, dy) => {
        await settled(page);
        const { x, y } = await middle(page, dx, dy);
        return pixelOf(page, await page.screenshot(), x, y);
      };
      const isMaterial = ([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b) < 12 && g > 110 && g < 185;
      const near = await colourAt(-60, 8);
      assert.ok(isMaterial(near), `the first bar is filled, not ${near}`);
      const gap = await colourAt(0, 38);
      assert.ok(!isMaterial(gap), `between the bars there is nothing to fill, not ${gap}`);
      const { x, y } = await middle(page, -60, 8);
      await page.mouse.move(x, y);
      await until(
        page,
        () => document.querySelector(".card.inside")?.textContent ?? "",
        (t) => t.includes("no value"),
        "the words",
      );
      assert.equal(await page.evaluate(probe), null);
      await page.mouse.move(5, 5);
      // A hidden bar leaves no cap.
      await (await unfold(page, "parts")).getByLabel("show bar", { exact: true }).click();
      const hidden = await colourAt(-60, 8);
      assert.ok(!isMaterial(hidden), `a hidden bar is not filled, not ${hidden}`);
      assert.deepEqual(hidden, gap);
      await context.close();
      await close();
    },
  },
];
