// SPDX-License-Identifier: Apache-2.0
// Rays against a part as it is drawn now: positions + factor x displacement. Nothing is rebuilt when the factor changes:
// a box of places and a box of displacements together bound where a node's triangles can be. No three.js.
import type { ScenePart } from "../scene";
import type { TreeData } from "./grow-tree";

/** Displacements of a part and how much of each is drawn; null: none. */
export interface Shape {
  readonly re: Float32Array | null;
  readonly im: Float32Array | null;
  readonly factorRe: number;
  readonly factorIm: number;
}

export interface TreeHit {
  readonly triangle: number;
  /** In units of the direction's length. */
  readonly distance: number;
}

type Triple = readonly [number, number, number];

const FAR = Number.POSITIVE_INFINITY;
const LEAF = 0xffff;
const NODE = 8;
/** Of a box's largest coordinate: what float32 may have rounded away. */
const SLACK = 1e-6;
const stack = new Int32Array(128);
const stackNear = new Float64Array(128);
const bounds = new Float64Array(2);
const corner = [new Float64Array(3), new Float64Array(3), new Float64Array(3)] as const;

/** A missing displacement moves nothing. */
const moved = (vectors: Float32Array | null, at: number) => {
  const by = vectors?.[at] ?? 0;
  return Number.isNaN(by) ? 0 : by;
};

/** Where a vertex is drawn, into `out`. */
export function drawnAt(part: ScenePart, shape: Shape, vertex: number, out: Float64Array): void {
  const { re, im, factorRe, factorIm } = shape;
  for (let c = 0; c < 3; ++c) {
    const at = 3 * vertex + c;
    out[c] = (part.positions[at] ?? 0) + factorRe * moved(re, at) + factorIm * moved(im, at);
  }
}

export class MovingTree {
  readonly #part: ScenePart;
  readonly #boxes: Float32Array;
  readonly #words: Uint32Array;
  readonly #halves: Uint16Array;
  readonly #order: TreeData["order"];
  #shape: Shape = { re: null, im: null, factorRe: 0, factorIm: 0 };
  /** Boxes of the displacements, 6 a node, made when first asked for. */
  #boxesRe: Float32Array | null = null;
  #boxesIm: Float32Array | null = null;

  constructor(part: ScenePart, data: TreeData) {
    this.#part = part;
    this.#boxes = new Float32Array(data.nodes);
    this.#words = new Uint32Array(data.nodes);
    this.#halves = new Uint16Array(data.nodes);
    this.#order = data.order;
  }

