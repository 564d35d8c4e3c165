// SPDX-License-Identifier: Apache-2.0
// Fingers on the page, and the rest of mouse and keyboard.
import assert from "node:assert/strict";
import { listen, openPage, until } from "./harness.mjs";
import { middle, viewFrom } from "./look.mjs";
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
      await until(page, listen, (h) => h.level > 0.002 && Math.abs(h.hz / here.hz - 1) < 0.01, "the tone");
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
      await until(page, listen, (h) => h.level > 0.002, "sound");
      await page.keyboard.press("m");
      await until(page, listen, (h) => h.level < 1e-4, "silence while muted");
      await page.keyboard.up("s");
      assert.deepEqual(problems, []);
      await context.close();
    },
  },
];
