// SPDX-License-Identifier: Apache-2.0
// Scene bytes -> SceneData: typed arrays with solver ids, results on demand. No three.js, no DOM.
import { differenceField } from "./difference";
import { FieldCache, type FieldList } from "./field-cache";
import {
  AccessorReader,
  type FetchSide,
  type GltfJson,
  type GltfNode,
  type Numbers,
  parseContainer,
} from "./gltf";
import {
  type AccessorNames,
  type FeelemExtras,
  MISSING,
  type PartEdges,
  type PartField,
  SceneError,
  type ScenePart,
  type SceneResult,
  SOLVER,
} from "./scene-types";

const ID_HIGH = 16_777_216;
const LINES = 1;

/** An opened scene. Everything but results is in memory; results are read when asked for, then kept. */
export interface SceneData {
  readonly extras: FeelemExtras;
  /** Column-major: model units and axes -> metres, +Y up. */
  readonly matrix: readonly number[];
  readonly parts: readonly ScenePart[];
  /** Parts of the contract that this file has lost; the page says so and goes on. */
  readonly gaps: readonly string[];
  /** A result at a step, one entry a part; null where the part has no such result. Cached. */
  loadField(result: SceneResult, step: number): Promise<readonly (PartField | null)[]>;
}

/** Bytes of results that are kept for showing a step again. */
const FIELD_ROOM = 160e6;

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] as const;

function readExtras(json: GltfJson): FeelemExtras {
  const extras = json.extras?.feelem as FeelemExtras | undefined;
  if (!extras || typeof extras !== "object") {
    throw new SceneError("this is a glTF file but not a Feelem scene: extras.feelem is missing");
  }
  if (extras.version !== 1) {
    throw new SceneError(`scene version ${String(extras.version)}; this page reads version 1`);
  }
  for (const key of ["parts", "steps", "results"] as const) {
    if (!Array.isArray(extras[key])) throw new SceneError(`extras.feelem.${key} is not a list`);
  }
  return extras;
}

interface Found {
  readonly node: GltfNode;
  readonly role: string;
  readonly part: number;
}

function walk(json: GltfJson): { matrix: readonly number[]; found: Found[] } {
  let matrix: readonly number[] = IDENTITY;
  const found: Found[] = [];
  const seen = new Set<number>();
  const visit = (index: number): void => {
    const node = json.nodes?.[index];
    if (!node || seen.has(index)) return;
    seen.add(index);
    const extras = node.extras?.feelem;
    const role = typeof extras?.role === "string" ? extras.role : "";
    if (role === "model" && node.matrix?.length === 16) matrix = node.matrix;
    if (node.mesh !== undefined) found.push({ node, role, part: Number(extras?.part ?? -1) });
    for (const child of node.children ?? []) visit(child);
  };
  for (const root of json.scenes?.[json.scene ?? 0]?.nodes ?? []) visit(root);
  return { matrix, found };
}

function asIndices(numbers: Numbers, vertices: number, label: string): Uint32Array {
  const indices = numbers.data instanceof Uint32Array ? numbers.data : Uint32Array.from(numbers.data);
  for (const i of indices) {
    if (i >= vertices) throw new SceneError(`${label}: index ${i} but only ${vertices} vertices`);
  }
  return indices;
}

function asFloats(numbers: Numbers, label: string, count: number, components: number): Float32Array {
  if (
    !(numbers.data instanceof Float32Array) ||
    numbers.count !== count ||
    numbers.components !== components
  ) {
    throw new SceneError(
      `${label}: ${numbers.count} x ${numbers.components} values, expected ${count} x ${components}`,
    );
  }
  return numbers.data;
}

class Opener {
  readonly gaps: string[] = [];
  readonly #json: GltfJson;
  readonly #reader: AccessorReader;

  constructor(json: GltfJson, reader: AccessorReader) {
    this.#json = json;
    this.#reader = reader;
  }

