// SPDX-License-Identifier: Apache-2.0
// How each part is drawn, as a texture that the shaders ask: hiding a part uploads a few bytes, no geometry.
import { DataTexture, NearestFilter, RGBAFormat, UnsignedByteType } from "three";

export type PartLook = "shown" | "clear" | "hidden";

/** Bytes of a look in the red channel; green: 255 for a part that encloses a volume. */
const CODES: Record<PartLook, number> = { hidden: 0, clear: 128, shown: 255 };
/** Wider rows than this some cards refuse. */
const ROW = 1024;

export class PartTable {
  readonly texture: DataTexture;
  readonly width: number;
  readonly height: number;
  readonly #texels: Uint8Array;

  constructor(solid: readonly boolean[]) {
    const count = Math.max(solid.length, 1);
    this.width = Math.min(count, ROW);
    this.height = Math.ceil(count / ROW);
    this.#texels = new Uint8Array(4 * this.width * this.height);
    for (const [i, is] of solid.entries()) this.#texels.set([255, is ? 255 : 0, 0, 255], 4 * i);
    this.texture = new DataTexture(this.#texels, this.width, this.height, RGBAFormat, UnsignedByteType);
    this.texture.magFilter = NearestFilter;
    this.texture.minFilter = NearestFilter;
    this.texture.needsUpdate = true;
  }

  set(looks: readonly PartLook[]): void {
    for (const [i, look] of looks.entries()) this.#texels[4 * i] = CODES[look];
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}
