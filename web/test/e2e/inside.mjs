// SPDX-License-Identifier: Apache-2.0
// Inside the boiler, served by the real program from its model file: sections, values at places, surfaces; a scene alone
// says that it has none of these.
import assert from "node:assert/strict";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, whyNoScene } from "./binary.mjs";
import { readVolume, valueInside } from "./frd-volume.mjs";
import { enterHeadset, HEARD, listen, openPage, pixelOf, until } from "./harness.mjs";
import { unfold, viewFrom } from "./look.mjs";
import { BOILER_OPTIONS, view, viewBoiler } from "./program.mjs";

const MODEL = "examples/boiler/small/static.frd";
const skip = whyNoScene(MODEL);
const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
/** In no plane of nodes, and across both walls, heads, nozzles and legs. */
const PLACE = 37;

const viewModel = () =>
  view(mkdtempSync(join(tmpdir(), "feelem-e2e-")), join(ROOT, MODEL), ...BOILER_OPTIONS);

const sectionShown = (page, what = "the section") =>
  until(page, state, (s) => s.sections?.[0]?.state === "shown", what);

/** The undeformed boiler cut along its length, seen from the side that is gone. */
async function cutAlong(page) {
  for (const key of ["0", "x", "e", "c"]) await page.keyboard.press(key);
  const section = await unfold(page, "cuts");
  await section.getByRole("button", { name: "y", exact: true }).click();
  await section.getByLabel("other side of plane 1").click();
  await section.getByLabel("place of plane 1, typed").fill(String(-PLACE));
  await page.keyboard.press("Enter");
  await viewFrom(page, "-y");
  const { cuts } = await until(page, state, (s) => s.cuts[0]?.offset === -PLACE, "the plane");
  assert.deepEqual(cuts[0].normal, [0, -1, 0]);
  return sectionShown(page);
}

/** Pixels of the canvas where the pointer is on the section, at most `count`: the saddles below the boiler are solid. */
async function placesOnSection(page, count) {
  const box = await page.locator(".area-stage canvas").boundingBox();
  const isInside = async (x, y) => {
    await page.mouse.move(x, y);
    return page.evaluate(() => (window.feelem.lastProbe()?.interior ?? null) !== null);
  };
  const found = [];
  for (const [down, from] of [
    [0.74, 0.225],
    [0.77, 0.695],
    [0.72, 0.695],
    [0.77, 0.225],
  ]) {
    const y = Math.round(box.y + down * box.height);
    for (let along = from; along < from + 0.09 && found.length < count; along += 0.01) {
      const x = Math.round(box.x + along * box.width);
      // The one beside it too, so that the pixel is well inside.
      if (!(await isInside(x, y)) || !(await isInside(x + 3, y))) continue;
      found.push({ x: x + 1, y });
      break;
    }
  }
  return found;
}

/** In the page: what the server says of a place. */
async function askPoint([x, y, z]) {
  return (await fetch(`inside/point?at=${x},${y},${z}&step=1&results=temperature`)).json();
}

/** In the page: the palette from the lowest to the highest. */
function coloursOfLegend() {
  const canvas = document.querySelector(".legend canvas");
  const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const rows = Array.from({ length: height }, (_, row) => {
    const at = 4 * (row * width + Math.floor(width / 2));
    return [data[at], data[at + 1], data[at + 2]];
  });
  return rows.filter((c, i) => i === 0 || c.some((v, k) => v !== rows[i - 1][k])).reverse();
}

