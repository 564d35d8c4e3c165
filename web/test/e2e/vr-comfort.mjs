// SPDX-License-Identifier: Apache-2.0
// Rules of the table of interactions: where things stand at first, nothing moves by itself, comfort, menu at the wrist.
import assert from "node:assert/strict";
import { until } from "./harness.mjs";
import { aim, aimAtNode, button, enter, frames, panelButton, pressPanel } from "./vr-hands.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();
const scaleOf = (m) => Math.hypot(...m.slice(0, 3));

/** The middle of the tiny bar in the room. */
const middleOf = (m) => [0, 1, 2].map((k) => m[k] * 60 + m[4 + k] * 20 + m[8 + k] * 15 + m[12 + k]);

/** Both controllers beside the body. */
async function grips(page, left, right) {
  await page.evaluate(
    ([left, right]) => {
      const turn = [0, 0, 0, 1];
      for (const [hand, at] of Object.entries({ left, right })) {
        window.headset.controllers[hand].position.set(...at);
        window.headset.controllers[hand].quaternion.set(...turn);
      }
    },
    [left, right],
  );
  await frames(page, 3);
}

/** Moves the left controller by so many metres with each frame; what the vignette was after each. */
const carryBy = (page, by, count) =>
  page.evaluate(
    ({ by, count }) =>
      new Promise((resolve) => {
        const seen = [];
        const step = () => {
          const { position } = window.headset.controllers.left;
          position.set(position.x, position.y, position.z + by);
          seen.push(window.feelem.state().headset.vignette);
          if (seen.length === count) resolve(seen);
          else window.xrSession.requestAnimationFrame(step);
        };
        window.xrSession.requestAnimationFrame(step);
      }),
    { by, count },
  );

