// SPDX-License-Identifier: Apache-2.0
// Claims of docs/senses.md that only the whole page can show: what is drawn, said, heard and felt of one value.
import assert from "node:assert/strict";
import { workshop } from "./binary.mjs";
import { HEARD, listen, openPage, pixelsOf, until } from "./harness.mjs";
import { middle, viewFrom } from "./look.mjs";
import { BOILER, BOILER_OPTIONS, whyNot } from "./program.mjs";
import { chooseColours, gridOf, legendRows, plainModel, probedAt, readingOf, settled } from "./read-back.mjs";
import { aim, button, enter, frames } from "./vr-hands.mjs";

const measured = (claim, figure) => console.log(`measured ${claim}: ${figure}`);

/** Reading errors (share of the range) over a ball of one value after the other. */
async function errorsOnBall(page, shares) {
  const [mid] = await page.evaluate(() => window.feelem.scene().results[0].values.map((v) => v.max.value));
  const points = await gridOf(page, 45, 31);
  const on = (await probedAt(page, points)).map((report) => report !== null);
  const errors = [];
  for (const share of shares) {
    await chooseColours(page, { lo: mid - 100 * share, hi: mid + 100 * (1 - share) });
    const png = await page.screenshot();
    const read = readingOf(await legendRows(page, png));
    const drawn = await pixelsOf(page, png, points);
    for (const [i, colour] of drawn.entries()) if (on[i]) errors.push(Math.abs(read(colour) - share));
  }
  assert.ok(errors.length >= 200 * shares.length, `${errors.length} pixels`);
  return {
    mean: errors.reduce((a, b) => a + b, 0) / errors.length,
    max: errors.reduce((a, b) => Math.max(a, b), 0),
  };
}

const EVERYWHERE = [0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.98];
const HERE_AND_THERE = [0.1, 0.3, 0.5, 0.7, 0.9];

const probe = () => window.feelem.lastProbe();

/** The boiler on a page of its own; `use` gets it. */
async function withBoiler(browser, use, options = {}) {
  const shop = await workshop();
  try {
    const url = await shop.show(shop.convert("boiler.glb", `${BOILER}/boiler.frd`, ...BOILER_OPTIONS));
    const { page, context, problems } = await openPage(browser, url, options);
    await use(page);
    assert.deepEqual(problems, []);
    await context.close();
  } finally {
    await shop.end();
  }
}

const bytesOf = (hex) => [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16));
const VIEWS = ["+x", "-y", "+z", "-z"];

/** Hands the page's numbers and those by the formulas of docs/effects.md back, both computed by the same engine. */
function bitsOf({ reports, lo, hi }) {
  return reports.map((report) => {
    const { value } = report.results.find((r) => r.key === "S");
    const u = Math.min(Math.max((value - lo) / (hi - lo), 0), 1);
    const outside = value < lo ? "below" : value > hi ? "above" : null;
    return {
      outside,
      band: Math.min(Math.floor(u * 9), 8),
      colour: report.colour,
      said: [report.hz, report.tickRate, report.pulse.rate, report.pulse.amplitude],
      wanted: [
        440 * 2 ** ((48 + (84 - 48) * u - 69) / 12),
        1.5 * (12 / 1.5) ** u,
        2 * (10 / 2) ** u,
        0.15 * (1 / 0.15) ** u,
      ],
    };
  });
}

/** Remembers the pitch that the tone is led to: cents above middle C, the last of them in `globalThis.ledTo`. */
function rememberPitch() {
  const glide = AudioParam.prototype.setTargetAtTime;
  const jump = AudioParam.prototype.setValueAtTime;
  // Detune is the one parameter that goes beyond a thousand either way.
  const keep = (parameter, value) => {
    if (parameter.maxValue > 1e5 && parameter.minValue < -1e5 && parameter.maxValue < 1e6)
      globalThis.ledTo = value;
  };
  AudioParam.prototype.setTargetAtTime = function (value, ...rest) {
    keep(this, value);
    return glide.call(this, value, ...rest);
  };
  AudioParam.prototype.setValueAtTime = function (value, ...rest) {
    keep(this, value);
    return jump.call(this, value, ...rest);
  };
}

