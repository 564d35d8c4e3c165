// SPDX-License-Identifier: Apache-2.0
// Value -> colour, tone, tick, pulse. C++ `present` is the reference; tests/contract binds both.
export {
  type Candidate,
  type Choice,
  type ChosenEffect,
  type ChosenResult,
  choosePresentation,
  type Slot,
} from "./choose";
export { differenceOf, labOf, leastDifference, type Vision, visions } from "./colour-difference";
export { bandOf, colourMaps, colourOf, mapColour, paletteColour } from "./colour-map";
export { automaticDeformationFactor, normalise } from "./normalise";
export {
  type Presentation,
  PresentationError,
  type PresentedEffect,
  type PresentedResult,
  parsePresentation,
  type RangeMode,
} from "./presentation";
export { pulseOf, tickRateOf } from "./rates";
export { equalLoudness, negativePartials, toneOf, tonePartials } from "./tone";
export * from "./types";
