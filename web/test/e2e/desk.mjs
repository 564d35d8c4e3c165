// SPDX-License-Identifier: Apache-2.0
// The page at a desk: values, colours, legend, steps, keys, sound without pulses.
import assert from "node:assert/strict";
import { HEARD, listen, openPage, pixelOf, until } from "./harness.mjs";
import { readScene, resultIdOf, valueAtNode, valueAtPoint } from "./oracle.mjs";

const probe = () => window.feelem.lastProbe();
const nearly = (a, b, slack) => assert.ok(Math.abs(a - b) <= slack, `${a} is not within ${slack} of ${b}`);

async function stageBox(page) {
  return page.locator(".area-stage canvas").boundingBox();
}

/** Sweeps the pointer over the stage and returns what was probed at places on the model. */
async function sweep(page, count) {
  const box = await stageBox(page);
  const found = [];
  for (let i = 0; i < count * 4 && found.length < count; ++i) {
    const x = Math.round(box.x + box.width * (0.25 + 0.5 * ((i * 0.618) % 1)));
    const y = Math.round(box.y + box.height * (0.3 + 0.4 * ((i * 0.414) % 1)));
    await page.mouse.move(x, y);
    const report = await page.evaluate(probe);
    if (report) found.push({ x, y, report });
  }
  assert.ok(found.length >= count, `only ${found.length} places on the model`);
  return found;
}

const channels = (hex) => [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16));

