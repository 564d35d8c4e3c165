// SPDX-License-Identifier: Apache-2.0
// A word on what a colour map costs: bands that look alike to some people.
import { type ColourEffect, leastDifference, paletteColour, type Vision } from "../present";

/** Nearer than this (CIEDE2000) two bands are easily taken for each other. */
const ALIKE = 5;
/** A smooth map is judged by so many of its colours. */
const SMOOTH_AS = 9;

const TO: Record<Vision, string> = {
  normal: "",
  protan: " without red cones in the eye",
  deutan: " without green cones in the eye",
  tritan: " without blue cones in the eye",
};

const known = new Map<string, string | null>();

/** Null: every band differs for everybody. */
export function mapNote(effect: ColourEffect): string | null {
  const count = effect.bands > 0 ? effect.bands : SMOOTH_AS;
  const key = `${effect.map} ${count}`;
  let note = known.get(key);
  if (note === undefined) {
    const bands = { ...effect, bands: count, invert: false };
    const colours = Array.from({ length: count }, (_, i) => paletteColour((i + 0.5) / count, bands));
    const { apart, vision } = leastDifference(colours);
    note = apart < ALIKE ? `some of ${count} colours of this map look alike${TO[vision]}` : null;
    known.set(key, note);
  }
  return note;
}
