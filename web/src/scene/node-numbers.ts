// SPDX-License-Identifier: Apache-2.0
// Vertices of a part by their node: where a skin bends sharply one node has several vertices.
import type { NodeIds, ScenePart } from "./scene-types";

export interface NodeNumbers {
  /** For each vertex a number that all vertices of its node share; 0 for centres of cut quads. */
  readonly numbers: Uint32Array;
  /** One more than the largest number. */
  readonly count: number;
}

/** A number for each of several ids: a plain list where the ids lie close together, as solvers number them. */
class Numbered {
  readonly #list: Int32Array | null;
  readonly #map = new Map<number, number>();

  constructor(ids: NodeIds) {
    let largest = 0;
    for (const id of ids) if (id > largest) largest = id;
    this.#list = largest < 4 * ids.length + 1000 ? new Int32Array(largest + 1).fill(-1) : null;
  }

  /** -1: none yet. */
  get(id: number): number {
    return (this.#list ? this.#list[id] : this.#map.get(id)) ?? -1;
  }

  set(id: number, number: number): void {
    if (this.#list) this.#list[id] = number;
    else this.#map.set(id, number);
  }
}

/** For each id its first vertex among `nodeIds`, or -1. */
export function firstVertices(nodeIds: NodeIds): (id: number) => number {
  const numbered = new Numbered(nodeIds);
  for (let i = 0; i < nodeIds.length; ++i) {
    const id = nodeIds[i] ?? 0;
    if (id !== 0 && numbered.get(id) < 0) numbered.set(id, i);
  }
  return (id) => (id === 0 ? -1 : numbered.get(id));
}

const kept = new WeakMap<ScenePart, NodeNumbers>();

/** Made once a part, when first asked for. */
export function nodeNumbers(part: ScenePart): NodeNumbers {
  let made = kept.get(part);
  if (made) return made;
  const numbers = new Uint32Array(part.nodeIds.length);
  const known = new Numbered(part.nodeIds);
  let count = 1;
  for (let i = 0; i < numbers.length; ++i) {
    const id = part.nodeIds[i] ?? 0;
    if (id === 0) continue;
    let number = known.get(id);
    if (number < 0) {
      number = count;
      count += 1;
      known.set(id, number);
    }
    numbers[i] = number;
  }
  made = { numbers, count };
  kept.set(part, made);
  return made;
}
