// SPDX-License-Identifier: Apache-2.0
// The few parts of glTF 2.0 that a scene uses, read with every length checked against the bytes at hand.
import type { OwnBytes } from "./own-bytes";
import { packedOf, storedOf } from "./packed-view";
import { SceneError } from "./scene-types";
import { type Unpack, unpackAside } from "./unpack-aside";

export interface GltfAccessor {
  bufferView?: number;
  byteOffset?: number;
  componentType: number;
  normalized?: boolean;
  count: number;
  type: string;
  name?: string;
  extras?: { feelem?: Partial<Steps> };
}
/** The numbers of an accessor are steps: value = offset + step * number, the number's bits read as signed. */
interface Steps {
  offset: number;
  step: number;
}
export interface GltfBufferView {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride?: number;
  extensions?: Record<string, unknown>;
}
export interface GltfPrimitive {
  attributes: Record<string, number>;
  indices?: number;
  mode?: number;
}
export interface GltfNode {
  name?: string;
  mesh?: number;
  children?: number[];
  matrix?: number[];
  extras?: { feelem?: Record<string, unknown> };
}
export interface GltfJson {
  accessors?: GltfAccessor[];
  bufferViews?: GltfBufferView[];
  buffers?: { uri?: string; byteLength: number }[];
  meshes?: { name?: string; primitives: GltfPrimitive[] }[];
  nodes?: GltfNode[];
  scenes?: { nodes?: number[] }[];
  scene?: number;
  extras?: { feelem?: unknown };
  extensionsRequired?: string[];
}

/** Fetches a file that stands beside the scene. */
export type FetchSide = (uri: string) => Promise<ArrayBuffer>;

const MAGIC = 0x46546c67;
const CHUNK_JSON = 0x4e4f534a;
const CHUNK_BIN = 0x004e4942;

export interface Container {
  readonly json: GltfJson;
  readonly bin: Uint8Array | null;
}

export function parseJson(bytes: Uint8Array): GltfJson {
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch {
    throw new SceneError("the scene's JSON cannot be read: is the file complete?");
  }
  if (typeof json !== "object" || json === null || Array.isArray(json)) {
    throw new SceneError("the scene's JSON is not an object");
  }
  return json as GltfJson;
}

/** Whether the first 12 bytes are those of a .glb; false: it may be a .gltf. */
export function readHead(bytes: Uint8Array): boolean {
  if (bytes.byteLength < 12) throw new SceneError(`not a scene: only ${bytes.byteLength} bytes`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== MAGIC) return false;
  if (view.getUint32(4, true) !== 2) throw new SceneError("not a glTF 2.0 file");
  return true;
}

/** Takes .glb (binary) and .gltf (JSON with buffers beside it). */
export function parseContainer(bytes: Uint8Array): Container {
  if (!readHead(bytes)) return { json: parseJson(bytes), bin: null };
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let json: GltfJson | null = null;
  let bin: Uint8Array | null = null;
  for (let at = 12; at + 8 <= bytes.byteLength; ) {
    const length = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    if (at + 8 + length > bytes.byteLength)
      throw new SceneError("the scene is cut off: a chunk is longer than the file");
    const chunk = bytes.subarray(at + 8, at + 8 + length);
    if (type === CHUNK_JSON && !json) json = parseJson(chunk);
    if (type === CHUNK_BIN && !bin) bin = chunk;
    at += 8 + length;
  }
  if (!json) throw new SceneError("the scene has no JSON chunk");
  return { json, bin };
}

const COMPONENTS: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const BYTES: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };

function readOne(view: DataView, at: number, type: number, normalized: boolean): number {
  switch (type) {
    case 5120: {
      const v = view.getInt8(at);
      return normalized ? Math.max(v / 127, -1) : v;
    }
    case 5121:
      return normalized ? view.getUint8(at) / 255 : view.getUint8(at);
    case 5122: {
      const v = view.getInt16(at, true);
      return normalized ? Math.max(v / 32767, -1) : v;
    }
    case 5123:
      return normalized ? view.getUint16(at, true) / 65535 : view.getUint16(at, true);
    case 5125:
      return view.getUint32(at, true);
    default:
      return view.getFloat32(at, true);
  }
}

function onSteps(buffer: ArrayBufferLike, at: number, length: number, { offset, step }: Steps): Float32Array {
  const numbers = new Int32Array(buffer, at, length);
  const values = new Float32Array(length);
  for (let i = 0; i < length; ++i) values[i] = offset + step * (numbers[i] ?? 0);
  return values;
}

export interface Numbers {
  readonly components: number;
  readonly count: number;
  readonly data: Float32Array | Uint32Array;
}

