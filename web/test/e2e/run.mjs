// SPDX-License-Identifier: Apache-2.0
// Runs the browser tests: `node test/e2e/run.mjs [PART OF A NAME]`. Builds the page first when it is not built.
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { tinyScene } from "../support/tiny-scene.ts";
import { accessTests } from "./access.mjs";
import { budgetTests } from "./budget.mjs";
import { claimTests } from "./claims.mjs";
import { contrastTests } from "./contrast.mjs";
import { deskTests } from "./desk.mjs";
import { launch } from "./harness.mjs";
import { insideTests } from "./inside.mjs";
import { keepTests } from "./keep.mjs";
import { keyboardTests } from "./keyboard.mjs";
import { lanTests } from "./lan.mjs";
import { legendTests } from "./legend.mjs";
import { listeningTests } from "./listening.mjs";
import { lodTests } from "./lod.mjs";
import { lookTests } from "./look.mjs";
import { nativeTests } from "./native.mjs";
import { openingTests } from "./opening.mjs";
import { readScene } from "./oracle.mjs";
import { packedTests } from "./packed.mjs";
import { programTests } from "./program.mjs";
import { reviewTests } from "./review.mjs";
import { serve } from "./server.mjs";
import { shaderTests } from "./shaders.mjs";
import { shareTests } from "./share.mjs";
import { smallTests } from "./small.mjs";
import { timeTests } from "./time.mjs";
import { touchTests } from "./touch.mjs";
import { variantTests } from "./variants.mjs";
import { vectorTests } from "./vectors.mjs";
import { vrTests } from "./vr.mjs";
import { vrComfortTests } from "./vr-comfort.mjs";
import { vrPinchTests } from "./vr-pinches.mjs";
import { vrRowTests } from "./vr-rows.mjs";
import { vrTouchTests } from "./vr-touch.mjs";

const LIMIT_SECONDS = 180;
const root = fileURLToPath(new URL("../../", import.meta.url));
const wanted = process.argv[2] ?? "";
if (!existsSync(`${root}/dist/index.html`) || process.env.FEELEM_E2E_BUILD) {
  await build({ root, logLevel: "warn" });
}

const { glb } = tinyScene();
const server = await serve(new Map([["scene.glb", new Uint8Array(glb)]]));
const browser = await launch();
/** Another tiny scene on a server of its own. */
async function serveTiny(options) {
  const made = tinyScene(options);
  const files = new Map([["scene.glb", new Uint8Array(made.glb)]]);
  for (const [uri, bytes] of made.side) files.set(uri, new Uint8Array(bytes));
  return { ...(await serve(files)), bytes: made.glb, files };
}
/** A test that hangs fails; it does not keep everybody waiting. */
function inTime(running) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no end after ${LIMIT_SECONDS} s`)), LIMIT_SECONDS * 1000);
  });
  return Promise.race([running, late]).finally(() => clearTimeout(timer));
}
const given = { browser, url: server.url, scene: readScene(glb), serveTiny };
let passed = 0;
let failed = 0;
let skipped = 0;
for (const { name, run, skip } of [
  ...deskTests,
  ...claimTests,
  ...legendTests,
  ...lookTests,
  ...shaderTests,
  ...nativeTests,
  ...budgetTests,
  ...listeningTests,
  ...timeTests,
  ...keepTests,
  ...shareTests,
  ...openingTests,
  ...accessTests,
  ...contrastTests,
  ...smallTests,
  ...keyboardTests,
  ...vrTests,
  ...vrRowTests,
  ...vrComfortTests,
  ...vrPinchTests,
  ...vrTouchTests,
  ...touchTests,
  ...packedTests,
  ...programTests,
  ...insideTests,
  ...variantTests,
  ...vectorTests,
  ...reviewTests,
  ...lanTests,
  ...lodTests,
]) {
  if (!name.includes(wanted)) continue;
  if (skip) {
    skipped += 1;
    console.log(`skip  ${name}: ${skip}`);
    continue;
  }
  const start = Date.now();
  try {
    await inTime(run(given));
    passed += 1;
    console.log(`ok    ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed += 1;
    console.log(`FAIL  ${name}: ${error.stack ?? error}`);
  }
}
await browser.close();
await server.close();
console.log(`${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ""}`);
// A test that failed may have left a server open: that is no reason to wait.
process.exit(failed > 0 || passed === 0 ? 1 : 0);
