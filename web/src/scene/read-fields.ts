// SPDX-License-Identifier: Apache-2.0
// Results of a scene: read when asked for, shared where they can be, and kept as long as there is room.
import { asFloats } from "./arrays";
import { differenceField } from "./difference";
import { FieldCache, type FieldList } from "./field-cache";
import type { AccessorReader, Numbers } from "./gltf";
import {
  type AccessorNames,
  type FeelemExtras,
  MISSING,
  type PartField,
  SceneError,
  type ScenePart,
  type SceneResult,
  SOLVER,
} from "./scene-types";

/** Bytes of results that are kept for showing a step again. */
const FIELD_ROOM = 110e6;

/** Accessors of one part side by side; what stands alone is taken as it is. */
function joined(pieces: readonly Numbers[], list: readonly string[], vertices: number): Float32Array {
  const [only] = pieces;
  if (pieces.length === 1 && only) return asFloats(only, list[0] ?? "", vertices, only.components);
  const components = pieces.reduce((sum, piece) => sum + piece.components, 0);
  const values = new Float32Array(vertices * components);
  let first = 0;
  for (const [k, piece] of pieces.entries()) {
    const data = asFloats(piece, list[k] ?? "", vertices, piece.components);
    for (let i = 0; i < vertices; ++i) {
      for (let c = 0; c < piece.components; ++c)
        values[i * components + first + c] = data[i * piece.components + c] ?? Number.NaN;
    }
    first += piece.components;
  }
  return values;
}

/** A part's accessors of a result, with masked values turned back into missing. */
async function readField(
  reader: AccessorReader,
  result: SceneResult,
  names: AccessorNames,
  mask: string | null,
  vertices: number,
  noGaps: Uint8Array,
): Promise<PartField | null> {
  if (!names || (Array.isArray(names) && names.length === 0)) return null;
  const list = typeof names === "string" ? [names] : names;
  // All are asked for at once, so that they share the side file.
  const [valid, ...pieces] = await Promise.all([
    mask === null ? null : reader.readNamed(mask),
    ...list.map((name) => reader.readNamed(name)),
  ]);
  const components = pieces.reduce((sum, piece) => sum + piece.components, 0);
  if (components < result.components.length) {
    throw new SceneError(`${result.id}: ${components} components stored, ${result.components.length} listed`);
  }
  const values = joined(pieces, list, vertices);
  if (!valid || mask === null) return { components, values, state: noGaps };
  const own = pieces.length > 1 ? values : values.slice();
  return { components, ...masked(own, asFloats(valid, mask, vertices, 1), components) };
}

function masked(values: Float32Array, valid: Float32Array, components: number) {
  const state = new Uint8Array(valid.length);
  for (let i = 0; i < state.length; ++i) {
    state[i] = valid[i] ?? MISSING;
    if (state[i] === MISSING) values.fill(Number.NaN, i * components, (i + 1) * components);
  }
  return { values, state };
}

/** Reads a result at a step, one entry a part. */
export type LoadField = (result: SceneResult, step: number) => Promise<FieldList>;

export function fieldLoader(
  parts: readonly ScenePart[],
  extras: FeelemExtras,
  reader: AccessorReader,
): LoadField {
  // Of results without gaps: one array for all of them.
  const noGaps = parts.map((part) => new Uint8Array(part.nodeIds.length).fill(SOLVER));
  const shared = new Set<ArrayBufferLike>(noGaps.map((state) => state.buffer));
  const cache = new FieldCache(FIELD_ROOM, (buffer) => !shared.has(buffer) && !reader.keeps(buffer));
  const slots = parts.map((part) => extras.parts.findIndex((p) => p.id === part.index));
  const loadField = (result: SceneResult, step: number): Promise<FieldList> => {
    const { minus } = result;
    if (minus) {
      return cache.get(`${result.id}\n${step}`, async () => {
        const [one, two] = await Promise.all([
          loadField(minus.result, step),
          loadField(minus.result, minus.step),
        ]);
        return parts.map((_, i) => differenceField(one[i] ?? null, two[i] ?? null));
      });
    }
    const entry = result.values.find((v) => v.step === step);
    if (!entry) return Promise.resolve(parts.map(() => null));
    return cache.get(`${result.id}\n${step}`, () =>
      Promise.all(
        parts.map((part, i) => {
          const slot = slots[i] ?? -1;
          const vertices = part.nodeIds.length;
          const gaps = noGaps[i] ?? new Uint8Array(vertices).fill(SOLVER);
          const mask = entry.valid?.[slot] ?? null;
          return readField(reader, result, entry.accessors[slot] ?? null, mask, vertices, gaps);
        }),
      ),
    );
  };
  return loadField;
}
