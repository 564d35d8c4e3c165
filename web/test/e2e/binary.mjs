// SPDX-License-Identifier: Apache-2.0
// The built program for the browser tests: makes scenes and says what it knows of them.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve } from "./server.mjs";

export const ROOT = fileURLToPath(new URL("../../../", import.meta.url));

/** The newest program that was built here; FEELEM_BINARY names another. */
export function findProgram() {
  if (process.env.FEELEM_BINARY) return process.env.FEELEM_BINARY;
  const built = ["release", "dev"]
    .map((preset) => join(ROOT, "build", preset, "bin/feelem"))
    .filter(existsSync);
  return built.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0] ?? null;
}

/** Null when the program and these files are here; else the reason to skip. */
export function whyNoScene(...files) {
  if (!findProgram()) return "the program is not built";
  const gone = files.find((file) => !existsSync(join(ROOT, file)));
  return gone ? `${gone} is not here` : null;
}

export function tell(...given) {
  return execFileSync(findProgram(), given, { encoding: "utf8", stdio: "pipe", cwd: ROOT });
}

/** A folder for scenes, with all that was put there served beside the page. */
export async function workshop() {
  const folder = mkdtempSync(join(tmpdir(), "feelem-e2e-"));
  const servers = [];
  return {
    folder,
    /** Converts; gives the scene's file. */
    convert(name, ...given) {
      const file = join(folder, name);
      tell("convert", ...given, "-o", file);
      return file;
    },
    /** Address of the page that shows the scene. */
    async show(file) {
      const server = await serve(new Map([["scene.glb", readFileSync(file)]]));
      servers.push(server);
      return server.url;
    },
    async end() {
      for (const server of servers) await server.close();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

/** What `feelem probe` prints of a node: the places of its parts, each with its results. */
export function probeNode(file, node, ...given) {
  const printed = JSON.parse(tell("probe", file, "--node", String(node), "--json", ...given));
  return [printed, ...(printed.others ?? [])];
}
