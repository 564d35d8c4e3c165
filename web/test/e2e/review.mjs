// SPDX-License-Identifier: Apache-2.0
// `feelem convert … -o review.html`: one file, opened from disk with the network off, shows, sounds and enters VR.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { findProgram } from "./binary.mjs";
import { enterHeadset, HEARD, listen, openPage, until } from "./harness.mjs";
import { BOILER, BOILER_OPTIONS, viewBoiler, whyNot } from "./program.mjs";

const probe = () => window.feelem.lastProbe();

function makeReview(...more) {
  const folder = mkdtempSync(join(tmpdir(), "feelem-review-"));
  const file = join(folder, "review.html");
  const inputs = more.length > 0 ? more : [join(BOILER, "boiler.frd"), ...BOILER_OPTIONS];
  execFileSync(findProgram(), ["convert", ...inputs, "-o", file], { stdio: "pipe" });
  const end = () => rmSync(folder, { recursive: true, force: true });
  return { folder, file, url: pathToFileURL(file).href, end };
}

/** Colours of the model's picture on a grid of 40 by 30 places. */
async function coloursOf(page) {
  const picture = await page.locator(".area-stage canvas").screenshot();
  return page.evaluate(async (data) => {
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, width, height);
    return Array.from({ length: 1200 }, (_, i) => {
      const x = Math.floor((((i % 40) + 0.5) / 40) * width);
      const y = Math.floor(((Math.floor(i / 40) + 0.5) / 30) * height);
      return String([...pixels.slice(4 * (y * width + x), 4 * (y * width + x) + 3)]);
    });
  }, picture.toString("base64"));
}

export const reviewTests = [
  {
    name: "review_file_shows_the_colours_and_values_of_the_served_page_with_the_network_off",
    skip: whyNot,
    async run({ browser }) {
      const review = makeReview();
      const served = await viewBoiler();
      try {
        const { page, context, foreign, problems } = await openPage(browser, review.url, { offline: true });
        assert.deepEqual(
          foreign.filter((url) => !url.startsWith(review.url)),
          [],
        );
        assert.equal(await page.evaluate(() => isSecureContext), true, "else no headset and no sound");
        const colours = await coloursOf(page);
        assert.ok(
          new Set(colours).size > 20,
          `the model in its colours, not ${new Set(colours).size} of them`,
        );
        for (const id of [3938, 52]) {
          await page.fill(".goto input", String(id));
          await page.keyboard.press("Enter");
          const seen = await until(page, probe, (r) => r?.nodeId === id, `node ${id}`);
          const printed = JSON.parse(
            execFileSync(served.program, ["probe", served.file, "--node", String(id), "--json"], {
              encoding: "utf8",
            }),
          );
          for (const entry of seen.results) {
            const wanted = printed.results.find((r) => r.key === entry.key);
            assert.equal(entry.value, wanted.value, `${entry.name} at node ${id}`);
          }
        }
        assert.deepEqual(problems, []);
        const other = await openPage(browser, served.url);
        assert.deepEqual(await coloursOf(other.page), colours);
        await other.context.close();
        await context.close();
      } finally {
        review.end();
        served.end();
      }
    },
  },
  {
    name: "review_file_sounds_and_enters_the_headset_with_the_network_off",
    skip: whyNot,
    async run({ browser }) {
      const { url, end } = makeReview();
      try {
        const { page, context, problems } = await openPage(browser, url, {
          width: 480,
          height: 300,
          headset: true,
          offline: true,
        });
        const box = await page.locator(".area-stage canvas").boundingBox();
        // Without the labels of the extremes, one of which stands before the middle.
        await page.keyboard.press("x");
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        await page.mouse.down();
        const { hz } = await until(page, probe, (r) => r?.hz > 0, "a pitch");
        const heard = (h) => h.level > HEARD && Math.abs(h.hz / hz - 1) < 0.01;
        await until(page, listen, heard, `a tone of ${hz} Hz`);
        await page.mouse.up();
        await enterHeadset(page);
        await page.evaluate(() => {
          window.headset.controllers.right.position.set(0.05, 1.1, -0.2);
        });
        await until(page, probe, (r) => r?.pointer === "right-controller", "the ray on the boiler");
        assert.deepEqual(problems, []);
        await context.close();
      } finally {
        end();
      }
    },
  },
  {
    name: "review_file_lets_no_other_script_run_and_builds_in_its_worker",
    skip: whyNot,
    async run({ browser }) {
      const { folder, file, end } = makeReview();
      try {
        const text = readFileSync(file, "utf8");
        const workers = text.match(/data:text\/javascript;base64,[A-Za-z0-9+/=]+/g) ?? [];
        assert.equal(workers.length, 2, "both workers are carried too");
        // The other one unpacks compressed scenes.
        const worker = workers.find((address) => !atob(address.split(",")[1]).includes("decodeGltfBuffer"));
        const changed = join(folder, "changed.html");
        writeFileSync(changed, text.replace("</body>", "<script>window.foreignRan = true</script></body>"));
        const { page, context, problems } = await openPage(browser, pathToFileURL(changed).href, {
          offline: true,
        });
        assert.equal(await page.evaluate(() => window.foreignRan), undefined);
        assert.equal(problems.length, 1, "the browser says that it refused it");
        // As the page itself starts it for big models.
        const answered = await page.evaluate(
          (address) =>
            new Promise((resolve) => {
              const started = new Worker(address, { type: "module" });
              started.onmessage = (event) => resolve(Object.keys(event.data));
              started.onerror = () => resolve("failed");
              const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
              const indices = new Uint32Array([0, 1, 2]);
              started.postMessage({ positions, indices });
            }),
          worker,
        );
        assert.deepEqual(answered, ["nodes", "order"]);
        await context.close();
      } finally {
        end();
      }
    },
  },
];
