// SPDX-License-Identifier: Apache-2.0
// Displacements as three numbers a vertex. No DOM.
import { MISSING, type PartField } from "../scene";

/** Three numbers a vertex; NaN where missing, which moves nothing. */
export function toVectors(field: PartField): Float32Array {
  if (field.components === 3) return field.values;
  const count = field.state.length;
  const out = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    for (let c = 0; c < 3; ++c)
      out[3 * i + c] = field.state[i] === MISSING ? 0 : (field.values[i * field.components + c] ?? 0);
  }
  return out;
}

/** Length of the longest; 0 without any. */
export function largestOf(displacements: readonly (Float32Array | null)[]): number {
  let largest = 0;
  for (const vectors of displacements) {
    for (let i = 0; vectors && i + 2 < vectors.length; i += 3) {
      const [x, y, z] = [vectors[i] ?? 0, vectors[i + 1] ?? 0, vectors[i + 2] ?? 0];
      const square = x * x + y * y + z * z;
      if (square > largest) largest = square;
    }
  }
  return Math.sqrt(largest);
}
