// SPDX-License-Identifier: Apache-2.0
// three.js and glTF-Transform give every array of our scenes back bit for bit: the reference is a reader of this
// file's own, over the plain bytes. Argument: the folder of the tests' scenes.
import { createHash } from 'node:crypto';
import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { finish, here, require, root, scenesIn } from './files.mjs';

const { NodeIO, Logger } = await import(pathToFileURL(join(here, 'node_modules/@gltf-transform/core/dist/index.js')));
const { MeshoptDecoder } = await import(pathToFileURL(join(root, 'web/node_modules/meshoptimizer/meshopt_decoder.mjs')));
await MeshoptDecoder.ready;
const { GLTFLoader } = await import(pathToFileURL(join(root, 'web/node_modules/three/examples/jsm/loaders/GLTFLoader.js')));

let checked = 0;
const failures = [];
function check(holds, text) {
  checked += 1;
  if (!holds) failures.push(text);
}
const sameBytes = (a, b) => Buffer.compare(Buffer.from(a.buffer, a.byteOffset, a.byteLength), Buffer.from(b.buffer, b.byteOffset, b.byteLength)) === 0;

/** JSON and buffers of a scene, read without any library. */
function plain(path) {
  const bytes = readFileSync(path);
  let json = JSON.parse('null');
  const buffers = [];
  if (path.endsWith('.glb')) {
    const size = bytes.readUInt32LE(12);
    json = JSON.parse(bytes.subarray(20, 20 + size));
    buffers[0] = bytes.subarray(28 + size);
  } else {
    json = JSON.parse(bytes);
  }
  json.buffers.forEach((buffer, i) => {
    if (buffer.uri) buffers[i] = readFileSync(join(dirname(path), buffer.uri));
  });
  return { json, buffers };
}

/** The numbers of an accessor as its own typed array. */
function numbers({ json, buffers }, index) {
  const accessor = json.accessors[index];
  const view = json.bufferViews[accessor.bufferView];
  const packed = view.extensions?.EXT_meshopt_compression;
  const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[accessor.type];
  const Kind = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }[accessor.componentType];
  if (packed) {
    const rows = new Uint8Array(packed.count * packed.byteStride);
    const bytes = buffers[packed.buffer].subarray(packed.byteOffset, packed.byteOffset + packed.byteLength);
    MeshoptDecoder.decodeGltfBuffer(rows, packed.count, packed.byteStride, bytes, packed.mode, packed.filter);
    return new Kind(rows.buffer);
  }
  const from = buffers[view.buffer].subarray(view.byteOffset, view.byteOffset + accessor.count * width * Kind.BYTES_PER_ELEMENT);
  return new Kind(from.buffer.slice(from.byteOffset, from.byteOffset + from.byteLength));
}

/** What the decoder of the browsers unpacks is what the certificate has digests of. */
function checkUnpacked(path, reference) {
  const { digests } = reference.json.extras.feelem.certificate;
  reference.json.accessors.forEach(({ name }, index) => {
    const found = createHash('sha256').update(numbers(reference, index)).digest('hex');
    check(found === digests[name], `${path}: ${name} unpacks to something else`);
  });
}

async function checkTransform(path, reference) {
  const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT));
  const document = await io.read(path);
  const accessors = document.getRoot().listAccessors();
  check(accessors.length === reference.json.accessors.length, `${path}: glTF-Transform has another number of accessors`);
  for (const accessor of accessors) {
    const index = reference.json.accessors.findIndex((a) => a.name === accessor.getName());
    check(index >= 0 && sameBytes(accessor.getArray(), numbers(reference, index)), `${path}: glTF-Transform changes ${accessor.getName()}`);
  }
  check(JSON.stringify(document.getRoot().getExtras()) === JSON.stringify(reference.json.extras), `${path}: glTF-Transform changes extras`);
}

/** Pictures need a browser; everything else of GLTFLoader runs here. */
class WithoutPictures {
  constructor(parser) {
    this.name = 'without_pictures';
    parser.loadTextureImage = async () => null;
  }
}

async function checkThree(path, reference) {
  globalThis.self ??= globalThis;
  globalThis.ProgressEvent ??= class {};
  const fetched = globalThis.fetch;
  globalThis.fetch = async (request) => new Response(readFileSync(decodeURIComponent(new URL(request.url ?? request).pathname)));
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).register((parser) => new WithoutPictures(parser));
  const bytes = readFileSync(path);
  const data = path.endsWith('.glb') ? bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length) : bytes.toString();
  const gltf = await loader.parseAsync(data, `${pathToFileURL(dirname(path))}/`);
  for (let i = 0; i < reference.json.accessors.length; i++) {
    const name = reference.json.accessors[i].name;
    const attribute = await gltf.parser.getDependency('accessor', i);
    check(sameBytes(attribute.array, numbers(reference, i)), `${path}: three.js changes ${name}`);
  }
  // The attributes of the parts by their lower-cased names, as our page and everybody's script asks for them.
  const parts = [];
  gltf.scene.traverse((object) => {
    if (object.userData.feelem?.role === 'part') parts.push(object);
  });
  check(parts.length === gltf.userData.feelem.parts.length, `${path}: three.js has ${parts.length} parts`);
  for (const part of parts) {
    const node = reference.json.nodes.find((n) => n.extras.feelem.role === 'part' && n.extras.feelem.part === part.userData.feelem.part);
    const attributes = reference.json.meshes[node.mesh].primitives[0].attributes;
    for (const [semantic, accessor] of Object.entries(attributes)) {
      if (!semantic.startsWith('_')) continue;
      const attribute = part.geometry.attributes[semantic.toLowerCase()];
      check(attribute && sameBytes(attribute.array, numbers(reference, accessor)), `${path}: three.js loses ${semantic}`);
    }
  }
  globalThis.fetch = fetched;
}

if (!existsSync(join(here, 'node_modules'))) {
  console.log('skipped: run ./dev setup test first');
  process.exit(77);
}
for (const path of scenesIn(process.argv[2])) {
  let reference;
  try {
    reference = plain(path);
  } catch {
    continue; // a test of another folder wrote what is no scene
  }
  if (!reference.json.extras?.feelem?.certificate) continue;
  try {
    if (reference.json.extensionsRequired) checkUnpacked(path, reference);
    else await checkTransform(path, reference);
    await checkThree(path, reference);
  } catch (error) {
    failures.push(`${path} (${basename(path)}): ${error.stack}`);
  }
}
finish(checked, failures);
