// SPDX-License-Identifier: Apache-2.0
// `feelem view --lan`: the page under TLS by the secret link, with the code that brings a headset there.
import assert from "node:assert/strict";
import { request } from "node:https";
import { openPage, pixelOf, until } from "./harness.mjs";
import { viewBoiler, whyNot } from "./program.mjs";

/** Status and body of a plain request, trusting any certificate. */
const ask = (url) =>
  new Promise((resolve, reject) => {
    const asked = request(url, { rejectUnauthorized: false }, (answer) => {
      const pieces = [];
      answer.on("data", (bytes) => pieces.push(bytes));
      answer.on("end", () => resolve({ status: answer.statusCode, body: Buffer.concat(pieces) }));
    });
    asked.on("error", reject);
    asked.end();
  });

export const lanTests = [
  {
    name: "lan_page_runs_under_tls_by_its_link_alone_and_shows_the_code",
    skip: whyNot,
    async run({ browser }) {
      const { url, end } = await viewBoiler("--lan");
      try {
        const secure = url.replace("http:", "https:");
        const { page, context, foreign, problems } = await openPage(browser, secure);
        assert.equal(await page.evaluate(() => isSecureContext), true);
        await page.fill(".goto input", "3938");
        await page.keyboard.press("Enter");
        const seen = await until(
          page,
          () => window.feelem.lastProbe(),
          (r) => r?.nodeId === 3938,
          "node 3938",
        );
        assert.ok(seen.results.length > 0);
        const section = page.locator("details[data-section=connect]");
        await section.locator("summary").click();
        const code = section.locator("img");
        await until(
          page,
          () => document.querySelector(".connect-code")?.naturalWidth ?? 0,
          (width) => width > 0,
          "the code",
        );
        const picture = await code.screenshot();
        assert.deepEqual(await pixelOf(page, picture, 6, 6), [255, 255, 255], "a quiet zone around it");
        assert.deepEqual([foreign, problems], [[], []]);
        const about = await ask(`${secure}connect.html`);
        assert.equal(about.status, 200);
        assert.match(about.body.toString(), /([0-9A-F]{2}:){31}[0-9A-F]{2}/);
        await context.close();
        const { origin } = new URL(secure);
        for (const path of ["/", "/scene.glb", "/boiler.glb", "/connect.svg"]) {
          const { status, body } = await ask(origin + path);
          assert.equal(status, 403);
          assert.equal(body.toString(), "the whole link is needed, as it was printed\n");
        }
      } finally {
        end();
      }
    },
  },
];
