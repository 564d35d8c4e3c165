// SPDX-License-Identifier: Apache-2.0
// The page around the model.
export type { Actions, ViewName } from "./actions";
export { CALIBRATION_STEPS, type CalibrationStep, calibrationTemplate } from "./calibration-form";
export { connectTemplate } from "./connect";
export { axisOf, type CutActions, type CutDirection, cutListTemplate } from "./cut-list";
export { deviceTemplate } from "./device-form";
export { axisTexts, boundText, numberText, stepText, unitText, withUnit } from "./format";
export { type Handle, handlesTemplate } from "./handles";
export { type HistoryLine, type HistoryModel, historyTemplate } from "./history-plot";
export { type HotListModel, type HotRow, hotListTemplate } from "./hot-list";
export type { IconName } from "./icons";
export { type InsideActions, type InsideFormModel, insideTemplate } from "./inside-form";
export { type LegendModel, legendTemplate, paintLegend } from "./legend";
export { type LimitChange, type LimitRow, limitListTemplate } from "./limit-list";
export { type ListeningModel, listeningTemplate } from "./listening-form";
export { type Marker, markersTemplate } from "./markers";
export {
  type DifferenceModel,
  differenceTemplate,
  type NoteActions,
  type NoteRow,
  notesTemplate,
  type SaveModel,
  saveTemplate,
} from "./note-list";
export { found, matching, type PaletteEntry, paletteTemplate } from "./palette";
export { type PartListActions, type PartRow, partListTemplate } from "./part-list";
export { type PlaceChoice, placeMenuTemplate } from "./place-menu";
export {
  type CardModel,
  type CardRow,
  cardSentence,
  cardTemplate,
  interiorText,
} from "./probe-card";
export { readingTemplate, withoutResults } from "./reading";
export { COLUMNS, resultTableTemplate, type TableModel } from "./result-table";
export { labelPositions, positionOf, valueAtPosition } from "./scale-axis";
export { beaconTemplate, pathTemplate, sweepTemplate } from "./scan-forms";
export { type PanelButton, type PanelPage, type PanelRow, type Section, sectionsTemplate } from "./section";
export { type StepBarModel, stepBarTemplate } from "./step-bar";
export { type TopBarModel, topBarTemplate } from "./top-bar";
export { modelDirection, triadTemplate } from "./triad";
export {
  averagingText,
  originText,
  type VariantActions,
  type VariantRow,
  variantListTemplate,
} from "./variant-list";
export { type VectorFormActions, vectorTemplate } from "./vector-form";
