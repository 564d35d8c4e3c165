// SPDX-License-Identifier: Apache-2.0
// Looking at the model: parts, hot spots, limits, sections, notes. Everything by its values and by what is drawn.
import assert from "node:assert/strict";
import { openPage, pixelOf, pixelsOf, until } from "./harness.mjs";
import { readScene } from "./oracle.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();

export async function unfold(page, id) {
  const section = page.locator(`details[data-section='${id}']`);
  if (!(await section.evaluate((e) => e.open))) await section.locator("summary").click();
  return section;
}

/** Gives the ids of the sections. */
export async function unfoldAll(page) {
  const ids = await page
    .locator("details[data-section]")
    .evaluateAll((all) => all.map((d) => d.dataset.section));
  for (const id of ids) await unfold(page, id);
  return ids;
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
    name: "parts_that_are_hidden_have_no_ghost",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ bars: 2 });
      const { page, context } = await openPage(browser, url);
      for (const key of ["x", "e", "f"]) await page.keyboard.press(key);
      // From +z the first bar lies to the lower left, and there alone.
      await viewFrom(page, "+z");
      await page.mouse.move(5, 5);
      const section = await unfold(page, "parts");
      const { x, y } = await middle(page, -175, 0);
      const points = [...Array(185 * 100).keys()].map((k) => [x + (k % 185), y + Math.floor(k / 185)]);
      const others = points.slice(0, 9000).map((_, k) => [x + 245 + (k % 110), y - 60 + Math.floor(k / 110)]);
      const picture = async (ghost) => {
        await page.locator(".area-stage canvas").focus();
        if ((await page.evaluate(state)).ghost !== ghost) await page.keyboard.press("u");
        await until(page, state, (s) => s.ghost === ghost, "the ghost");
        await page.waitForTimeout(200);
        const png = await page.screenshot();
        return [await pixelsOf(page, png, points), await pixelsOf(page, png, others)].map((list) =>
          list.map(String),
        );
      };
      const drawnByGhost = async () => {
        const [with_, without] = [await picture(true), await picture(false)];
        return with_.map((list, k) => list.filter((colour, i) => colour !== without[k][i]).length);
      };
      const [first, second] = await drawnByGhost();
      assert.ok(first > 40 && second > 40, `${first} and ${second}`);
      await section.getByLabel("show bar", { exact: true }).click();
      const [gone, left] = await drawnByGhost();
      assert.equal(gone, 0);
      assert.equal(left, second);
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
    name: "a_typed_limit_is_drawn_on_model_and_legend_and_said_on_the_card",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const section = await unfold(page, "limits");
      await section.getByLabel("limit of Temperature").fill("80");
      await page.keyboard.press("Enter");
      const { limits } = await until(page, state, (s) => s.limits.some((l) => l.key === "T"), "the limit");
      assert.deepEqual(
        limits.find((l) => l.key === "T"),
        { key: "T", value: 80, kind: "above", used: 160 / 80 },
      );
      assert.ok((await page.locator(".legend-labels .limit").textContent()).includes("80"));
      for (const key of ["x", "e"]) await page.keyboard.press(key);
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      await page.mouse.move(x, y);
      const here = await until(page, probe, (r) => r !== null, "the bar");
      const read = (r) => r.results.find((e) => e.key === "T");
      assert.equal(read(here).utilisation, read(here).value / 80);
      // Move to where the value is the limit: there the line is black.
      await page.mouse.move(x + 20, y);
      const there = await until(page, probe, (r) => r !== null, "the bar further on");
      const slope = (read(there).value - read(here).value) / 20;
      const at = x + (80 - read(here).value) / slope;
      await page.mouse.move(5, 5);
      await page.waitForTimeout(300);
      const png = await page.screenshot();
      const seen = [];
      for (const dx of [-2, -1, 0, 1, 2]) seen.push(await pixelOf(page, png, at + dx, y));
      const darkest = Math.min(...seen.map(([r, g, b]) => r + g + b));
      assert.ok(darkest < 120, `no line among ${JSON.stringify(seen)}`);
      await section.getByLabel("limit of Temperature").fill("");
      await page.keyboard.press("Enter");
      await until(page, state, (s) => s.limits.every((l) => l.key !== "T"), "no limit");
      await context.close();
    },
  },
  {
    name: "range_is_held_over_steps_and_lines_stand_between_bands",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const ends = () =>
        ["lower", "upper"].map(
          (e) => document.querySelector(`input[aria-label='${e} end of the range']`).value,
        );
      await page.keyboard.press("r");
      await page.keyboard.press(".");
      await until(page, state, (s) => s.step === 2, "the second step");
      await page.waitForTimeout(200);
      assert.deepEqual(await page.evaluate(ends), ["20", "160"]);
      await page.keyboard.press("r");
      await until(page, ends, (e) => e[0] === "50" && e[1] === "190", "the step's own range");
      const colour = (s) => s.presentation.effects.find((e) => e.type === "colour");
      await page.keyboard.press("o");
      await until(page, state, (s) => colour(s).isolines === true, "lines");
      await page.locator(".legend-outside summary").click();
      await page.getByLabel("colour of above").fill("#00ff00");
      await until(page, state, (s) => colour(s).above === "#00ff00", "another colour above");
      await context.close();
    },
  },
  {
    name: "a_plane_opens_the_solid_hatched_and_says_that_there_are_no_values_inside",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      for (const key of ["x", "e", "0"]) await page.keyboard.press(key);
      await viewFrom(page, "+x");
      const { x, y } = await middle(page);
      await page.mouse.move(x, y);
      const end = await until(page, probe, (r) => r !== null, "the end of the bar");
      assert.ok(Math.abs(end.point[0] - 120) < 1e-3);
      const coloured = await pixelOf(page, await page.screenshot(), x + 12, y);
      await page.keyboard.press("c");
      const { cuts } = await until(page, state, (s) => s.cuts.length === 1, "a plane");
      assert.deepEqual(cuts[0], { normal: [1, 0, 0], offset: 60, on: true });
      await page.mouse.move(x + 1, y);
      await until(page, probe, (r) => r === null, "no place");
      const said = await page.locator(".card.inside").textContent();
      assert.ok(said.includes("no value"), said);
      await page.mouse.move(5, 5);
      await page.waitForTimeout(200);
      const [r, g, b] = await pixelOf(page, await page.screenshot(), x + 12, y);
      assert.ok(Math.max(r, g, b) - Math.min(r, g, b) < 12, `the cap is plain, not ${[r, g, b]}`);
      assert.notDeepEqual([r, g, b], coloured);
      // The other side: the ray meets the bar's near end again.
      const section = await unfold(page, "cuts");
      await section.getByLabel("other side of plane 1").click();
      // Beside the plane's knob.
      await page.mouse.move(x + 18, y);
      const again = await until(page, probe, (p) => p !== null, "the end of the bar again");
      assert.ok(again.point[0] > 60);
      await context.close();
    },
  },
  {
    name: "a_plane_is_typed_stepped_and_dragged",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      await viewFrom(page, "-y");
      await page.keyboard.press("c");
      const section = await unfold(page, "cuts");
      await section.getByLabel("place of plane 1, typed").fill("90");
      await page.keyboard.press("Enter");
      const offset = (s) => s.cuts[0].offset;
      await until(page, state, (s) => offset(s) === 90, "the typed place");
      await page.locator(".area-stage canvas").focus();
      await page.keyboard.press("]");
      await until(page, state, (s) => Math.abs(offset(s) - 91.2) < 1e-9, "one percent further");
      // The knob stands where the last picture has it: let the one with this step be drawn.
      await page.evaluate(
        () => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))),
      );
      const knob = await page.locator("[data-handle='cut-0']").boundingBox();
      const [kx, ky] = [knob.x + knob.width / 2, knob.y + knob.height / 2];
      await page.mouse.move(kx, ky);
      await page.mouse.down();
      await page.mouse.move(kx - 40, ky, { steps: 4 });
      await page.mouse.up();
      // The plane and its knob follow with the next picture.
      await until(page, state, (s) => offset(s) < 85 && offset(s) > 20, "the plane dragged");
      const left = () => document.querySelector("[data-handle='cut-0']").getBoundingClientRect().x;
      await until(page, left, (x) => Math.abs(knob.x - x - 40) < 2, "the knob that follows the hand");
      await section.getByLabel("normal of plane 1").fill("0 3 4");
      await page.keyboard.press("Enter");
      const { cuts } = await page.evaluate(state);
      assert.deepEqual(cuts[0].normal, [0, 0.6, 0.8]);
      await context.close();
    },
  },
  {
    name: "two_hundred_parts_are_drawn_in_a_few_calls",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ bars: 200, cells: [2, 1, 1] });
      assert.equal(readScene(bytes).parts.length, 200);
      const { page, context, problems } = await openPage(browser, url);
      const calls = await page.evaluate(
        () =>
          new Promise((resolve) => {
            const names = ["drawElements", "drawArrays"];
            const { prototype } = WebGL2RenderingContext;
            let count = 0;
            const frame = () => {
              if (count > 0) resolve(count);
              else requestAnimationFrame(frame);
            };
            for (const name of names) {
              const draw = prototype[name];
              prototype[name] = function (...given) {
                count += 1;
                return draw.apply(this, given);
              };
            }
            window.dispatchEvent(new KeyboardEvent("keydown", { key: "e" }));
            setTimeout(() => requestAnimationFrame(frame), 300);
          }),
      );
      assert.ok(calls >= 1 && calls <= 6, `${calls} draw calls`);
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "another_result_sends_its_values_to_the_card_and_no_geometry",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ cells: [60, 20, 15] });
      const vertices = readScene(bytes).parts[0].nodeIds.length;
      const { page, context } = await openPage(browser, url);
      await page.evaluate(() => {
        globalThis.sent = 0;
        const { prototype } = WebGL2RenderingContext;
        for (const name of ["bufferData", "bufferSubData"]) {
          const send = prototype[name];
          prototype[name] = function (...given) {
            globalThis.sent += given.find((g) => ArrayBuffer.isView(g))?.byteLength ?? 0;
            return send.apply(this, given);
          };
        }
      });
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      // Two numbers a vertex: the value, and whether it is missing.
      await until(
        page,
        () => globalThis.sent,
        (n) => n >= 8 * vertices,
        "the values",
      );
      await page.waitForTimeout(300);
      assert.equal(await page.evaluate(() => globalThis.sent), 8 * vertices);
      await page.evaluate(() => {
        globalThis.sent = 0;
      });
      for (const key of ["c", "]", "o", "r", "l"]) await page.keyboard.press(key);
      await page.waitForTimeout(400);
      // The square that the plane is filled with: four places and six corners, once.
      assert.equal(await page.evaluate(() => globalThis.sent), 4 * 12 + 6 * 2);
      await context.close();
      await close();
    },
  },
];
