// SPDX-License-Identifier: Apache-2.0
// Unpacks arrays of EXT_meshopt_compression. Heavy: the page has it done by unpack-worker.ts.
import { MeshoptDecoder } from "meshoptimizer/decoder";
import type { Packed } from "./packed-view";
import { SceneError } from "./scene-types";

/** The rows, or an error when the bytes do not hold them. */
export async function unpack(bytes: Uint8Array, packed: Packed): Promise<Uint8Array<ArrayBuffer>> {
  await MeshoptDecoder.ready;
  const rows = new Uint8Array(packed.count * packed.byteStride);
  try {
    MeshoptDecoder.decodeGltfBuffer(rows, packed.count, packed.byteStride, bytes, packed.mode, packed.filter);
  } catch {
    throw new SceneError("a packed array is damaged: its bytes are not what they say");
  }
  return rows;
}
