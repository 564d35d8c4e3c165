// SPDX-License-Identifier: Apache-2.0
// Takes the pictures of docs/pictures: `node test/e2e/pictures.mjs SCENE.glb [FOLDER [PART OF A NAME]]`. In place of a scene
// the address at which `feelem view MODEL` serves it: then a section has its values.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { launch, openPage, until } from "./harness.mjs";
import { serve } from "./server.mjs";

const [scene, folder = fileURLToPath(new URL("../../../docs/pictures/", import.meta.url))] =
  process.argv.slice(2);
const isServed = /^http:/.test(scene);
const server = isServed
  ? { url: scene, close: async () => {} }
  : await serve(new Map([["scene.glb", readFileSync(scene)]]));
const browser = await launch();

async function desk(
  name,
  { width, height, dark = false, at, before = async () => {}, held = false, device = {} },
) {
  const { page, context } = await openPage(browser, server.url, {
    width,
    height,
    dark,
    smooth: true,
    device,
  });
  await before(page);
  await page.evaluate(() => document.activeElement?.blur());
  const box = await page.locator(".area-stage canvas").boundingBox();
  await page.mouse.move(box.x + box.width * at[0], box.y + box.height * at[1]);
  if (held) await page.mouse.down();
  await page.waitForTimeout(1500);
  await page.screenshot({ path: join(folder, name) });
  await context.close();
}

