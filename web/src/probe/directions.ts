// SPDX-License-Identifier: Apache-2.0
// Which nodes bear an arrow, and the principal values and directions of a symmetric tensor. No three.js.

export type Triple = [number, number, number];

/** A principal value with its direction, of unit length and either sign. */
export interface Principal {
  readonly value: number;
  readonly axis: Triple;
}

/** Vertices that bear arrows: of those in each cube of side `spacing` the one nearest to its middle, the smaller node on a
 * tie; each node once, in the order of ids. `bears` leaves out what shows no value or is not seen. */
export function spacedVertices(
  parts: readonly { readonly positions: ArrayLike<number>; readonly nodeIds: ArrayLike<number> }[],
  spacing: number,
  bears: (part: number, vertex: number) => boolean,
): { part: number; vertex: number; node: number }[] {
  const best = new Map<string, { part: number; vertex: number; node: number; away: number }>();
  for (const [part, { positions, nodeIds }] of parts.entries()) {
    for (let vertex = 0; vertex < nodeIds.length; ++vertex) {
      const node = nodeIds[vertex] ?? 0;
      if (node === 0 || !bears(part, vertex)) continue;
      let key = "";
      let away = 0;
      for (let axis = 0; axis < 3; ++axis) {
        const at = (positions[3 * vertex + axis] ?? 0) / spacing;
        const cell = Math.floor(at);
        key += `${cell} `;
        away += (at - cell - 0.5) ** 2;
      }
      const known = best.get(key);
      if (known && (known.away < away || (known.away === away && known.node <= node))) continue;
      best.set(key, { part, vertex, node, away });
    }
  }
  const chosen = [...best.values()].sort((a, b) => a.node - b.node || a.away - b.away || a.part - b.part);
  // The vertices round a beam are all of one node.
  return chosen
    .filter((place, i) => place.node !== chosen[i - 1]?.node)
    .map(({ part, vertex, node }) => ({ part, vertex, node }));
}

/** Principal values of a symmetric tensor (xx yy zz xy yz zx), the largest first, by Jacobi's rotations (Golub and Van Loan,
 * Matrix Computations, 8.5). NaN anywhere: null. */
export function principalOf(tensor: ArrayLike<number>): [Principal, Principal, Principal] | null {
  const [xx, yy, zz, xy, yz, zx] = [0, 1, 2, 3, 4, 5].map((i) => tensor[i] ?? Number.NaN) as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  if ([xx, yy, zz, xy, yz, zx].some((v) => !Number.isFinite(v))) return null;
  const a = [
    [xx, xy, zx],
    [xy, yy, yz],
    [zx, yz, zz],
  ];
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const at = (m: number[][], i: number, k: number) => m[i]?.[k] ?? 0;
  const put = (m: number[][], i: number, k: number, v: number) => {
    const row = m[i];
    if (row) row[k] = v;
  };
  const size = Math.max(...[xx, yy, zz, xy, yz, zx].map(Math.abs));
  for (let sweep = 0; sweep < 30; ++sweep) {
    if (Math.max(...[at(a, 0, 1), at(a, 1, 2), at(a, 0, 2)].map(Math.abs)) <= 1e-15 * size) break;
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      const off = at(a, p, q);
      if (off === 0) continue;
      const theta = (at(a, q, q) - at(a, p, p)) / (2 * off);
      const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
      const c = 1 / Math.hypot(t, 1);
      const s = t * c;
      for (let i = 0; i < 3; ++i) {
        const [ip, iq] = [at(a, i, p), at(a, i, q)];
        put(a, i, p, c * ip - s * iq);
        put(a, i, q, s * ip + c * iq);
      }
      for (let i = 0; i < 3; ++i) {
        const [pi, qi] = [at(a, p, i), at(a, q, i)];
        put(a, p, i, c * pi - s * qi);
        put(a, q, i, s * pi + c * qi);
        const [vp, vq] = [at(axes, i, p), at(axes, i, q)];
        put(axes, i, p, c * vp - s * vq);
        put(axes, i, q, s * vp + c * vq);
      }
    }
  }
  const found = [0, 1, 2].map((k) => ({
    value: at(a, k, k),
    axis: [at(axes, 0, k), at(axes, 1, k), at(axes, 2, k)] as Triple,
  }));
  return found.sort((one, other) => other.value - one.value) as [Principal, Principal, Principal];
}