export const insideTests = [
  {
    name: "inside_section_of_the_boiler_has_the_colours_and_the_values_of_its_elements",
    skip,
    async run({ browser }) {
      const { url, end } = await viewModel();
      try {
        const { page, context, foreign, problems } = await openPage(browser, url, {
          width: 1000,
          height: 640,
        });
        const volume = readVolume(join(ROOT, MODEL));
        const temperature = (node) => volume.results.get("NDTEMP").get(node)[0];
        const { sections, presentation } = await cutAlong(page);
        assert.ok(sections[0].area > 0 && sections[0].triangles > 1000, JSON.stringify(sections));
        const seen = presentation.effects.find((e) => e.type === "colour").result;
        assert.equal(presentation.results.find((r) => r.key === seen).name, "temperature");
        const places = await placesOnSection(page, 4);
        assert.ok(places.length >= 3, `only ${places.length} places were met on the section`);
        const wanted = [];
        for (const { x, y } of places) {
          await page.mouse.move(x, y);
          const exact = await until(page, probe, (r) => r?.interior?.exact, "the value by the element");
          assert.ok(Math.abs(exact.point[1] - PLACE) < 0.01, `on the plane: ${exact.point}`);
          const own = exact.results.find((r) => r.name === "temperature");
          const independent = valueInside(volume, temperature, exact.point);
          assert.ok(independent, `an element at ${exact.point}`);
          wanted.push(independent.value);
          // The pointer's place is known to float32 of the picture's ray.
          assert.ok(Math.abs(own.value - independent.value) < 0.02, `${own.value} is ${independent.value}`);
          assert.equal(own.nodeValue, Math.fround(temperature(exact.nodeId)));
          // The same place asked for by hand.
          const answer = await page.evaluate(askPoint, exact.point);
          assert.equal(answer.element, exact.elementId);
          assert.equal(Math.fround(answer.results[0].value), own.value);
          const said = await page.locator(".card-interior").textContent();
          assert.ok(said.includes(`element ${exact.elementId}`) && said.includes("interior value"), said);
        }
        // The picture: at each place the palette's colour of its value, or of the step beside it.
        await page.mouse.move(5, 5);
        await page.waitForTimeout(120);
        const picture = await page.screenshot();
        const colours = await page.evaluate(coloursOfLegend);
        const [lo, hi] = await page.evaluate(() => {
          const stated = window.feelem.scene().results.find((s) => s.id === "temperature").values[0];
          return [stated.min.value, stated.max.value];
        });
        for (const [i, { x, y }] of places.entries()) {
          const [r, g, b] = await pixelOf(page, picture, x, y);
          const off = (c) => Math.hypot(c[0] - r, c[1] - g, c[2] - b);
          const shown = colours.reduce((best, c, k) => (off(c) < off(colours[best]) ? k : best), 0);
          assert.ok(off(colours[shown]) < 6, `a colour of the legend at ${x}, ${y}: ${[r, g, b]}`);
          const step = Math.floor(((wanted[i] - lo) / (hi - lo)) * colours.length);
          assert.ok(Math.abs(step - shown) <= 1, `step ${shown} is drawn for ${wanted[i]}, of step ${step}`);
        }
        assert.deepEqual([foreign, problems], [[], []]);
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "inside_section_follows_plane_result_and_shape_and_says_when_it_is_not_yet_computed",
    skip,
    async run({ browser }) {
      const { url, end } = await viewModel();
      try {
        const { page, context, problems } = await openPage(browser, url, { width: 1000, height: 640 });
        const first = (await cutAlong(page)).sections[0];
        const section = await unfold(page, "cuts");
        const slider = section.getByLabel("place of plane 1", { exact: true });
        // While it moves nothing is drawn, and the section says so.
        await slider.evaluate((e) => {
          e.value = "-120";
          e.dispatchEvent(new Event("input", { bubbles: true }));
        });
        const moving = await until(page, state, (s) => s.sections[0].state === "waiting", "the wait");
        assert.equal(moving.sections[0].text, "Section not yet computed.");
        const moved = (await sectionShown(page, "the moved section")).sections[0];
        assert.notEqual(moved.area, first.area);
        const said = await page.locator(".cut-section").first().textContent();
        assert.match(said, /^Cuts \d+ elements, [\d.]+ mm²/);
        // Deformed, the plane meets other places of the material.
        await page.getByRole("button", { name: "5 %" }).click();
        await until(page, state, (s) => s.deformationFactor > 1, "a deformation");
        const isOther = (s) => s.sections[0].state === "shown" && s.sections[0].area !== moved.area;
        await until(page, state, isOther, "the section of the deformed shape");
        await page.keyboard.press("0");
        const again = await until(
          page,
          state,
          (s) => s.sections[0].area === moved.area,
          "the same section again",
        );
        assert.equal(again.sections[0].triangles, moved.triangles);
        // Another result is seen: the section has its colours.
        const places = await placesOnSection(page, 3);
        assert.ok(places.length >= 2, `only ${places.length} places were met on the section`);
        const colours = async () => {
          await page.mouse.move(5, 5);
          await page.waitForTimeout(300);
          const picture = await page.screenshot();
          return Promise.all(places.map(async ({ x, y }) => String(await pixelOf(page, picture, x, y))));
        };
        const before = await colours();
        const stress = again.presentation.results.find((r) => r.name === "stress");
        await page.click(`tr[data-key='${stress.key}'] button[data-slot='colour']`);
        await until(page, state, (s) => s.sections[0].state === "waiting", "the section of another result");
        const { sections } = await sectionShown(page, "the section in stress");
        assert.equal(sections[0].area, moved.area);
        assert.notDeepEqual(await colours(), before);
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "inside_places_are_heard_and_a_typed_place_and_a_surface_are_answered",
    skip,
    async run({ browser }) {
      const { url, end } = await viewModel();
      try {
        const { page, context, problems } = await openPage(browser, url, { width: 1000, height: 640 });
        await cutAlong(page);
        const [place] = await placesOnSection(page, 1);
        await page.mouse.move(place.x, place.y);
        await until(page, probe, (r) => r?.interior?.exact, "the value by the element");
        await page.mouse.down();
        const { hz, results, elementId, point } = await until(
          page,
          probe,
          (r) => r?.hz > 0 && r.interior?.exact,
          "a pitch",
        );
        await until(
          page,
          listen,
          (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.02,
          `a tone of ${hz} Hz`,
        );
        await page.mouse.up();
        const section = await unfold(page, "inside");
        for (const [i, axis] of ["x", "y", "z"].entries())
          await section.getByLabel(`${axis} of the place`).fill(String(point[i]));
        await section.getByRole("button", { name: "Read" }).click();
        const { inside } = await until(page, state, (s) => s.inside.place !== null, "the typed place");
        assert.equal(inside.place.element, elementId);
        for (const { key, value } of results) assert.equal(inside.place.values[key].value, value);
        await section.getByLabel("x of the place").fill("1e6");
        await section.getByRole("button", { name: "Read" }).click();
        await until(
          page,
          () => document.querySelector(".inside-found").textContent,
          (text) => text === "There is no volume element at this place.",
          "the answer that there is none",
        );
        await page.locator(".area-stage canvas").focus();
        await page.keyboard.press("8");
        const shown = await until(page, state, (s) => s.inside.surface.state === "shown", "the surface");
        assert.ok(shown.inside.surface.area > 0);
        await section.getByLabel("value of the surface, typed").fill("1e6");
        await page.keyboard.press("Enter");
        await until(
          page,
          state,
          (s) => s.inside.surface.text === "No volume element has this value inside.",
          "none",
        );
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "inside_section_is_pointed_at_in_the_headset",
    skip,
    async run({ browser }) {
      const { url, end } = await viewModel();
      try {
        const { page, context } = await openPage(browser, url, { width: 480, height: 620, headset: true });
        await cutAlong(page);
        await enterHeadset(page);
        const aim = (y) =>
          page.evaluate((to) => window.headset.controllers.right.position.set(0.05, to, -0.2), y);
        let met = null;
        for (let y = 1.3; y > 0.85 && !met?.interior; y -= 0.004) {
          await aim(y);
          await page.evaluate(() => new Promise((done) => window.setTimeout(done, 60)));
          met = await page.evaluate(probe);
        }
        assert.ok(met?.interior, "the ray meets the section");
        assert.equal(met.pointer, "right-controller");
        assert.ok(Math.abs(met.point[1] - PLACE) < 0.5, `on the plane: ${met.point}`);
        assert.ok(met.results[0].value > 100);
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "inside_of_a_scene_alone_is_hatched_and_the_page_says_that_it_has_no_volume_elements",
    skip: whyNoScene("examples/boiler/boiler.frd"),
    async run({ browser }) {
      const { url, end } = await viewBoiler();
      try {
        const { page, context, problems } = await openPage(browser, url);
        await page.keyboard.press("c");
        const { sections, inside } = await until(page, state, (s) => s.cuts.length === 1, "a plane");
        assert.deepEqual([sections, inside], [null, null]);
        const section = await unfold(page, "cuts");
        await section.getByText("this scene has no volume elements").waitFor();
        assert.equal(await page.locator("[data-section='inside']").count(), 0);
        assert.deepEqual(problems, []);
        const [status, text] = await page.evaluate(async () => {
          const reply = await fetch("inside/point?at=0,0,0&step=1&results=temperature");
          return [reply.status, await reply.text()];
        });
        assert.deepEqual([status, text], [404, "this scene has no volume elements: open the model file\n"]);
        await context.close();
      } finally {
        end();
      }
    },
  },
];
