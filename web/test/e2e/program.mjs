// SPDX-License-Identifier: Apache-2.0
// The real program with the boiler: what `feelem probe` prints, the page shows; `feelem view` serves it.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { findProgram, ROOT, whyNoScene } from "./binary.mjs";
import { enterHeadset, HEARD, listen, openPage, until } from "./harness.mjs";

export const BOILER = join(ROOT, "examples/boiler");
export const whyNot = whyNoScene("examples/boiler/boiler.frd");

export const BOILER_OPTIONS = [
  ...["--length-unit", "mm", "--unit", "temperature=degC"],
  ...["--unit", "displacement=mm", "--unit", "stress=MPa"],
  ...["--present", join(BOILER, "boiler.presentation.json")],
];

/** `feelem view` of a file, with nothing kept between runs but in `folder`; gives its address and an end. */
export async function view(folder, file, ...options) {
  const child = spawn(findProgram(), ["view", file, "--no-open", ...options], {
    env: { ...process.env, XDG_DATA_HOME: folder },
    stdio: ["ignore", "pipe", "pipe"],
  });
  const url = await new Promise((resolve, reject) => {
    let said = "";
    const more = (bytes) => {
      said += bytes;
      const address = /https?:\/\/[^\s]+/.exec(said)?.[0];
      if (address) resolve(address);
    };
    child.stdout.on("data", more);
    child.stderr.on("data", more);
    child.on("exit", () => reject(new Error(`feelem view ended: ${said}`)));
  });
  const end = () => {
    child.removeAllListeners("exit");
    child.kill("SIGINT");
    rmSync(folder, { recursive: true, force: true });
  };
  return { url, end };
}

/** Converts the boiler and serves it; gives address, scene file and an end. */
export async function viewBoiler(...options) {
  const program = findProgram();
  const folder = mkdtempSync(join(tmpdir(), "feelem-e2e-"));
  const file = join(folder, "boiler.glb");
  execFileSync(program, ["convert", join(BOILER, "boiler.frd"), "-o", file, ...BOILER_OPTIONS], {
    stdio: "pipe",
  });
  return { program, file, ...(await view(folder, file, ...options)) };
}

const probe = () => window.feelem.lastProbe();

export const programTests = [
  {
    name: "program_serves_the_boiler_and_the_page_says_what_probe_prints",
    skip: whyNot,
    async run({ browser }) {
      const { program, file, url, end } = await viewBoiler();
      try {
        const { page, context, foreign, problems } = await openPage(browser, url);
        const { results, title } = await page.evaluate(() => window.feelem.scene());
        assert.ok(title.length > 0);
        const hottest = results.find((r) => r.id === "temperature").values[0].max.node;
        for (const id of [hottest, 3938, 52]) {
          await page.fill(".goto input", String(id));
          await page.keyboard.press("Enter");
          const seen = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
          const printed = JSON.parse(
            execFileSync(program, ["probe", file, "--node", String(id), "--json"], { encoding: "utf8" }),
          );
          const place =
            (printed.places ?? [printed]).find((p) => p.elementId === seen.elementId) ??
            (printed.places ?? [printed])[0];
          for (const entry of seen.results) {
            const wanted = place.results.find((r) => r.key === entry.key);
            assert.equal(entry.value, wanted.value, `${entry.name} at node ${id}`);
            assert.equal(entry.state, wanted.state);
            assert.equal(entry.unit, wanted.unit);
          }
        }
        assert.deepEqual([foreign, problems], [[], []]);
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "program_boiler_sounds_under_the_mouse_and_in_the_headset",
    skip: whyNot,
    async run({ browser }) {
      const { url, end } = await viewBoiler();
      try {
        const { page, context } = await openPage(browser, url, { width: 480, height: 620, headset: true });
        const box = await page.locator(".area-stage canvas").boundingBox();
        // Without the labels of the extremes, one of which stands before the middle.
        await page.keyboard.press("x");
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        await page.mouse.down();
        const { hz } = await until(page, probe, (r) => r?.hz > 0, "a pitch");
        await until(
          page,
          listen,
          (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01,
          `a tone of ${hz} Hz`,
        );
        await page.mouse.up();
        await enterHeadset(page);
        await page.evaluate(() => {
          window.headset.controllers.right.position.set(0.05, 1.1, -0.2);
        });
        await until(page, probe, (r) => r?.pointer === "right-controller", "the ray on the boiler");
        await page.evaluate(() => window.headset.controllers.right.updateButtonValue("trigger", 1));
        await until(
          page,
          () => window.feelem.pulses().length,
          (n) => n >= 2,
          "pulses in the hand",
        );
        const report = await page.evaluate(probe);
        assert.equal(report.pointer, "right-controller");
        await page.evaluate(() => window.headset.controllers.right.updateButtonValue("trigger", 0));
        await until(page, listen, (h) => h.level < 1e-4, "silence");
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "program_page_is_the_one_that_was_built",
    skip: whyNot,
    async run() {
      const { url, end } = await viewBoiler();
      try {
        const served = await (await fetch(url)).text();
        const built = readFileSync(join(ROOT, "web/dist/index.html"), "utf8");
        assert.equal(served, built, "the program carries an older page: build it again");
        const policy = (await fetch(url)).headers.get("content-security-policy");
        assert.ok(policy?.includes("default-src 'self'"), `policy: ${policy}`);
      } finally {
        end();
      }
    },
  },
];
