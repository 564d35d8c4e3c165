// SPDX-License-Identifier: Apache-2.0
// Levels of detail on the page: which one is drawn, what is said of it, and that nothing that is read comes from it.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { probeNode, ROOT, whyNoScene, workshop } from "./binary.mjs";
import { openPage, until } from "./harness.mjs";
import { middle } from "./look.mjs";
import { readScene, resultIdOf, valueAtNode } from "./oracle.mjs";
import { aim, aimAtNode, enter } from "./vr-hands.mjs";
import { watchPage } from "./watch-page.mjs";

const BOILER = `${ROOT}examples/boiler/hex_linear/static.frd`;
const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const drawn = (level) => (s) => s.levels.drawn === level;
const WORDS = /^drawn with values within ±1 % \(±[0-9.]+\)$/;

/** A wavy sheet of so many quads along each side, with a temperature and a pressure. */
function sheetFile(folder, side) {
  const all = Array.from({ length: (side + 1) ** 2 }, (_, k) => [k % (side + 1), Math.floor(k / (side + 1))]);
  const quads = Array.from({ length: side ** 2 }, (_, k) => {
    const a = (k % side) + (side + 1) * Math.floor(k / side);
    return `4 ${a} ${a + 1} ${a + side + 2} ${a + side + 1}`;
  });
  const scalars = (name, of) => [
    `SCALARS ${name} float 1`,
    "LOOKUP_TABLE default",
    ...all.map(([i, j]) => of(i / side, j / side).toFixed(4)),
  ];
  const lines = [
    "# vtk DataFile Version 3.0\nsheet\nASCII\nDATASET UNSTRUCTURED_GRID",
    `POINTS ${all.length} float`,
    ...all.map(([i, j]) => `${i} ${j} ${(6 * Math.sin(i / 40) * Math.cos(j / 50)).toFixed(4)}`),
    `CELLS ${quads.length} ${5 * quads.length}`,
    ...quads,
    `CELL_TYPES ${quads.length}`,
    ...quads.map(() => "9"),
    `POINT_DATA ${all.length}`,
    ...scalars("temperature", (x, y) => 20 + 80 * x + 30 * Math.sin(40 * y) * Math.cos(50 * x)),
    ...scalars("pressure", (x, y) => 5 * Math.sin(13 * x + 6 * y)),
  ];
  const file = join(folder, "sheet.vtk");
  writeFileSync(file, `${lines.join("\n")}\n`);
  return file;
}

/**
 * A clock for the page's frames and the headset's: each is globalThis.frameMs after the last, however long it took to draw. Before
 * the page's own scripts.
 */
function frameClock() {
  globalThis.frameMs = 10;
  const counted = (request) => {
    let [now, last] = [0, 0];
    return function (act) {
      return request.call(this, (time, ...rest) => {
        // All that ask for one frame are told the same.
        if (time !== last) now += globalThis.frameMs;
        last = time;
        act(now, ...rest);
      });
    };
  };
  window.requestAnimationFrame = counted(window.requestAnimationFrame.bind(window));
  Object.defineProperty(globalThis, "XRSession", {
    configurable: true,
    set(made) {
      made.prototype.requestAnimationFrame = counted(made.prototype.requestAnimationFrame);
      Object.defineProperty(globalThis, "XRSession", { configurable: true, writable: true, value: made });
    },
  });
  globalThis.cornersDrawn = 0;
  const draw = WebGL2RenderingContext.prototype.drawElements;
  WebGL2RenderingContext.prototype.drawElements = function (mode, count, ...rest) {
    if (mode === this.TRIANGLES && count > 1000) globalThis.cornersDrawn = count;
    return draw.call(this, mode, count, ...rest);
  };
}

/** The pointer goes to and fro, a move a frame, until the governor and the level are as wanted for some frames. */
function moveUntil(page, places, wanted) {
  return page.evaluate(
    ({ places, least, most, drawn }) =>
      new Promise((resolve, reject) => {
        const canvas = document.querySelector(".area-stage canvas");
        const seen = new Map();
        let left = 600;
        let held = 0;
        const next = () => {
          const { governor, levels } = window.feelem.state();
          held = governor.level >= least && governor.level <= most && levels.drawn === drawn ? held + 1 : 0;
          const report = window.feelem.lastProbe();
          if (held > 1 && report) seen.set(report.nodeId, report);
          const words = document.querySelector(".legend-level").innerText;
          if (held === 8)
            return resolve({
              governor,
              levels,
              words,
              corners: globalThis.cornersDrawn,
              seen: [...seen.values()],
            });
          left -= 1;
          if (left < 0)
            return reject(new Error(`did not come: ${JSON.stringify([governor, levels, drawn])}`));
          const [clientX, clientY] = places[left % places.length];
          const at = { clientX, clientY, bubbles: true, pointerType: "mouse", pointerId: 1 };
          canvas.dispatchEvent(new PointerEvent("pointermove", at));
          requestAnimationFrame(next);
        };
        requestAnimationFrame(next);
      }),
    { places, ...wanted },
  );
}

