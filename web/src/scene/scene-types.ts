// SPDX-License-Identifier: Apache-2.0
// extras.feelem of a scene, and a scene as typed arrays.

/** Something in a scene breaks the contract so that it cannot be shown. */
export class SceneError extends Error {
  override readonly name = "SceneError";
}

/** Smallest or largest value of a result over the whole model; `node` or `element` is the solver's id. */
export interface Extreme {
  readonly value: number;
  readonly node?: number;
  readonly element?: number;
}

/** An accessor name a part, null where the part has no such result; tensors name two. */
export type AccessorNames = string | readonly string[] | null;

export interface ResultValues {
  readonly step: number;
  readonly accessors: readonly AccessorNames[];
  readonly valid?: readonly (string | null)[];
  readonly missing?: number;
  readonly min?: Extreme | null;
  readonly max?: Extreme | null;
}

export interface SceneResult {
  readonly id: string;
  readonly attribute: string;
  readonly name: string;
  readonly quantity?: string;
  readonly source?: string;
  readonly components: readonly string[];
  readonly unit?: string | null;
  readonly location: string;
  readonly averaging?: string | null;
  readonly layer?: string | null;
  /** Of the components: "cylindrical:OX,OY,OZ,AX,AY,AZ"; null: the global one. */
  readonly system?: string | null;
  readonly derived?: boolean;
  /** Of a compressed scene: its values differ from the solver's by at most this. Absent: bit for bit. */
  readonly bound?: number;
  /** Of complex results: which part this is. */
  readonly complex?: false | "real" | "imaginary" | "amplitude" | "phase";
  readonly values: readonly ResultValues[];
  /** Made by the page: this result minus itself at a step. */
  readonly minus?: { readonly result: SceneResult; readonly step: number };
}

export interface SceneStep {
  readonly id: number;
  readonly kind: string;
  readonly input?: number;
  readonly number?: readonly number[];
  readonly value?: number | null;
  readonly unit?: string | null;
  readonly name?: string;
}

export interface ScenePartInfo {
  readonly id: number;
  readonly name: string;
  readonly kind: string;
  readonly domain?: string;
  readonly elements?: string | null;
  /** Which part of the model: its solids and its shells are two parts of the scene. */
  readonly modelPart?: number;
}

/** A reduced list of triangles over the same vertices, and what is promised while it is drawn (docs/levels.md). */
export interface SceneLevel {
  readonly triangles: number;
  /** An accessor name a part; null where nothing of the part is left. */
  readonly indices: readonly (string | null)[];
  /** Of each result's range: the largest of the values' bounds. */
  readonly bound: number;
  readonly distance?: { readonly bound: number; readonly max: number };
  /** In the result's unit, of every result at every step. */
  readonly values: readonly { readonly result: string; readonly step: number; readonly bound: number }[];
}

/** Root extras.feelem. Keys this page does not know are kept as they are. */
export interface FeelemExtras {
  readonly version: number;
  readonly title?: string;
  readonly lengthUnit?: { readonly name: string; readonly metres: number } | null;
  readonly origin?: readonly [number, number, number];
  readonly parts: readonly ScenePartInfo[];
  readonly steps: readonly SceneStep[];
  readonly results: readonly SceneResult[];
  /** From fine to coarse, without the full one. */
  readonly levels?: readonly SceneLevel[];
  /** Of a compressed scene: the part of a result's range that its values may be off. */
  readonly valueBound?: number;
  readonly deformation?: { readonly result: string; readonly step?: number; readonly factor: number } | null;
  readonly presentation?: Record<string, unknown>;
  readonly certificate?: Record<string, unknown>;
  readonly [key: string]: unknown;
}

/** Single precision holds ids below 16,777,216 exactly. */
export type NodeIds = Float32Array | Float64Array;

export interface PartEdges {
  readonly positions: Float32Array;
  /** Solver ids; 0 = none. */
  readonly nodeIds: NodeIds;
  readonly indices: Uint32Array;
}

/** One part of the skin, in model units minus the scene's origin. */
export interface ScenePart {
  readonly index: number;
  readonly info: ScenePartInfo;
  readonly positions: Float32Array;
  /** Let go by who draws them. */
  normals: Float32Array | null;
  readonly indices: Uint32Array;
  /** Solver's node id of each vertex; 0 = none (the centre of a cut quad). */
  readonly nodeIds: NodeIds;
  /** Solver's element id of each triangle; null when the scene has lost them. */
  readonly elementIds: Uint32Array | null;
  edges: PartEdges | null;
}

/** Mask values of a vertex. */
export const MISSING = 0;
export const SOLVER = 1;
export const INTERPOLATED = 2;

/** What the values of a result may be off; of a difference, twice that of its result. */
export function boundOf(result: SceneResult): number {
  return result.minus ? 2 * (result.minus.result.bound ?? 0) : (result.bound ?? 0);
}

/** A result on one part at one step: NaN where missing. */
export interface PartField {
  readonly components: number;
  readonly values: Float32Array;
  /** MISSING, SOLVER or INTERPOLATED of each vertex. */
  readonly state: Uint8Array;
}