export const deskTests = [
  {
    name: "hover_gives_the_barycentric_value_and_the_files_value_at_the_node",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const { step } = await page.evaluate(() => window.feelem.state());
      let checked = 0;
      for (const { report } of await sweep(page, 12)) {
        for (const entry of report.results) {
          const id = resultIdOf(scene, entry);
          const wanted = valueAtPoint(scene, id, step, report.elementId, report.point);
          assert.equal(
            entry.value === null,
            wanted.value === null,
            `${id} is missing in one and not in the other`,
          );
          if (entry.value !== null) nearly(entry.value, wanted.value, 1e-5 * (1 + Math.abs(wanted.value)));
          assert.equal(entry.nodeValue, valueAtNode(scene, id, step, report.nodeId));
          const corner = wanted.weights.indexOf(Math.max(...wanted.weights));
          const nodes = scene.parts[0].nodeIds;
          if (scene.parts.length === 1 && nodes[wanted.corners[corner]] !== 0)
            assert.equal(report.nodeId, nodes[wanted.corners[corner]]);
          checked += 1;
        }
      }
      assert.ok(checked >= 24);
      await context.close();
    },
  },
  {
    name: "colour_under_the_pointer_equals_the_legend_at_that_value",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      await page.keyboard.press("x");
      await page.keyboard.press("e");
      for (const bands of ["9", "0"]) {
        await page.fill("input[aria-label^='number of bands']", bands);
        await page.keyboard.press("Enter");
        let compared = 0;
        for (const { x, y } of await sweep(page, 8)) {
          // The pointer stands still while the picture is taken: its ring is open in the middle.
          await page.mouse.move(x, y);
          await page.waitForTimeout(120);
          const report = await page.evaluate(probe);
          if (!report) continue;
          const drawn = await pixelOf(page, await page.screenshot(), x, y);
          const value = report.results.find((r) => r.key === report.results[0].key).value;
          const legend = await page.evaluate((value) => {
            const canvas = document.querySelector(".legend-canvas");
            const read = (label) =>
              Number(document.querySelector(`input[aria-label='${label} end of the range']`).value);
            const [lo, hi] = [read("lower"), read("upper")];
            const row = Math.min(
              Math.max(Math.floor((1 - (value - lo) / (hi - lo)) * canvas.height), 0),
              canvas.height - 1,
            );
            return [...canvas.getContext("2d").getImageData(5, row, 1, 1).data].slice(0, 3);
          }, value);
          const said = channels(report.colour);
          const apart = (a, b) => Math.max(...a.map((v, i) => Math.abs(v - b[i])));
          // Next to the edge of a band one pixel may fall on either side; there the three may differ by one band.
          const near = bands === "9" && (await nearBandEdge(page, value));
          if (near) continue;
          assert.ok(apart(drawn, said) <= 2, `drawn ${drawn}, said ${said} for ${value}`);
          assert.ok(apart(legend, said) <= 2, `legend ${legend}, said ${said} for ${value}`);
          compared += 1;
        }
        assert.ok(compared >= 5, `compared only ${compared}`);
      }
      await context.close();
    },
  },
  {
    name: "press_on_the_model_sounds_at_the_formulas_pitch_and_release_silences",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const places = await sweep(page, 6);
      const tones = places.filter(({ report }) => report.hz > 0);
      assert.ok(tones.length >= 3);
      for (const { x, y } of tones.slice(0, 3)) {
        await page.mouse.move(x, y);
        await page.mouse.down();
        const { hz } = await page.evaluate(probe);
        const heard = await until(
          page,
          listen,
          (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01,
          `a tone of ${hz} Hz`,
        );
        nearly(heard.hz, hz, 0.01 * hz);
        await page.mouse.up();
        await until(page, listen, (h) => h.level < 1e-4, "silence after the release");
      }
      await context.close();
    },
  },
  {
    name: "mouse_never_pulses_and_ticks_stand_in",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const [{ x, y }] = (await sweep(page, 8)).filter(({ report }) => report.pulse.rate > 0);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.waitForTimeout(600);
      const report = await page.evaluate(probe);
      assert.deepEqual(await page.evaluate(() => window.feelem.pulses()), []);
      assert.ok(report.tickRate >= 1.5 && report.tickRate <= 12);
      await page.mouse.up();
      await context.close();
    },
  },
  {
    name: "key_s_holds_and_blur_silences",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const [{ x, y }] = (await sweep(page, 6)).filter(({ report }) => report.hz > 0);
      await page.mouse.move(x, y);
      await page.keyboard.down("s");
      await until(page, listen, (h) => h.level > HEARD, "sound while S is held");
      await page.evaluate(() => window.dispatchEvent(new Event("blur")));
      await until(page, listen, (h) => h.level < 1e-4, "silence after blur");
      await page.keyboard.up("s");
      await context.close();
    },
  },
  {
    name: "assignment_table_moves_a_result_to_another_sense",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const before = await page.evaluate(() => window.feelem.state().presentation);
      const other = before.results.find(
        (r) => r.key !== before.effects.find((e) => e.type === "colour").result,
      );
      await page.click(`tr[data-key='${other.key}'] button[data-slot='colour']`);
      const { presentation } = await page.evaluate(() => window.feelem.state());
      assert.equal(presentation.effects.find((e) => e.type === "colour").result, other.key);
      assert.equal(presentation.effects.filter((e) => e.type === "colour").length, 1);
      await page.click(`tr[data-key='${other.key}'] button[data-slot='off']`);
      const off = await page.evaluate(() => window.feelem.state().presentation);
      assert.ok(off.effects.every((e) => e.result !== other.key));
      await context.close();
    },
  },
  {
    name: "typed_range_bands_and_factor_are_obeyed",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const type = async (label, text) => {
        await page.fill(`input[aria-label='${label}']`, text);
        await page.keyboard.press("Enter");
      };
      await type("lower end of the range", "50");
      await type("upper end of the range", "100");
      await type("number of bands, 0 for smooth", "5");
      await type("deformation factor", "12.5");
      const state = await page.evaluate(() => window.feelem.state());
      const colour = state.presentation.effects.find((e) => e.type === "colour");
      const { range } = state.presentation.results.find((r) => r.key === colour.result);
      assert.deepEqual(
        [range.lo, range.hi, range.mode, colour.bands, state.deformationFactor],
        [50, 100, "manual", 5, 12.5],
      );
      await page.click(".segments button:has-text('true scale')");
      assert.equal((await page.evaluate(() => window.feelem.state())).deformationFactor, 1);
      const labels = await page.locator(".legend-labels li").allTextContents();
      assert.deepEqual(labels.map(Number), [50, 60, 70, 80, 90, 100]);
      await context.close();
    },
  },
  {
    name: "going_to_a_node_shows_the_files_value_there",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const { step } = await page.evaluate(() => window.feelem.state());
      const ids = scene.parts[0].nodeIds.filter((id) => id > 0);
      for (const id of [ids[0], ids[Math.floor(ids.length / 2)], ids.at(-1)]) {
        await page.selectOption(".goto select", "node");
        await page.fill(".goto input", String(id));
        await page.keyboard.press("Enter");
        const report = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
        for (const entry of report.results) {
          const wanted = valueAtNode(scene, resultIdOf(scene, entry), step, id);
          assert.equal(entry.nodeValue, wanted);
          if (entry.value !== null) assert.equal(entry.value, wanted);
        }
      }
      await context.close();
    },
  },
  {
    name: "markers_stand_for_the_scenes_extremes",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const { step, presentation } = await page.evaluate(() => window.feelem.state());
      const colour = presentation.effects.find((e) => e.type === "colour");
      const entry = presentation.results.find((r) => r.key === colour.result);
      const values = scene.extras.results
        .find((r) => r.id === resultIdOf(scene, entry))
        .values.find((v) => v.step === step);
      const text = (await page.locator(".markers").textContent()) ?? "";
      assert.ok(text.includes(`node ${values.max.node}`) && text.includes("MX"), text);
      assert.ok(text.includes(`node ${values.min.node}`) && text.includes("MN"), text);
      await context.close();
    },
  },
  {
    name: "nothing_is_asked_from_another_origin_and_nothing_fails",
    async run({ browser, url }) {
      const { page, context, foreign, problems } = await openPage(browser, url);
      await sweep(page, 3);
      for (const key of [".", " ", " ", "l", "e", "f", "1", "0", "5", "t"]) await page.keyboard.press(key);
      await page.waitForTimeout(300);
      assert.deepEqual(foreign, []);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "large_model_is_pointed_at_through_a_worker_and_deforms",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ cells: [115, 115, 32] });
      const scene = readScene(bytes);
      assert.ok(scene.parts[0].elements.length > 150_000);
      const { page, context, foreign, problems } = await openPage(browser, url, { width: 320, height: 240 });
      await page.setViewportSize({ width: 900, height: 620 });
      await page.click(".segments button:has-text('true scale')");
      for (const { report } of await sweep(page, 3)) {
        const [entry] = report.results;
        const wanted = valueAtPoint(scene, resultIdOf(scene, entry), 1, report.elementId, report.point);
        nearly(entry.value, wanted.value, 1e-4 * Math.abs(wanted.value));
      }
      assert.deepEqual([foreign, problems], [[], []]);
      await context.close();
      await close();
    },
  },
  {
    name: "steps_come_from_side_files_and_a_lost_one_is_said",
    async run({ browser, serveTiny }) {
      const { url, bytes, files, close } = await serveTiny({ sideFiles: true });
      const { page, context } = await openPage(browser, url);
      const id = readScene(bytes).parts[0].nodeIds.find((n) => n > 0);
      await page.fill(".goto input", String(id));
      await page.keyboard.press("Enter");
      const first = await until(page, probe, (r) => r?.nodeId === id, "the node");
      files.delete("tiny.d/stress_von_mises.2.bin");
      await page.locator(".stepbar").getByLabel("next step").click();
      const read = (r) => r?.results.find((e) => e.key === "T").value;
      await until(
        page,
        probe,
        (r) => read(r) === Math.fround(read(first) + 30),
        "the next step's temperature",
      );
      const said = await until(
        page,
        () => document.querySelector(".banner")?.textContent ?? "",
        (t) => t !== "",
        "a word",
      );
      assert.ok(said.includes("tiny.d/stress_von_mises.2.bin"), said);
      const lost = await page.evaluate(probe);
      assert.equal(lost.results.find((e) => e.key === "S").state, "missing");
      assert.equal((await page.evaluate(() => window.feelem.state())).step, 2);
      await context.close();
      await close();
    },
  },
  {
    name: "missing_value_is_said_drawn_grey_and_silent",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      await page.click("tr[data-key='S'] button[data-slot='pitch']");
      const { positions, nodeIds } = scene.parts[0];
      const id = nodeIds.find((n, i) => n > 0 && positions[3 * i] === 120 && positions[3 * i + 2] === 30);
      await page.fill(".goto input", String(id));
      await page.keyboard.press("Enter");
      const report = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
      const entry = report.results.find((e) => e.key === "S");
      assert.deepEqual([entry.value, entry.nodeValue, entry.state], [null, null, "missing"]);
      assert.deepEqual([report.colour, report.hz, report.gain], ["#808080", 0, 0]);
      // The card is drawn with the next frame.
      await until(
        page,
        () => document.querySelector(".card").textContent,
        (t) => t.includes("no value"),
        "the word",
      );
      await context.close();
    },
  },
  {
    name: "mode_swings_while_played_and_comes_to_rest",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      await page.locator(".stepbar").getByLabel("next step").click();
      await page.waitForTimeout(300);
      await page.locator(".area-stage canvas").focus();
      await page.mouse.move(5, 5);
      await page.waitForTimeout(300);
      const still = (await page.screenshot()).toString("base64");
      await page.locator(".stepbar").getByLabel("play").click();
      await page.waitForTimeout(1200);
      assert.notEqual((await page.screenshot()).toString("base64"), still, "the model moves");
      assert.equal((await page.evaluate(() => window.feelem.state())).step, 2);
      await page.locator(".stepbar").getByLabel("pause").click();
      await page.locator(".area-stage canvas").focus();
      await page.mouse.move(5, 5);
      await page.waitForTimeout(600);
      assert.equal((await page.screenshot()).toString("base64"), still, "the model is back at rest");
      await context.close();
    },
  },
  {
    name: "arrow_keys_walk_from_node_to_node",
    async run({ browser, url, scene }) {
      const { page, context } = await openPage(browser, url);
      const { positions, nodeIds } = scene.parts[0];
      const at = (x, y, z) =>
        nodeIds.find((n, i) => n > 0 && [x, y, z].every((c, k) => Math.abs(positions[3 * i + k] - c) < 1e-3));
      const start = at(50, 20, 30);
      await page.fill(".goto input", String(start));
      await page.keyboard.press("Enter");
      await until(page, probe, (r) => r?.nodeId === start, "the first node");
      await page.click("h1");
      await page.locator(".area-stage canvas").focus();
      await page.keyboard.press("ArrowRight");
      const next = await until(page, probe, (r) => r && r.nodeId !== start, "its neighbour");
      assert.equal(next.nodeId, at(60, 20, 30));
      await page.keyboard.press("ArrowLeft");
      await until(page, probe, (r) => r?.nodeId === start, "the way back");
      await page.keyboard.down("s");
      await until(page, listen, (h) => h.level > HEARD, "the pinned node is heard");
      await page.keyboard.up("s");
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      await context.close();
    },
  },
  {
    name: "page_says_when_there_is_no_scene_or_not_one_of_ours",
    async run({ browser, serveTiny }) {
      for (const [bytes, word] of [
        [null, "404"],
        [new TextEncoder().encode("solid ascii"), "not a scene"],
        [new TextEncoder().encode("{}{}{}{}{}{}"), "JSON"],
        [new TextEncoder().encode('{"asset":{"version":"2.0"}}'), "not a Feelem scene"],
      ]) {
        const { url, files, close } = await serveTiny({});
        if (bytes) files.set("scene.glb", bytes);
        else files.delete("scene.glb");
        const page = await browser.newPage();
        await page.goto(url);
        const reason = await page.evaluate(() =>
          window.feelem.ready.then(
            () => "",
            (error) => error.message,
          ),
        );
        assert.ok(reason.includes(word), reason);
        assert.ok((await page.locator(".banner").textContent()).includes(word));
        assert.equal(await page.evaluate(() => window.feelem.scene()), null);
        await page.close();
        await close();
      }
    },
  },
  {
    name: "page_api_is_read_only",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const kept = await page.evaluate(() => {
        const state = window.feelem.state();
        state.presentation.title = "changed";
        try {
          window.feelem = null;
        } catch {
          // Refused: right.
        }
        return window.feelem.state().presentation.title !== "changed" && Object.isFrozen(window.feelem);
      });
      assert.ok(kept);
      await context.close();
    },
  },
];

async function nearBandEdge(page, value) {
  return page.evaluate((value) => {
    const read = (label) =>
      Number(document.querySelector(`input[aria-label='${label} end of the range']`).value);
    const [lo, hi] = [read("lower"), read("upper")];
    const t = (9 * (value - lo)) / (hi - lo);
    return Math.abs(t - Math.round(t)) < 0.06;
  }, value);
}
