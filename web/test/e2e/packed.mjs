// SPDX-License-Identifier: Apache-2.0
// Compressed scenes in the page: the same numbers bit for bit, or within the bound that card and probe state.
import assert from "node:assert/strict";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { probeNode, workshop } from "./binary.mjs";
import { openPage, until } from "./harness.mjs";
import { BOILER, BOILER_OPTIONS, whyNot } from "./program.mjs";

const INPUT = [join(BOILER, "boiler.frd"), ...BOILER_OPTIONS];
const probe = () => window.feelem.lastProbe();

async function goTo(page, id) {
  await page.fill(".goto input", String(id));
  await page.keyboard.press("Enter");
  return until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
}

/** What the page says at nodes of the boiler, by name of the result. */
async function saidAt(browser, url, ids, options) {
  const { page, context, problems } = await openPage(browser, url, options);
  const said = [];
  for (const id of ids) {
    const { results } = await goTo(page, id);
    said.push(Object.fromEntries(results.map((r) => [`${r.name} ${r.component}`, r])));
  }
  const card = await page.locator(".bound").allTextContents();
  assert.deepEqual(problems, []);
  await context.close();
  return { said, card };
}

export const packedTests = [
  {
    name: "packed_scene_shows_the_same_numbers_and_none_is_called_uncertain",
    skip: whyNot,
    async run({ browser }) {
      const shop = await workshop();
      try {
        const ids = [206, 4565, 52];
        const plain = await saidAt(browser, await shop.show(shop.convert("plain.glb", ...INPUT)), ids);
        const packed = await saidAt(
          browser,
          await shop.show(shop.convert("packed.glb", ...INPUT, "--compress")),
          ids,
        );
        assert.deepEqual(packed, plain);
        assert.deepEqual(packed.card, []);
        assert.ok(Object.keys(plain.said[0]).length >= 3);
      } finally {
        await shop.end();
      }
    },
  },
  {
    name: "packed_scene_with_a_bound_shows_what_probe_prints_within_the_bound_it_states",
    skip: whyNot,
    async run({ browser }) {
      const shop = await workshop();
      try {
        const ids = [206, 4565, 52];
        const file = shop.convert("bounded.glb", ...INPUT, "--compress-bound", "0.1%");
        const plain = await saidAt(browser, await shop.show(shop.convert("plain.glb", ...INPUT)), ids);
        const { said, card } = await saidAt(browser, await shop.show(file), ids);
        let changed = 0;
        for (const [i, id] of ids.entries()) {
          const printed = probeNode(file, id)[0].results;
          for (const [name, entry] of Object.entries(said[i])) {
            const exact = plain.said[i][name].value;
            assert.ok(entry.bound > 0 && Math.abs(entry.value - exact) <= entry.bound, `${name} at ${id}`);
            assert.equal(entry.value, printed.find((r) => r.key === entry.key).value, `${name} at ${id}`);
            changed += entry.value === exact ? 0 : 1;
          }
        }
        assert.ok(changed > 0, "a bound that loses nothing was not used");
        assert.ok(card.length >= 3 && card.every((text) => /^± [0-9.e-]+$/.test(text.trim())), card.join());
      } finally {
        await shop.end();
      }
    },
  },
  {
    name: "packed_review_file_opens_from_disk_with_the_network_off",
    skip: whyNot,
    async run({ browser }) {
      const shop = await workshop();
      try {
        const plain = shop.convert("plain.html", ...INPUT);
        const packed = shop.convert("packed.html", ...INPUT, "--compress");
        const ids = [206, 52];
        const offline = { offline: true };
        const wanted = await saidAt(browser, pathToFileURL(plain).href, ids, offline);
        assert.deepEqual(await saidAt(browser, pathToFileURL(packed).href, ids, offline), wanted);
      } finally {
        await shop.end();
      }
    },
  },
];
