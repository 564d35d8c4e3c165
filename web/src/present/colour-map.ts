// SPDX-License-Identifier: Apache-2.0
// Value -> colour: the maps, bands, and the colours beside the map. Twin of src/present/colour_map.cpp.
import { colourTables } from "./colour-tables";
import { normalise } from "./normalise";
import type { ColourEffect, Rgb, ValueRange } from "./types";

function bytesOf(hex: string): Uint8Array {
  const bytes = new Uint8Array(hex.length / 2);
  for (let i = 0; i < bytes.length; i++) bytes[i] = Number.parseInt(hex.slice(2 * i, 2 * i + 2), 16);
  return bytes;
}

/** Map name -> rows of three bytes. */
const tables: ReadonlyMap<string, Uint8Array> = new Map(
  Object.entries(colourTables).map(([name, hex]) => [name, bytesOf(hex)]),
);

/** t within 0..1, and 0 for anything that is no number. */
const unit = (t: number) => (t > 0 ? Math.min(t, 1) : 0);

/** Names of the colour maps, default first. */
export function colourMaps(): string[] {
  return [...tables.keys()];
}

/** sRGB of a map at t in 0..1: linear between the map's rows. */
export function mapColour(map: string, t: number): Rgb {
  const rows = tables.get(map);
  if (!rows) throw new RangeError(`there is no colour map '${map}'; the maps are: ${colourMaps().join(" ")}`);
  const count = rows.length / 3;
  const place = unit(t) * (count - 1);
  const first = Math.min(Math.floor(place), count - 2);
  const share = place - first;
  const mix = (i: number) => {
    const a = rows[3 * first + i] ?? 0;
    const b = rows[3 * first + 3 + i] ?? 0;
    return Math.floor(a * (1 - share) + b * share + 0.5);
  };
  return [mix(0), mix(1), mix(2)];
}

/** Which of `bands` equal bands t lies in: 0..bands-1. */
export function bandOf(t: number, bands: number): number {
  return Math.min(Math.floor(unit(t) * bands), Math.max(bands - 1, 0));
}

/** The effect's colour at t in 0..1 of the range: bands and inversion applied. Outer bands take the map's ends. */
export function paletteColour(t: number, effect: ColourEffect): Rgb {
  let place = t;
  if (effect.bands === 1) place = 0.5;
  else if (effect.bands > 1) place = bandOf(t, effect.bands) / (effect.bands - 1);
  return mapColour(effect.map, effect.invert ? 1 - place : place);
}

export function colourOf(value: number, range: ValueRange, effect: ColourEffect): Rgb {
  const place = normalise(value, range);
  if (place.missing) return effect.missing;
  if (place.below) return effect.below;
  return place.above ? effect.above : paletteColour(place.position, effect);
}
