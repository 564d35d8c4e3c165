// SPDX-License-Identifier: Apache-2.0
// Real Chromium: a bare three.js page and model-viewer show the palette's colours within 2/255 a channel, under each
// variant. Argument: the folder of the tests' scenes.
import { createServer } from 'node:http';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { finish, here, require, root } from './files.mjs';

const browserPath = '/usr/bin/chromium';
if (!existsSync(join(here, 'node_modules')) || !existsSync(browserPath)) {
  console.log('skipped: run ./dev setup test first');
  process.exit(77);
}
const { chromium } = require('playwright-core');
const folders = { three: join(root, 'web/node_modules/three'), 'model-viewer': join(here, 'node_modules/@google/model-viewer'), scenes: process.argv[2] };
const types = { '.html': 'text/html', '.js': 'text/javascript', '.glb': 'model/gltf-binary', '.bin': 'application/octet-stream' };

const server = createServer((request, response) => {
  const path = normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname)).slice(1);
  const [top, ...rest] = path.split('/');
  const file = top in folders ? join(folders[top], ...rest) : join(here, path);
  if (!existsSync(file)) {
    response.writeHead(404).end();
    return;
  }
  response.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/plain' }).end(readFileSync(file));
}).listen(0, '127.0.0.1');
await new Promise((resolve) => server.on('listening', resolve));
const origin = `http://127.0.0.1:${server.address().port}`;

const browser = await chromium.launch({
  executablePath: browserPath,
  headless: true,
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
// Scenes with triangles so large that edge lines, a pixel wide, do not matter inside them.
const scenes = ['check_whole/scene.glb', 'scene_edges/scene.glb'].filter((scene) => existsSync(join(process.argv[2], scene)));
const failures = scenes.length === 2 ? [] : ['the scenes of the tests are not there'];
let checked = 0;
for (const kind of ['three', 'model_viewer']) {
  for (const scene of scenes) {
    const page = await browser.newPage({ viewport: { width: 420, height: 420 } });
    page.on('pageerror', (error) => failures.push(`${kind} ${scene}: ${error}`));
    page.on('request', (request) => {
      if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(origin)) failures.push(`${kind} asks for ${request.url()}`);
    });
    await page.goto(`${origin}/colours_${kind}.html`);
    await page.waitForFunction('window.ready === true', null, { timeout: 60000 });
    const results = await page.evaluate((url) => window.compare(url), `/scenes/${scene}`);
    const looks = new Set();
    for (const [variant, points] of Object.entries(results)) {
      const worst = Math.max(...points.map((p) => Math.max(...p.wanted.map((c, i) => Math.abs(c - p.shown[i])))));
      const wrong = points.filter((p) => p.wanted.some((c, i) => Math.abs(c - p.shown[i]) > 2));
      console.log(`${kind} ${scene} "${variant}": ${points.length} points, worst difference ${worst}`);
      checked += points.length;
      looks.add(JSON.stringify(points.map((p) => p.shown)));
      if (points.length < 50) failures.push(`${kind} ${scene} ${variant}: only ${points.length} points`);
      if (wrong.length > 0) failures.push(`${kind} ${scene} ${variant}: ${wrong.length} wrong, first ${JSON.stringify(wrong[0])}`);
    }
    if (looks.size !== Object.keys(results).length) failures.push(`${kind} ${scene}: two variants look the same`);
    await page.close();
  }
}
await browser.close();
server.close();
finish(checked, failures);
