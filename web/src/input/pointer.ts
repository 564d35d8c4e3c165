// SPDX-License-Identifier: Apache-2.0
// What points: a mouse, a finger, a controller. The page treats them alike.

export type PointerKind =
  | "mouse"
  | "touch"
  | "pen"
  | "keyboard"
  | "controller"
  | "hand"
  | "transient"
  | "gaze";