/** The words on the legend are what the scene states, rounded up. */
function assertWords(words, level, result, unit) {
  const [, share, bound, ofUnit] =
    /^drawn with values within ±(\S+) % \(±([0-9.e-]+)( .+)?\)$/.exec(words) ?? [];
  const stated = level.values.find((v) => v.result === result).bound;
  for (const [said, meant] of [
    [share, 100 * level.bound],
    [bound, stated],
  ])
    assert.ok(
      Number(said) >= meant * 0.999999 && Number(said) < 1.1 * meant,
      `${words}: ${said} for ${meant}`,
    );
  assert.equal(ofUnit?.trim() ?? "", unit);
}

export const lodTests = [
  {
    name: "lod_level_is_not_drawn_of_a_result_or_shape_for_which_it_has_no_bound",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ levels: "of temperature" });
      const { page, context, problems } = await openPage(browser, url, { query: "triangles=100" });
      await until(page, state, drawn(1), "the level of the temperature");
      await page.click("tr[data-key='S'] button[data-slot='colour']");
      const { levels } = await until(page, state, drawn(0), "all triangles of the stress");
      assert.equal(levels.text, "");
      const words = () => document.querySelector(".legend-level").innerText;
      await until(page, words, (text) => text === "all triangles are drawn", "the words");
      await page.click("tr[data-key='T'] button[data-slot='colour']");
      await until(page, state, drawn(1), "the level again");
      await page.locator(".area-stage canvas").focus();
      // The shape of the second step has no bound; undeformed it needs none.
      await page.keyboard.press(".");
      await until(
        page,
        state,
        (s) => s.step === 2 && s.levels.drawn === 0,
        "all triangles of the other shape",
      );
      await page.keyboard.press("0");
      await until(page, state, (s) => s.step === 2 && s.levels.drawn === 1, "the level, undeformed");
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "lod_governor_takes_coarser_levels_while_frames_are_slow_and_all_triangles_when_they_are_quick",
    skip: whyNoScene(),
    async run({ browser }) {
      const shop = await workshop();
      try {
        // 705,600 triangles: more than either of the governor's two budgets.
        const file = shop.convert("sheet.glb", sheetFile(shop.folder, 420), "--length-unit", "mm");
        const scene = readScene(readFileSync(file));
        const [fine, coarse] = scene.extras.levels;
        assert.ok(fine.triangles <= 500_000 && coarse.triangles <= 125_000 && coarse.bound > fine.bound);
        const options = { width: 480, height: 300, before: frameClock, governed: true };
        const { page, context, problems } = await openPage(browser, await shop.show(file), options);
        for (const key of ["x", "e"]) await page.keyboard.press(key);
        const { x, y } = await middle(page);
        const places = [
          [x + 30, y + 12],
          [x - 25, y - 8],
        ];
        const quick = { least: 0, most: 0, drawn: 0 };
        const rest = await moveUntil(page, places, quick);
        assert.equal(rest.words, "all triangles are drawn");
        assert.equal(rest.corners, 3 * 705_600);
        assert.equal(rest.seen.length, 2);
        for (const report of rest.seen)
          for (const entry of report.results)
            assert.equal(entry.nodeValue, valueAtNode(scene, resultIdOf(scene, entry), 1, report.nodeId));

        const byNode = (reports) => [...reports].sort((a, b) => a.nodeId - b.nodeId);
        const pace = (ms) =>
          page.evaluate((given) => {
            globalThis.frameMs = given;
          }, ms);
        await pace(60);
        for (const [least, most, number, level] of [
          [1, 2, 1, fine],
          [3, 4, 2, coarse],
        ]) {
          const moved = await moveUntil(page, places, { least, most, drawn: number });
          assert.equal(moved.levels.triangles, level.triangles);
          assert.equal(moved.corners, 3 * level.triangles);
          assertWords(moved.words, level, "temperature", "");
          assert.deepEqual(byNode(moved.seen), byNode(rest.seen), `what is read at level ${number}`);
        }
        const { key } = scene.extras.presentation.results.find((r) => r.name === "pressure");
        const button = page.locator(`tr[data-key='${key}'] button[data-slot='colour']`);
        await button.evaluate((b) => b.click());
        const other = await moveUntil(page, places, { least: 3, most: 4, drawn: 2 });
        assertWords(other.words, coarse, "pressure", "");
        await until(page, state, (s) => !s.governor.moving && s.levels.drawn === 0, "all triangles at rest");
        await pace(10);
        const again = await moveUntil(page, places, quick);
        assert.equal(again.words, "all triangles are drawn");
        assert.equal(again.corners, 3 * 705_600);
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        await shop.end();
      }
    },
  },
  {
    name: "lod_headset_takes_the_level_while_frames_are_slow_and_all_triangles_when_they_are_quick",
    skip: whyNoScene(),
    async run({ browser }) {
      const shop = await workshop();
      try {
        // 160,000 triangles: no more than a headset has to draw, more than it does when it is slow.
        const file = shop.convert(
          "sheet.glb",
          sheetFile(shop.folder, 200),
          "--length-unit",
          "mm",
          "--lod",
          "60000",
        );
        const scene = readScene(readFileSync(file));
        const [level] = scene.extras.levels;
        const { page, context, problems } = await enter(browser, await shop.show(file), {
          before: frameClock,
          governed: true,
        });
        const fine = await until(
          page,
          state,
          (s) => s.governor.moving && s.levels.drawn === 0,
          "all triangles",
        );
        assert.ok(Math.abs(fine.governor.budgetMs - 1000 / 90) < 6, `${fine.governor.budgetMs} ms`);
        assert.equal(fine.levels.text, "");
        await aim(page, "right", [0, 1.5, -0.6], [0.05, 1, -1.2]);
        const wanted = await until(page, probe, (r) => r?.nodeId > 0, "a reading");
        for (const entry of wanted.results)
          assert.equal(entry.nodeValue, valueAtNode(scene, resultIdOf(scene, entry), 1, wanted.nodeId));
        await page.evaluate(() => {
          globalThis.frameMs = 30;
        });
        const slow = await until(page, state, (s) => s.levels.drawn === 1, "the level");
        assert.ok(slow.governor.level >= 3);
        assert.equal(slow.levels.triangles, level.triangles);
        assertWords(`drawn with ${slow.levels.text}`, level, "temperature", "");
        assert.deepEqual(await page.evaluate(probe), wanted);
        await page.evaluate(() => {
          globalThis.frameMs = 10;
        });
        const again = await until(page, state, (s) => s.governor.level === 0, "the finest again");
        assert.deepEqual([again.levels.drawn, again.levels.text], [0, ""]);
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        await shop.end();
      }
    },
  },
  {
    name: "lod_headset_draws_the_level_within_the_budget_and_reads_the_files_values",
    async run({ browser, serveTiny }) {
      const { url, bytes, close } = await serveTiny({ levels: true });
      const scene = readScene(bytes);
      const { page, context, problems } = await enter(browser, url, { query: "triangles=100" });
      const { levels } = await until(page, state, drawn(1), "the level");
      assert.equal(levels.triangles, 12);
      assert.match(levels.text, /values within ±2 % \(±0\.13 °C\)/);
      // Between the corners the level has no vertex at all.
      for (const [i, j, k] of [
        [6, 2, 3],
        [3, 1, 3],
      ]) {
        const id = await aimAtNode(page, "right", i, j, k);
        const report = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
        for (const entry of report.results) {
          const wanted = valueAtNode(scene, resultIdOf(scene, entry), 1, id);
          assert.equal(entry.nodeValue, wanted);
          assert.equal(entry.value, wanted, `${entry.name} at node ${id}`);
        }
      }
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "lod_of_a_small_scene_is_not_drawn_in_the_headset_without_need",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ levels: true });
      const { page, context } = await enter(browser, url);
      const { levels } = await page.evaluate(state);
      assert.deepEqual([levels.drawn, levels.of, levels.text], [0, 1, ""]);
      await context.close();
      await close();
    },
  },
  {
    name: "lod_of_the_boiler_says_its_bound_and_the_page_reads_what_probe_prints",
    skip: whyNoScene("examples/boiler/hex_linear/static.frd"),
    async run({ browser }) {
      const shop = await workshop();
      try {
        const file = shop.convert("boiler.glb", BOILER, "--length-unit", "mm", "--lod", "1%");
        const url = await shop.show(file);
        const options = { before: watchPage, query: "triangles=6000" };
        const { page, context, problems } = await openPage(browser, url, options);
        const { levels } = await until(page, state, drawn(1), "the level");
        assert.ok(levels.triangles < 6000);
        assert.match(await page.locator(".legend-level").innerText(), WORDS);
        const { x, y } = await middle(page);
        for (const [dx, dy] of [
          [0, 0],
          [-12, 30],
          [10, -25],
        ]) {
          await page.mouse.move(x + dx, y + dy);
          const report = await until(page, probe, (r) => r?.nodeId > 0, "a reading");
          const printed = probeNode(file, report.nodeId)[0].results;
          for (const entry of report.results) {
            const wanted = printed.find((r) => r.key === entry.key);
            assert.equal(
              entry.nodeValue,
              wanted.node_value ?? wanted.value,
              `${entry.key} at ${report.nodeId}`,
            );
          }
        }
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        await shop.end();
      }
    },
  },
  {
    name: "lod_keeps_the_largest_and_smallest_value_of_every_result",
    skip: whyNoScene("examples/boiler/hex_linear/static.frd"),
    async run() {
      const shop = await workshop();
      try {
        const bytes = readFileSync(shop.convert("boiler.glb", BOILER, "--lod", "2%"));
        const scene = readScene(bytes);
        const own = new Set(scene.named("p0/indices/lod1"));
        assert.ok(own.size < 0.6 * scene.parts[0].nodeIds.length);
        let compared = 0;
        for (const { id, components } of scene.extras.results) {
          if (components.length > 1) continue;
          const { values } = scene.field(id, 1, 0);
          const ends = (of) => [Math.min(...of), Math.max(...of)];
          assert.deepEqual(ends([...own].map((v) => values[v])), ends([...values]), id);
          compared += 1;
        }
        assert.ok(compared >= 7);
      } finally {
        await shop.end();
      }
    },
  },
];
