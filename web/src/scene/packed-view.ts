// SPDX-License-Identifier: Apache-2.0
// What a packed bufferView says of itself, and whether its bytes can hold that much.
import { SceneError } from "./scene-types";

export const PACKED = "EXT_meshopt_compression";

/** The keys of the extension. */
export interface Packed {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride: number;
  readonly count: number;
  readonly mode: string;
  readonly filter?: string;
}

/** Where the bytes of a view stand. */
export interface Stored {
  readonly buffer: number;
  readonly start: number;
  readonly length: number;
}

interface View {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly extensions?: Record<string, unknown>;
}

const isCount = (value: unknown): value is number => Number.isSafeInteger(value) && Number(value) >= 0;

/** Nothing when the view is not packed. Counts that its bytes cannot hold are refused: they would ask for memory. */
export function packedOf(view: View): Packed | null {
  const packed = view.extensions?.[PACKED] as Packed | undefined;
  if (!packed) return null;
  const { byteLength, byteStride, count, mode } = packed;
  const numbers = [packed.buffer, packed.byteOffset ?? 0, byteLength, byteStride, count];
  if (!numbers.every(isCount)) throw new SceneError("a packed array says nonsense of itself");
  // The smallest that the codecs make of so many rows.
  const least =
    mode === "ATTRIBUTES"
      ? Math.floor(count / 64) * byteStride
      : mode === "TRIANGLES"
        ? count / 3
        : mode === "INDICES"
          ? count
          : Number.POSITIVE_INFINITY;
  const strides =
    mode === "ATTRIBUTES" ? byteStride % 4 === 0 && byteStride <= 256 : [2, 4].includes(byteStride);
  if (least > byteLength || !strides || byteStride === 0 || count * byteStride !== view.byteLength)
    throw new SceneError("a packed array says more than its bytes hold");
  return packed;
}

export function storedOf(view: View): Stored {
  const packed = packedOf(view);
  const at = packed ?? view;
  return { buffer: at.buffer, start: at.byteOffset ?? 0, length: at.byteLength };
}
