// SPDX-License-Identifier: Apache-2.0
// Khronos' validator on every scene that the tests wrote: no error, no warning, only the expected notes.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { finish, require, scenesIn } from './files.mjs';

const validator = require('gltf-validator');
const expected = new Set(['UNUSED_OBJECT', 'URI_GLB', 'IMAGE_NPOT_DIMENSIONS', 'UNSUPPORTED_EXTENSION']);

const failures = [];
const scenes = scenesIn(process.argv[2]);
for (const scene of scenes) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(scene)), {
    uri: scene,
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(scene), decodeURIComponent(uri)))),
  });
  for (const issue of report.issues.messages) {
    if (issue.severity > 1 && expected.has(issue.code)) continue;
    failures.push(`${scene}: ${issue.code} ${issue.message} at ${issue.pointer}`);
  }
}
finish(scenes.length, failures);
