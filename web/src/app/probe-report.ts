// SPDX-License-Identifier: Apache-2.0
// What is at a place: the numbers, and what each sense makes of them. The page API hands this out as it is.
import { colourOf, pulseOf, tickRateOf, toneOf } from "../present";
import {
  nearestNode,
  type Place,
  type PlaceValue,
  placePoint,
  type SectionPlace,
  sectionValue,
  type ValueState,
  valueAt,
} from "../probe";
import { boundOf } from "../scene";
import { utilisation } from "./limits";
import type { ModelView, Shown } from "./model-view";
import type { Person } from "./person";
import { personalPitch, personalPulse } from "./personal";
import {
  colourEffect,
  type PresentationDoc,
  pitchEffect,
  pulseEffect,
  pulseFallback,
  tickEffect,
} from "./presentation-doc";

export interface ProbeResult {
  readonly key: string;
  readonly name: string;
  readonly component: string;
  readonly unit: string | null;
  /** Barycentric mean of the triangle's corners; null = missing. */
  readonly value: number | null;
  /** The file's value at nodeId. */
  readonly nodeValue: number | null;
  readonly state: ValueState;
  /** The values differ from the solver's by at most this: a compressed scene says so. 0: not at all. */
  readonly bound: number;
  /** Part of the limit that the value uses, 1 at the limit; null without one. */
  readonly utilisation: number | null;
}

export interface ProbeReport {
  /** Undeformed, model units. */
  readonly point: readonly [number, number, number];
  readonly elementId: number | null;
  readonly nodeId: number | null;
  readonly results: readonly ProbeResult[];
  /** '#rrggbb' of the result that is seen; null when none is. */
  readonly colour: string | null;
  readonly hz: number;
  readonly gain: number;
  /** The hollow tone of negative values. */
  readonly negative: boolean;
  /** Ticks a second, also those that stand in for pulses where nothing vibrates. */
  readonly tickRate: number;
  readonly pulse: { readonly rate: number; readonly amplitude: number };
  readonly pointer: string;
  /** Of a place inside, on the section of a plane; null on the skin. */
  readonly interior: InteriorReport | null;
}

export interface InteriorReport {
  /** Values are those of the element's shape functions at this place; else, for a moment, those of the drawing. */
  readonly exact: boolean;
  readonly elementType: string | null;
}

/** Where a place is and how its values are read. */
interface Reading {
  readonly point: readonly [number, number, number];
  readonly elementId: number | null;
  readonly nodeId: number | null;
  readonly interior: InteriorReport | null;
  readonly read: (shown: Shown) => PlaceValue;
}

function onSkin(view: ModelView, place: Place): Reading | null {
  const part = view.scene.parts[place.part];
  if (!part) return null;
  return {
    point: placePoint(part, place, view.scene.extras.origin ?? [0, 0, 0]),
    elementId: part.elementIds?.[place.triangle] ?? null,
    nodeId: nearestNode(part, place)?.id ?? null,
    interior: null,
    read: (shown) => valueAt(part, place, shown.fields[place.part] ?? null, shown.componentIndex),
  };
}

function onSection(view: ModelView, place: SectionPlace): Reading {
  const origin = view.scene.extras.origin ?? [0, 0, 0];
  const [x, y, z] = place.point;
  // A chord of a curved wall is drawn a little outside of the elements: there the drawing is all there is.
  const exact = place.exact?.elementId == null ? null : place.exact;
  return {
    point: [x + origin[0], y + origin[1], z + origin[2]],
    elementId: exact?.elementId ?? place.section.data.elementIds[place.triangle] ?? null,
    nodeId: exact?.nodeId ?? null,
    interior: { exact: exact !== null, elementType: exact?.elementType ?? null },
    read: (shown) => {
      const known = exact?.values.get(shown.key);
      const value = known ? known.value : sectionValue(place, shown.key);
      const state = value === null ? "missing" : known ? "solver" : "interpolated";
      return { value, nodeValue: known?.nodeValue ?? null, state };
    },
  };
}

const hex = (rgb: readonly number[]) => `#${rgb.map((c) => c.toString(16).padStart(2, "0")).join("")}`;

/** Everything at a place of the skin or of a section. `vibrates`: whether the pointer has an actuator. */
export function reportAt(
  view: ModelView,
  doc: PresentationDoc,
  person: Person,
  place: Place,
  pointer: { name: string; vibrates: boolean },
): ProbeReport | null {
  const reading = place.section ? onSection(view, place.section) : onSkin(view, place);
  if (!reading) return null;
  const { read: readOf, ...where } = reading;
  const numberOf = (shown: Shown | null) => (shown && readOf(shown).value) ?? Number.NaN;
  const colour = view.shownAs("colour");
  const pitch = view.shownAs("pitch");
  const ticks = view.shownAs("ticks");
  const pulses = view.shownAs("pulses");
  const looks = colourEffect(doc);
  const sounds = personalPitch(pitchEffect(doc), person);
  const beats = personalPulse(pulseEffect(doc), person);
  const tone = pitch && sounds ? toneOf(numberOf(pitch), pitch.range, sounds) : null;
  const pulse = pulses && beats ? pulseOf(numberOf(pulses), pulses.range, beats) : { rate: 0, amplitude: 0 };
  const ownTicks = tickEffect(doc);
  const standIn = pulseFallback(doc);
  let tickRate = 0;
  if (ticks && ownTicks) tickRate = tickRateOf(numberOf(ticks), ticks.range, ownTicks);
  else if (pulses && standIn && !pointer.vibrates)
    tickRate = tickRateOf(numberOf(pulses), pulses.range, standIn);
  return {
    ...where,
    results: view.shown
      .filter((shown) => shown.result)
      .map((shown) => {
        const read = readOf(shown);
        return {
          key: shown.key,
          name: shown.name,
          component: shown.component,
          unit: shown.unit,
          ...read,
          bound: shown.result ? boundOf(shown.result) : 0,
          utilisation: utilisation(read.value, shown),
        };
      }),
    colour: colour && looks ? hex(colourOf(numberOf(colour), colour.range, looks)) : null,
    hz: tone?.hz ?? 0,
    gain: tone?.gain ?? 0,
    negative: tone?.negative ?? false,
    tickRate,
    pulse: { rate: pulse.rate, amplitude: pulse.amplitude },
    pointer: pointer.name,
  };
}
