// SPDX-License-Identifier: Apache-2.0
// The sound engine in a Chromium that renders offline: scripts of calls in, samples out.
import { existsSync } from "node:fs";
import { chromium, type Page } from "playwright-core";
import { build } from "vite";
import type { Script } from "./sound-page";

const executablePath = "/usr/bin/chromium";
export const canRender = existsSync(executablePath);

export interface Renderer {
  readonly page: Page;
  render(script: Script): Promise<readonly [Float32Array, Float32Array]>;
  close(): Promise<void>;
}

export async function startRenderer(): Promise<Renderer> {
  const bundle = await build({
    configFile: false,
    logLevel: "error",
    build: {
      write: false,
      minify: false,
      lib: { entry: new URL("./sound-page.ts", import.meta.url).pathname, formats: ["iife"], name: "page" },
    },
  });
  const [first] = Array.isArray(bundle) ? bundle : [bundle];
  if (!first || !("output" in first)) throw new Error("the page of the test was not built");
  const browser = await chromium.launch({
    executablePath,
    headless: true,
    args: ["--no-sandbox", "--disable-quic"],
  });
  const page = await browser.newPage();
  // An init script is no gesture: what it starts stays silent until somebody touches the page.
  await page.addInitScript({ content: first.output[0].code });
  await page.goto("data:text/html,<title>sound</title>");
  return {
    page,
    close: () => browser.close(),
    async render(script) {
      const channels = await page.evaluate(
        (s) => (globalThis as unknown as { render(script: unknown): Promise<string[]> }).render(s),
        script,
      );
      const [left, right] = channels.map((text) => {
        const bytes = Buffer.from(text, "base64");
        return new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4).slice();
      });
      if (!left || !right) throw new Error("no sound came back");
      return [left, right];
    },
  };
}
