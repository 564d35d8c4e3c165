// SPDX-License-Identifier: Apache-2.0
// Colours of the boards in the headset. Alone in a file, so that their contrast is computed without a headset.
export const BOARD_COLOURS = {
  panel: "#182025",
  line: "#33414a",
  ink: "#eef2f3",
  soft: "#a5b4bc",
  /** What cannot be pressed now. */
  faint: "#74838b",
  accent: "#74c9c6",
  accentInk: "#0d2226",
  hover: "#24323a",
  alarm: "#ff7ac4",
} as const;
