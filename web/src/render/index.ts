// SPDX-License-Identifier: Apache-2.0
// Drawing: stage, model, palette.
export { ModelObject } from "./model-object";
export { Orbit } from "./orbit";
export { makePalette, type Palette, texelOf } from "./palette";
export { Stage } from "./stage";
