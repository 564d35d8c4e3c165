// SPDX-License-Identifier: Apache-2.0
// From the start of `feelem view FILE` to the shape in the page and to its results, beside the way without an early shape
// (`feelem convert FILE -o SCENE`, then `feelem view SCENE`), in turn. A browser is open already. No figure fails.
//
//     node bench/first-picture.mjs [--runs 3] [--sides 68,100] [--bin ../build/bench/bin] [--program ../build/release/bin/feelem]
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdirSync, renameSync, statSync, writeFileSync } from "node:fs";
import { cpus, loadavg, release } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { launch } from "../test/e2e/harness.mjs";
import { watchPage } from "../test/e2e/watch-page.mjs";
import { makeModel } from "./make-model.mjs";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const { values: options } = parseArgs({
  options: {
    runs: { type: "string", default: "3" },
    sides: { type: "string", default: "68,100" },
    bin: { type: "string", default: join(ROOT, "build/bench/bin") },
    program: { type: "string", default: join(ROOT, "build/release/bin/feelem") },
    work: { type: "string", default: join(ROOT, "build/bench") },
    name: { type: "string", default: "first-picture" },
  },
});

/** Made once; half a file is no file. */
function made(name, make) {
  const path = join(options.work, name);
  if (existsSync(path)) return path;
  mkdirSync(options.work, { recursive: true });
  make(`${path}.part`);
  renameSync(`${path}.part`, path);
  return path;
}
const run = (program, ...given) => execFileSync(program, given, { stdio: "pipe", encoding: "utf8" });

/** The files of a model, and its size. */
function models() {
  const blocks = options.sides.split(",").flatMap((side) => {
    const frd = made(`block${side}.frd`, (to) => run(join(options.bin, "bench_make_frd"), side, to));
    return [
      { what: `block of ${Number(side) - 1}³ hex8, one step`, file: `block${side}.frd`, inputs: [frd] },
    ];
  });
  const [side] = options.sides.split(",");
  const lists = made(`lists${side}`, (to) => {
    mkdirSync(to, { recursive: true });
    run(join(options.bin, "bench_make_lists"), side, to);
  });
  const sheet = made("sheet200-20.frd", (to) => makeModel(to, { cells: 200, steps: 20 }));
  return [
    ...blocks,
    { what: `block of ${Number(side) - 1}³ hex8 as lists`, file: `lists${side}/`, inputs: [lists] },
    { what: "sheet of 200 x 200, 20 steps", file: "sheet200-20.frd", inputs: [sheet] },
  ];
}

function sizeOf(path) {
  if (!statSync(path).isDirectory()) return statSync(path).size;
  return Number(run("du", "-sb", path).split("\t")[0]);
}

/** Address that `feelem view` prints. */
function view(...given) {
  const child = spawn(options.program, ["view", ...given, "--no-open"], {
    stdio: ["ignore", "pipe", "pipe"],
  });
  const address = new Promise((resolve, reject) => {
    let said = "";
    const more = (bytes) => {
      said += bytes;
      const url = /https?:\/\/\S+/.exec(said)?.[0];
      if (url) resolve(url);
    };
    child.stdout.on("data", more);
    child.stderr.on("data", more);
    child.on("close", () => reject(new Error(said)));
  });
  return { child, address };
}

/** Milliseconds since `began` until the shape and the results are drawn. */
async function shown(browser, address, began) {
  const context = await browser.newContext({ viewport: { width: 640, height: 420 } });
  context.setDefaultTimeout(180_000);
  await context.addInitScript(watchPage);
  const page = await context.newPage();
  await page.goto(`${await address}?antialias=0`, { waitUntil: "commit" });
  await page.waitForFunction(() => globalThis.feelem);
  await page.evaluate(() => globalThis.feelem.ready);
  const times = await page.evaluate(
    () =>
      new Promise((resolve) =>
        requestAnimationFrame(() =>
          resolve({
            shape: performance.timeOrigin + globalThis.watched.firstModelPicture,
            results: performance.timeOrigin + performance.now(),
            asked: performance.timeOrigin,
          }),
        ),
      ),
  );
  await context.close();
  return Object.fromEntries(Object.entries(times).map(([key, at]) => [key, Math.round(at - began)]));
}

async function shapeFirst(browser, model) {
  const began = Date.now();
  const { child, address } = view(...model.inputs);
  const times = await shown(browser, address, began);
  child.kill("SIGINT");
  return times;
}

async function sceneFirst(browser, model) {
  const scene = join(options.work, "first-picture.glb");
  const began = Date.now();
  run(options.program, "convert", ...model.inputs, "-o", scene);
  const { child, address } = view(scene);
  const times = await shown(browser, address, began);
  child.kill("SIGINT");
  return times;
}

function spread(list) {
  const sorted = [...list].sort((a, b) => a - b);
  const seconds = (ms) => Math.round(ms) / 1000;
  const middle = sorted.length >> 1;
  const median = sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  return { median: seconds(median), least: seconds(sorted[0]), most: seconds(sorted.at(-1)) };
}

const browser = await launch();
const rows = [];
const loads = [];
for (const model of models()) {
  const early = [];
  const late = [];
  for (let i = 0; i < Number(options.runs); ++i) {
    late.push(await sceneFirst(browser, model));
    early.push(await shapeFirst(browser, model));
    loads.push(loadavg()[0]);
  }
  const of = (list, key) => spread(list.map((times) => times[key]));
  const bytes = model.inputs.reduce((sum, path) => sum + sizeOf(path), 0);
  const way = (list) => ({
    page_asked: of(list, "asked"),
    shape: of(list, "shape"),
    results: of(list, "results"),
  });
  rows.push({
    model: model.what,
    file: model.file,
    bytes,
    runs: early.length,
    scene_first: way(late),
    shape_first: way(early),
  });
  const last = rows.at(-1);
  const text = (one) => `shape ${one.shape.median} s, results ${one.results.median} s`;
  console.log(
    `${model.what}, ${Math.round(bytes / 1e6)} MB: scene first: ${text(last.scene_first)}; shape first: ${text(last.shape_first)}`,
  );
}
await browser.close();
const report = {
  what: "from the start of the command to the shape and to the results in the page; the browser is open already",
  machine: `${cpus()[0]?.model}, ${cpus().length} cores, Linux ${release()}; Chromium, SwiftShader`,
  load: `${Math.min(...loads).toFixed(1)} to ${Math.max(...loads).toFixed(1)}`,
  commit: run("git", "-C", ROOT, "describe", "--always", "--dirty").trim(),
  command: `node web/bench/first-picture.mjs --runs ${options.runs} --sides ${options.sides}`,
  rows,
};
writeFileSync(join(ROOT, "bench/results", `${options.name}.json`), `${JSON.stringify(report, null, 1)}\n`);
