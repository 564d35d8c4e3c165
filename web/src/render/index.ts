// SPDX-License-Identifier: Apache-2.0
// Drawing: stage, model, palette.
export { ArrowGlyphs, type Glyph } from "./arrow-glyphs";
export { featureEdges } from "./feature-edges";
export { type CutPlane, MAX_CUTS } from "./field-material";
export { HEADSET_TRIANGLES, levelWithin } from "./governor";
export type { InsideMesh, InsideTriangles } from "./inside-mesh";
export { ModelObject } from "./model-object";
export { Orbit } from "./orbit";
export { makePalette, type Palette, texelOf } from "./palette";
export type { PartLook } from "./part-table";
export { RulerLine } from "./ruler-line";
export { Stage } from "./stage";
export { SweepPlane } from "./sweep-plane";
