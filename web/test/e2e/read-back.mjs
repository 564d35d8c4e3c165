// SPDX-License-Identifier: Apache-2.0
// Reads colours off pictures of the page as a person does: pixels of the model against pixels of the legend.
import { differenceOf, labOf } from "../../src/present/colour-difference.ts";
import { pixelsOf } from "./harness.mjs";

/** Lays away what stands on the model: extremes, lines of the mesh and of the undeformed shape. */
export async function plainModel(page) {
  await page.locator(".area-stage canvas").focus();
  await page.keyboard.press("x");
  await page.keyboard.press("e");
  if ((await page.evaluate(() => window.feelem.state())).ghost) await page.keyboard.press("u");
  await page.mouse.move(3, 3);
  await settled(page);
}

/** Two frames later everything that was asked for is drawn. */
export async function settled(page) {
  await page.waitForTimeout(150);
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))),
  );
}

export async function chooseColours(page, { map, bands, scale, lo, hi }) {
  const choose = (name, value) => page.getByLabel(name, { exact: true }).selectOption(value);
  const type = async (name, value) => {
    await page.getByLabel(name).fill(String(value));
    await page.keyboard.press("Enter");
  };
  if (map !== undefined) await choose("colour map", map);
  if (scale !== undefined) await choose("scale", scale);
  if (bands !== undefined) await type("number of bands, 0 for smooth", bands);
  if (hi !== undefined) await type("upper end of the range", hi);
  if (lo !== undefined) await type("lower end of the range", lo);
  await page.locator(".area-stage canvas").focus();
  await settled(page);
}

/** Pixel centres of the stage on a grid, as [x, y] of the page; none where the axes stand before the model. */
export async function gridOf(page, columns, rows) {
  const box = await page.locator(".area-stage canvas").boundingBox();
  const axes = await page.locator(".triad").boundingBox();
  const isFree = ([x, y]) =>
    x < axes.x - 2 || y < axes.y - 2 || x > axes.x + axes.width + 2 || y > axes.y + axes.height + 2;
  const points = [];
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i)
      points.push([
        Math.floor(box.x + (box.width * (i + 0.5)) / columns),
        Math.floor(box.y + (box.height * (j + 0.5)) / rows),
      ]);
  return points.filter(isFree);
}

/** What the page says of each of these pixels when it is pointed at its middle; null beside the model. */
export async function probedAt(page, points) {
  const reports = await page.evaluate((points) => {
    const canvas = document.querySelector(".area-stage canvas");
    const over = (x, y) =>
      canvas.dispatchEvent(
        new PointerEvent("pointermove", { clientX: x + 0.5, clientY: y + 0.5, bubbles: true, pointerId: 1 }),
      );
    // Within a hundredth of a pixel from its outline the model may be drawn or not: the card rounds corners to 1/256.
    const outline = (x, y) =>
      [-0.01, 0.01].some((dx) => {
        over(x + dx, y + dx);
        const one = window.feelem.lastProbe();
        over(x + dx, y - dx);
        return !one || !window.feelem.lastProbe();
      });
    const all = points.map(([x, y]) => {
      over(x, y);
      const report = window.feelem.lastProbe();
      return report && outline(x, y) ? null : report;
    });
    over(-1e6, -1e6);
    return all;
  }, points);
  return reports;
}

/** The legend's bar in a picture: the colour of each of its rows, the lowest value first. */
export async function legendRows(page, png) {
  const box = await page.locator(".legend-canvas").boundingBox();
  const x = Math.round(box.x + box.width / 2);
  const top = Math.round(box.y);
  const count = Math.round(box.y + box.height) - top;
  const points = Array.from({ length: count }, (_, i) => [x, top + count - 1 - i]);
  return pixelsOf(page, png, points);
}

/** Where on the legend (0..1) a colour is found: the row that looks most like it. */
export function readingOf(rows) {
  const labs = rows.map((colour) => labOf(colour));
  const known = new Map();
  return (colour) => {
    const key = colour.join(" ");
    let best = known.get(key);
    if (best === undefined) {
      const lab = labOf(colour);
      let least = Number.POSITIVE_INFINITY;
      for (const [i, row] of labs.entries()) {
        const apart = differenceOf(lab, row);
        if (apart < least) [least, best] = [apart, (i + 0.5) / labs.length];
      }
      known.set(key, best);
    }
    return best;
  };
}
