// SPDX-License-Identifier: Apache-2.0
// The one table of colours that the mesh, the legend and the panel in the headset all draw from.
import { type ColourEffect, paletteColour } from "../present";

/** Texels of a smooth palette: no step between neighbours is visible. */
const SMOOTH = 1024;

export interface Palette {
  /** RGBA, lowest value first; one texel a band, or SMOOTH of them. */
  readonly texels: Uint8Array;
  readonly count: number;
}

export function makePalette(effect: ColourEffect): Palette {
  const count = effect.bands > 0 ? effect.bands : SMOOTH;
  const texels = new Uint8Array(count * 4);
  for (let i = 0; i < count; ++i) {
    const [r, g, b] = paletteColour((i + 0.5) / count, effect);
    texels.set([r, g, b, 255], i * 4);
  }
  return { texels, count };
}

/** The texel that position t (0..1) falls on; the shader computes the same. */
export function texelOf(t: number, palette: Palette): number {
  return Math.min(Math.max(Math.floor(t * palette.count), 0), palette.count - 1);
}
