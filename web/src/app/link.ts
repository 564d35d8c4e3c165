// SPDX-License-Identifier: Apache-2.0
// The whole view as a piece of text that fits into an address, and back. What comes back is judged, not trusted. No DOM.
import { parsePresentation } from "../present";
import type { PresentationDoc } from "./presentation-doc";
import type { CutState, HotOptions, PinState, ViewState } from "./store";

/** Target, yaw, pitch, distance: as the turntable camera has them, world metres and radians. */
export type CameraNumbers = readonly [number, number, number, number, number, number];

/** What a link or a presentation file says of a view. */
export interface Snapshot {
  readonly state: Partial<ViewState>;
  readonly camera: CameraNumbers | null;
  /** Solver's id of the marked node. */
  readonly node: number | null;
}

/** What of the state belongs to a view; the rest is the person's, or of the moment. */
export const LINKED = [
  "step",
  "deformMode",
  "typedFactor",
  "edges",
  "shading",
  "extremes",
  "hidden",
  "clear",
  "open",
  "hot",
  "cuts",
  "pins",
  "ruler",
  "ghost",
] as const satisfies readonly (keyof ViewState)[];

/** Longer texts than this are no view of ours. */
const LONGEST = 1_000_000;
const MOST = 10_000;

type Json = Record<string, unknown>;
const isObject = (v: unknown): v is Json => typeof v === "object" && v !== null && !Array.isArray(v);
const isNumber = (v: unknown): v is number => typeof v === "number" && Number.isFinite(v);
const isId = (v: unknown): v is number => Number.isSafeInteger(v) && (v as number) >= 0;
const isText = (v: unknown): v is string => typeof v === "string";

function listOf<T>(value: unknown, item: (v: unknown) => T | null): readonly T[] | undefined {
  if (!Array.isArray(value) || value.length > MOST) return undefined;
  return value.flatMap((v) => item(v) ?? []);
}

function cutOf(value: unknown): CutState | null {
  if (!isObject(value) || !Array.isArray(value.normal) || !isNumber(value.offset)) return null;
  const [x, y, z] = value.normal;
  if (!isNumber(x) || !isNumber(y) || !isNumber(z) || Math.abs(Math.hypot(x, y, z) - 1) > 1e-3) return null;
  return { normal: [x, y, z], offset: value.offset, on: value.on !== false };
}

function pinOf(value: unknown): PinState | null {
  if (!isObject(value) || !isId(value.id) || !isId(value.node)) return null;
  return { id: value.id, node: value.node, note: isText(value.note) ? value.note.slice(0, 500) : "" };
}

function hotOf(value: unknown): HotOptions | undefined {
  if (!isObject(value) || !isNumber(value.count) || !isNumber(value.share)) return undefined;
  return {
    count: Math.min(Math.max(Math.round(value.count), 1), 50),
    share: Math.min(Math.max(value.share, 0), 1),
    by: value.by === "utilisation" ? "utilisation" : "value",
    end: value.end === "smallest" ? "smallest" : "largest",
    marks: value.marks !== false,
  };
}

/** Keys that are wrong are left out; a wrong presentation throws, because half of one would mislead. */
export function snapshotOf(value: unknown): Snapshot {
  const given = isObject(value) ? value : {};
  const ids = (v: unknown) => listOf(v, (id) => (isId(id) ? id : null));
  const flag = (v: unknown) => (typeof v === "boolean" ? v : undefined);
  const doc = given.doc === undefined ? undefined : (given.doc as PresentationDoc);
  if (doc !== undefined) parsePresentation(doc);
  const modes = ["off", "true", "auto", "factor"] as const;
  const all = {
    doc,
    step: isId(given.step) ? given.step : undefined,
    deformMode: modes.find((m) => m === given.deformMode),
    typedFactor: isNumber(given.typedFactor) ? given.typedFactor : undefined,
    edges: flag(given.edges),
    shading: flag(given.shading),
    extremes: flag(given.extremes),
    ghost: flag(given.ghost),
    hidden: ids(given.hidden),
    clear: ids(given.clear),
    open: listOf(given.open, (v) => (isText(v) ? v.slice(0, 40) : null)),
    hot: hotOf(given.hot),
    cuts: listOf(given.cuts, cutOf)?.slice(0, 3),
    pins: listOf(given.pins, pinOf)?.slice(0, 50),
    ruler: ids(given.ruler)?.slice(0, 2),
  };
  const state = Object.fromEntries(Object.entries(all).filter(([, v]) => v !== undefined));
  const camera = Array.isArray(given.camera) && given.camera.length === 6 ? given.camera : null;
  const usable = camera?.every(isNumber) && (camera[5] as number) > 0;
  return {
    state,
    camera: usable ? (camera as unknown as CameraNumbers) : null,
    node: isId(given.node) ? given.node : null,
  };
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: TransformStream,
  limit: number,
): Promise<Uint8Array> {
  const reader = new Blob([bytes])
    .stream()
    .pipeThrough(stream)
    .getReader() as ReadableStreamDefaultReader<Uint8Array>;
  const pieces: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > limit) throw new Error("this link holds more than a view");
    pieces.push(value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

/** JSON, deflated, in the letters that an address may have. */
export async function encodeView(view: object): Promise<string> {
  const text = new TextEncoder().encode(JSON.stringify(view));
  const packed = await through(text, new CompressionStream("deflate-raw"), LONGEST);
  let binary = "";
  for (const byte of packed) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

export async function decodeView(text: string): Promise<unknown> {
  if (text.length > LONGEST) throw new Error("this link holds more than a view");
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const packed = Uint8Array.from(binary, (c) => c.charCodeAt(0));
  const bytes = await through(packed, new DecompressionStream("deflate-raw"), LONGEST);
  return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
}
