// SPDX-License-Identifier: Apache-2.0
// What is at a place: the numbers, and what each sense makes of them. The page API hands this out as it is.
import { colourOf, pulseOf, tickRateOf, toneOf } from "../present";
import { nearestNode, type Place, placePoint, type ValueState, valueAt } from "../probe";
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
}

const hex = (rgb: readonly number[]) => `#${rgb.map((c) => c.toString(16).padStart(2, "0")).join("")}`;

/** Everything at a place of the skin. `vibrates`: whether the pointer has an actuator. */
export function reportAt(
  view: ModelView,
  doc: PresentationDoc,
  person: Person,
  place: Place,
  pointer: { name: string; vibrates: boolean },
): ProbeReport | null {
  const part = view.scene.parts[place.part];
  if (!part) return null;
  const readOf = (shown: Shown) =>
    valueAt(part, place, shown.fields[place.part] ?? null, shown.componentIndex);
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
    point: placePoint(part, place, view.scene.extras.origin ?? [0, 0, 0]),
    elementId: part.elementIds?.[place.triangle] ?? null,
    nodeId: nearestNode(part, place)?.id ?? null,
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
