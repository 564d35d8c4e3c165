// SPDX-License-Identifier: Apache-2.0
// Serves the built page and a scene from disk, as fast as a given network: large files are never held in memory.
import { createReadStream, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { fileURLToPath } from "node:url";

const DIST = fileURLToPath(new URL("../dist/", import.meta.url));
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml" };
const PIECE = 256 << 10;

function find(path, folder) {
  for (const root of [DIST, folder]) {
    const file = join(root, normalize(path));
    const found = statSync(file, { throwIfNoEntry: false });
    if (found?.isFile()) return { file, size: found.size };
  }
  return null;
}

/** `asked` remembers each path with its size and what had been sent when. */
export async function serveFiles(folder, bytesPerSecond) {
  const asked = [];
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://x").pathname).slice(1) || "index.html";
    const found = find(path, folder);
    if (!found) {
      response.writeHead(404).end("not found");
      return;
    }
    const type = TYPES[extname(path)] ?? "application/octet-stream";
    response.writeHead(200, { "Content-Type": type, "Content-Length": found.size });
    const entry = { path, sent: 0, progress: [] };
    asked.push(entry);
    const start = Date.now();
    for await (const piece of createReadStream(found.file, { highWaterMark: PIECE })) {
      if (response.destroyed) return;
      if (!response.write(piece)) await new Promise((go) => response.once("drain", go));
      entry.sent += piece.length;
      entry.progress.push([Date.now(), entry.sent]);
      const ahead = (1000 * entry.sent) / bytesPerSecond - (Date.now() - start);
      if (ahead > 5) await sleep(ahead);
    }
    response.end();
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const close = () => {
    server.closeAllConnections();
    return new Promise((done) => server.close(done));
  };
  return { url: `http://127.0.0.1:${server.address().port}/`, asked, close };
}
