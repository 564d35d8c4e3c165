// SPDX-License-Identifier: Apache-2.0
// Fingers on the page, and the rest of mouse and keyboard.
import assert from "node:assert/strict";
import { HEARD, listen, openPage, PHONE, until } from "./harness.mjs";
import { middle, unfold, viewFrom } from "./look.mjs";
import { resultIdOf, valueAtPoint } from "./oracle.mjs";

const state = () => window.feelem.state();
const probe = () => window.feelem.lastProbe();

const DISTANCE = 5;
const cameraOf = (s) => ({
  target: s.camera.slice(0, 3),
  yaw: s.camera[3],
  distance: s.camera[DISTANCE],
});

/** Fingers by the browser's own input: [x, y] of each. */
async function fingers(context, page) {
  const client = await context.newCDPSession(page);
  return (type, ...points) =>
    client.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
}

export const touchTests = [
  {
    name: "touch_one_finger_senses_two_move_and_scale",
    async run({ browser, url, scene }) {
      const { page, context, problems } = await openPage(browser, url);
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      const touch = await fingers(context, page);
      await touch("touchStart", [x, y]);
      const here = await until(page, probe, (r) => r !== null, "the place under the finger");
      for (const entry of here.results) {
        const there = valueAtPoint(scene, resultIdOf(scene, entry), 1, here.elementId, here.point);
        assert.ok(
          Math.abs(entry.value - there.value) <= 1e-5 * Math.max(1, Math.abs(there.value)),
          entry.name,
        );
      }
      await until(page, listen, (h) => h.level > HEARD && Math.abs(h.hz / here.hz - 1) < 0.01, "the tone");
      assert.ok(here.tickRate > 0, "ticks stand in for pulses");
      await touch("touchMove", [x + 40, y]);
      await until(page, probe, (r) => r && r.point[0] > here.point[0] + 5, "a place further on");
      await touch("touchEnd");
      await until(page, probe, (r) => r === null, "nothing is pointed at");
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      // Two fingers: apart by twice as much is half as far; moved together the target moves.
      const before = cameraOf(await page.evaluate(state));
      await touch("touchStart", [x - 40, y], [x + 40, y]);
      await touch("touchMove", [x - 80, y], [x + 80, y]);
      await touch("touchEnd");
      const near = cameraOf(
        await until(page, state, (s) => s.camera[DISTANCE] < 0.9 * before.distance, "nearer"),
      );
      assert.ok(Math.abs(near.distance / before.distance - 0.5) < 0.02, `${near.distance}`);
      await touch("touchStart", [x - 40, y], [x + 40, y]);
      await touch("touchMove", [x + 20, y], [x + 100, y]);
      await touch("touchEnd");
      const moved = cameraOf(await page.evaluate(state));
      assert.ok(Math.abs(moved.target[0] - near.target[0]) > 1e-4, "the model has moved");
      assert.ok(Math.abs(moved.distance / near.distance - 1) < 1e-3);
      // One finger beside the model turns it.
      await page.keyboard.press("f");
      const whole = cameraOf(await page.evaluate(state));
      const aside = await middle(page, -40, -170);
      await touch("touchStart", [aside.x, aside.y]);
      await touch("touchMove", [aside.x + 50, aside.y]);
      await touch("touchEnd");
      const turned = cameraOf(await page.evaluate(state));
      // The browser keeps the first pixels of a finger for itself.
      const angle = Math.abs(turned.yaw - whole.yaw);
      assert.ok(angle > 0.2 && angle < 0.41, `50 pixels are 0.4 rad at most: ${angle}`);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "mouse_turns_beside_the_model_and_presses_fit_steps_and_mute",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      await viewFrom(page, "+z");
      const start = cameraOf(await page.evaluate(state));
      const aside = await middle(page, -40, -170);
      await page.mouse.move(aside.x, aside.y);
      await page.mouse.down();
      await page.mouse.move(aside.x + 50, aside.y, { steps: 3 });
      assert.equal(await page.evaluate(probe), null, "beside the model nothing is probed");
      await page.mouse.up();
      const turned = cameraOf(await page.evaluate(state));
      assert.ok(Math.abs(Math.abs(turned.yaw - start.yaw) - 0.4) < 1e-4, "50 pixels are 0.4 rad");
      await page.mouse.wheel(0, -300);
      await until(page, state, (s) => s.camera[DISTANCE] < 0.9 * start.distance, "nearer");
      const press = (name) => page.getByRole("button", { name, exact: true }).first().click();
      await press("fit");
      const fitted = cameraOf(await page.evaluate(state));
      assert.ok(
        fitted.distance > 0.9 * start.distance && fitted.yaw === turned.yaw,
        "the whole model, as turned",
      );
      const { step } = await page.evaluate(state);
      await press("next step");
      await until(page, state, (s) => s.step !== step, "the next step");
      await press("previous step");
      await until(page, state, (s) => s.step === step, "the step before");
      const { x, y } = await middle(page);
      await press("sound");
      await page.mouse.move(x, y);
      await page.mouse.down();
      await until(page, probe, (r) => r?.hz > 0, "the mouse on the model");
      await page.waitForTimeout(500);
      assert.ok((await page.evaluate(listen)).level < 1e-4, "muted");
      await page.mouse.up();
      await press("sound");
      await page.mouse.move(x, y);
      await page.mouse.down();
      await until(page, listen, (h) => h.level > HEARD, "sound again");
      await page.mouse.up();
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "mouse_pans_turns_zooms_and_notes_keys_step_fit_and_mute",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      const camera = async () => cameraOf(await page.evaluate(state));
      const { x, y } = await middle(page);
      const drag = async (button, from, dx) => {
        await page.mouse.move(from.x, from.y);
        await page.mouse.down({ button });
        await page.mouse.move(from.x + dx, from.y, { steps: 3 });
        await page.mouse.up({ button });
        return camera();
      };
      const start = await camera();
      const panned = await drag("right", { x, y }, 40);
      assert.notDeepEqual(panned.target, start.target);
      assert.deepEqual([panned.yaw, panned.distance], [start.yaw, start.distance]);
      const turned = await drag("middle", { x, y }, 50);
      assert.ok(Math.abs(Math.abs(turned.yaw - panned.yaw) - 0.4) < 1e-4);
      await page.mouse.wheel(0, -100);
      const zoomed = cameraOf(
        await until(page, state, (s) => s.camera[DISTANCE] !== turned.distance, "another distance"),
      );
      const nearer = zoomed.distance / turned.distance;
      assert.ok(nearer > 0.8 && nearer < 0.95, `one notch of the wheel comes nearer: ${nearer}`);
      await page.locator(".area-stage canvas").focus();
      await page.keyboard.press("f");
      assert.ok(Math.abs((await camera()).distance / start.distance - 1) < 0.5);
      await viewFrom(page, "+z");
      await page.mouse.move(x, y);
      const { nodeId } = await until(page, probe, (r) => r !== null, "a place");
      await page.mouse.dblclick(x, y);
      const { pins } = await until(page, state, (s) => s.pins.length === 1, "a note");
      assert.equal(pins[0].node, nodeId);
      const step = (await page.evaluate(state)).step;
      await page.keyboard.press(".");
      await until(page, state, (s) => s.step !== step, "the next step");
      await page.keyboard.press(",");
      await until(page, state, (s) => s.step === step, "the step before");
      for (const [key, factor] of [
        ["1", 1],
        ["0", 0],
      ]) {
        await page.keyboard.press(key);
        await until(page, state, (s) => s.deformationFactor === factor, `factor ${factor}`);
      }
      await page.mouse.move(x + 1, y);
      await page.keyboard.down("s");
      await until(page, listen, (h) => h.level > HEARD, "sound");
      await page.keyboard.press("m");
      await until(page, listen, (h) => h.level < 1e-4, "silence while muted");
      await page.keyboard.up("s");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "touch_pulses_by_the_phones_motor_to_the_same_plan",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url, PHONE);
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      await page.touchscreen.tap(5, 5);
      const touch = await fingers(context, page);
      await touch("touchStart", [x, y]);
      const said = await until(
        page,
        () => window.feelem.pulses(),
        (p) => p.length >= 3,
        "pulses",
      );
      const here = await page.evaluate(probe);
      await touch("touchEnd");
      assert.equal(here.tickRate, 0, "a phone that shakes needs no ticks in its place");
      assert.ok(here.pulse.rate > 0);
      assert.ok(said.some((p) => Math.abs(p.amplitude - here.pulse.amplitude) < 1e-9));
      const count = () => globalThis.shaken.length;
      const shaken = await page.evaluate(() => globalThis.shaken);
      for (const [i, p] of said.entries()) {
        assert.equal(shaken[i].ms, p.ms);
        assert.ok(Math.abs(shaken[i].time - p.time) < 50, "sent at once");
      }
      const still = await page.evaluate(count);
      await page.waitForTimeout(600);
      assert.equal(await page.evaluate(count), still, "nothing after the finger is gone");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "touch_long_press_asks_and_leaves_a_note",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url, PHONE);
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      const touch = await fingers(context, page);
      const menu = page.locator(".place-menu");
      // A sweep is no question.
      await touch("touchStart", [x, y]);
      await touch("touchMove", [x + 30, y]);
      await until(page, probe, (r) => r !== null, "the place under the finger");
      await page.waitForTimeout(900);
      assert.equal(await menu.isVisible(), false);
      await touch("touchEnd");
      await touch("touchStart", [x, y]);
      const { nodeId } = await until(page, probe, (r) => r !== null, "the place under the finger");
      await menu.waitFor();
      assert.ok((await page.evaluate(probe))?.hz > 0, "it is heard all the while");
      await touch("touchEnd");
      assert.ok(await menu.isVisible(), "it stays when the finger is gone");
      for (const button of await menu.getByRole("button").all()) {
        const box = await button.boundingBox();
        assert.ok(box.height >= 44, `${box.height} pixels are few for a finger`);
      }
      await menu.getByRole("button", { name: "Note here" }).tap();
      const { pins } = await until(page, state, (s) => s.pins.length === 1, "a note");
      assert.equal(pins[0].node, nodeId);
      assert.equal(await menu.isVisible(), false);
      // Asked again, it measures; a press beside it sends it away.
      await touch("touchStart", [x, y]);
      await menu.waitFor();
      await touch("touchEnd");
      await menu.getByRole("button", { name: "Measure" }).tap();
      await until(page, state, (s) => s.ruler?.nodes[0] === nodeId, "one end of the ruler");
      await touch("touchStart", [x, y]);
      await menu.waitFor();
      await touch("touchEnd");
      const aside = await middle(page, 190, 200);
      await page.touchscreen.tap(aside.x, aside.y);
      await menu.waitFor({ state: "hidden" });
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "touch_buttons_fit_scale_mute_and_choose_results",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url, PHONE);
      const whole = cameraOf(await page.evaluate(state));
      const { x, y } = await middle(page);
      const touch = await fingers(context, page);
      await touch("touchStart", [x - 40, y], [x + 40, y]);
      await touch("touchMove", [x - 80, y], [x + 80, y]);
      await touch("touchEnd");
      await until(page, state, (s) => s.camera[DISTANCE] < 0.9 * whole.distance, "nearer");
      const tap = (name) => page.getByRole("button", { name, exact: true }).first().tap();
      await tap("fit");
      const fitted = cameraOf(await page.evaluate(state));
      assert.ok(Math.abs(fitted.distance / whole.distance - 1) < 1e-6, "the whole model again");
      for (const [name, factor] of [
        ["true scale", 1],
        ["undeformed", 0],
      ]) {
        await tap(name);
        await until(page, state, (s) => s.deformationFactor === factor, name);
      }
      await page.locator("tr[data-key='U'] button[data-slot='colour']").tap();
      const seen = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      await until(page, state, (s) => seen(s) === "U", "displacement is seen");
      // Mute and stillness, on what is held.
      const hold = async () => {
        await touch("touchStart", [x, y]);
        await until(page, probe, (r) => r?.hz > 0, "the finger on the model");
      };
      await tap("sound");
      await tap("touch");
      await hold();
      await page.waitForTimeout(500);
      assert.ok((await page.evaluate(listen)).level < 1e-4, "muted");
      assert.equal((await page.evaluate(() => globalThis.shaken)).length, 0, "still");
      await touch("touchEnd");
      await tap("sound");
      await tap("touch");
      await hold();
      await until(page, listen, (h) => h.level > HEARD, "sound again");
      await until(
        page,
        () => globalThis.shaken.length,
        (n) => n > 0,
        "pulses again",
      );
      await touch("touchEnd");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "touch_scrubs_the_steps_and_drags_a_planes_knob",
    async run({ browser, serveTiny }) {
      const { url, close } = await serveTiny({ times: 5 });
      const { page, context, problems } = await openPage(browser, url, PHONE);
      const touch = await fingers(context, page);
      const { steps } = await page.evaluate(() => window.feelem.scene());
      const slider = await page.locator(".step-slider").boundingBox();
      const row = slider.y + slider.height / 2;
      await touch("touchStart", [slider.x + 8, row]);
      await touch("touchMove", [slider.x + slider.width / 2, row]);
      await until(
        page,
        state,
        (s) => s.step === steps[Math.round((steps.length - 1) / 2)].id,
        "the middle step",
      );
      await touch("touchMove", [slider.x + slider.width - 2, row]);
      await until(page, state, (s) => s.step === steps.at(-1).id, "the last step");
      await touch("touchEnd");
      await viewFrom(page, "-y");
      const section = await unfold(page, "cuts");
      await section.getByRole("button", { name: "Add a plane" }).tap();
      const { cuts } = await until(page, state, (s) => s.cuts.length === 1, "a plane");
      const handle = page.locator("[data-handle='cut-0']");
      await handle.waitFor();
      const knob = await handle.boundingBox();
      const [kx, ky] = [knob.x + knob.width / 2, knob.y + knob.height / 2];
      await touch("touchStart", [kx, ky]);
      await touch("touchMove", [kx - 20, ky]);
      await touch("touchMove", [kx - 40, ky]);
      await until(page, state, (s) => s.cuts[0].offset < cuts[0].offset - 5, "the plane dragged");
      const at = () => document.querySelector("[data-handle='cut-0']").getBoundingClientRect().x;
      await until(page, at, (left) => Math.abs(knob.x - left - 40) < 2, "the knob under the finger");
      const moved = await page.evaluate(state);
      await touch("touchEnd");
      await page.waitForTimeout(200);
      assert.equal((await page.evaluate(state)).cuts[0].offset, moved.cuts[0].offset, "let go, it stays");
      assert.deepEqual(problems, []);
      await context.close();
      await close();
    },
  },
  {
    name: "tab_goes_through_results_after_a_press_on_the_model_and_esc_gives_it_back",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      const seen = (s) => s.presentation.effects.find((e) => e.type === "colour").result;
      const { x, y } = await middle(page);
      await page.mouse.click(x, y);
      const first = seen(await page.evaluate(state));
      const keys = (await page.evaluate(state)).presentation.results.map((r) => r.key);
      const all = [];
      for (let i = 0; i < keys.length; ++i) {
        await page.keyboard.press("Tab");
        all.push(seen(await page.evaluate(state)));
      }
      assert.deepEqual(new Set(all), new Set(keys), "every result in turn");
      assert.equal(all.at(-1), first, "round again");
      const focused = () => document.activeElement?.tagName ?? "";
      assert.equal(await page.evaluate(focused), "CANVAS", "the model keeps the focus");
      // Esc: Tab goes on through the page, and no result changes.
      await page.keyboard.press("Escape");
      await page.keyboard.press("Tab");
      assert.notEqual(await page.evaluate(focused), "CANVAS");
      assert.equal(seen(await page.evaluate(state)), first);
      // Whoever comes to the canvas by Tab is not held there, and Shift leaves it backwards.
      // A card that is going away would take the press.
      const isBare = ([left, top]) => document.elementFromPoint(left, top)?.tagName === "CANVAS";
      await page.waitForFunction(isBare, [x, y]);
      await page.mouse.click(x, y);
      await until(page, focused, (tag) => tag === "CANVAS", "a press on the model takes the focus");
      await page.keyboard.press("Shift+Tab");
      await until(page, focused, (tag) => tag !== "CANVAS", "backwards out of the model");
      await page.keyboard.press("Tab");
      await until(page, focused, (tag) => tag === "CANVAS", "into the model again");
      await page.keyboard.press("Tab");
      await until(page, focused, (tag) => tag !== "CANVAS", "and on");
      assert.equal(seen(await page.evaluate(state)), first);
      // In a field Tab is the field's.
      await page.mouse.click(x, y);
      await page.locator(".goto input").focus();
      await page.keyboard.press("Tab");
      assert.equal(seen(await page.evaluate(state)), first);
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "keys_walk_where_that_is_chosen_and_mean_what_they_did_elsewhere",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url);
      const target = async () => (await page.evaluate(state)).camera.slice(0, 3);
      const pictures = (count) =>
        page.evaluate(
          (count) =>
            new Promise((resolve) => {
              const step = (left) => (left > 0 ? requestAnimationFrame(() => step(left - 1)) : resolve());
              step(count);
            }),
          count,
        );
      const hold = async (key) => {
        const before = await target();
        await page.keyboard.down(key);
        await pictures(6);
        await page.keyboard.up(key);
        const after = await target();
        return after.map((v, i) => v - before[i]);
      };
      const canvas = page.locator(".area-stage canvas");
      await canvas.focus();
      const nobody = await hold("w");
      assert.deepEqual(nobody, [0, 0, 0], "nobody walks unasked");
      const section = await unfold(page, "walking");
      await section.getByRole("checkbox").check();
      assert.equal((await page.evaluate(state)).person.walkKeys, true);
      await canvas.focus();
      const { camera } = await page.evaluate(state);
      const [sin, cos] = [Math.sin(camera[3]), Math.cos(camera[3])];
      const ahead = [-sin, 0, -cos];
      const right = [cos, 0, -sin];
      const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
      for (const [key, way] of [
        ["w", ahead],
        ["s", ahead.map((v) => -v)],
        ["d", right],
        ["a", right.map((v) => -v)],
      ]) {
        const moved = await hold(key);
        const length = Math.hypot(...moved);
        assert.ok(length > 1e-4, `${key} walks`);
        assert.ok(dot(moved, way) / length > 0.9999, `${key} walks that way: ${moved}`);
      }
      const rests = await target();
      await pictures(6);
      assert.deepEqual(await target(), rests, "let go, one stands");
      // With Shift, and with the choice off, S holds sound again.
      const { x, y } = await middle(page);
      await page.keyboard.press("f");
      await page.mouse.move(x, y);
      await until(page, probe, (r) => r !== null, "the model under the mouse");
      await page.keyboard.down("Shift");
      await page.keyboard.down("S");
      await until(page, listen, (h) => h.level > HEARD, "sound");
      await page.keyboard.up("S");
      await page.keyboard.up("Shift");
      await until(page, listen, (h) => h.level < 1e-4, "silence");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
  {
    name: "key_v_stills_and_space_plays_and_a_hidden_page_is_silent",
    async run({ browser, url }) {
      const { page, context, problems } = await openPage(browser, url, PHONE);
      await viewFrom(page, "+z");
      const { x, y } = await middle(page);
      const touch = await fingers(context, page);
      await page.touchscreen.tap(5, 5);
      await page.locator(".area-stage canvas").focus();
      const shaken = () => globalThis.shaken.length;
      const hold = async () => {
        await touch("touchStart", [x, y]);
        await until(page, probe, (r) => r?.hz > 0, "the finger on the model");
        await until(page, listen, (h) => h.level > HEARD, "sound");
      };
      await page.keyboard.press("v");
      await hold();
      await page.waitForTimeout(400);
      assert.equal(await page.evaluate(shaken), 0, "still");
      await page.keyboard.press("v");
      await until(page, shaken, (n) => n > 0, "pulses again");
      // Another page comes before this one.
      await page.evaluate(() => {
        Object.defineProperty(document, "visibilityState", { value: "hidden", configurable: true });
        document.dispatchEvent(new Event("visibilitychange"));
      });
      await until(page, listen, (h) => h.level < 1e-4, "silence of a hidden page");
      const count = await page.evaluate(shaken);
      await page.waitForTimeout(600);
      assert.equal(await page.evaluate(shaken), count, "no pulse of a hidden page");
      await touch("touchEnd");
      const playing = () => document.querySelector("button.play").ariaPressed;
      await page.keyboard.press(" ");
      await until(page, playing, (p) => p === "true", "playing");
      await page.keyboard.press(" ");
      await until(page, playing, (p) => p === "false", "paused");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
