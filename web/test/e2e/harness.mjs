// SPDX-License-Identifier: Apache-2.0
// Opens the page in a real Chromium: software rendering, an emulated headset, taps on sound and pulses.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { chromium } from "playwright-core";

const CHROMIUM_ARGUMENTS = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--autoplay-policy=no-user-gesture-required",
];
const IWER = createRequire(import.meta.url)
  .resolve("iwer")
  .replace(/lib\/.*|build\/.*|index\.js$/, "build/iwer.min.js");

/** Runs in the page before its own scripts: an emulated Quest 3 whose pulses are remembered. */
function emulateHeadset() {
  const device = new globalThis.IWER.XRDevice(globalThis.IWER.metaQuest3, { stereoEnabled: true });
  device.installRuntime({ forceInstall: true });
  device.position.set(0, 1.6, 0);
  // The emulator takes the matrix where the standard hands it the transform.
  const spaces = globalThis.XRReferenceSpace.prototype;
  const offset = spaces.getOffsetReferenceSpace;
  spaces.getOffsetReferenceSpace = function (transform) {
    return offset.call(this, transform.matrix);
  };
  globalThis.headset = device;
  globalThis.felt = [];
  for (const hand of ["left", "right"]) {
    const actuator = device.controllers[hand].inputSource?.gamepad?.hapticActuators?.[0];
    if (!actuator) continue;
    const pulse = actuator.pulse.bind(actuator);
    actuator.pulse = (value, ms) => {
      globalThis.felt.push({ hand, value, ms, time: performance.now() });
      return pulse(value, ms);
    };
  }
}

/** Whatever goes to the loudspeakers also goes to an analyser. */
function tapSound() {
  const connect = AudioNode.prototype.connect;
  AudioNode.prototype.connect = function (target, ...rest) {
    if (target instanceof AudioDestinationNode) {
      const tap = new AnalyserNode(this.context, { fftSize: 32768, smoothingTimeConstant: 0 });
      connect.call(this, tap);
      globalThis.soundTap = tap;
    }
    return connect.call(this, target, ...rest);
  };
}

export async function launch() {
  return chromium.launch({ executablePath: "/usr/bin/chromium", headless: true, args: CHROMIUM_ARGUMENTS });
}

/** A phone with Android: fingers, and a motor whose pulses are remembered. */
export const PHONE = {
  device: {
    hasTouch: true,
    userAgent:
      "Mozilla/5.0 (Linux; Android 15; Pixel 9) AppleWebKit/537.36 Chrome/156.0.0.0 Mobile Safari/537.36",
  },
  before: () => {
    globalThis.shaken = [];
    Object.defineProperty(Navigator.prototype, "vibrate", {
      configurable: true,
      value: (ms) => {
        globalThis.shaken.push({ ms, time: performance.now() });
        return true;
      },
    });
  },
};

/** `url` of the page; asks for nothing else are recorded in `foreign`. `device`: of the browser's context; `before`
 * runs in the page before its own scripts. */
export async function openPage(browser, url, options = {}) {
  const { width = 900, height = 620, headset = false, dark = false, offline = false, device = {} } = options;
  // Pictures that are compared must not depend on how quick this machine is.
  const { smooth = false, governed = false, before = null } = options;
  const context = await browser.newContext({
    viewport: { width, height },
    ignoreHTTPSErrors: true,
    offline,
    colorScheme: dark ? "dark" : "light",
    ...device,
  });
  context.setDefaultTimeout(40000);
  const origin = new URL(url).origin;
  const foreign = [];
  const problems = [];
  await context.route("**/*", (route) => {
    const asked = route.request().url();
    if (!asked.startsWith(origin) && !/^(data|blob):/.test(asked)) foreign.push(asked);
    return route.continue();
  });
  await context.addInitScript(tapSound);
  if (before) await context.addInitScript(before);
  if (headset) {
    await context.addInitScript(readFileSync(IWER, "utf8"));
    await context.addInitScript(emulateHeadset);
  }
  const page = await context.newPage();
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") problems.push(message.text());
  });
  const drawing = [options.query ?? [], smooth ? [] : "antialias=0", governed ? [] : "governor=0"]
    .flat()
    .join("&");
  await page.goto(drawing ? url.replace(/(?=#|$)/, `?${drawing}`) : url);
  if (!options.early) await page.evaluate(() => window.feelem.ready);
  return { page, context, foreign, problems };
}

/** Waits until `read` in the page gives something that `accept` takes; returns it. */
export async function until(page, read, accept, what, milliseconds = 40000) {
  const end = Date.now() + milliseconds;
  let last;
  while (Date.now() < end) {
    last = await page.evaluate(read);
    if (accept(last)) return last;
    await page.waitForTimeout(40);
  }
  throw new Error(`${what} did not come; last seen: ${JSON.stringify(last)?.slice(0, 400)}`);
}

/** Presses Enter VR and waits for the emulated headset's session. */
export async function enterHeadset(page) {
  await page.evaluate(() => document.querySelector("button.vr").click());
  const session = () => window.feelem.state().session;
  await until(page, session, (s) => s === "immersive-vr", "the session");
}

/** Level above which something sounds, also when it has rested for so long that it has faded by 18 dB (silence is 0). */
export const HEARD = 0.0005;

/** Loudest partial of what sounds now, and its level. Runs in the page. */
export function listen() {
  const tap = globalThis.soundTap;
  if (!tap) return { hz: 0, level: 0 };
  const wave = new Float32Array(tap.fftSize);
  tap.getFloatTimeDomainData(wave);
  const late = wave.subarray(wave.length - 2048);
  const level = Math.sqrt(late.reduce((sum, v) => sum + v * v, 0) / late.length);
  const bins = new Float32Array(tap.frequencyBinCount);
  tap.getFloatFrequencyData(bins);
  let best = 1;
  for (let i = 2; i + 1 < bins.length; ++i) if (bins[i] > bins[best]) best = i;
  const [a, b, c] = [bins[best - 1], bins[best], bins[best + 1]];
  const shift = (0.5 * (a - c)) / (a - 2 * b + c) || 0;
  return { hz: ((best + shift) * tap.context.sampleRate) / tap.fftSize, level };
}

/** Colour of a pixel of a picture, as #rrggbb. */
export async function pixelOf(page, png, x, y) {
  return page.evaluate(
    async ({ data, x, y }) => {
      const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d");
      context.drawImage(bitmap, 0, 0);
      const [r, g, b] = context.getImageData(x, y, 1, 1).data;
      return [r, g, b];
    },
    { data: png.toString("base64"), x: Math.round(x), y: Math.round(y) },
  );
}

/** Colours of many pixels of one picture, each as [r, g, b]. */
export async function pixelsOf(page, png, points) {
  return page.evaluate(
    async ({ data, points }) => {
      const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d");
      context.drawImage(bitmap, 0, 0);
      const all = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
      return points.map(([x, y]) => [
        ...all.subarray(4 * (y * bitmap.width + x), 4 * (y * bitmap.width + x) + 3),
      ]);
    },
    { data: png.toString("base64"), points },
  );
}