export const vrComfortTests = [
  {
    name: "vr_starts_on_the_table_before_the_person_and_nothing_moves_by_itself",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const start = (await page.evaluate(state)).headset;
      for (const [i, wanted] of [0, 1, -1.2].entries())
        assert.ok(
          Math.abs(middleOf(start.model)[i] - wanted) < 1e-3,
          `the middle is at ${middleOf(start.model)}`,
        );
      assert.ok(Math.abs(120 * scaleOf(start.model) - 0.8) < 1e-6, "0.8 m large");
      await frames(page, 30);
      const later = (await page.evaluate(state)).headset;
      for (const key of ["model", "head", "panel", "legend", "bar"])
        assert.deepEqual(later[key], start[key], key);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_seated_person_finds_table_and_boards_at_their_own_height",
    async run({ browser, url }) {
      const { page, context } = await enter(browser, url);
      await page.evaluate(() => window.headset.position.set(0.3, 1.15, 0.4));
      await frames(page, 3);
      await button(page, "right", "thumbstick", 1);
      await frames(page, 4);
      await button(page, "right", "thumbstick", 0);
      const { headset } = await page.evaluate(state);
      for (const [i, wanted] of [0.3, 1, 0.4 - 1.2].entries())
        assert.ok(
          Math.abs(middleOf(headset.model)[i] - wanted) < 1e-3,
          `the middle is at ${middleOf(headset.model)}`,
        );
      assert.ok(Math.abs(headset.panel.matrix[13] - 1.05) < 1e-3, "the panel at the height of the eyes");
      await context.close();
    },
  },
  {
    name: "vr_edge_of_sight_goes_dark_while_a_world_moves_fast_and_only_then",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const squeeze = (on) => button(page, "left", "squeeze", on);
      // On the table it is a thing in the hand: however fast it is carried, sight stays open.
      await grips(page, [-0.2, 1.1, -0.4], [0.2, 1.1, -0.4]);
      await squeeze(1);
      await frames(page, 3);
      assert.deepEqual(new Set(await carryBy(page, 0.2, 4)), new Set([0]));
      await squeeze(0);
      await frames(page, 3);
      await grips(page, [-0.2, 1.1, -0.4], [0.2, 1.1, -0.4]);
      await squeeze(1);
      // Ten times as large it surrounds the person.
      await button(page, "right", "squeeze", 1);
      await frames(page, 3);
      await grips(page, [-2, 1.1, -0.4], [2, 1.1, -0.4]);
      await button(page, "right", "squeeze", 0);
      await frames(page, 12);
      const large = (await page.evaluate(state)).headset;
      // The grips are not quite where the rays begin.
      assert.ok(120 * scaleOf(large.model) > 7, "it is some 8 m large");
      assert.equal(large.vignette, 0, "it rests");
      // A frame of software takes a quarter of a second at most, so that this is a metre a second and more.
      const fast = await carryBy(page, 0.25, 14);
      assert.ok(Math.max(...fast) > 0.5, `dark while it moves: ${fast}`);
      await frames(page, 24);
      assert.equal((await page.evaluate(state)).headset.vignette, 0, "open again at rest");
      // A millimetre a frame is a stroll.
      assert.deepEqual(new Set(await carryBy(page, 0.001, 6)), new Set([0]));
      await squeeze(0);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_vignette_and_upright_lock_are_the_persons_choice",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await pressPanel(page, "tab:move");
      await pressPanel(page, "move:shade-off");
      await until(page, state, (s) => s.person.vignette === 0, "no vignette");
      await pressPanel(page, "move:upright");
      await until(page, state, (s) => s.person.upright === false, "no lock");
      const both = async (on) => {
        for (const hand of ["left", "right"]) await button(page, hand, "squeeze", on);
        await frames(page, 3);
      };
      await grips(page, [-0.2, 1.1, -0.4], [0.2, 1.1, -0.4]);
      await both(1);
      // Free of the lock, the model tilts as the hands do: the left one down, the right one up.
      await grips(page, [-0.2, 0.9, -0.4], [0.2, 1.3, -0.4]);
      const tilted = (await page.evaluate(state)).headset.model;
      const along = tilted.slice(0, 3).map((v) => v / scaleOf(tilted));
      assert.ok(Math.abs(along[1] - Math.SQRT1_2) < 0.01, `the bar's axis rises: ${along}`);
      await grips(page, [-2, 1.1, -0.4], [2, 1.1, -0.4]);
      await button(page, "right", "squeeze", 0);
      await frames(page, 6);
      assert.ok(120 * scaleOf((await page.evaluate(state)).headset.model) > 5);
      assert.deepEqual(new Set(await carryBy(page, 0.3, 6)), new Set([0]), "no vignette for who wants none");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_menu_at_the_wrist_of_the_other_hand_mutes_steps_and_brings_home",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await aim(page, "left", [-0.2, 1.1, -0.45], [-0.2, 1.1, -2]);
      const call = async () => {
        await button(page, "right", "b-button", 1);
        await frames(page, 3);
        await button(page, "right", "b-button", 0);
        await frames(page, 3);
      };
      await call();
      const { headset } = await until(page, state, (s) => s.headset.menu !== null, "the menu");
      assert.equal(headset.menu.hand, "left-controller");
      const wrist = [-0.2, 1.1, -0.45];
      const apart = Math.hypot(...wrist.map((v, k) => v - headset.menu.matrix[12 + k]));
      assert.ok(apart < 0.2, `${apart} m from the hand`);
      const press = async (id) => {
        await aim(page, "right", [0.1, 1.25, -0.1], await panelButton(page, id, "menu"));
        await button(page, "right", "trigger", 1);
        await frames(page, 3);
        await button(page, "right", "trigger", 0);
        await frames(page, 3);
      };
      const sound = () => document.querySelector("[aria-label='sound']").ariaPressed;
      await press("menu:sound");
      await until(page, sound, (p) => p === "false", "muted");
      const before = (await page.evaluate(state)).step;
      await press("menu:next");
      await until(page, state, (s) => s.step !== before, "the next step");
      await press("menu:back");
      await until(page, state, (s) => s.step === before, "the step before");
      await press("menu:cut");
      await until(page, state, (s) => s.cuts.length === 1, "a plane");
      await press("menu:true-size");
      await until(page, state, (s) => Math.abs(scaleOf(s.headset.model) - 0.001) < 1e-9, "1:1");
      await press("menu:table");
      await until(page, state, (s) => Math.abs(120 * scaleOf(s.headset.model) - 0.8) < 1e-6, "on the table");
      await call();
      assert.equal((await page.evaluate(state)).headset.menu, null, "sent away");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_bar_under_the_model_carries_it_by_the_trigger_too",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const { headset } = await page.evaluate(state);
      const from = [headset.bar[0] + 0.05, headset.bar[1] + 0.1, headset.bar[2] + 0.4];
      const by = [0.1, 0.05, 0.1];
      const carry = async (to) => {
        await aim(page, "right", from, to);
        await button(page, "right", "trigger", 1);
        await frames(page, 3);
        const before = (await page.evaluate(state)).headset.model;
        const moved = (v) => v.map((c, i) => c + by[i]);
        await aim(page, "right", moved(from), moved(to));
        const after = (await page.evaluate(state)).headset.model;
        await button(page, "right", "trigger", 0);
        await frames(page, 3);
        return [12, 13, 14].map((i) => after[i] - before[i]);
      };
      // Beside the bar a trigger takes hold of nothing.
      assert.deepEqual(await carry([headset.bar[0] + 0.4, headset.bar[1], headset.bar[2]]), [0, 0, 0]);
      const carried = await carry(headset.bar);
      for (const [i, v] of by.entries()) assert.ok(Math.abs(carried[i] - v) < 1e-4, `carried by ${carried}`);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_panel_turns_the_person_and_comes_along",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      const start = (await page.evaluate(state)).headset;
      await pressPanel(page, "tab:move");
      await pressPanel(page, "move:turn-left");
      const turned = (await page.evaluate(state)).headset;
      assert.ok(Math.abs(turned.head.yaw - start.head.yaw - Math.PI / 6) < 1e-3, `yaw ${turned.head.yaw}`);
      // The panel is where it was for the eyes: 30 degrees further to the left in the room.
      const bearing = (h) =>
        Math.atan2(h.panel.matrix[12] - h.head.position[0], -(h.panel.matrix[14] - h.head.position[2]));
      assert.ok(Math.abs(bearing(turned) - bearing(start) + Math.PI / 6) < 1e-3, "the panel comes along");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "vr_other_motors_are_played_where_there_is_no_pulse",
    async run({ browser, url }) {
      const { page, context, problems } = await enter(browser, url);
      await page.evaluate(() => {
        window.played = [];
        for (const hand of ["left", "right"]) {
          const { gamepad } = window.headset.controllers[hand].inputSource;
          Object.defineProperty(gamepad, "hapticActuators", { value: [] });
          Object.defineProperty(gamepad, "vibrationActuator", {
            value: {
              playEffect: (type, given) => {
                window.played.push({ hand, type, ...given });
                return Promise.resolve("complete");
              },
            },
          });
          window.headset.controllers[hand].connected = false;
        }
      });
      await frames(page, 4);
      await page.evaluate(() => {
        for (const hand of ["left", "right"]) window.headset.controllers[hand].connected = true;
      });
      await frames(page, 4);
      await aimAtNode(page, "right", 6, 2, 3);
      await button(page, "right", "trigger", 1);
      const said = await until(
        page,
        () => window.feelem.pulses(),
        (p) => p.length >= 3,
        "pulses",
      );
      const { pulse } = await page.evaluate(probe);
      await button(page, "right", "trigger", 0);
      await frames(page, 4);
      const played = await page.evaluate(() => window.played);
      assert.ok(played.length >= 3);
      assert.ok(played.every((p) => p.hand === "right" && p.type === "dual-rumble"));
      for (const [i, p] of said.entries()) {
        assert.equal(played[i].strongMagnitude, p.amplitude);
        assert.equal(played[i].duration, p.ms);
      }
      assert.ok(
        said.some((p) => Math.abs(p.amplitude - pulse.amplitude) < 1e-9),
        "the same plan of pulses",
      );
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
