// SPDX-License-Identifier: Apache-2.0
// Scenes that the tests wrote, packages of the page, and a count of what held.
import { createRequire } from 'node:module';
import { readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, '..', '..');
export const require = createRequire(join(root, 'web', 'package.json'));

/** A test that runs at the same time may just have taken its folder away. */
function entriesOf(folder) {
  try {
    return readdirSync(folder, { withFileTypes: true });
  } catch (error) {
    if (error.code === 'ENOENT') return [];
    throw error;
  }
}

/**
 * All scenes below a folder, but for those in folders named "broken" and "stand_ins" (the server's), which only look like scenes, and
 * those of the native viewer's tests, which write what others have written and may run at the same time.
 */
export function scenesIn(folder) {
  const found = [];
  for (const entry of entriesOf(folder)) {
    const path = join(folder, entry.name);
    const isOurs = !['broken', 'stand_ins'].includes(entry.name) && !entry.name.startsWith('viewer_');
    if (entry.isDirectory() && isOurs) found.push(...scenesIn(path));
    else if (entry.isFile() && /\.(glb|gltf)$/.test(entry.name)) found.push(path);
  }
  return found.sort();
}

/** Ends the program: failures are listed, and nothing checked is a failure too. */
export function finish(checked, failures) {
  for (const failure of failures) console.error(failure);
  console.log(`${checked} checked, ${failures.length} failed`);
  process.exit(failures.length > 0 || checked === 0 ? 1 : 0);
}
