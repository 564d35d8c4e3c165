// SPDX-License-Identifier: Apache-2.0
// The page may load nothing from elsewhere: its policy says so before any script runs.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";

test("page_policy_allows_own_origin_only", () => {
  const html = readFileSync(new URL("../index.html", import.meta.url), "utf8");
  const policy = /http-equiv="Content-Security-Policy"\s+content="([^"]+)"/.exec(html)?.[1] ?? "";

  expect(policy).toContain("default-src 'self'");
  // The decoder of compressed scenes is WebAssembly; no script is made of text.
  expect(policy.replace("'wasm-unsafe-eval'", "")).not.toContain("unsafe");
  expect(policy).not.toMatch(/https?:/);
  expect(html).not.toMatch(/<script(?![^>]*\bsrc=)/);
  expect(html).not.toMatch(/<style|\sstyle=|\son[a-z]+=/);
});
