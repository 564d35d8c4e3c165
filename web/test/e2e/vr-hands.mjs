// SPDX-License-Identifier: Apache-2.0
// Entering the emulated headset; controllers, hands and pinches that come and go, pointing and pressing there.
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
  if (options.early) await page.locator("button.vr:not([disabled])").waitFor();
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
  await frames(page, 2);
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

/** Middle of a button of the panel (or of the menu at a hand) in the room, as the page reports them. */
export async function panelButton(page, id, of = "panel") {
  const { headset } = await until(
    page,
    () => window.feelem.state(),
    (s) => s.headset?.[of]?.buttons.some((b) => b.id === id),
    `the button ${id} of the ${of}`,
  );
  const panel = headset[of];
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
  await frames(page, 2);
  await button(page, hand, "trigger", 0);
  await frames(page, 2);
}

/** The turn that takes (0,0,-1) to the direction from one point to another. */
function turnTowards(from, to) {
  const d = to.map((v, i) => v - from[i]);
  const [x, y, z] = d.map((v) => v / Math.hypot(...d));
  const q = [y, -x, 0, 1 - z];
  const size = Math.hypot(...q);
  return q.map((v) => v / size);
}

/** Bare hands in place of controllers. */
export async function useHands(page) {
  await page.evaluate(() => {
    window.headset.primaryInputMode = "hand";
  });
  await frames(page, 6);
}

/** Puts a bare hand so that its ray goes from one point to another. */
export async function hand(page, side, from, to) {
  await page.evaluate(
    ({ side, from, turn }) => {
      window.headset.hands[side].position.set(...from);
      window.headset.hands[side].quaternion.set(...turn);
    },
    { side, from, turn: turnTowards(from, to) },
  );
  await frames(page, 2);
}

/** Closes (1) or opens (0) thumb and index finger of a bare hand. */
export async function pinch(page, side, on) {
  await page.evaluate(({ side, on }) => window.headset.hands[side].updatePinchValue(on), { side, on });
  await frames(page, 2);
}

/** Points at a button of the panel with a bare hand and pinches. */
export async function pinchPanel(page, id, side = "right") {
  await hand(page, side, [side === "right" ? 0.1 : -0.1, 1.3, -0.1], await panelButton(page, id));
  await pinch(page, side, 1);
  await pinch(page, side, 0);
}

/** Where a joint of a bare hand is, metres. */
export const joint = (page, side, name) =>
  page.evaluate(
    async ({ side, name }) => {
      const space = await window.xrSession.requestReferenceSpace("local-floor");
      return new Promise((resolve) => {
        window.xrSession.requestAnimationFrame((_, frame) => {
          const source = [...window.xrSession.inputSources].find((s) => s.hand && s.handedness === side);
          const { x, y, z } = frame.getJointPose(source.hand.get(name), space).transform.position;
          resolve([x, y, z]);
        });
      });
    },
    { side, name },
  );

/** A bare hand whose tip of the index finger is at a place; it points to the front. */
export async function fingerAt(page, side, to) {
  const from = [0.2, 1.2, -0.4];
  const ahead = (at) => [at[0], at[1], at[2] - 1];
  await hand(page, side, from, ahead(from));
  const tip = await joint(page, side, "index-finger-tip");
  const at = from.map((v, k) => v + to[k] - tip[k]);
  await hand(page, side, at, ahead(at));
}

/** Runs in the page: pinches of a headset that tells where one looks only when one begins to pinch. */
function transientPinches() {
  const { IWER, headset } = globalThis;
  const global = headset.viewerSpace[IWER.P_SPACE].parentSpace;
  class Transient extends Object.getPrototypeOf(IWER.XRGazeInput) {
    constructor(hand) {
      const grip = new IWER.XRSpace(global);
      const ray = new IWER.XRSpace(global);
      super(new IWER.XRInputSource(hand, "transient-pointer", ["generic-hand"], ray, undefined, grip));
    }
    /** The pinching fingers. */
    moveTo(at) {
      this.inputSource.gripSpace[IWER.P_SPACE].offsetMatrix.set(at, 12);
    }
  }
  const now = new Map();
  const active = Object.getOwnPropertyDescriptor(IWER.XRDevice.prototype, "activeInputs");
  Object.defineProperty(headset, "activeInputs", {
    get() {
      return [...active.get.call(headset), ...now.values()];
    },
  });
  headset.controllers.left.connected = false;
  headset.controllers.right.connected = false;
  const waiting = [];
  globalThis.pinches = {
    begin(hand, from, turn, at) {
      const pinch = new Transient(hand);
      pinch.connected = true;
      pinch.position.set(...from);
      pinch.quaternion.set(...turn);
      pinch.moveTo(at);
      now.set(hand, pinch);
    },
    move: (hand, at) => now.get(hand).moveTo(at),
    start: (hand) => waiting.push([hand, "selectstart"]),
    end: (hand) => waiting.push([hand, "selectend"]),
  };
  // Events belong to a frame.
  const step = (_, frame) => {
    for (const [hand, type] of waiting.splice(0)) {
      const { inputSource } = now.get(hand);
      frame.session.dispatchEvent(new XRInputSourceEvent(type, { frame, inputSource }));
      if (type === "selectend") now.delete(hand);
    }
    globalThis.xrSession.requestAnimationFrame(step);
  };
  globalThis.xrSession.requestAnimationFrame(step);
}

/** A headset of eyes and pinches in place of controllers; what its fingers do. */
export async function usePinches(page) {
  await page.evaluate(transientPinches);
  await frames(page, 4);
  const eyes = [0, 1.6, 0];
  const side = (name) => (name === "left" ? -0.2 : 0.2);
  /** The headset knows nothing of how far the person has walked in the page's room. */
  const unwalked = async (to) => {
    const { position, yaw } = (await page.evaluate(() => window.feelem.state())).headset.head;
    const [x, y, z] = to.map((v, i) => v - position[i]);
    const [sin, cos] = [Math.sin(-yaw), Math.cos(-yaw)];
    return [x * cos + z * sin, y, z * cos - x * sin].map((v, i) => v + eyes[i]);
  };
  return {
    /** Looks at a place and pinches; the fingers are before the body. */
    async begin(to, name = "right") {
      const at = [side(name), 1.1, -0.4];
      await page.evaluate(({ name, eyes, turn, at }) => globalThis.pinches.begin(name, eyes, turn, at), {
        name,
        eyes,
        turn: turnTowards(eyes, await unwalked(to)),
        at,
      });
      await frames(page, 2);
      await page.evaluate((name) => globalThis.pinches.start(name), name);
      await frames(page, 2);
    },
    /** Metres from where the pinch began. */
    async move([x, y, z], name = "right") {
      const at = [side(name) + x, 1.1 + y, -0.4 + z];
      await page.evaluate(({ name, at }) => globalThis.pinches.move(name, at), { name, at });
      await frames(page, 2);
    },
    async end(name = "right") {
      await page.evaluate((name) => globalThis.pinches.end(name), name);
      await frames(page, 2);
    },
    async press(id) {
      await this.begin(await panelButton(page, id));
      await this.end();
    },
  };
}
