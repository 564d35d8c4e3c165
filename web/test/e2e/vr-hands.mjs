// SPDX-License-Identifier: Apache-2.0
// Entering the emulated headset, and hands that point and press there.
import { FIRST_NODE_ID, tinyValues } from "../support/tiny-scene.ts";
import { enterHeadset, openPage, until } from "./harness.mjs";

const SMALL = { width: 320, height: 180, headset: true };

/** Waits for frames of the session, never for the clock: software rendering is slow. */
export async function frames(page, count) {
  await page.evaluate(
    (count) =>
      new Promise((resolve) => {
        let left = count;
        const session = window.xrSession;
        const step = () => {
          left -= 1;
          if (left <= 0) resolve();
          else session.requestAnimationFrame(step);
        };
        session.requestAnimationFrame(step);
      }),
    count,
  );
}

export async function enter(browser, url, options = {}) {
  const opened = await openPage(browser, url, { ...SMALL, ...options });
  const { page } = opened;
  await page.evaluate(() => {
    const request = navigator.xr.requestSession.bind(navigator.xr);
    navigator.xr.requestSession = async (...given) => {
      window.xrSession = await request(...given);
      return window.xrSession;
    };
  });
  await enterHeadset(page);
  await until(page, () => Boolean(window.xrSession), Boolean, "the session object");
  await frames(page, 4);
  return opened;
}

/** The tiny bar's node in the room: on its table, deformed by the factor the page says. */
export function nodeInRoom(x, y, z, factor, step = 1) {
  const moved = tinyValues.displacement(x, step).map((d, i) => [x, y, z][i] + factor * d);
  const metres = (p) => [p[0] / 1000, p[2] / 1000, -p[1] / 1000];
  const centre = metres([60, 20, 15]);
  const scale = 0.8 / 0.12;
  return metres(moved).map((c, i) => scale * (c - centre[i]) + [0, 1, -1.2][i]);
}

/** Puts a controller at `from` so that its ray goes through `to`. */
export async function aim(page, hand, from, to) {
  await page.evaluate(
    ({ hand, from, to }) => {
      const d = to.map((v, i) => v - from[i]);
      const length = Math.hypot(...d);
      const [x, y, z] = d.map((v) => v / length);
      // The turn that takes (0,0,-1) to the direction.
      const q = [y, -x, 0, 1 - z];
      const size = Math.hypot(...q);
      const controller = window.headset.controllers[hand];
      controller.position.set(...from);
      controller.quaternion.set(...q.map((v) => v / size));
    },
    { hand, from, to },
  );
  await frames(page, 3);
}

export const button = (page, hand, name, value) =>
  page.evaluate(({ hand, name, value }) => window.headset.controllers[hand].updateButtonValue(name, value), {
    hand,
    name,
    value,
  });

const cells = [12, 4, 3];
export const nodeId = (i, j, k) => FIRST_NODE_ID + i + (cells[0] + 1) * (j + (cells[1] + 1) * k);
export const place = (i, j, k) => [i * 10, j * 10, k * 10];

export async function aimAtNode(page, hand, i, j, k) {
  const { deformationFactor } = await page.evaluate(() => window.feelem.state());
  const to = nodeInRoom(...place(i, j, k), deformationFactor);
  await aim(page, hand, [to[0], to[1] + 0.35, to[2] + 0.5], to);
  return nodeId(i, j, k);
}

/** Middle of the panel's button in the room, as the page reports panel and buttons. */
export async function panelButton(page, id) {
  const { headset } = await until(
    page,
    () => window.feelem.state(),
    (s) => s.headset?.panel?.buttons.some((b) => b.id === id),
    `the panel's button ${id}`,
  );
  const { panel } = headset;
  const at = panel.buttons.find((b) => b.id === id);
  const u = ((at.x + at.width / 2) / panel.width - 0.5) * panel.metresWide;
  const v = (0.5 - (at.y + at.height / 2) / panel.height) * panel.metresHigh;
  const m = panel.matrix;
  return [0, 1, 2].map((k) => m[k] * u + m[4 + k] * v + m[12 + k]);
}

/** Points at a button of the panel with a controller and pulls the trigger. */
export async function pressPanel(page, id, hand = "right") {
  await aim(page, hand, [hand === "right" ? 0.1 : -0.1, 1.3, -0.1], await panelButton(page, id));
  await button(page, hand, "trigger", 1);
  await frames(page, 3);
  await button(page, hand, "trigger", 0);
  await frames(page, 3);
}