export const claimTests = [
  {
    name: "V4_shading_of_a_ball_of_one_value_misleads_the_reader_by_two_per_cent_at_most",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ ball: 50, cells: [24, 24, 24] });
      const { page, context } = await openPage(browser, url);
      await plainModel(page);
      await chooseColours(page, { bands: 0 });
      const flat = await errorsOnBall(page, [0.3]);
      assert.ok(flat.max <= 0.01, `unlit: ${flat.max}`);
      await page.keyboard.press("l");
      for (const map of await page
        .getByLabel("colour map", { exact: true })
        .locator("option")
        .allTextContents()) {
        await chooseColours(page, { map: map.replace(" ", "_"), bands: 0 });
        const { mean, max } = await errorsOnBall(page, map === "batlow" ? EVERYWHERE : HERE_AND_THERE);
        measured("V4", `${map}: mean ${(100 * mean).toFixed(2)} %, max ${(100 * max).toFixed(2)} %`);
        assert.ok(mean <= 0.02 && max <= 0.04, `${map}: mean ${mean}, max ${max}`);
      }
      // With bands, every pixel is read as the band it is.
      await chooseColours(page, { map: "batlow", bands: 9 });
      const banded = await errorsOnBall(page, [0.5 / 9, 2.5 / 9, 4.5 / 9, 6.5 / 9, 8.5 / 9]);
      assert.ok(banded.max < 0.5 / 9, `nine bands: ${banded.max}`);
      await context.close();
      await close();
    },
  },
  {
    name: "V5_every_pixel_of_the_boiler_shows_the_band_of_the_value_that_the_probe_says_there",
    skip: whyNot,
    async run({ browser }) {
      await withBoiler(browser, async (page) => {
        await plainModel(page);
        const { results } = await page.evaluate(() => window.feelem.scene());
        let [compared, edges] = [0, 0];
        for (const [row, id] of [
          [1, "temperature"],
          [2, "displacement_magnitude"],
        ]) {
          if (row > 1) await page.click(`tbody tr:nth-child(${row}) button[data-slot='colour']`);
          const { min, max } = results.find((r) => r.id === id).values[0];
          for (const view of VIEWS) {
            await viewFrom(page, view);
            await page.mouse.move(3, 3);
            await settled(page);
            const png = await page.screenshot();
            const rows = await legendRows(page, png);
            const points = await gridOf(page, 40, 30);
            const drawn = await pixelsOf(page, png, points);
            for (const [i, report] of (await probedAt(page, points)).entries()) {
              if (!report) continue;
              const { value } = report.results[row - 1];
              const place = (value - min.value) / (max.value - min.value);
              if (Math.abs(9 * place - Math.round(9 * place)) < 9 * 0.001) {
                edges += 1;
                continue;
              }
              const legend = rows[Math.floor(((Math.floor(9 * place) + 0.5) / 9) * rows.length)];
              assert.deepEqual(drawn[i], legend, `${id} ${value} from ${view} at ${points[i]}`);
              compared += 1;
            }
          }
        }
        assert.ok(compared >= 500, `${compared} points`);
        measured("V5", `${compared} of ${compared} points, ${edges} at edges of bands left out`);
      });
    },
  },
  {
    name: "X1_colour_tone_ticks_pulses_and_card_are_of_one_value_bit_for_bit_over_the_boiler",
    skip: whyNot,
    async run({ browser }) {
      await withBoiler(browser, async (page) => {
        await plainModel(page);
        for (const slot of ["colour", "pitch", "ticks", "pulses"]) {
          const cell = page.locator(`tbody tr[data-key='S'] button[data-slot='${slot}']`);
          if ((await cell.getAttribute("aria-pressed")) === "false") await cell.click();
        }
        const { presentation } = await page.evaluate(() => window.feelem.state());
        assert.deepEqual(
          presentation.effects.map((e) => e.result),
          Array(4).fill("S"),
        );
        const { lo, hi } = presentation.results.find((r) => r.key === "S").range;
        const colours = presentation.effects.find((e) => e.type === "colour");
        let [probed, outside] = [0, 0];
        for (const view of VIEWS) {
          await viewFrom(page, view);
          const reports = (await probedAt(page, await gridOf(page, 40, 30))).filter((r) => r !== null);
          const rows = await legendRows(page, await page.screenshot());
          for (const { said, wanted, band, colour, outside: beyond } of await page.evaluate(bitsOf, {
            reports,
            lo,
            hi,
          })) {
            for (const [k, number] of said.entries())
              assert.ok(Object.is(number, wanted[k]), `${said} is not ${wanted}`);
            const legend = rows[Math.floor(((band + 0.5) / 9) * rows.length)];
            assert.deepEqual(bytesOf(colour), beyond ? bytesOf(colours[beyond]) : legend);
            probed += 1;
            outside += beyond ? 1 : 0;
          }
        }
        assert.ok(probed >= 500 && outside > 0, `${probed} places, ${outside} outside the range`);
        // What the card writes is that value, to six digits.
        const { x, y } = await middle(page);
        await page.mouse.move(x, y);
        const { results } = await until(page, probe, (r) => r !== null, "a place");
        const { value } = results.find((r) => r.key === "S");
        const written = await page.locator(".card tr[data-key='S'] td.value").textContent();
        assert.equal(Number.parseFloat(written), Number(value.toPrecision(6)));
        measured("X1", `${probed} places, all bits equal`);
      });
    },
  },
  {
    name: "A8_X1_the_pose_of_a_frame_is_heard_and_felt_in_that_frame_with_the_probes_own_bits",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url, { before: rememberPitch });
      await aim(page, "right", [0.3, 1.3, -0.4], [0, 1.05, -1.2]);
      await frames(page, 3);
      await button(page, "right", "trigger", 1);
      await until(page, listen, (h) => h.level > HEARD, "a tone");
      const seen = await page.evaluate(
        () =>
          new Promise((done) => {
            const all = [];
            const { right } = window.headset.controllers;
            const step = () => {
              // After all listeners of this frame have run.
              queueMicrotask(() =>
                setTimeout(() => {
                  const report = window.feelem.lastProbe();
                  if (report) all.push({ report, ledTo: globalThis.ledTo });
                  right.position.x += 0.01 * (all.length % 8 < 4 ? 1 : -1);
                  if (all.length < 24) window.xrSession.requestAnimationFrame(step);
                  else done(all);
                }),
              );
            };
            window.xrSession.requestAnimationFrame(step);
          }),
      );
      const cents = await page.evaluate(
        (all) => all.map(({ report }) => 1200 * Math.log2(report.hz / 261.6255653005986)),
        seen,
      );
      assert.ok(new Set(cents).size >= 4, `only ${new Set(cents).size} pitches`);
      for (const [i, { ledTo }] of seen.entries())
        assert.ok(Object.is(ledTo, cents[i]), `frame ${i}: led to ${ledTo}, probed ${cents[i]}`);
      // Resting: each pulse has the amplitude of the probe, to the bit.
      const before = await page.evaluate(() => globalThis.felt.length);
      await until(
        page,
        () => globalThis.felt.length,
        (n) => n >= before + 2,
        "pulses",
      );
      const { felt, report } = await page.evaluate(() => ({
        felt: globalThis.felt.at(-1),
        report: window.feelem.lastProbe(),
      }));
      assert.ok(
        Object.is(felt.value, report.pulse.amplitude),
        `${felt.value} is not ${report.pulse.amplitude}`,
      );
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "H4_without_an_actuator_ticks_sound_and_the_page_says_so",
    async run({ browser, url }) {
      const { page, context } = await openPage(browser, url);
      const note = page.locator(".touch-note");
      assert.equal(await note.textContent(), "Nothing here vibrates: Von Mises stress ticks instead.");
      // Only the ticks: the tone is let go.
      await page.click("tbody tr[data-key='U'] button[data-slot='pitch']");
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      await page.mouse.move(x, y);
      await until(page, probe, (r) => r?.tickRate > 0 && r.hz === 0, "ticks alone");
      await page.mouse.down();
      await until(page, listen, (h) => h.level > HEARD && h.hz > 2200 && h.hz < 4600, "a tick in its band");
      assert.match(await page.locator(".card-sound").textContent(), /^[\d.]+ ticks\/s for touch$/);
      assert.deepEqual(await page.evaluate(() => window.feelem.pulses()), []);
      await page.mouse.up();
      await page.click("tbody tr[data-key='U'] button[data-slot='ticks']");
      assert.equal(await note.textContent(), "Nothing here vibrates: Von Mises stress is on the card alone.");
      await page.click("tbody tr[data-key='S'] button[data-slot='pulses']");
      assert.equal(await note.count(), 0);
      await context.close();
    },
  },
];
