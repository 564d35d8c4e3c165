// SPDX-License-Identifier: Apache-2.0
// Vertices of a part by their node: where a skin bends sharply one node has several vertices.
import type { ScenePart } from "./scene-types";

export interface NodeNumbers {
  /** For each vertex a number that all vertices of its node share; 0 for centres of cut quads. */
  readonly numbers: Uint32Array;
  /** One more than the largest number. */
  readonly count: number;
}

const kept = new WeakMap<ScenePart, NodeNumbers>();

/** Made once a part, when first asked for. */
export function nodeNumbers(part: ScenePart): NodeNumbers {
  let made = kept.get(part);
  if (made) return made;
  const numbers = new Uint32Array(part.nodeIds.length);
  const known = new Map<number, number>();
  for (let i = 0; i < numbers.length; ++i) {
    const id = part.nodeIds[i] ?? 0;
    if (id === 0) continue;
    let number = known.get(id);
    if (number === undefined) {
      number = known.size + 1;
      known.set(id, number);
    }
    numbers[i] = number;
  }
  made = { numbers, count: known.size + 1 };
  kept.set(part, made);
  return made;
}
