// SPDX-License-Identifier: Apache-2.0
// Levels of detail on the page: which one is drawn, what is said of it, and that nothing that is read comes from it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { probeNode, ROOT, whyNoScene, workshop } from "./binary.mjs";
import { openPage, until } from "./harness.mjs";
import { middle } from "./look.mjs";
import { readScene, resultIdOf, valueAtNode } from "./oracle.mjs";
import { aimAtNode, enter } from "./vr-hands.mjs";
import { watchPage } from "./watch-page.mjs";

const BOILER = `${ROOT}examples/boiler/hex_linear/static.frd`;
const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const drawn = (level) => (s) => s.levels.drawn === level;
const WORDS = /^drawn with values within ±1 % \(±[0-9.]+\)$/;

export const lodTests = [
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
