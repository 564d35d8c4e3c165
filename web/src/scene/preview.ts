// SPDX-License-Identifier: Apache-2.0
// A scene of the shape alone, made while results are being read, and the finished one that takes its place.
import type { FeelemExtras, SceneData } from "./index";

type Numbers = ArrayLike<number> | null;

/** Its certificate says so: whatever shows it must say that results are missing. */
export function isPreview(extras: FeelemExtras): boolean {
  const notes = extras.certificate?.notes as Record<string, unknown> | undefined;
  return typeof notes?.preview === "string";
}

function same(a: Numbers, b: Numbers): boolean {
  if (a === null || b === null) return a === b;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}

/**
 * The finished scene with the parts that are drawn already, when they are the same number by number; else null. The
 * arrays that it came with are let go.
 */
export function onShape(drawn: SceneData, finished: SceneData): SceneData | null {
  const fits = (i: number) => {
    const [a, b] = [drawn.parts[i], finished.parts[i]];
    if (!a || !b) return false;
    const arrays = ["positions", "indices", "nodeIds", "elementIds"] as const;
    return a.index === b.index && arrays.every((name) => same(a[name], b[name]));
  };
  if (!same(drawn.matrix, finished.matrix) || !same(drawn.extras.origin ?? [], finished.extras.origin ?? []))
    return null;
  if (drawn.parts.length !== finished.parts.length || !drawn.parts.every((_, i) => fits(i))) return null;
  for (const [i, part] of finished.parts.entries()) {
    const { positions, indices, nodeIds, elementIds, normals } = drawn.parts[i] as typeof part;
    Object.assign(part, { positions, indices, nodeIds, elementIds, normals });
  }
  const letGo = () => {
    for (const part of finished.parts) part.edges = null;
  };
  finished.edgesCame.then(letGo, () => {});
  return { ...finished, parts: drawn.parts, edgesCame: drawn.edgesCame };
}
