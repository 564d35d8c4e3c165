// SPDX-License-Identifier: Apache-2.0
// Vectors and principal directions: arrows by their values, where they stand and how they are drawn.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { whyNoScene, workshop } from "./binary.mjs";
import { openPage, until } from "./harness.mjs";
import { unfold } from "./look.mjs";
import { readScene } from "./oracle.mjs";

const state = () => window.feelem.state();
const shown = (page) => until(page, state, (s) => s.arrows?.ready && s.arrows.shown.length > 0, "the arrows");
const BOILER = "examples/boiler/small/static.frd";

/** Values of a result at a node, by the scene's own bytes. */
function valuesAt(scene, id, step, node, width) {
  const part = scene.parts.findIndex((p) => p.nodeIds.includes(node));
  const vertex = scene.parts[part].nodeIds.indexOf(node);
  return [...scene.field(id, step, part).values.subarray(width * vertex, width * (vertex + 1))];
}

export const vectorTests = [
  {
    name: "vectors_stand_at_nodes_with_the_files_values_and_go_with_what_is_cut_away",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await openPage(browser, url);
      const section = await unfold(page, "vectors");
      await page.mouse.move(5, 5);
      const picture = async () => {
        await page.waitForTimeout(400);
        return (await page.locator(".area-stage canvas").screenshot()).toString("base64");
      };
      const plain = await picture();
      await section.getByLabel("result drawn as arrows").selectOption("displacement");
      const { arrows, step } = await shown(page);
      for (const { node, value, axis } of arrows.shown) {
        const wanted = valuesAt(scene, "displacement", step, node, 3);
        const length = Math.hypot(...wanted);
        assert.ok(Math.abs(value - length) <= 1e-12 * length, `node ${node}: ${value}, not ${length}`);
        for (const k of [0, 1, 2]) assert.ok(Math.abs(axis[k] * value - wanted[k]) <= 1e-12 * length);
      }
      const drawn = await picture();
      assert.notEqual(drawn, plain);
      await page.keyboard.press("c");
      const uncut = arrows.shown.length;
      await until(page, state, (s) => s.arrows.shown.length < uncut, "fewer behind the plane");
      await page.keyboard.press("c");
      await until(page, state, (s) => s.arrows.shown.length === uncut, "all again");
      await section.getByLabel("number of arrows").selectOption("few");
      await until(page, state, (s) => s.arrows.shown.length < uncut, "fewer arrows");
      await section.getByLabel("result drawn as arrows").selectOption("");
      await until(page, state, (s) => s.arrows === null, "none");
      await page.locator(".area-stage canvas").focus();
      await page.keyboard.press("9");
      assert.equal((await shown(page)).arrows.result, "displacement");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vectors_of_the_boilers_stress_are_the_principal_values_that_the_converter_found",
    skip: whyNoScene(BOILER),
    async run({ browser }) {
      const shop = await workshop();
      try {
        const file = shop.convert("boiler.glb", BOILER);
        const scene = readScene(readFileSync(file));
        const { page, context } = await openPage(browser, await shop.show(file));
        const section = await unfold(page, "vectors");
        await section.getByLabel("result drawn as arrows").selectOption("stress");
        const { arrows, step } = await shown(page);
        const byNode = new Map();
        for (const { node, value } of arrows.shown) byNode.set(node, [...(byNode.get(node) ?? []), value]);
        // The report ends after so many arrows: the last node may be cut short.
        const told = [...byNode].filter(([, values]) => values.length === 3);
        assert.ok(told.length > 50, `${told.length} nodes`);
        for (const [node, values] of told) {
          const most = Math.max(...values.map(Math.abs));
          for (const [k, value] of values.entries()) {
            const [wanted] = valuesAt(scene, `stress_principal_${k + 1}`, step, node, 1);
            assert.ok(Math.abs(value - wanted) <= 1e-6 * most, `node ${node}: ${value}, not ${wanted}`);
          }
        }
        await context.close();
      } finally {
        await shop.end();
      }
    },
  },
];
