// SPDX-License-Identifier: Apache-2.0
// The table of interactions, row by row: controllers' buttons and sticks, planes in the hand, hands that pinch, and
// pinches that come and go.
import assert from "node:assert/strict";
import { HEARD, listen, until } from "./harness.mjs";
import { resultIdOf, valueAtNode } from "./oracle.mjs";
import {
  aim,
  aimAtNode,
  button,
  enter,
  frames,
  hand,
  nodeInRoom,
  panelButton,
  pinch,
  pressPanel,
  useHands,
} from "./vr-hands.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const near = (a, b, limit, what) =>
  assert.ok(
    a.every((v, i) => Math.abs(v - b[i]) <= limit),
    `${what}: ${a} is not ${b}`,
  );

async function press(page, hand, name) {
  await button(page, hand, name, 1);
  await frames(page, 3);
  await button(page, hand, name, 0);
  await frames(page, 3);
}

async function stick(page, hand, x, y) {
  await page.evaluate(({ hand, x, y }) => window.headset.controllers[hand].updateAxes("thumbstick", x, y), {
    hand,
    x,
    y,
  });
  await frames(page, 3);
}

/** Remembers how high (pixels) the smallest capital letter is on each canvas; runs in the page before its own scripts. */
function rememberLetters() {
  globalThis.letters = {};
  const fill = CanvasRenderingContext2D.prototype.fillText;
  CanvasRenderingContext2D.prototype.fillText = function (...given) {
    const key = `${this.canvas.width} x ${this.canvas.height}`;
    const { actualBoundingBoxAscent: up, actualBoundingBoxDescent: down } = this.measureText("H");
    globalThis.letters[key] = Math.min(globalThis.letters[key] ?? 1e9, up + down);
    return fill.apply(this, given);
  };
}

/** Both eyes as the headset gives them: matrices from the room to the eye, and to what it sees. */
const eyesOf = (page) =>
  page.evaluate(async () => {
    const space = await window.xrSession.requestReferenceSpace("local-floor");
    return new Promise((resolve) =>
      window.xrSession.requestAnimationFrame((_, frame) => {
        const { views } = frame.getViewerPose(space);
        resolve(
          views.map((view) => ({
            projection: [...view.projectionMatrix],
            toEye: [...view.transform.inverse.matrix],
          })),
        );
      }),
    );
  });
const times = (m, v) => [0, 1, 2, 3].map((row) => v.reduce((sum, c, k) => sum + m[4 * k + row] * c, 0));

/** Pointing away from everything. */
const away = (page, hand) => aim(page, hand, [hand === "left" ? -0.2 : 0.2, 1.2, -0.1], [0, 3, -3]);

