// SPDX-License-Identifier: Apache-2.0
// What a level of detail promises of the picture that is drawn: bounds of the result that is seen and of the shape, each at
// the step that is drawn. Without a bound for all of them the level must not be drawn.
import { boundOf, type FeelemExtras, type SceneLevel, type SceneResult } from "../scene";
import { boundText } from "../ui";

/** A result at a step, part of what is drawn. */
export interface Drawn {
  readonly result: SceneResult;
  readonly step: number;
}

const keyOf = (result: string, step: number) => `${step} ${result}`;
const bounds = new WeakMap<SceneLevel, ReadonlyMap<string, number>>();

function boundsOf(level: SceneLevel): ReadonlyMap<string, number> {
  let made = bounds.get(level);
  if (!made) {
    const stated = (level.values ?? []).filter(({ bound }) => Number.isFinite(bound) && bound >= 0);
    made = new Map(stated.map(({ result, step, bound }) => [keyOf(result, step), bound]));
    bounds.set(level, made);
  }
  return made;
}

/** A difference is drawn from two steps. */
export function drawnOf(result: SceneResult | null | undefined, step: number): readonly Drawn[] {
  if (!result) return [];
  const { minus } = result;
  return minus
    ? [
        { result: minus.result, step },
        { result: minus.result, step: minus.step },
      ]
    : [{ result, step }];
}

/** What has no values at its step is not drawn, and needs no bound. */
export function covers(level: SceneLevel, drawn: readonly Drawn[]): boolean {
  const stated = boundsOf(level);
  return drawn.every(
    ({ result, step }) =>
      stated.has(keyOf(result.id, step)) || !result.values.some((values) => values.step === step),
  );
}

/** `seen`: the result whose colours are drawn, and its unit. */
export function levelWords(
  level: SceneLevel,
  extras: FeelemExtras,
  seen: { readonly result: SceneResult | null; readonly step: number; readonly unit: string },
): string {
  const stated = boundsOf(level);
  const parts = drawnOf(seen.result, seen.step).map(
    ({ result, step }) => stated.get(keyOf(result.id, step)) ?? Number.NaN,
  );
  // What a compressed scene has rounded comes on top.
  const rounded = seen.result ? boundOf(seen.result) : Number.NaN;
  const bound = parts.reduce((sum, part) => sum + part, rounded);
  const own = Number.isFinite(bound) ? ` (±${boundText(bound)}${seen.unit ? ` ${seen.unit}` : ""})` : "";
  return `values within ±${boundText(100 * (level.bound + (extras.valueBound ?? 0)))} %${own}`;
}
