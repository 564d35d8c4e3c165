// SPDX-License-Identifier: Apache-2.0
// Scene bytes -> SceneData: typed arrays with solver ids, results on demand. No three.js, no DOM.
import { asFloats } from "./arrays";
import {
  AccessorReader,
  type FetchSide,
  type GltfJson,
  type GltfNode,
  type Numbers,
  parseContainer,
} from "./gltf";
import { type OwnBytes, readComing, WholeBytes } from "./own-bytes";
import { storedOf } from "./packed-view";
import { fieldLoader, type LoadField } from "./read-fields";
import { type FeelemExtras, type NodeIds, type PartEdges, SceneError, type ScenePart } from "./scene-types";
import type { Unpack } from "./unpack-aside";

const ID_HIGH = 16_777_216;
const LINES = 1;

/** An opened scene: its parts are in memory, edges come a little later; results are read when asked for, then kept. */
export interface SceneData {
  readonly extras: FeelemExtras;
  /** Column-major: model units and axes -> metres, +Y up. */
  readonly matrix: readonly number[];
  readonly parts: readonly ScenePart[];
  /** Parts of the contract that this file has lost; the page says so and goes on. */
  readonly gaps: readonly string[];
  /** Settled when the edges of the parts are there too. */
  readonly edgesCame: Promise<void>;
  /** A result at a step, one entry a part; null where the part has no such result. Cached. */
  readonly loadField: LoadField;
  /** Corners of the triangles of a level of `extras.levels`, one list a part; null: nothing of the part is left. */
  readonly loadLevel: (level: number) => Promise<readonly (Uint32Array | null)[]>;
}

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

class Opener {
  readonly gaps: string[] = [];
  readonly #json: GltfJson;
  readonly #reader: AccessorReader;

  constructor(json: GltfJson, reader: AccessorReader) {
    this.#json = json;
    this.#reader = reader;
  }

  #gap(what: string): void {
    if (!this.gaps.includes(what)) this.gaps.push(what);
  }

  #primitive(found: Found) {
    const primitive = this.#json.meshes?.[found.node.mesh ?? -1]?.primitives?.[0];
    if (!primitive) throw new SceneError(`mesh of '${found.node.name ?? "a part"}' has no primitive`);
    return primitive;
  }

  async #nodeIds(attributes: Record<string, number>, count: number, label: string): Promise<NodeIds> {
    if (attributes._NODE_ID === undefined) {
      this.#gap(`node ids of ${label}`);
      return new Float32Array(count);
    }
    const low = asFloats(await this.#reader.read(attributes._NODE_ID), `_NODE_ID of ${label}`, count, 1);
    if (attributes._NODE_ID_HIGH === undefined) return low;
    const numbers = await this.#reader.read(attributes._NODE_ID_HIGH);
    const high = asFloats(numbers, `_NODE_ID_HIGH of ${label}`, count, 1);
    const ids = new Float64Array(count);
    for (let i = 0; i < count; ++i) ids[i] = (low[i] ?? 0) + (high[i] ?? 0) * ID_HIGH;
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
      this.#gap(`element ids of '${label}'`);
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

  async level(index: number, parts: readonly ScenePart[], extras: FeelemExtras) {
    const names = extras.levels?.[index]?.indices ?? [];
    return Promise.all(
      parts.map(async (part) => {
        const name = names[extras.parts.findIndex((p) => p.id === part.index)];
        if (!name) return null;
        const numbers = await this.#reader.readNamed(name);
        if (numbers.count % 3) throw new SceneError(`${name}: a triangle with too few corners`);
        return asIndices(numbers, part.positions.length / 3, name);
      }),
    );
  }

  /** Said before the edges come. */
  checkEdges(found: Found): void {
    if (this.#primitive(found).attributes._NODE_ID === undefined) this.#gap("node ids of edges");
  }

  isLines(found: Found): boolean {
    return this.#primitive(found).mode === LINES;
  }
}

/** The bufferViews of the scene's own buffer that this page reads. */
function wantedViews(json: GltfJson, found: readonly Found[], extras: FeelemExtras) {
  const geometry = new Set<number>();
  const views = new Set<number>();
  const add = (accessor: number | undefined, to: Set<number>) => {
    const view = json.accessors?.[accessor ?? -1]?.bufferView;
    const found = json.bufferViews?.[view ?? -1];
    if (view !== undefined && found && json.buffers?.[storedOf(found).buffer]?.uri === undefined)
      to.add(view);
  };
  const byName = new Map<string, number>();
  for (const [i, { name }] of (json.accessors ?? []).entries())
    if (name && !byName.has(name)) byName.set(name, i);
  for (const { node, role } of found) {
    if (role !== "part" && role !== "section" && role !== "edges") continue;
    const primitive = json.meshes?.[node.mesh ?? -1]?.primitives?.[0];
    for (const name of ["POSITION", "NORMAL", "_NODE_ID", "_NODE_ID_HIGH"])
      add(primitive?.attributes[name], geometry);
    add(primitive?.indices, geometry);
  }
  for (const part of extras.parts) if (part.elements) add(byName.get(part.elements), geometry);
  for (const { indices } of extras.levels ?? [])
    for (const name of indices) if (name) add(byName.get(name), views);
  for (const { values } of extras.results)
    for (const { accessors, valid } of values)
      for (const name of [...accessors.flat(), ...(valid ?? [])]) if (name) add(byName.get(name), views);
  return { geometry, all: new Set([...geometry, ...views]), results: views };
}

interface Begun {
  readonly json: GltfJson;
  readonly start: (wanted: Iterable<number>) => OwnBytes;
}

function begin(bytes: ArrayBuffer): Begun {
  const container = parseContainer(new Uint8Array(bytes));
  return { json: container.json, start: () => new WholeBytes(container) };
}

/** Throws SceneError on anything that is not a scene of ours. A stream is read as far as the page needs it. */
export async function openScene(
  bytes: ArrayBuffer | ReadableStream<Uint8Array>,
  fetchSide: FetchSide,
  unpack?: Unpack,
): Promise<SceneData> {
  const { json, start } = bytes instanceof ArrayBuffer ? begin(bytes) : await readComing(bytes);
  const extras = readExtras(json);
  const { matrix, found } = walk(json);
  const wanted = wantedViews(json, found, extras);
  const own = start(wanted.all);
  const reader = new AccessorReader(json, own, fetchSide, unpack);
  const opener = new Opener(json, reader);
  const parts: ScenePart[] = [];
  for (const item of found) {
    if ((item.role === "part" || item.role === "section") && !opener.isLines(item))
      parts.push(await opener.part(item, extras));
  }
  if (parts.length === 0) throw new SceneError("the scene has no part to draw");
  const edges = found.flatMap((item) => {
    const part = item.role === "edges" && parts.find((p) => p.index === item.part);
    return part ? [{ item, part }] : [];
  });
  for (const { item } of edges) opener.checkEdges(item);
  const readEdges = async () => {
    for (const { item, part } of edges) part.edges = await opener.edges(item);
    // From here on the parts alone hold their arrays.
    own.release([...wanted.geometry].filter((view) => !wanted.results.has(view)));
  };
  const edgesCame = readEdges();
  edgesCame.catch(() => {});
  return {
    extras,
    matrix,
    parts,
    gaps: opener.gaps,
    edgesCame,
    loadField: fieldLoader(parts, extras, reader),
    loadLevel: (level) => opener.level(level, parts, extras),
  };
}
