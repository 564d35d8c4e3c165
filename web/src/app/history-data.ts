// SPDX-License-Identifier: Apache-2.0
// All steps of a node: read one step after the other from the scene's own arrays, nothing in between. No DOM.
import { MISSING, type SceneData, type SceneResult } from "../scene";

export interface HistoryPoint {
  readonly step: number;
  /** The scene's value at the node; null where there is none. */
  readonly value: number | null;
}

export interface HistoryQuery {
  readonly result: SceneResult;
  readonly component: number;
  /** Position in the list of parts. */
  readonly part: number;
  readonly vertex: number;
}

/** `more` gets what is known so far, after each step; false ends the reading. */
export async function readHistory(
  scene: SceneData,
  query: HistoryQuery,
  more: (points: readonly HistoryPoint[]) => boolean,
): Promise<void> {
  const points: HistoryPoint[] = [];
  for (const { step } of query.result.values) {
    let value: number | null = null;
    try {
      const field = (await scene.loadField(query.result, step))[query.part];
      if (field && field.state[query.vertex] !== MISSING)
        value = field.values[query.vertex * field.components + query.component] ?? null;
    } catch {
      // A side file that is lost is a gap in the line; the page says so when the step is shown.
    }
    points.push({ step, value: value === null || Number.isNaN(value) ? null : value });
    if (!more([...points])) return;
  }
}

/** Where a step stands on the line: its time or frequency, when all have one and it grows; else its number. */
export function stepPositions(steps: readonly { id: number; value?: number | null }[]): Map<number, number> {
  const values = steps.map((s) => s.value);
  const grows = values.every(
    (v, i) =>
      typeof v === "number" && (i === 0 || v > ((values[i - 1] as number) ?? Number.POSITIVE_INFINITY)),
  );
  return new Map(steps.map((s, i) => [s.id, grows ? (s.value as number) : i + 1]));
}
