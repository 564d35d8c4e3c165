// SPDX-License-Identifier: Apache-2.0
// Arrays of a scene, checked to be what they must be.
import type { Numbers } from "./gltf";
import { SceneError } from "./scene-types";

export function asFloats(numbers: Numbers, label: string, count: number, components: number): Float32Array {
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
