// SPDX-License-Identifier: Apache-2.0
// The page and the native viewer show the same colours: tests/contract/pixels.json holds what this page shows at 200 places of
// the boiler; tests/viewer/render/page_colours_test.cpp looks there too. FEELEM_UPDATE_CONTRACT=1 writes the file anew.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT, workshop } from "./binary.mjs";
import { openPage, pixelsOf } from "./harness.mjs";
import { viewFrom } from "./look.mjs";
import { BOILER, BOILER_OPTIONS, whyNot } from "./program.mjs";
import { gridOf, plainModel, probedAt, settled } from "./read-back.mjs";

const FILE = join(ROOT, "tests/contract/pixels.json");
const RESULTS = [
  ["T", "temperature"],
  ["U", "displacement_magnitude"],
];
const VIEWS = ["+x", "-y", "+z", "-z"];
/** Of each result in each view. */
const PLACES = 25;

/** Places spread over the picture; none within a thousandth of the range from an edge of a band. */
function chosen(reports, points, key, range) {
  const good = reports.flatMap((report, i) => {
    const value = report?.results.find((r) => r.key === key)?.value;
    if (value == null) return [];
    const band = (9 * (value - range.min.value)) / (range.max.value - range.min.value);
    return Math.abs(band - Math.round(band)) < 9 * 0.001
      ? []
      : [{ pixel: points[i], at: report.point, value }];
  });
  const step = good.length / PLACES;
  return step < 1 ? good : Array.from({ length: PLACES }, (_, i) => good[Math.floor(i * step)]);
}

async function shownPlaces(page) {
  const { results } = await page.evaluate(() => window.feelem.scene());
  const all = [];
  for (const [row, [key, id]] of RESULTS.entries()) {
    if (row > 0) await page.click(`tbody tr:nth-child(${row + 1}) button[data-slot='colour']`);
    for (const view of VIEWS) {
      await viewFrom(page, view);
      await page.mouse.move(3, 3);
      await settled(page);
      const points = await gridOf(page, 40, 30);
      const places = chosen(
        await probedAt(page, points),
        points,
        key,
        results.find((r) => r.id === id).values[0],
      );
      const drawn = await pixelsOf(
        page,
        await page.screenshot(),
        places.map((place) => place.pixel),
      );
      for (const [i, { at, value }] of places.entries())
        all.push({ key, view, at: at.map(Math.fround), value, colour: [...drawn[i]].slice(0, 3) });
    }
  }
  return all;
}

export const nativeTests = [
  {
    name: "page_shows_the_colours_that_the_native_viewer_is_held_to",
    skip: whyNot,
    async run({ browser }) {
      const shop = await workshop();
      try {
        const url = await shop.show(shop.convert("boiler.glb", `${BOILER}/boiler.frd`, ...BOILER_OPTIONS));
        const { page, context, problems } = await openPage(browser, url, {});
        await plainModel(page);
        const shown = await shownPlaces(page);
        assert.deepEqual(problems, []);
        await context.close();
        assert.ok(shown.length >= 200, `${shown.length} places`);
        if (process.env.FEELEM_UPDATE_CONTRACT) {
          const rows = shown.map((place) => `    ${JSON.stringify(place)}`).join(",\n");
          writeFileSync(FILE, `{\n  "places": [\n${rows}\n  ]\n}\n`);
        }
        const { places } = JSON.parse(readFileSync(FILE, "utf8"));
        assert.deepEqual(shown, places);
      } finally {
        await shop.end();
      }
    },
  },
];
