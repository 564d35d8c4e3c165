// SPDX-License-Identifier: Apache-2.0
// What the inside is asked for: the result that is seen, at the step and of the shape that are shown.
import type { SceneResult, SectionData } from "../scene";
import type { App } from "./app";
import type { AskedField, AskedShape } from "./inside-client";
import type { Shown } from "./model-view";

export interface InsideSubject {
  readonly shown: Shown;
  readonly field: AskedField;
  readonly shape: AskedShape | null;
  readonly step: number;
}

export function fieldOf(result: SceneResult, shown: Shown): AskedField {
  return { result: result.id, component: shown.componentIndex };
}

/** The shape that is drawn; null: the model as it is. */
export function shapeOf({ view }: App): AskedShape | null {
  const factor = view.swing.re;
  const result = view.shapeResult;
  return factor !== 0 && result ? { result: result.id, factor } : null;
}

/** What is seen, if the server can know it; else why not. `what`: "Section". */
export function subjectOf(app: App, what: string): InsideSubject | { readonly reason: string } {
  const { view, store } = app;
  if (!view.ready) return { reason: `${what} not yet computed: results are being read.` };
  const shown = view.shownAs("colour");
  if (!shown?.result) return { reason: `${what} computed once a result is seen as colour.` };
  if (shown.result.minus)
    return { reason: `No ${what.toLowerCase()} of a difference: it is known on the skin only.` };
  if (store.state.playing) return { reason: `${what} not yet computed: it waits until nothing moves.` };
  if (view.swing.im !== 0)
    return { reason: `${what} is computed of a shape at rest, not in the middle of a turn.` };
  return { shown, field: fieldOf(shown.result, shown), shape: shapeOf(app), step: store.state.step };
}

/** All results of the table that have values at this step, by key. */
export function askedFields({ view, store }: App): Map<string, AskedField> {
  return new Map(
    view.shown.flatMap((shown): [string, AskedField][] =>
      shown.result && !shown.result.minus && shown.result.values.some((v) => v.step === store.state.step)
        ? [[shown.key, fieldOf(shown.result, shown)]]
        : [],
    ),
  );
}

/** The scene's part of each triangle. */
export function partOfTriangle(app: App, data: SectionData): (triangle: number) => number {
  const byModel = new Map<number, number>();
  for (const [i, { info }] of app.view.scene.parts.entries())
    if (info.kind === "solid") byModel.set(info.modelPart ?? info.id, i);
  return (triangle) => byModel.get(data.parts[triangle] ?? -1) ?? 0;
}

/** The scene's part of each vertex: none is shared by two elements. */
export function ownersOf(app: App, data: SectionData): Uint16Array<ArrayBuffer> {
  const part = partOfTriangle(app, data);
  const owners = new Uint16Array(data.values.length);
  for (let i = 0; i < data.indices.length; ++i) owners[data.indices[i] ?? 0] = part(Math.floor(i / 3));
  return owners;
}