export const vrRowTests = [
  {
    name: "vr_buttons_note_home_step_result_and_mute",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const node = await aimAtNode(page, "right", 6, 2, 3);
      await until(page, probe, (r) => r?.nodeId === node, `node ${node}`);
      await press(page, "right", "a-button");
      const { pins } = await until(page, state, (s) => s.pins.length === 1, "a note");
      assert.equal(pins[0].node, node);
      const { headset } = await page.evaluate(state);
      await press(page, "right", "b-button");
      await until(
        page,
        state,
        (s) => s.headset.menu?.hand === "left-controller",
        "the menu at the other hand",
      );
      await press(page, "right", "b-button");
      await until(page, state, (s) => s.headset.menu === null, "no menu");
      await press(page, "left", "y-button");
      const seen = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      await until(page, state, (s) => seen(s) === "U", "the next result");
      await press(page, "left", "thumbstick");
      await until(
        page,
        () => document.querySelector("[aria-label='sound']")?.ariaPressed ?? "gone",
        Boolean,
        "mute",
      );
      await stick(page, "left", 1, 0);
      await until(page, state, (s) => s.step === 2, "the next step");
      // Held to the side it is one step, not one a frame.
      await frames(page, 6);
      assert.equal((await page.evaluate(state)).step, 2);
      await stick(page, "left", 0, 0);
      await stick(page, "left", -1, 0);
      await until(page, state, (s) => s.step === 1, "the step before");
      await stick(page, "left", 0, 0);
      // Carried away and home again.
      await away(page, "left");
      await button(page, "left", "squeeze", 1);
      await frames(page, 3);
      await aim(page, "left", [-0.5, 1.5, -0.4], [0, 3, -3]);
      await button(page, "left", "squeeze", 0);
      await frames(page, 3);
      const carried = (await page.evaluate(state)).headset.model;
      assert.ok(Math.hypot(...[12, 13, 14].map((i) => carried[i] - headset.model[i])) > 0.2);
      await press(page, "right", "thumbstick");
      near((await page.evaluate(state)).headset.model, headset.model, 1e-6, "home");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_stick_mutes_and_what_is_held_falls_silent",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      await aimAtNode(page, "right", 8, 2, 3);
      await button(page, "right", "trigger", 1);
      await until(page, listen, (h) => h.level > HEARD, "sound");
      await press(page, "left", "thumbstick");
      await until(page, listen, (h) => h.level < 1e-4, "silence while muted");
      await press(page, "left", "thumbstick");
      await until(page, listen, (h) => h.level > HEARD, "sound again");
      await context.close();
    },
  },
  {
    name: "vr_person_turns_by_thirty_degrees_and_walks_where_the_ray_meets_the_floor",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const at = async () => (await page.evaluate(state)).headset;
      const start = await at();
      await stick(page, "right", 1, 0);
      await frames(page, 8);
      await stick(page, "right", 0, 0);
      const turned = await at();
      assert.ok(Math.abs(turned.head.yaw - start.head.yaw + Math.PI / 6) < 1e-3, `yaw ${turned.head.yaw}`);
      near(turned.head.position, start.head.position, 1e-3, "turning does not move");
      near(turned.model, start.model, 1e-6, "the model stays in the room");
      await stick(page, "right", -1, 0);
      await stick(page, "right", 0, 0);
      assert.ok(Math.abs((await at()).head.yaw - start.head.yaw) < 1e-3);
      // From 1.2 m high to a place of the floor 1 m to the right and half a metre behind.
      await aim(page, "right", [0.2, 1.2, -0.1], [1, 0, 0.5]);
      await stick(page, "right", 0, -1);
      near((await at()).head.position, start.head.position, 1e-3, "aiming does not move");
      await stick(page, "right", 0, 0);
      const walked = await until(page, state, (s) => s.headset.head.position[0] > 0.9, "another place");
      near(walked.headset.head.position, [1, 1.6, 0.5], 0.02, "where the ray met the floor");
      near(walked.headset.model, start.model, 1e-6, "the model stays in the room");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_plane_is_dragged_by_its_knob_and_follows_the_other_hand",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await pressPanel(page, "tab:cuts");
      await pressPanel(page, "cuts:x");
      const before = await until(
        page,
        state,
        (s) => s.headset.knobs.length === 1 && s.headset.knobs[0],
        "a knob",
      );
      assert.equal(before.cuts[0].offset, 60);
      const knob = before.headset.knobs[0];
      // The bar is 0.8 m for 120 mm: 0.2 m to the left are 30 mm less.
      const from = [knob[0], knob[1] + 0.35, knob[2] + 0.5];
      await aim(page, "right", from, knob);
      await button(page, "right", "trigger", 1);
      await frames(page, 3);
      await aim(page, "right", [from[0] - 0.2, from[1], from[2]], [knob[0] - 0.2, knob[1], knob[2]]);
      await until(page, state, (s) => Math.abs(s.cuts[0].offset - 30) < 0.05, "30 mm less");
      await button(page, "right", "trigger", 0);
      await frames(page, 3);
      await away(page, "right");
      const dragged = await page.evaluate(state);
      assert.ok(Math.abs(dragged.cuts[0].offset - 30) < 0.05, "it stays where it was let go");
      assert.ok(
        Math.abs(dragged.headset.knobs[0][0] - (knob[0] - 0.2)) < 1e-3,
        "the knob is where the hand was",
      );
      // X: square to where the left hand points, through the hand.
      const through = nodeInRoom(90, 20, 15, 0);
      await aim(page, "left", through, [through[0] + 1, through[1], through[2]]);
      await button(page, "left", "x-button", 1);
      await until(page, state, (s) => Math.abs(s.cuts[0].offset - 90) < 0.05, "the plane in the hand");
      near((await page.evaluate(state)).cuts[0].normal, [1, 0, 0], 1e-4, "square to the hand");
      await button(page, "left", "x-button", 0);
      await frames(page, 3);
      await away(page, "left");
      assert.ok(Math.abs((await page.evaluate(state)).cuts[0].offset - 90) < 0.05, "it stays");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_left_handed_mirrors_boards_and_buttons_in_the_middle_of_a_stay",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const x = (s) => [s.headset.panel.matrix[12], s.headset.legend.matrix[12]];
      const before = x(await page.evaluate(state));
      assert.ok(before[0] < -0.4 && before[1] > 0.4, `${before}`);
      await pressPanel(page, "tab:listening");
      await pressPanel(page, "listening:leftHanded");
      const after = await until(page, state, (s) => s.person.leftHanded, "left-handed");
      near(
        x(after),
        before.map((v) => -v),
        1e-6,
        "the boards have changed sides",
      );
      // The panel is pressed where it is now, and the left hand has the pointing hand's buttons.
      await pressPanel(page, "tab:results", "left");
      const node = await aimAtNode(page, "left", 6, 2, 3);
      await until(page, probe, (r) => r?.nodeId === node && r.pointer === "left-controller", "the left ray");
      await press(page, "left", "x-button");
      const { pins } = await until(page, state, (s) => s.pins.length === 1, "a note");
      assert.equal(pins[0].node, node);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "V6_vr_boards_are_within_sight_and_their_letters_half_a_degree_high",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url, { before: rememberLetters });
      await aimAtNode(page, "right", 6, 2, 3);
      // Every tab is painted once.
      const { panelPages } = await page.evaluate(state);
      for (const tab of [...panelPages, "results"]) {
        await pressPanel(page, `tab:${tab}`);
        await until(page, state, (s) => s.headset.page === tab, `the tab ${tab}`);
      }
      await aimAtNode(page, "right", 6, 2, 3);
      const { headset } = await until(page, state, (s) => s.headset.card, "the card");
      const letters = await page.evaluate(() => globalThis.letters);
      assert.ok(headset.labels.length >= 2, "labels of extremes");
      let least = Number.POSITIVE_INFINITY;
      const eye = headset.head.position;
      const eyes = await eyesOf(page);
      assert.equal(eyes.length, 2);
      const degrees = (rad) => (180 * rad) / Math.PI;
      const boards = ["panel", "legend", "card"].map((name) => [name, headset[name]]);
      for (const [name, board] of [...boards, ...headset.labels.map((label) => ["label", label])]) {
        const { matrix: m, metresWide, metresHigh, width, height } = board;
        const scale = Math.hypot(m[0], m[1], m[2]);
        const distance = Math.hypot(...[12, 13, 14].map((i, k) => m[i] - eye[k]));
        const high = (letters[`${width} x ${height}`] * metresWide * scale) / width;
        const angle = degrees(2 * Math.atan(high / 2 / distance));
        least = Math.min(least, angle);
        assert.ok(angle >= 0.5, `${name}: letters of ${angle.toFixed(2)} degrees`);
        for (const [u, v] of [
          [-0.5, 0.5],
          [0.5, 0.5],
          [-0.5, -0.5],
          [0.5, -0.5],
        ]) {
          const at = [0, 1, 2].map((k) => m[k] * u * metresWide + m[4 + k] * v * metresHigh + m[12 + k]);
          for (const { projection, toEye } of eyes) {
            const [x, y, , w] = times(projection, times(toEye, [...at, 1]));
            assert.ok(
              w > 0 && Math.abs(x / w) < 1 && Math.abs(y / w) < 1,
              `${name}: a corner of it is cut off: ${(x / w).toFixed(2)} ${(y / w).toFixed(2)}`,
            );
          }
        }
      }
      console.log(`measured V6: smallest capital letter ${least.toFixed(2)} degrees`);
      await context.close();
    },
  },
  {
    name: "vr_hands_sense_by_pinch_press_the_panel_and_carry_the_model",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await enter(browser, url);
      await useHands(page);
      const { deformationFactor } = await page.evaluate(state);
      const to = nodeInRoom(80, 20, 30, deformationFactor);
      await hand(page, "right", [to[0], to[1] + 0.35, to[2] + 0.5], to);
      const seen = await until(page, probe, (r) => r?.pointer === "right-hand" && r.nodeId, "the hand's ray");
      for (const entry of seen.results)
        assert.equal(entry.nodeValue, valueAtNode(scene, resultIdOf(scene, entry), 1, seen.nodeId));
      await pinch(page, "right", 1);
      const { hz } = await page.evaluate(probe);
      await until(
        page,
        listen,
        (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01,
        `a tone of ${hz} Hz`,
      );
      const { tickRate } = await page.evaluate(probe);
      assert.ok(tickRate > 0, "ticks stand in for pulses where nothing shakes");
      const { pulse } = await page.evaluate(probe);
      const rings = (s) => s.headset.rings.find((r) => r.pointer === "right-hand");
      const shown = await until(page, state, (s) => rings(s).pulses >= 2, "rings that show pulses");
      // Whoever rests on a place for a while feels it at half the strength.
      const share = rings(shown).strength / pulse.amplitude;
      assert.ok(
        Math.min(Math.abs(share - 1), Math.abs(share - 0.5)) < 1e-9,
        "as wide as the pulse is strong",
      );
      await pinch(page, "right", 0);
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      assert.equal((await page.evaluate(() => window.feelem.pulses())).length, 0);
      await hand(page, "right", [0.1, 1.3, -0.1], await panelButton(page, "deform:true"));
      await pinch(page, "right", 1);
      await pinch(page, "right", 0);
      await until(page, state, (s) => s.deformationFactor === 1, "true scale");
      // A pinch on nothing carries the model, two scale it.
      const origin = async () => (await page.evaluate(state)).headset.model;
      await hand(page, "right", [0.3, 1.2, -0.3], [0.3, 3, -3]);
      await pinch(page, "right", 1);
      // The wrist gives way while the fingers close.
      await frames(page, 12);
      const start = await origin();
      await hand(page, "right", [0.5, 1.2, -0.3], [0.5, 3, -3]);
      const carried = await origin();
      near([carried[12] - start[12], carried[13] - start[13]], [0.2, 0], 0.01, "carried by 0.2 m");
      await hand(page, "left", [-0.1, 1.2, -0.3], [-0.1, 3, -3]);
      await pinch(page, "left", 1);
      await hand(page, "left", [-0.7, 1.2, -0.3], [-0.7, 3, -3]);
      const scaled = await origin();
      assert.ok(Math.abs(Math.hypot(...scaled.slice(0, 3)) / Math.hypot(...carried.slice(0, 3)) - 2) < 0.05);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
