// SPDX-License-Identifier: Apache-2.0
// The table of interactions: the touch probe, what bare hands do beside pointing, and comfort while the world moves.
import assert from "node:assert/strict";
import { HEARD, listen, until } from "./harness.mjs";
import { resultIdOf, valueAtPoint } from "./oracle.mjs";
import {
  aim,
  button,
  enter,
  fingerAt,
  frames,
  hand,
  joint,
  nodeInRoom,
  panelButton,
  pinch,
  pinchPanel,
  pressPanel,
  useHands,
} from "./vr-hands.mjs";
import { scrubPlace } from "./vr-pinches.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const rayOf = (s, pointer) => s.headset.rays.find((r) => r.pointer === pointer).ray;
const scaleOf = (m) => Math.hypot(...m.slice(0, 3));

/** Every result at the report's place is what the file's values give there. */
function assertTrue(scene, report) {
  assert.ok(report.results.length >= 3);
  for (const entry of report.results) {
    const there = valueAtPoint(scene, resultIdOf(scene, entry), 1, report.elementId, report.point);
    assert.ok(
      Math.abs(entry.value - there.value) <= 1e-4 * Math.max(1, Math.abs(there.value)),
      `${entry.name}: ${entry.value} is not ${there.value}`,
    );
  }
}

export const vrTouchTests = [
  {
    name: "vr_controller_tip_near_the_skin_reads_it_without_a_ray",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await enter(browser, url);
      const { deformationFactor } = await page.evaluate(state);
      const on = nodeInRoom(80, 20, 30, deformationFactor);
      // 2 cm above the skin, pointing up: the ray meets nothing.
      const over = (metres) => [on[0], on[1] + metres, on[2]];
      await aim(page, "right", over(0.02), [on[0], 3, on[2]]);
      const seen = await until(page, probe, (r) => r?.pointer === "right-controller", "the touched place");
      assert.ok(Math.abs(seen.point[0] - 80) < 1.5 && Math.abs(seen.point[2] - 30) < 1e-3, `${seen.point}`);
      assertTrue(scene, seen);
      const touching = await page.evaluate(state);
      assert.deepEqual(touching.headset.touching, ["right-controller"]);
      assert.equal(rayOf(touching, "right-controller"), null, "no ray while it touches");
      // The gate: nothing is heard or felt before the trigger.
      await frames(page, 6);
      assert.ok((await page.evaluate(listen)).level < 1e-4);
      assert.equal((await page.evaluate(() => window.feelem.pulses())).length, 0);
      await button(page, "right", "trigger", 1);
      const { hz, pulse } = await page.evaluate(probe);
      await until(page, listen, (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01, "the tone");
      const felt = await until(
        page,
        () => window.feelem.pulses(),
        (p) => p.length >= 2,
        "pulses",
      );
      assert.ok(felt.every((p) => p.pointer === "right-controller"));
      assert.ok(felt.some((p) => Math.abs(p.amplitude - pulse.amplitude) < 1e-9));
      await button(page, "right", "trigger", 0);
      await until(page, listen, (h) => h.level < 1e-4, "silence after the release");
      // 4 cm are too far.
      await aim(page, "right", over(0.04), [on[0], 3, on[2]]);
      const away = await until(page, state, (s) => s.headset.touching.length === 0, "no touch");
      assert.ok(rayOf(away, "right-controller") > 0, "the ray again");
      assert.equal(await page.evaluate(probe), null);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_touch_alone_is_heard_and_felt_where_the_person_wants_that",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      await pressPanel(page, "tab:move");
      await pressPanel(page, "move:byTouch");
      await until(page, state, (s) => s.person.byTouch, "by touch");
      const { deformationFactor } = await page.evaluate(state);
      const on = nodeInRoom(80, 20, 30, deformationFactor);
      await aim(page, "right", [on[0], on[1] + 0.02, on[2]], [on[0], 3, on[2]]);
      const { hz } = await until(page, probe, (r) => r?.hz > 0, "the touched place");
      await until(page, listen, (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01, "the tone");
      await until(
        page,
        () => window.feelem.pulses().length,
        (n) => n >= 2,
        "pulses",
      );
      // A ray is not a touch.
      await aim(page, "right", [on[0], on[1] + 0.35, on[2] + 0.5], on);
      await until(page, listen, (h) => h.level < 1e-4, "silence of a ray that is not pressed");
      assert.ok((await page.evaluate(probe)) !== null);
      await context.close();
    },
  },
  {
    name: "vr_index_finger_on_the_skin_reads_it_and_a_pinch_there_is_heard",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await enter(browser, url);
      await useHands(page);
      const { deformationFactor } = await page.evaluate(state);
      const on = nodeInRoom(80, 20, 30, deformationFactor);
      await fingerAt(page, "right", [on[0], on[1] + 0.01, on[2]]);
      const seen = await until(page, probe, (r) => r?.pointer === "right-hand", "the touched place");
      assert.ok(Math.abs(seen.point[0] - 80) < 1.5 && Math.abs(seen.point[2] - 30) < 1e-3, `${seen.point}`);
      assertTrue(scene, seen);
      const touching = await page.evaluate(state);
      assert.deepEqual(touching.headset.touching, ["right-hand"]);
      assert.equal(rayOf(touching, "right-hand"), null, "no ray while it touches");
      await page.evaluate(() => window.headset.hands.right.updatePinchValue(1));
      // The finger bends as it pinches: the place is held once it rests.
      let before = 0;
      const rests = ({ hz }) => {
        const same = hz === before;
        before = hz;
        return hz > 0 && same;
      };
      await until(page, probe, (r) => r?.hz > 0, "the place that is held");
      await frames(page, 6);
      const held = await until(page, probe, (r) => r && rests(r), "a finger that rests");
      const isHeard = (h) => h.level > HEARD && Math.abs(h.hz / held.hz - 1) < 0.02;
      await until(page, listen, isHeard, `the tone of ${held.hz} Hz`);
      const model = (await page.evaluate(state)).headset.model;
      await page.evaluate(() => window.headset.hands.right.updatePinchValue(0));
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      assert.deepEqual((await page.evaluate(state)).headset.model, model, "a touch does not carry");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_resting_pinch_shows_a_ring_and_leaves_a_note",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await useHands(page);
      const { deformationFactor } = await page.evaluate(state);
      const to = nodeInRoom(80, 20, 30, deformationFactor);
      await hand(page, "right", [to[0], to[1] + 0.35, to[2] + 0.5], to);
      const { nodeId } = await until(page, probe, (r) => r?.pointer === "right-hand", "the hand's ray");
      const ring = (s) => s.headset.rings.find((r) => r.pointer === "right-hand").offer;
      // Let go before the ring comes: no note.
      await page.evaluate(() => window.headset.hands.right.updatePinchValue(1));
      await frames(page, 2);
      await page.evaluate(() => window.headset.hands.right.updatePinchValue(0));
      await frames(page, 3);
      assert.equal((await page.evaluate(state)).pins.length, 0);
      // Let go while it is there: a note at the node.
      await page.evaluate(() => window.headset.hands.right.updatePinchValue(1));
      const during = await page.evaluate(
        () =>
          new Promise((resolve) => {
            const seen = [];
            const look = () => {
              const offer = window.feelem.state().headset.rings.find((r) => r.pointer === "right-hand").offer;
              seen.push(offer);
              if (offer > 0) {
                window.headset.hands.right.updatePinchValue(0);
                resolve(seen);
              } else window.xrSession.requestAnimationFrame(look);
            };
            window.xrSession.requestAnimationFrame(look);
          }),
      );
      assert.ok(during.length > 2 && during[0] === 0, `the ring came after a while: ${during}`);
      const { pins } = await until(page, state, (s) => s.pins.length === 1, "a note");
      assert.equal(pins[0].node, nodeId);
      assert.equal(ring(await page.evaluate(state)), 0, "the ring is gone");
      // Held on, the ring goes again, and no note is left.
      await page.evaluate(() => window.headset.hands.right.updatePinchValue(1));
      await until(page, state, (s) => ring(s) > 0, "the ring");
      await until(page, state, (s) => ring(s) === 0, "no ring for who only listens");
      await pinch(page, "right", 0);
      assert.equal((await page.evaluate(state)).pins.length, 1);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_hands_drag_the_planes_knob_scrub_and_carry_by_the_bar",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ times: 5 });
      const { page, context, problems } = await enter(browser, url);
      await useHands(page);
      await pinchPanel(page, "tab:cuts");
      await pinchPanel(page, "cuts:x");
      const before = await until(page, state, (s) => s.headset.knobs[0], "a knob");
      const knob = before.headset.knobs[0];
      const from = [knob[0], knob[1] + 0.35, knob[2] + 0.5];
      const aside = ([x, y, z], by) => [x + by, y, z];
      await hand(page, "right", from, knob);
      await pinch(page, "right", 1);
      // The wrist gives way while the fingers close: what counts is the way from here.
      const start = (await page.evaluate(state)).cuts[0].offset;
      await hand(page, "right", aside(from, -0.1), aside(knob, -0.1));
      await until(page, state, (s) => Math.abs(s.cuts[0].offset - start + 15) < 0.1, "15 mm less");
      await pinch(page, "right", 0);
      // The scrubber: pressed in the middle, drawn to its end.
      await pinchPanel(page, "tab:results");
      const { steps } = await page.evaluate(() => window.feelem.scene());
      const eye = [0.1, 1.3, -0.1];
      await hand(page, "right", eye, await scrubPlace(page, 0.5));
      await pinch(page, "right", 1);
      await until(page, state, (s) => s.step === steps[3].id, "the step in the middle");
      await hand(page, "right", eye, await scrubPlace(page, 1));
      await until(page, state, (s) => s.step === steps.at(-1).id, "the last step");
      await pinch(page, "right", 0);
      // The bar under the model.
      const { headset } = await page.evaluate(state);
      const grip = [headset.bar[0] + 0.1, headset.bar[1], headset.bar[2] + 0.4];
      await hand(page, "right", grip, headset.bar);
      await pinch(page, "right", 1);
      await frames(page, 8);
      const held = (await page.evaluate(state)).headset.model;
      const ahead = headset.bar.map((v, i) => v + [0, 0.1, 0.2][i]);
      await hand(page, "right", [grip[0], grip[1] + 0.1, grip[2] + 0.2], ahead);
      const carried = (await page.evaluate(state)).headset.model;
      for (const [i, by] of [0, 0.1, 0.2].entries())
        assert.ok(
          Math.abs(carried[12 + i] - held[12 + i] - by) < 0.005,
          `axis ${i}: ${carried[12 + i] - held[12 + i]}`,
        );
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "vr_palm_turned_up_bears_the_menu_that_mutes_and_brings_home",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await useHands(page);
      await hand(page, "left", [-0.2, 1.1, -0.35], [-0.2, 1.1, -2]);
      assert.equal((await page.evaluate(state)).headset.menu, null, "palm down: no menu");
      // Rolled over: palm up.
      await page.evaluate(() => window.headset.hands.left.quaternion.set(0, 0, 1, 0));
      await frames(page, 4);
      const { headset } = await until(page, state, (s) => s.headset.menu?.hand === "left-hand", "the menu");
      const wrist = await joint(page, "left", "wrist");
      const apart = Math.hypot(...wrist.map((v, k) => v - headset.menu.matrix[12 + k]));
      assert.ok(apart < 0.15, `${apart} m from the wrist`);
      assert.equal(
        rayOf(await page.evaluate(state), "left-hand"),
        null,
        "the hand that bears it does not point",
      );
      const press = async (id) => {
        await hand(page, "right", [0.1, 1.2, -0.1], await panelButton(page, id, "menu"));
        await pinch(page, "right", 1);
        await pinch(page, "right", 0);
      };
      const playing = () => document.querySelector("[aria-label='sound']").ariaPressed;
      await press("menu:sound");
      await until(page, playing, (p) => p === "false", "muted");
      await press("menu:sound");
      await until(page, playing, (p) => p === "true", "sound again");
      await press("menu:touch");
      await until(
        page,
        () => document.querySelector("[aria-label='touch']").ariaPressed,
        (p) => p === "false",
        "still",
      );
      const seen = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      await press("menu:result");
      await until(page, state, (s) => seen(s) === "U", "the next result");
      await press("menu:true-size");
      const small = await until(page, state, (s) => scaleOf(s.headset.model) < 0.0011, "1:1");
      assert.ok(Math.abs(scaleOf(small.headset.model) - 0.001) < 1e-9, "a millimetre is a millimetre");
      await press("menu:home");
      await until(
        page,
        state,
        (s) => Math.abs(scaleOf(s.headset.model) - 0.8 / 120) < 1e-6,
        "home on the table",
      );
      await page.evaluate(() => window.headset.hands.left.quaternion.set(0, 0, 0, 1));
      await frames(page, 4);
      assert.equal((await page.evaluate(state)).headset.menu, null, "palm down: no menu");
      // Walking and turning are on the panel.
      const { position } = (await page.evaluate(state)).headset.head;
      await pinchPanel(page, "tab:move");
      await pinchPanel(page, "move:ahead");
      const walked = await until(
        page,
        state,
        (s) => s.headset.head.position[2] < position[2] - 0.4,
        "a step",
      );
      assert.ok(Math.abs(walked.headset.head.position[2] - position[2] + 0.5) < 1e-3, "half a metre");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
