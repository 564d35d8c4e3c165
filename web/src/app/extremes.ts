// SPDX-License-Identifier: Apache-2.0
// The markers MX and MN of the result that is seen: the solver's extremes, at their nodes on the skin.
import { findElement, findNode, type Place } from "../probe";
import { numberText, unitText } from "../ui";
import type { ModelView, Shown } from "./model-view";
import { statedExtremes } from "./ranges";

export interface ExtremePlace {
  readonly kind: "max" | "min";
  readonly text: string;
  readonly detail: string;
  readonly place: Place;
}

/** Where an extreme stands; null where its node is inside the model. */
export function extremePlaces(view: ModelView, shown: Shown | null, step: number): ExtremePlace[] {
  const stated = shown?.result ? statedExtremes(shown.result, step) : null;
  if (!shown || !stated) return [];
  const ends = [
    { kind: "max", word: "MX", extreme: stated.max },
    { kind: "min", word: "MN", extreme: stated.min },
  ] as const;
  return ends.flatMap(({ kind, word, extreme }) => {
    const { parts } = view.scene;
    const isElement = extreme.element !== undefined;
    const id = extreme.element ?? extreme.node ?? 0;
    const place = isElement ? findElement(parts, id) : findNode(parts, id);
    if (!place) return [];
    const detail = `${isElement ? "element" : "node"} ${id}`;
    return [{ kind, text: `${word} ${numberText(extreme.value)} ${unitText(shown.unit)}`, detail, place }];
  });
}
