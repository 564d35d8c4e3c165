// SPDX-License-Identifier: Apache-2.0
// A scene packed as `feelem convert --compress` does it, made of a plain one.
import { MeshoptEncoder } from "meshoptimizer/encoder";

interface View {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  target?: number;
  extensions?: Record<string, unknown>;
}
interface Json {
  accessors: { bufferView: number; componentType: number; count: number; type: string; name?: string }[];
  bufferViews: View[];
  buffers: { uri?: string; byteLength: number; extensions?: unknown }[];
  extensionsUsed?: string[];
  extensionsRequired?: string[];
}

const COMPONENTS: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3 };

/** Chunks of a .glb. */
export function readGlb(glb: ArrayBuffer): { json: Json; bin: Uint8Array } {
  const view = new DataView(glb);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, 20, length))) as Json;
  return { json, bin: new Uint8Array(glb, 28 + length, view.getUint32(20 + length, true)) };
}

export function writeGlb(json: unknown, bin: Uint8Array): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const head = Math.ceil(text.length / 4) * 4;
  const rest = Math.ceil(bin.length / 4) * 4;
  const glb = new Uint8Array(28 + head + rest).fill(0x20, 20, 20 + head);
  const view = new DataView(glb.buffer);
  for (const [i, word] of [0x46546c67, 2, glb.length, head, 0x4e4f534a].entries())
    view.setUint32(4 * i, word, true);
  view.setUint32(20 + head, rest, true);
  view.setUint32(24 + head, 0x004e4942, true);
  glb.set(text, 20);
  glb.set(bin, 28 + head);
  return glb.buffer;
}

/** Packs every array of the .glb's own buffer; indices as plain lists, so that no corner turns. */
export async function packScene(glb: ArrayBuffer): Promise<ArrayBuffer> {
  await MeshoptEncoder.ready;
  const { json, bin } = readGlb(glb);
  const pieces: Uint8Array[] = [];
  let at = 0;
  let unpacked = 0;
  const fallback = json.buffers.length;
  const used = new Map(json.accessors.map((a) => [a.bufferView, a]));
  for (const [index, view] of json.bufferViews.entries()) {
    if (view.buffer !== 0) continue;
    const start = view.byteOffset ?? 0;
    const bytes = bin.slice(start, start + view.byteLength);
    const accessor = used.get(index);
    if (!accessor) {
      pieces.push(bytes, new Uint8Array((4 - (bytes.length % 4)) % 4));
      view.byteOffset = at;
      at += Math.ceil(bytes.length / 4) * 4;
      continue;
    }
    const size = accessor.componentType === 5123 ? 2 : 4;
    const mode = view.target === 34963 ? "INDICES" : "ATTRIBUTES";
    const byteStride = size * (COMPONENTS[accessor.type] ?? 1);
    const packed = MeshoptEncoder.encodeGltfBuffer(bytes, accessor.count, byteStride, mode, 0);
    pieces.push(packed, new Uint8Array((4 - (packed.length % 4)) % 4));
    view.extensions = {
      EXT_meshopt_compression: {
        buffer: 0,
        byteOffset: at,
        byteLength: packed.length,
        byteStride,
        count: accessor.count,
        mode,
      },
    };
    view.buffer = fallback;
    view.byteOffset = unpacked;
    unpacked += Math.ceil(view.byteLength / 4) * 4;
    at += Math.ceil(packed.length / 4) * 4;
  }
  const whole = new Uint8Array(at);
  let to = 0;
  for (const piece of pieces) {
    whole.set(piece, to);
    to += piece.length;
  }
  json.buffers[0] = { byteLength: at };
  json.buffers.push({ byteLength: unpacked, extensions: { EXT_meshopt_compression: { fallback: true } } });
  json.extensionsRequired = ["EXT_meshopt_compression"];
  return writeGlb(json, whole);
}
