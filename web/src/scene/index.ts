// SPDX-License-Identifier: Apache-2.0
// Scenes: bytes to typed arrays.
export { differenceResult } from "./difference";
export { firstVertices, type NodeNumbers, nodeNumbers } from "./node-numbers";
export { isPreview, onShape } from "./preview";
export { openScene, type SceneData } from "./scene-file";
export * from "./scene-types";
export { readSection, type SectionData } from "./section-data";