/** Turns the camera: a drag that begins beside the model. */
async function drag(page, dx, dy) {
  const box = await page.locator(".area-stage canvas").boundingBox();
  await page.mouse.move(box.x + 40, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + 40 + dx, box.y + 40 + dy, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.press("f");
}

/** Both eyes, or the left one alone, turned by `yaw` and narrowed to `field` (radians). */
async function headset(name, { yaw = 0, field = 1.45, both = true } = {}) {
  // Each eye gets half of the stage: about as wide as it is high, as in a headset.
  const [width, height] = [2000, 800];
  const { page, context } = await openPage(browser, server.url, {
    width,
    height,
    headset: true,
    smooth: true,
  });
  const stage = await page.locator(".area-stage canvas").boundingBox();
  await page.evaluate((field) => {
    window.headset.fovy = field;
    document.querySelector("button.vr").click();
  }, field);
  await until(
    page,
    () => window.feelem.state().session,
    (s) => s === "immersive-vr",
    "the session",
  );
  await page.waitForTimeout(1500);
  const grip = (turned, squeezed) =>
    page.evaluate(
      ([turned, squeezed]) => {
        const { left } = window.headset.controllers;
        left.position.set(0, 1, -1.2);
        left.quaternion.set(0, Math.sin(turned / 2), 0, Math.cos(turned / 2));
        left.updateButtonValue("squeeze", squeezed);
      },
      [turned, squeezed],
    );
  for (const [turned, squeezed] of [
    [0, 0],
    [0, 1],
    [-0.7, 1],
    [-0.7, 0],
  ]) {
    await grip(turned, squeezed);
    await page.waitForTimeout(900);
  }
  await page.evaluate(() => {
    const { headset } = window;
    const turn = (x, y) => [
      Math.sin(x / 2) * Math.cos(y / 2),
      Math.cos(x / 2) * Math.sin(y / 2),
      0,
      Math.cos(x / 2) * Math.cos(y / 2),
    ];
    headset.quaternion.set(...turn(-0.4, 0));
    const { right, left } = headset.controllers;
    right.position.set(0.3, 1.2, -0.42);
    right.quaternion.set(...turn(-0.24, 0.24));
    left.position.set(-0.22, 1.02, -0.5);
    left.quaternion.set(...turn(0.62, 0.5));
  });
  // A press counts from the moment the controller is known.
  await until(
    page,
    () => window.feelem.lastProbe()?.pointer,
    (p) => p === "right-controller",
    "the ray on the model",
  );
  await page.evaluate(() => window.headset.controllers.right.updateButtonValue("trigger", 1));
  await page.waitForTimeout(6000);
  await page.evaluate((yaw) => {
    const { x, y, z, w } = window.headset.quaternion;
    const [s, c] = [Math.sin(yaw / 2), Math.cos(yaw / 2)];
    window.headset.quaternion.set(c * x + s * z, c * y + s * w, c * z - s * x, c * w - s * y);
  }, yaw);
  await page.waitForTimeout(2000);
  // The emulator shows the canvas, as large as it was on the page, in the middle of the window.
  const clip = {
    x: (width - stage.width) / 2,
    y: (height - stage.height) / 2,
    width: both ? stage.width : stage.width / 2,
    height: stage.height,
  };
  await page.screenshot({ path: join(folder, name), clip });
  await context.close();
}

const sectionsShown = () => window.feelem.state().sections?.every((section) => section.state === "shown");

const wanted = process.argv[4] ?? "";
const shots = {
  "desk.png": (name) =>
    desk(name, {
      width: 1440,
      height: 900,
      at: [0.72, 0.6],
      held: true,
      before: async (page) => {
        await drag(page, -42, -14);
        await page.getByRole("button", { name: "shading", exact: true }).click();
      },
    }),
  "desk-dark.png": (name) =>
    desk(name, {
      width: 1440,
      height: 900,
      dark: true,
      at: [0.7, 0.36],
      before: async (page) => {
        await page.click("tbody tr:nth-child(3) button[data-slot='colour']");
        await page.click("tbody tr:nth-child(1) button[data-slot='pulses']");
        await page.keyboard.press("l");
      },
    }),
  "phone.png": (name) =>
    desk(name, {
      width: 390,
      height: 844,
      at: [0.86, 0.62],
      device: { hasTouch: true, isMobile: true, deviceScaleFactor: 1.5 },
      before: (page) => page.keyboard.press("x"),
    }),
  "clip.png": (name) =>
    desk(name, {
      width: 1200,
      height: 760,
      at: [0.5, 0.02],
      before: async (page) => {
        for (const key of ["x", "u"]) await page.keyboard.press(key);
        await page.locator("details[data-section='cuts'] > summary").click();
        const section = page.locator("details[data-section='cuts']");
        await section.getByRole("button", { name: "Add a plane" }).click();
        await section.getByRole("button", { name: "y", exact: true }).click();
        await section.getByRole("button", { name: "other side of plane 1" }).click();
        await drag(page, 150, -10);
        await page.keyboard.press("l");
        if (isServed) await until(page, sectionsShown, (all) => all, "the section's colours");
      },
    }),
  "hot-spots.png": (name) =>
    desk(name, {
      width: 1200,
      height: 760,
      dark: true,
      at: [0.02, 0.02],
      before: async (page) => {
        for (const key of ["x", "u"]) await page.keyboard.press(key);
        await page.click("tbody tr:nth-child(3) button[data-slot='colour']");
        await page.locator("details[data-section='hot-spots'] > summary").click();
        await page.keyboard.press("l");
      },
    }),
  "principal.png": (name) =>
    desk(name, {
      width: 1200,
      height: 760,
      at: [0.02, 0.02],
      before: async (page) => {
        for (const key of ["x", "u", "e"]) await page.keyboard.press(key);
        await page.locator("details[data-section='vectors'] > summary").click();
        await page.getByLabel("result drawn as arrows").selectOption("stress");
        await page.keyboard.press("l");
      },
    }),
  "modes.png": (name) =>
    desk(name, {
      width: 1200,
      height: 760,
      at: [0.02, 0.02],
      before: async (page) => {
        for (const key of ["x", "l"]) await page.keyboard.press(key);
        await drag(page, -60, -16);
        await page.locator(".stepbar").getByLabel("next step").click();
        await page.waitForTimeout(1500);
      },
    }),
  "headset.png": headset,
  "headset-panel.png": (name) => headset(name, { yaw: 0.42, field: 1.3, both: false }),
};
for (const [name, take] of Object.entries(shots)) if (name.includes(wanted)) await take(name);
await browser.close();
await server.close();