/** Reads accessors; who asks for the same side buffer while it comes shares it, then it is theirs alone. */
export class AccessorReader {
  readonly #json: GltfJson;
  readonly #own: OwnBytes;
  readonly #fetchSide: FetchSide;
  readonly #byName = new Map<string, number>();
  readonly #kept = new WeakSet<ArrayBufferLike>();
  readonly #coming = new Map<number, Promise<Uint8Array>>();

  readonly #unpack: Unpack;

  constructor(json: GltfJson, own: OwnBytes, fetchSide: FetchSide, unpack: Unpack = unpackAside()) {
    this.#unpack = unpack;
    this.#json = json;
    this.#own = own;
    this.#fetchSide = fetchSide;
    for (const [i, accessor] of (json.accessors ?? []).entries()) {
      if (accessor.name && !this.#byName.has(accessor.name)) this.#byName.set(accessor.name, i);
    }
  }

  has(name: string): boolean {
    return this.#byName.has(name);
  }

  async readNamed(name: string): Promise<Numbers> {
    const index = this.#byName.get(name);
    if (index === undefined) throw new SceneError(`the scene names '${name}' but holds no such data`);
    return this.read(index);
  }

  async read(index: number): Promise<Numbers> {
    const accessor = this.#json.accessors?.[index];
    if (!accessor) throw new SceneError(`the scene has no accessor ${index}`);
    const label = accessor.name ?? `accessor ${index}`;
    const components = COMPONENTS[accessor.type];
    const size = BYTES[accessor.componentType];
    const view = this.#json.bufferViews?.[accessor.bufferView ?? -1];
    if (!components || !size || !view) throw new SceneError(`${label}: not data this page can read`);
    const buffer = await this.#viewBytes(accessor.bufferView ?? -1, view);
    const count = accessor.count;
    const stride = view.byteStride ?? components * size;
    const start = accessor.byteOffset ?? 0;
    const end = count > 0 ? start + (count - 1) * stride + components * size : start;
    if (
      !Number.isInteger(count) ||
      count < 0 ||
      stride < components * size ||
      !(start >= 0) ||
      end > buffer.byteLength
    ) {
      throw new SceneError(`${label}: says ${count} values, more than the file holds`);
    }
    const wide = accessor.componentType === 5126 || accessor.normalized === true;
    const length = count * components;
    const at = buffer.byteOffset + start;
    if (stride === components * size && at % 4 === 0 && size === 4) {
      const data = wide
        ? new Float32Array(buffer.buffer, at, length)
        : new Uint32Array(buffer.buffer, at, length);
      const steps = accessor.extras?.feelem;
      if (!wide && steps?.step !== undefined && steps.offset !== undefined)
        return { components, count, data: onSteps(data.buffer, at, length, steps as Steps) };
      return { components, count, data };
    }
    const data = wide ? new Float32Array(length) : new Uint32Array(length);
    const bytes = new DataView(buffer.buffer, at, end - start);
    for (let i = 0; i < count; ++i) {
      for (let c = 0; c < components; ++c) {
        const from = i * stride + c * size;
        data[i * components + c] = readOne(bytes, from, accessor.componentType, accessor.normalized === true);
      }
    }
    return { components, count, data };
  }

  async #viewBytes(index: number, view: GltfBufferView): Promise<Uint8Array> {
    const packed = packedOf(view);
    if (packed) return this.#unpack(await this.#storedBytes(index, view), packed);
    const bytes = await this.#storedBytes(index, view);
    if (this.#json.buffers?.[view.buffer]?.uri === undefined) this.#kept.add(bytes.buffer);
    return bytes;
  }

  async #storedBytes(index: number, view: GltfBufferView): Promise<Uint8Array> {
    const stored = storedOf(view);
    const buffer = this.#json.buffers?.[stored.buffer];
    if (!buffer) throw new SceneError(`the scene has no buffer ${stored.buffer}`);
    if (buffer.uri === undefined) return this.#own.view(index);
    const bytes = await this.#side(stored.buffer, buffer.uri);
    return bytes.subarray(stored.start, stored.start + stored.length);
  }

  #side(index: number, uri: string): Promise<Uint8Array> {
    let coming = this.#coming.get(index);
    if (!coming) {
      coming = this.#fetch(uri).finally(() => this.#coming.delete(index));
      this.#coming.set(index, coming);
    }
    return coming;
  }

  /** Whether a buffer is the scene's own, which stays in memory anyway. */
  keeps(buffer: ArrayBufferLike): boolean {
    return this.#kept.has(buffer);
  }

  async #fetch(uri: string): Promise<Uint8Array> {
    let bytes: ArrayBuffer;
    try {
      bytes = await this.#fetchSide(uri);
    } catch (error) {
      throw new SceneError(`'${uri}', which stands beside the scene, cannot be read: ${String(error)}`);
    }
    return new Uint8Array(bytes);
  }
}
