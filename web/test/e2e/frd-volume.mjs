// SPDX-License-Identifier: Apache-2.0
// An ASCII .frd of straight 10-node tetrahedra, read by itself: nodes, elements, nodal scalars, and values inside by the
// element's quadratic functions. Knows nothing of Feelem.
import { readFileSync } from "node:fs";

const EDGES = [
  [0, 1],
  [1, 2],
  [2, 0],
  [0, 3],
  [1, 3],
  [2, 3],
];

export function readVolume(path) {
  const nodes = new Map();
  const elements = new Map();
  const results = new Map();
  let block = "";
  let element = 0;
  let name = "";
  for (const line of readFileSync(path, "latin1").split("\n")) {
    const key = line.slice(0, 6);
    if (key === "    2C") block = "nodes";
    else if (key === "    3C") block = "elements";
    else if (line.startsWith(" -4")) {
      block = "result";
      name = line.slice(5, 13).trim();
      results.set(name, new Map());
    } else if (line.startsWith(" -3")) block = "";
    else if (line.startsWith(" -1")) {
      const id = Number(line.slice(3, 13));
      const rest = line.slice(13);
      const numbers = () => rest.match(/.{12}/g).map(Number);
      if (block === "nodes") nodes.set(id, numbers());
      else if (block === "elements") element = id;
      else if (block === "result") results.get(name).set(id, numbers());
    } else if (line.startsWith(" -2") && block === "elements") {
      elements.set(element, line.slice(3).match(/.{10}/g).map(Number));
    }
  }
  return { nodes, elements, results };
}

/** Weights of the four corners; all within 0..1 inside. */
function barycentric(corners, p) {
  const [a, b, c, d] = corners;
  const minus = (u, v) => u.map((x, i) => x - v[i]);
  const det = (u, v, w) =>
    u[0] * (v[1] * w[2] - v[2] * w[1]) -
    u[1] * (v[0] * w[2] - v[2] * w[0]) +
    u[2] * (v[0] * w[1] - v[1] * w[0]);
  const [u, v, w, q] = [minus(b, a), minus(c, a), minus(d, a), minus(p, a)];
  const whole = det(u, v, w);
  const [wb, wc, wd] = [det(q, v, w) / whole, det(u, q, w) / whole, det(u, v, q) / whole];
  return [1 - wb - wc - wd, wb, wc, wd];
}

/** Element and value of a nodal number (`of` a node id) at a place; null outside. */
export function valueInside({ nodes, elements }, of, place) {
  let best = null;
  for (const [id, list] of elements) {
    const corners = list.slice(0, 4).map((n) => nodes.get(n));
    const far = [0, 1, 2].some(
      (i) =>
        Math.min(...corners.map((c) => c[i])) > place[i] + 1e-3 ||
        Math.max(...corners.map((c) => c[i])) < place[i] - 1e-3,
    );
    if (far) continue;
    const l = barycentric(corners, place);
    const depth = Math.min(...l);
    if (depth < -1e-4 || (best && best.depth >= depth)) continue;
    let value = 0;
    for (let i = 0; i < 4; ++i) value += l[i] * (2 * l[i] - 1) * of(list[i]);
    for (const [k, [i, j]] of EDGES.entries()) value += 4 * l[i] * l[j] * of(list[4 + k]);
    best = { id, value, depth };
  }
  return best;
}
