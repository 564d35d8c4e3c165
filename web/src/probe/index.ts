// SPDX-License-Identifier: Apache-2.0
// Pointing: where on the skin, and which values are there.
export { type Cut, isCutAway, kept } from "./cuts";
export { type Principal, principalOf, spacedVertices } from "./directions";
export { findElement, findNode, placeOfVertex, placeVertex } from "./find";
export { type HotSpot, hotSpots } from "./hot-spots";
export { type Cast, type Hit, Picker, type PickLook } from "./picker";
export * from "./sample";
export {
  type DrawnSection,
  type InteriorAnswer,
  placeOnSections,
  type SectionPlace,
  sectionValue,
} from "./sections";
export { type Slab, slabsOf } from "./slabs";
export { placeOnWalk, type Walk, walkThrough } from "./walk";
