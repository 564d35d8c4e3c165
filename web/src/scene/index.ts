// SPDX-License-Identifier: Apache-2.0
// Scenes: bytes to typed arrays.
export { openScene, type SceneData } from "./scene-file";
export * from "./scene-types";
