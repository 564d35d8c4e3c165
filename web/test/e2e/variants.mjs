// SPDX-License-Identifier: Apache-2.0
// Averagings, layers, systems and envelopes: after the choice the card has the number of a conversion that holds
// nothing but that choice.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { probeNode, tell, whyNoScene, workshop } from "./binary.mjs";
import { openPage, until } from "./harness.mjs";
import { unfold } from "./look.mjs";

const probe = () => window.feelem.lastProbe();
const state = () => window.feelem.state();
const CUBES = "tests/data/ansys/two_cubes/file.rst";
const HEX = "examples/boiler/hex_linear";
const AXIS = "cylindrical:0,0,0,0,0,1";

async function goTo(page, node) {
  await page.fill(".goto input", String(node));
  await page.keyboard.press("Enter");
  return until(page, probe, (r) => r?.nodeId === node, `node ${node}`);
}

/** Picks in the section "Components, averaging" what a result shows. */
async function choose(page, key, what, word) {
  const section = await unfold(page, "variants");
  await section.locator(`li[data-key='${key}'] [data-choice='${what}']`).selectOption(word);
  await until(page, state, (s) => s.variants.find((v) => v.key === key)?.[what] === word, `${what} ${word}`);
}

const entryOf = (report, key) => report?.results.find((r) => r.key === key);
const six = (v) => Number(v.toPrecision(6));

/** The page's report has the number to the last bit, the card to its six digits. */
async function saysNumber(page, key, wanted, what) {
  const seen = await until(
    page,
    probe,
    (r) => entryOf(r, key)?.value === wanted.value,
    `${wanted.value} (${what})`,
  );
  assert.equal(entryOf(seen, key).nodeValue, Math.fround(wanted.nodeValue), what);
  const cells = page.locator(`.card:not(.inside) tr[data-key='${key}'] td`);
  const digits = [six(wanted.value), six(wanted.nodeValue)].join();
  let card = "";
  for (let n = 0; n < 50 && card !== digits; ++n) {
    await page.waitForTimeout(100);
    card = (await cells.allTextContents()).map((text) => Number.parseFloat(text)).join();
  }
  assert.equal(card, digits, `the card: ${what}`);
}

/** Two square shells with stress at top and bottom, as Ansys lists. */
function writeShell(folder) {
  const to = join(folder, "shell");
  mkdirSync(to);
  const head = (listing) =>
    ` \n  ***** POST1 ${listing} LISTING *****                            \n \n  LOAD STEP=     1  SUBSTEP=     1                                             \n   TIME=    1.0000      LOAD CASE=   0                                         \n \n`;
  const nodes = [1, 2, 3, 4, 5, 6].map((id) => [id, (id - 1) % 3, Math.floor((id - 1) / 3), 0]);
  const files = {
    "NLIST.lis": `\n LIST ALL SELECTED NODES.   DSYS=      0\n\n    NODE        X             Y             Z\n${nodes
      .map(([id, ...xyz]) => `${id}`.padStart(8) + xyz.map((v) => v.toFixed(6).padStart(14)).join(""))
      .join("\n")}\n`,
    "ETLIST.lis":
      "\n LIST ELEMENT TYPES FROM        1 TO        1 BY        1\n\n ELEMENT TYPE        1 IS SHELL181     \n",
    "ELIST.lis":
      "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n\n    ELEM MAT TYP REL ESY SEC        NODES\n\n" +
      "       1   1   1   1   0   1         1      2      5      4\n       2   1   1   1   0   1         2      3      6      5\n",
    "PRNSOL_S.lis": `${head("NODAL STRESS")}  SHELL NODAL RESULTS ARE AT TOP/BOTTOM FOR MATERIAL   1\n \n    NODE    SX          SY          SZ          SXY         SYZ         SXZ\n${nodes
      .flatMap(([id]) => [12.5 * id, -7.25 * id].map((sx) => [id, sx, id, 0, 0, 0, 0]))
      .map(([id, ...values]) => `${id}`.padStart(8) + values.map((v) => v.toFixed(4).padStart(12)).join(""))
      .join("\n")}\n`,
  };
  for (const [name, text] of Object.entries(files)) writeFileSync(join(to, name), text);
  return to;
}

