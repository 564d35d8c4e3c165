// SPDX-License-Identifier: Apache-2.0
// Pointing: where on the skin, and which values are there.
export { findElement, findNode } from "./find";
export { type Hit, Picker } from "./picker";
export * from "./sample";
