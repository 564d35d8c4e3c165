// SPDX-License-Identifier: Apache-2.0
// Serves the built page and scenes made by the tests on loopback, and remembers what was asked for.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const DIST = fileURLToPath(new URL("../../dist/", import.meta.url));
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".glb": "model/gltf-binary",
};

/** `files`: path -> bytes, looked at before dist/; or bytes of which what comes after `hold` waits for `free`;
 * or a function that answers. */
export async function serve(files = new Map()) {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://x").pathname).slice(1) || "index.html";
    try {
      const given = files.get(path);
      if (typeof given === "function") return await given(request, response);
      const bytes = given ?? (await readFile(join(DIST, normalize(path))));
      response.writeHead(200, {
        "Content-Type": TYPES[extname(path)] ?? "application/octet-stream",
        "Content-Security-Policy":
          "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data: blob:; connect-src 'self' data: blob:; worker-src 'self' blob:",
      });
      if (!bytes.free) return response.end(Buffer.from(bytes));
      response.write(Buffer.from(bytes.whole).subarray(0, bytes.hold));
      await bytes.free;
      response.end(Buffer.from(bytes.whole).subarray(bytes.hold));
    } catch {
      response.writeHead(404);
      response.end("not found");
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    close: () => {
      server.closeAllConnections();
      return new Promise((r) => server.close(r));
    },
  };
}