export const variantTests = [
  {
    name: "program_averagings_on_the_card_are_those_of_a_conversion_each",
    skip: whyNoScene(CUBES),
    async run({ browser }) {
      const shop = await workshop();
      const file = shop.convert("all.glb", CUBES, "--average", "part,all,none");
      const { page, context, problems } = await openPage(browser, await shop.show(file));
      // On the face between the two materials, where the three differ most, and at an end.
      const [face, end] = [6, 9];
      const values = new Map();
      for (const averaging of ["none", "all", "part"]) {
        const alone = shop.convert(`${averaging}.glb`, CUBES, "--average", averaging);
        await choose(page, "S", "averaging", averaging);
        for (const node of [end, face]) {
          const seen = await goTo(page, node);
          const places = probeNode(alone, node);
          const place = places.find((p) => p.elementId === seen.elementId) ?? places[0];
          const wanted = entryOf(place, "S");
          await saysNumber(page, "S", wanted, `${averaging} at node ${node}, element ${seen.elementId}`);
          values.set(`${averaging} ${node}`, wanted.value);
        }
      }
      const distinct = new Set(["none", "all", "part"].map((a) => values.get(`${a} ${face}`)));
      assert.equal(distinct.size, 3, `the three averagings differ between the parts: ${[...distinct]}`);
      assert.deepEqual(problems, []);
      await context.close();
      await shop.end();
    },
  },
  {
    name: "program_layers_of_shells_on_the_card_are_top_and_bottom_of_the_list",
    skip: whyNoScene(),
    async run({ browser }) {
      const shop = await workshop();
      const file = shop.convert("shell.glb", writeShell(shop.folder), "--length-unit", "mm");
      const { page, context, problems } = await openPage(browser, await shop.show(file));
      const key = (await page.evaluate(state)).variants[0].key;
      for (const [layer, factor] of [
        ["top", 12.5],
        ["bottom", -7.25],
        ["top", 12.5],
      ]) {
        await choose(page, key, "layer", layer);
        await choose(page, key, "component", "xx");
        for (const node of [1, 2, 6]) {
          await goTo(page, node);
          await saysNumber(
            page,
            key,
            { value: factor * node, nodeValue: factor * node },
            `${layer} at ${node}`,
          );
        }
      }
      assert.deepEqual(problems, []);
      await context.close();
      await shop.end();
    },
  },
  {
    name: "program_hoop_and_axial_stress_of_the_boiler_are_turned_about_its_axis",
    skip: whyNoScene(`${HEX}/static.frd`),
    async run({ browser }) {
      const shop = await workshop();
      const file = shop.convert(
        "boiler.glb",
        `${HEX}/static.frd`,
        "--length-unit",
        "mm",
        "--result-system",
        AXIS,
      );
      const { page, context, problems } = await openPage(browser, await shop.show(file));
      for (const node of [212, 698, 1500]) {
        const places = probeNode(file, node);
        const of = (component) =>
          places[0].results.find((r) => r.name === "stress" && r.component === component);
        const [x, y] = places[0].point;
        const turn = Math.atan2(y, x);
        const [xx, yy, xy] = ["xx", "yy", "xy"].map((c) => of(c).value);
        const hoop = xx * Math.sin(turn) ** 2 + yy * Math.cos(turn) ** 2 - xy * Math.sin(2 * turn);
        for (const component of ["hoop", "axial", "radial"]) {
          await choose(page, "S", "component", component);
          await goTo(page, node);
          await saysNumber(page, "S", of(component), `${component} at node ${node}`);
        }
        const size = Math.max(...[xx, yy, xy].map(Math.abs));
        assert.ok(
          Math.abs(of("hoop").value - hoop) < 2e-6 * size,
          `hoop ${of("hoop").value}, by hand ${hoop}`,
        );
        assert.equal(of("axial").value, of("zz").value);
      }
      assert.deepEqual(problems, []);
      await context.close();
      await shop.end();
    },
  },
  {
    name: "program_envelope_over_the_steps_is_the_largest_of_them_all",
    skip: whyNoScene(`${HEX}/transient.frd`),
    async run({ browser }) {
      const shop = await workshop();
      const file = shop.convert(
        "time.glb",
        `${HEX}/transient.frd`,
        "--length-unit",
        "mm",
        "--envelope",
        "max",
      );
      const { page, context, problems } = await openPage(browser, await shop.show(file));
      const scene = await page.evaluate(() => window.feelem.scene());
      const envelope = scene.steps.findIndex((s) => s.name === "maximum over 8 steps");
      assert.ok(envelope >= 0);
      await page.locator(".others summary").click();
      for (const name of [/temperature max(?! step)/i, /temperature max step/i]) {
        await page.locator(".others li", { hasText: name }).getByRole("button").click();
      }
      const shown = await page.evaluate(state);
      const added = shown.presentation.results.filter((r) => r.name.startsWith("temperature_max"));
      assert.equal(added.length, 2);
      const ahead = envelope - scene.steps.findIndex((s) => s.id === shown.step);
      for (let n = 0; n < Math.abs(ahead); ++n)
        await page
          .locator(".stepbar")
          .getByLabel(ahead > 0 ? "next step" : "step before")
          .click();
      await until(page, state, (s) => s.step === scene.steps[envelope].id, "the envelope");
      for (const node of [67, 199, 1231]) {
        const steps = JSON.parse(tell("info", `${HEX}/transient.frd`, "--json", "--brief")).steps;
        const all = steps.map(
          ({ step, substep }) =>
            entryOf(probeNode(file, node, "--steps", `${step}.${substep}`)[0], "T").value,
        );
        assert.equal(all.length, 8);
        const most = Math.max(...all);
        const at = 1 + all.indexOf(most);
        await goTo(page, node);
        await saysNumber(page, added[0].key, { value: most, nodeValue: most }, `envelope at node ${node}`);
        await saysNumber(
          page,
          added[1].key,
          { value: at, nodeValue: at },
          `step of the envelope at node ${node}`,
        );
      }
      assert.deepEqual(problems, []);
      await context.close();
      await shop.end();
    },
  },
];
