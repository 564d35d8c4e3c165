// SPDX-License-Identifier: Apache-2.0
// Colours that look alike are told: the formula by published pairs, the maps by what docs/effects.md says of them.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import {
  colourMaps,
  defaultColour,
  differenceOf,
  labOf,
  leastDifference,
  paletteColour,
  visions,
} from "../../src/present";
import { mapNote } from "../../src/ui/map-note";
import { measured } from "../support/measured";

const bandsOf = (map: string, bands: number) =>
  Array.from({ length: bands }, (_, i) => paletteColour((i + 0.5) / bands, { ...defaultColour, map, bands }));

test("the difference agrees with published pairs", () => {
  expect(differenceOf([50, 2.6772, -79.7751], [50, 0, -82.7485])).toBeCloseTo(2.0425, 4);
  expect(differenceOf([50, 0, 0], [50, -1, 2])).toBeCloseTo(2.3669, 4);
  expect(differenceOf([2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514])).toBeCloseTo(0.9082, 4);
});

test("nine bands of each map are as far apart as docs/effects.md says", () => {
  const text = readFileSync(new URL("../../../docs/effects.md", import.meta.url), "utf8");
  for (const map of colourMaps()) {
    const row = new RegExp(`^\\| ${map} \\|(.*)\\|$`, "m").exec(text)?.[1]?.split("|").map(Number) ?? [];
    const bands = bandsOf(map, 9);
    const found = visions.map((vision) => {
      const labs = bands.map((colour) => labOf(colour, vision));
      return Math.min(...labs.flatMap((a, i) => labs.slice(i + 1).map((b) => differenceOf(a, b))));
    });
    expect(found.map((apart) => Number(apart.toFixed(1)))).toEqual(row);
  }
});

test("V1 the default's bands differ by six, and a map with less than five says so on the legend", () => {
  const { apart } = leastDifference(bandsOf(defaultColour.map, defaultColour.bands));
  expect(apart).toBeGreaterThanOrEqual(6);
  measured("V1", `least difference ${apart.toFixed(2)}`);
  for (const map of colourMaps()) {
    for (const bands of [0, 5, 9, 11, 20, 64]) {
      const least = leastDifference(bandsOf(map, bands || 9)).apart;
      expect(mapNote({ ...defaultColour, map, bands }) !== null, `${map} ${bands}: ${least}`).toBe(least < 5);
    }
  }
  expect(mapNote({ ...defaultColour, map: "ansys_rainbow" })).toContain("without red cones");
  expect(mapNote(defaultColour)).toBeNull();
});
