// SPDX-License-Identifier: Apache-2.0
// The table of interactions for headsets that know eyes only while one pinches: no gamepad, no hover, all by pinches.
import assert from "node:assert/strict";
import { HEARD, listen, until } from "./harness.mjs";
import { enter, fingerAt, frames, nodeInRoom, panelButton, useHands, usePinches } from "./vr-hands.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const model = async (page) => (await page.evaluate(state)).headset.model;
const scaleOf = (m) => Math.hypot(...m.slice(0, 3));

export const vrPinchTests = [
  {
    name: "vr_transient_headset_that_tracks_hands_touches_by_the_index_finger",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await useHands(page);
      const fingers = await usePinches(page);
      const { deformationFactor } = await page.evaluate(state);
      const on = nodeInRoom(80, 20, 30, deformationFactor);
      await fingerAt(page, "left", [on[0], on[1] + 0.01, on[2]]);
      const seen = await until(page, probe, (r) => r?.pointer === "left-hand", "the touched place");
      assert.ok(Math.abs(seen.point[0] - 80) < 1.5 && Math.abs(seen.point[2] - 30) < 1e-3, `${seen.point}`);
      assert.deepEqual((await page.evaluate(state)).headset.touching, ["left-hand"]);
      // A pinch counts before a touch: what is held is what is meant.
      await fingers.begin(nodeInRoom(30, 20, 30, deformationFactor));
      const held = await until(page, probe, (r) => r?.pointer === "right-transient", "the pinch");
      assert.ok(Math.abs(held.point[0] - 30) < 0.5);
      await fingers.end();
      await until(page, probe, (r) => r?.pointer === "left-hand", "the touched place again");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_transient_pinch_is_heard_while_it_lasts_and_the_hand_sweeps_it",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      const fingers = await usePinches(page);
      const { deformationFactor } = await page.evaluate(state);
      await fingers.begin(nodeInRoom(60, 20, 30, deformationFactor));
      const here = await until(page, probe, (r) => r?.pointer === "right-transient", "the pinch on the bar");
      assert.ok(Math.abs(here.point[0] - 60) < 0.5, `at ${here.point}`);
      await until(page, listen, (h) => h.level > HEARD && Math.abs(h.hz / here.hz - 1) < 0.01, "the tone");
      assert.ok(here.tickRate > 0, "soft ticks stand in for pulses");
      // Nothing shakes: rings show each pulse to the eye.
      const rings = (s) => s.headset.rings.find((r) => r.pointer === "right-transient");
      const shown = await until(page, state, (s) => rings(s)?.pulses >= 2, "rings for pulses");
      // Whoever rests on a place for a while feels it at half the strength.
      const share = rings(shown).strength / here.pulse.amplitude;
      assert.ok(
        Math.min(Math.abs(share - 1), Math.abs(share - 0.5)) < 1e-9,
        "as wide as the pulse is strong",
      );
      // A tenth of a metre of the hand is a tenth of a metre of the room: 15 mm of the bar.
      await fingers.move([0.1, 0, 0]);
      const further = await page.evaluate(probe);
      assert.ok(Math.abs(further.point[0] - 75) < 0.5, `swept to ${further.point}`);
      await until(page, listen, (h) => Math.abs(h.hz / further.hz - 1) < 0.01, "the tone there");
      await fingers.end();
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      await until(page, probe, (r) => r === null, "nobody points");
      assert.equal((await page.evaluate(() => window.feelem.pulses())).length, 0);
      await context.close();
    },
  },
  {
    name: "vr_transient_leaves_a_note_mutes_and_assigns_on_the_panel",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const fingers = await usePinches(page);
      const { deformationFactor } = await page.evaluate(state);
      await fingers.begin(nodeInRoom(60, 20, 30, deformationFactor));
      const { nodeId } = await until(page, probe, (r) => r !== null, "the pinch on the bar");
      await fingers.end();
      await fingers.press("tab:notes");
      await fingers.press("notes:pin");
      const { pins } = await until(page, state, (s) => s.pins.length === 1, "a note");
      assert.equal(pins[0].node, nodeId);
      await fingers.press("tab:results");
      const touch = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      await fingers.press("U:colour");
      await until(page, state, (s) => touch(s) === "U", "displacement is seen");
      await fingers.press("sound");
      await fingers.begin(nodeInRoom(60, 20, 30, deformationFactor));
      await until(page, probe, (r) => r?.hz > 0, "the pinch on the bar");
      await frames(page, 10);
      assert.ok((await page.evaluate(listen)).level < 1e-4, "muted");
      await fingers.end();
      await fingers.press("sound");
      await fingers.begin(nodeInRoom(60, 20, 30, deformationFactor));
      await until(page, listen, (h) => h.level > HEARD, "sound again");
      await fingers.end();
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_transient_carries_by_the_bar_and_two_pinches_turn_and_scale_upright",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const fingers = await usePinches(page);
      const { headset } = await page.evaluate(state);
      await fingers.begin(headset.bar);
      await fingers.move([0.1, 0.05, -0.2]);
      const carried = await model(page);
      for (const [i, by] of [0.1, 0.05, -0.2].entries())
        assert.ok(Math.abs(carried[12 + i] - headset.model[12 + i] - by) < 1e-4, `axis ${i}`);
      await fingers.end();
      // Looking at nothing with both hands: twice as far apart, and one further ahead.
      await fingers.begin([-0.3, 2.4, -2], "left");
      await fingers.begin([0.3, 2.4, -2], "right");
      await fingers.move([-0.2, 0, 0], "left");
      await fingers.move([0.2, 0, 0], "right");
      const wider = await model(page);
      assert.ok(Math.abs(scaleOf(wider) / scaleOf(carried) - 2) < 1e-3, `${scaleOf(wider)}`);
      // The right hand goes up and ahead: the model turns by the way ahead alone.
      await fingers.move([0.2, 0.4, -0.4], "right");
      const turned = await model(page);
      // The solver's z is up in the room: column 2 of the matrix.
      const up = turned.slice(8, 11).map((v) => v / scaleOf(turned));
      assert.ok(up[1] > 0.9999, `it stays upright: ${up}`);
      const along = (m) => Math.atan2(-m[2], m[0]);
      assert.ok(Math.abs(along(turned) - along(wider) - Math.atan2(0.4, 0.8)) < 1e-3, "turned by the hands");
      await fingers.end("left");
      await fingers.end("right");
      const after = await model(page);
      await frames(page, 6);
      assert.deepEqual(await model(page), after, "let go, it stays");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_transient_drags_the_planes_knob_and_scrubs_the_steps",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ times: 5 });
      const { page, context, problems } = await enter(browser, url);
      const fingers = await usePinches(page);
      await fingers.press("tab:cuts");
      await fingers.press("cuts:x");
      const before = await until(page, state, (s) => s.headset.knobs[0], "a knob");
      assert.equal(before.cuts[0].offset, 60);
      await fingers.begin(before.headset.knobs[0]);
      await fingers.move([-0.1, 0, 0]);
      // 0.8 m are 120 mm.
      await until(page, state, (s) => Math.abs(s.cuts[0].offset - 45) < 0.1, "15 mm less");
      await fingers.end();
      assert.ok(Math.abs((await page.evaluate(state)).cuts[0].offset - 45) < 0.1, "it stays");
      await fingers.press("tab:results");
      const { steps } = await page.evaluate(() => window.feelem.scene());
      const left = await scrubPlace(page, 0);
      const right = await scrubPlace(page, 1);
      await fingers.begin(await scrubPlace(page, 0.5));
      const half = steps[Math.round(0.5 * (steps.length - 1))].id;
      await until(page, state, (s) => s.step === half, "the step in the middle");
      await fingers.move(right.map((v, i) => 0.5 * (v - left[i])));
      await until(page, state, (s) => s.step === steps.at(-1).id, "the last step");
      await fingers.move(right.map((v, i) => -0.5 * (v - left[i])));
      await until(page, state, (s) => s.step === steps[0].id, "the first step");
      await fingers.end();
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "vr_transient_walks_turns_and_comes_home_on_the_panel",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const fingers = await usePinches(page);
      const head = async () => (await page.evaluate(state)).headset.head;
      const start = (await page.evaluate(state)).headset;
      await fingers.press("tab:move");
      await fingers.press("move:ahead");
      const ahead = (await head()).position;
      assert.ok(Math.abs(ahead[2] + 0.5) < 1e-3 && Math.abs(ahead[0]) < 1e-3, `half a metre ahead: ${ahead}`);
      const walked = (await page.evaluate(state)).headset;
      assert.deepEqual(walked.model, start.model, "the model stays in the room");
      assert.ok(
        Math.abs(walked.panel.matrix[14] - start.panel.matrix[14] + 0.5) < 1e-3,
        "the panel comes along",
      );
      await fingers.press("move:turn-right");
      const turned = (await page.evaluate(state)).headset;
      assert.ok(Math.abs(turned.head.yaw + Math.PI / 6) < 1e-3, `yaw ${turned.head.yaw}`);
      await fingers.press("move:true-size");
      assert.ok(Math.abs(scaleOf(await model(page)) - 0.001) < 1e-9, "a millimetre is a millimetre");
      await fingers.press("move:table");
      assert.ok(Math.abs(120 * scaleOf(await model(page)) - 0.8) < 1e-6, "on the table");
      // Home: the table is before where one stands and looks now.
      await fingers.press("move:home");
      const home = (await page.evaluate(state)).headset;
      const { position, yaw } = home.head;
      const m = home.model;
      const middle = [0, 1, 2].map((k) => m[k] * 60 + m[4 + k] * 20 + m[8 + k] * 15 + m[12 + k]);
      const wanted = [position[0] - 1.2 * Math.sin(yaw), 1, position[2] - 1.2 * Math.cos(yaw)];
      for (const k of [0, 1, 2])
        assert.ok(Math.abs(middle[k] - wanted[k]) < 1e-3, `${middle} is not ${wanted}`);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];

/** A place of the panel's scrubber, by its share. */
export async function scrubPlace(page, share) {
  const middle = await panelButton(page, "scrub");
  const { panel } = (await page.evaluate(state)).headset;
  const { width } = panel.buttons.find((b) => b.id === "scrub");
  const way = ((share - 0.5) * width * panel.metresWide) / panel.width;
  return middle.map((v, k) => v + panel.matrix[k] * way);
}
