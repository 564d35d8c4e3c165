// SPDX-License-Identifier: Apache-2.0
// What planes leave of a model and of a ray through it. No three.js.

/** A plane in model units minus the scene's origin; the side its normal points to is cut away. */
export interface Cut {
  readonly normal: readonly [number, number, number];
  readonly offset: number;
}

type Point = { readonly x: number; readonly y: number; readonly z: number };
const along = (n: Cut["normal"], p: Point) => n[0] * p.x + n[1] * p.y + n[2] * p.z;

export function isCutAway(cuts: readonly Cut[], x: number, y: number, z: number): boolean {
  for (const { normal, offset } of cuts)
    if (normal[0] * x + normal[1] * y + normal[2] * z > offset) return true;
  return false;
}

/** Where a ray is in what the planes leave: from `enters` to `leaves`; null where it never is. */
export function kept(
  cuts: readonly Cut[],
  origin: Point,
  direction: Point,
): { enters: number; leaves: number } | null {
  let enters = 0;
  let leaves = Number.POSITIVE_INFINITY;
  for (const { normal, offset } of cuts) {
    const rise = along(normal, direction);
    const room = offset - along(normal, origin);
    if (rise === 0) {
      if (room < 0) return null;
    } else if (rise > 0) leaves = Math.min(leaves, room / rise);
    else enters = Math.max(enters, room / rise);
  }
  return enters < leaves ? { enters, leaves } : null;
}