  #primitive(found: Found) {
    const primitive = this.#json.meshes?.[found.node.mesh ?? -1]?.primitives?.[0];
    if (!primitive) throw new SceneError(`mesh of '${found.node.name ?? "a part"}' has no primitive`);
    return primitive;
  }

  async #nodeIds(attributes: Record<string, number>, count: number, label: string): Promise<Float64Array> {
    const ids = new Float64Array(count);
    if (attributes._NODE_ID === undefined) {
      this.gaps.push(`node ids of ${label}`);
      return ids;
    }
    ids.set(asFloats(await this.#reader.read(attributes._NODE_ID), `_NODE_ID of ${label}`, count, 1));
    if (attributes._NODE_ID_HIGH !== undefined) {
      const high = asFloats(
        await this.#reader.read(attributes._NODE_ID_HIGH),
        `_NODE_ID_HIGH of ${label}`,
        count,
        1,
      );
      for (let i = 0; i < count; ++i) ids[i] = (ids[i] ?? 0) + (high[i] ?? 0) * ID_HIGH;
    }
    return ids;
  }

  async part(found: Found, extras: FeelemExtras): Promise<ScenePart> {
    const info = extras.parts.find((p) => p.id === found.part);
    if (!info) throw new SceneError(`part ${found.part} is drawn but not listed`);
    const { attributes, indices } = this.#primitive(found);
    if (attributes.POSITION === undefined) throw new SceneError(`part '${info.name}' has no positions`);
    const position = await this.#reader.read(attributes.POSITION);
    const count = position.count;
    const triangles =
      indices === undefined
        ? Uint32Array.from({ length: count }, (_, i) => i)
        : asIndices(await this.#reader.read(indices), count, `part '${info.name}'`);
    if (triangles.length % 3) throw new SceneError(`part '${info.name}' has a triangle with too few corners`);
    const normal = attributes.NORMAL === undefined ? null : await this.#reader.read(attributes.NORMAL);
    return {
      index: found.part,
      info,
      positions: asFloats(position, `POSITION of '${info.name}'`, count, 3),
      normals: normal && asFloats(normal, `NORMAL of '${info.name}'`, count, 3),
      indices: triangles,
      nodeIds: await this.#nodeIds(attributes, count, `'${info.name}'`),
      elementIds: await this.#elementIds(info.name, info.elements, triangles.length / 3),
      edges: null,
    };
  }

  async #elementIds(
    label: string,
    name: string | null | undefined,
    triangles: number,
  ): Promise<Uint32Array | null> {
    if (!name || !this.#reader.has(name)) {
      this.gaps.push(`element ids of '${label}'`);
      return null;
    }
    const ids = await this.#reader.readNamed(name);
    if (!(ids.data instanceof Uint32Array) || ids.count !== triangles) {
      throw new SceneError(`${name}: ${ids.count} element ids for ${triangles} triangles`);
    }
    return ids.data;
  }

  async edges(found: Found): Promise<PartEdges> {
    const { attributes, indices } = this.#primitive(found);
    if (attributes.POSITION === undefined) throw new SceneError("an edge mesh has no positions");
    const position = await this.#reader.read(attributes.POSITION);
    const list =
      indices === undefined
        ? Uint32Array.from({ length: position.count }, (_, i) => i)
        : asIndices(await this.#reader.read(indices), position.count, "edges");
    return {
      positions: asFloats(position, "POSITION of edges", position.count, 3),
      nodeIds: await this.#nodeIds(attributes, position.count, "edges"),
      indices: list,
    };
  }

  isLines(found: Found): boolean {
    return this.#primitive(found).mode === LINES;
  }
}

/** Puts one part's accessors of a result side by side and turns masked values back into missing. */
async function readField(
  reader: AccessorReader,
  result: SceneResult,
  names: AccessorNames,
  mask: string | null,
  vertices: number,
): Promise<PartField | null> {
  if (!names || (Array.isArray(names) && names.length === 0)) return null;
  const list = typeof names === "string" ? [names] : names;
  const pieces = await Promise.all(list.map((name) => reader.readNamed(name)));
  const components = pieces.reduce((sum, piece) => sum + piece.components, 0);
  if (components < result.components.length) {
    throw new SceneError(`${result.id}: ${components} components stored, ${result.components.length} listed`);
  }
  const values = new Float32Array(vertices * components);
  let first = 0;
  for (const [k, piece] of pieces.entries()) {
    const data = asFloats(piece, list[k] ?? result.id, vertices, piece.components);
    for (let i = 0; i < vertices; ++i) {
      for (let c = 0; c < piece.components; ++c) {
        values[i * components + first + c] = data[i * piece.components + c] ?? Number.NaN;
      }
    }
    first += piece.components;
  }
  const state = new Uint8Array(vertices).fill(SOLVER);
  if (mask) {
    const valid = asFloats(await reader.readNamed(mask), mask, vertices, 1);
    for (let i = 0; i < vertices; ++i) {
      state[i] = valid[i] ?? MISSING;
      if (state[i] === MISSING) values.fill(Number.NaN, i * components, (i + 1) * components);
    }
  }
  return { components, values, state };
}

/** Throws SceneError on anything that is not a scene of ours. */
export async function openScene(bytes: ArrayBuffer, fetchSide: FetchSide): Promise<SceneData> {
  const container = parseContainer(new Uint8Array(bytes));
  const required = container.json.extensionsRequired ?? [];
  if (required.includes("EXT_meshopt_compression")) {
    throw new SceneError("this scene is compressed; convert it again without --compress to open it here");
  }
  const extras = readExtras(container.json);
  const reader = new AccessorReader(container, fetchSide);
  const opener = new Opener(container.json, reader);
  const { matrix, found } = walk(container.json);
  const parts: ScenePart[] = [];
  for (const item of found) {
    if ((item.role === "part" || item.role === "section") && !opener.isLines(item)) {
      parts.push(await opener.part(item, extras));
    }
  }
  if (parts.length === 0) throw new SceneError("the scene has no part to draw");
  for (const item of found) {
    const part = item.role === "edges" ? parts.find((p) => p.index === item.part) : undefined;
    if (part) part.edges = await opener.edges(item);
  }
  const cache = new FieldCache(FIELD_ROOM);
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
        parts.map((part) => {
          const slot = extras.parts.findIndex((p) => p.id === part.index);
          const mask = entry.valid?.[slot] ?? null;
          return readField(reader, result, entry.accessors[slot] ?? null, mask, part.nodeIds.length);
        }),
      ),
    );
  };
  return { extras, matrix, parts, gaps: opener.gaps, loadField };
}