  setShape(shape: Shape): void {
    if (shape.re !== this.#shape.re) this.#boxesRe = null;
    if (shape.im !== this.#shape.im) this.#boxesIm = null;
    this.#shape = shape;
  }

  #isLeaf(node: number): boolean {
    return this.#halves[2 * NODE * node + 15] === LEAF;
  }

  #second(node: number): number {
    return node + (this.#words[NODE * node + 6] ?? 0);
  }

  /** Children stand behind their parents: from the last node to the first each is met after its children. */
  #boxesOf(vectors: Float32Array): Float32Array {
    const count = this.#words.length / NODE;
    const boxes = new Float32Array(6 * count);
    const { indices } = this.#part;
    for (let node = count - 1; node >= 0; --node) {
      const at = 6 * node;
      if (!this.#isLeaf(node)) {
        const [a, b] = [6 * (node + 1), 6 * this.#second(node)];
        for (let c = 0; c < 3; ++c) {
          boxes[at + c] = Math.min(boxes[a + c] ?? 0, boxes[b + c] ?? 0);
          boxes[at + 3 + c] = Math.max(boxes[a + 3 + c] ?? 0, boxes[b + 3 + c] ?? 0);
        }
        continue;
      }
      const first = this.#words[NODE * node + 6] ?? 0;
      const last = first + (this.#halves[2 * NODE * node + 14] ?? 0);
      let [x0, y0, z0] = [FAR, FAR, FAR];
      let [x1, y1, z1] = [-FAR, -FAR, -FAR];
      for (let i = first; i < last; ++i) {
        const triangle = 3 * (this.#order[i] ?? 0);
        for (let k = 0; k < 3; ++k) {
          const v = 3 * (indices[triangle + k] ?? 0);
          const x = moved(vectors, v);
          const y = moved(vectors, v + 1);
          const z = moved(vectors, v + 2);
          if (x < x0) x0 = x;
          if (x > x1) x1 = x;
          if (y < y0) y0 = y;
          if (y > y1) y1 = y;
          if (z < z0) z0 = z;
          if (z > z1) z1 = z;
        }
      }
      boxes[at] = x0;
      boxes[at + 1] = y0;
      boxes[at + 2] = z0;
      boxes[at + 3] = x1;
      boxes[at + 4] = y1;
      boxes[at + 5] = z1;
    }
    return boxes;
  }

  #readyBoxes(): void {
    const { re, im, factorRe, factorIm } = this.#shape;
    if (re && factorRe !== 0) this.#boxesRe ??= this.#boxesOf(re);
    if (im && factorIm !== 0) this.#boxesIm ??= this.#boxesOf(im);
  }

  /** Where a node's triangles can be along axis `c`, into `bounds`. */
  #boundsAlong(node: number, c: number): void {
    const { factorRe, factorIm } = this.#shape;
    const at = NODE * node;
    let lo = this.#boxes[at + c] ?? 0;
    let hi = this.#boxes[at + 3 + c] ?? 0;
    if (this.#boxesRe && factorRe !== 0) {
      const a = factorRe * (this.#boxesRe[6 * node + c] ?? 0);
      const b = factorRe * (this.#boxesRe[6 * node + 3 + c] ?? 0);
      lo += a < b ? a : b;
      hi += a < b ? b : a;
    }
    if (this.#boxesIm && factorIm !== 0) {
      const a = factorIm * (this.#boxesIm[6 * node + c] ?? 0);
      const b = factorIm * (this.#boxesIm[6 * node + 3 + c] ?? 0);
      lo += a < b ? a : b;
      hi += a < b ? b : a;
    }
    const slack = SLACK * Math.max(Math.abs(lo), Math.abs(hi));
    bounds[0] = lo - slack;
    bounds[1] = hi + slack;
  }

  /** Where the ray comes into a node's box, not before 0; infinite when it does not. */
  #enters(node: number, origin: Triple, inverse: Triple): number {
    let near = 0;
    let far: number = FAR;
    for (let c = 0; c < 3; ++c) {
      this.#boundsAlong(node, c);
      const one = ((bounds[0] ?? 0) - (origin[c] ?? 0)) * (inverse[c] ?? 0);
      const two = ((bounds[1] ?? 0) - (origin[c] ?? 0)) * (inverse[c] ?? 0);
      // A ray within the plane of a side gives NaN, which leaves the bounds as they are.
      const enters = one < two ? one : two;
      const leaves = one < two ? two : one;
      if (enters > near) near = enters;
      if (leaves < far) far = leaves;
    }
    return near <= far ? near : FAR;
  }

  /** How far a node's box is from a point; 0 within. */
  #awayFrom(node: number, from: Triple): number {
    let squares = 0;
    for (let c = 0; c < 3; ++c) {
      this.#boundsAlong(node, c);
      const at = from[c] ?? 0;
      const away = Math.max((bounds[0] ?? 0) - at, at - (bounds[1] ?? 0), 0);
      squares += away * away;
    }
    return Math.sqrt(squares);
  }

  /** The triangle with the least distance, no further than `reach`; `distanceTo` may say infinite for one that is not there. */
  closest(from: Triple, reach: number, distanceTo: (triangle: number) => number): TreeHit | null {
    this.#readyBoxes();
    let nearest = reach;
    let triangle = -1;
    stack[0] = 0;
    stackNear[0] = this.#awayFrom(0, from);
    let depth = 1;
    while (depth > 0) {
      depth -= 1;
      const node = stack[depth] ?? 0;
      if ((stackNear[depth] ?? FAR) > nearest) continue;
      if (this.#isLeaf(node)) {
        const first = this.#words[NODE * node + 6] ?? 0;
        const last = first + (this.#halves[2 * NODE * node + 14] ?? 0);
        for (let i = first; i < last; ++i) {
          const candidate = this.#order[i] ?? 0;
          const distance = distanceTo(candidate);
          const isBetter =
            distance < nearest || (distance === nearest && (triangle < 0 || candidate < triangle));
          if (!isBetter || distance === FAR) continue;
          nearest = distance;
          triangle = candidate;
        }
        continue;
      }
      const children = [this.#second(node), node + 1];
      const away = children.map((child) => this.#awayFrom(child, from));
      const [near, far] = (away[0] ?? 0) <= (away[1] ?? 0) ? [0, 1] : [1, 0];
      for (const child of [far, near]) {
        stack[depth] = children[child] ?? 0;
        stackNear[depth] = away[child] ?? FAR;
        depth += 1;
      }
    }
    return triangle >= 0 ? { triangle, distance: nearest } : null;
  }

  /** The nearest triangle before `reach`, from either side. */
  cast(origin: Triple, direction: Triple, reach: number): TreeHit | null {
    this.#readyBoxes();
    const inverse: Triple = [1 / direction[0], 1 / direction[1], 1 / direction[2]];
    let nearest = reach;
    let triangle = -1;
    stack[0] = 0;
    stackNear[0] = this.#enters(0, origin, inverse);
    let depth = 1;
    while (depth > 0) {
      depth -= 1;
      const node = stack[depth] ?? 0;
      const near = stackNear[depth] ?? FAR;
      if (near === FAR || near > nearest) continue;
      if (this.#isLeaf(node)) {
        const first = this.#words[NODE * node + 6] ?? 0;
        const last = first + (this.#halves[2 * NODE * node + 14] ?? 0);
        for (let i = first; i < last; ++i) {
          const candidate = this.#order[i] ?? 0;
          const distance = this.#meets(candidate, origin, direction);
          if (
            distance === FAR ||
            distance > nearest ||
            (distance === nearest && triangle >= 0 && candidate > triangle)
          )
            continue;
          nearest = distance;
          triangle = candidate;
        }
        continue;
      }
      const second = this.#second(node);
      const near1 = this.#enters(node + 1, origin, inverse);
      const near2 = this.#enters(second, origin, inverse);
      // The nearer one is looked at first; what starts behind the nearest hit is thrown away when its turn comes.
      const firstIsNear = near1 <= near2;
      stack[depth] = firstIsNear ? second : node + 1;
      stackNear[depth] = firstIsNear ? near2 : near1;
      stack[depth + 1] = firstIsNear ? node + 1 : second;
      stackNear[depth + 1] = firstIsNear ? near1 : near2;
      depth += 2;
    }
    return triangle >= 0 ? { triangle, distance: nearest } : null;
  }

  /** Möller and Trumbore in double; infinite where the ray passes by. */
  #meets(triangle: number, origin: Triple, direction: Triple): number {
    const { indices } = this.#part;
    const [a, b, c] = corner;
    drawnAt(this.#part, this.#shape, indices[3 * triangle] ?? 0, a);
    drawnAt(this.#part, this.#shape, indices[3 * triangle + 1] ?? 0, b);
    drawnAt(this.#part, this.#shape, indices[3 * triangle + 2] ?? 0, c);
    const ax = a[0] ?? 0;
    const ay = a[1] ?? 0;
    const az = a[2] ?? 0;
    const e1x = (b[0] ?? 0) - ax;
    const e1y = (b[1] ?? 0) - ay;
    const e1z = (b[2] ?? 0) - az;
    const e2x = (c[0] ?? 0) - ax;
    const e2y = (c[1] ?? 0) - ay;
    const e2z = (c[2] ?? 0) - az;
    const dx = direction[0];
    const dy = direction[1];
    const dz = direction[2];
    const px = dy * e2z - dz * e2y;
    const py = dz * e2x - dx * e2z;
    const pz = dx * e2y - dy * e2x;
    const spread = e1x * px + e1y * py + e1z * pz;
    if (spread === 0) return FAR;
    const tx = origin[0] - ax;
    const ty = origin[1] - ay;
    const tz = origin[2] - az;
    const u = (tx * px + ty * py + tz * pz) / spread;
    if (!(u >= 0 && u <= 1)) return FAR;
    const qx = ty * e1z - tz * e1y;
    const qy = tz * e1x - tx * e1z;
    const qz = tx * e1y - ty * e1x;
    const v = (dx * qx + dy * qy + dz * qz) / spread;
    if (!(v >= 0 && u + v <= 1)) return FAR;
    const distance = (e2x * qx + e2y * qy + e2z * qz) / spread;
    return distance >= 0 ? distance : FAR;
  }
}
