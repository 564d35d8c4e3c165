// SPDX-License-Identifier: Apache-2.0
// Khronos' validator and our schema on every scene that the tests wrote: no error, no warning, only expected notes.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { finish, require, root, scenesIn } from './files.mjs';
import { violations } from './schema.mjs';

const validator = require('gltf-validator');
const expected = new Set(['UNUSED_OBJECT', 'URI_GLB', 'IMAGE_NPOT_DIMENSIONS', 'UNSUPPORTED_EXTENSION']);

const schema = JSON.parse(readFileSync(join(root, 'schema', 'scene.schema.json')));
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
  const bytes = readFileSync(scene);
  const json = JSON.parse(scene.endsWith('.glb') ? bytes.subarray(20, 20 + bytes.readUInt32LE(12)) : bytes);
  for (const text of violations(schema, json.extras?.feelem, 'extras.feelem')) failures.push(`${scene}: ${text}`);
}
finish(scenes.length, failures);
