// SPDX-License-Identifier: Apache-2.0
// Runs beside the page: unpacks one array after the other.
import type { Packed } from "./packed-view";
import { unpack } from "./unpack";

export interface UnpackTask {
  readonly id: number;
  readonly bytes: Uint8Array;
  readonly packed: Packed;
}
export interface UnpackAnswer {
  readonly id: number;
  readonly rows?: Uint8Array<ArrayBuffer>;
  readonly error?: string;
}

self.onmessage = async ({ data }: MessageEvent<UnpackTask>) => {
  try {
    const rows = await unpack(data.bytes, data.packed);
    self.postMessage({ id: data.id, rows } satisfies UnpackAnswer, { transfer: [rows.buffer] });
  } catch (error) {
    self.postMessage({ id: data.id, error: String(error) } satisfies UnpackAnswer);
  }
};
