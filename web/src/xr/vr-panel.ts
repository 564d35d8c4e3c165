// SPDX-License-Identifier: Apache-2.0
// The panel in the headset: the assignment table, steps, deformation, and the ways home and out.
import type { Shown } from "../app/model-view";
import { type Reading, stageText } from "../app/opening";
import { drivenBy } from "../app/presentation-doc";
import type { ViewState } from "../app/store";
import type { SceneStep } from "../scene";
import { type Actions, COLUMNS, numberText, type PanelPage, stepText, unitText, withoutResults } from "../ui";
import { type BoardButton, type BoardRect, BOARD_COLOURS as C, roundRect } from "./board";
import { button, type Ink, words } from "./panel-ink";
import { paintPage, paintTabs } from "./panel-page";

export const PANEL_WIDTH = 1024;
export const PANEL_ROWS = 6;
/** Without the row of tabs below. */
export const PAGE_HEIGHT = 950;
export const PANEL_HEIGHT = 1130;
const NAME_WIDTH = 400;
const CELL = 96;
const ROW = 84;

export interface PanelModel {
  readonly state: ViewState;
  readonly shown: readonly Shown[];
  readonly step: SceneStep | null;
  readonly steps: readonly SceneStep[];
  readonly factor: number;
  readonly canShape: (shown: Shown) => boolean;
  readonly canPlay: boolean;
  readonly pages: readonly PanelPage[];
  /** Id of the button that a ray is on. */
  readonly hover: string | null;
}

export interface PanelExtras {
  readonly table: () => void;
  readonly trueSize: () => void;
  readonly leave: () => void;
  /** Id of the page that is shown; "results" is the table. */
  readonly page: string;
  readonly first: number;
  readonly open: (page: string, first: number) => void;
}

function tableRow(ink: Ink, model: PanelModel, shown: Shown, y: number, actions: Actions): void {
  words(ink, shown.label, 28, y + 28, 29, C.ink, { bold: true, width: NAME_WIDTH - 44 });
  const range = `${numberText(shown.range.lo, 4)} … ${numberText(shown.range.hi, 4)} ${unitText(shown.unit)}`;
  words(ink, range, 28, y + 61, 26, C.soft, { width: NAME_WIDTH - 44 });
  COLUMNS.forEach(({ slot, word }, i) => {
    const on = drivenBy(model.state.doc, slot) === shown.key;
    const enabled = shown.result !== null && (slot !== "shape" || model.canShape(shown));
    const press = () => (on ? actions.release(slot) : actions.assign(shown.key, slot));
    button(ink, {
      id: `${shown.key}:${slot}`,
      x: NAME_WIDTH + i * CELL,
      y,
      width: CELL,
      height: ROW,
      text: on ? "●" : word,
      on,
      enabled,
      press,
    });
  });
  const off = COLUMNS.every(({ slot }) => drivenBy(model.state.doc, slot) !== shown.key);
  button(ink, {
    id: `${shown.key}:off`,
    x: NAME_WIDTH + COLUMNS.length * CELL,
    y,
    width: CELL,
    height: ROW,
    text: "Off",
    on: off,
    press: () => actions.releaseAll(shown.key),
  });
}

/** The step's name over its place among all steps; held, it goes where the pointer is. */
function scrubber(ink: Ink, model: PanelModel, rect: BoardRect, actions: Actions): void {
  const { steps, step } = model;
  words(ink, step ? stepText(step) : "", rect.x + 14, rect.y + 26, 29, C.ink, { width: rect.width - 28 });
  const last = steps.length - 1;
  if (last < 1) return;
  const slide = (share: number) => {
    const to = steps[Math.round(share * last)];
    if (to) actions.setStep(to.id);
  };
  const id = "scrub";
  const at =
    rect.x +
    (rect.width *
      Math.max(
        steps.findIndex((s) => s.id === step?.id),
        0,
      )) /
      last;
  const y = rect.y + 64;
  const line = ink.hover === id ? C.ink : C.line;
  roundRect(ink.context, { x: rect.x, y: y - 4, width: rect.width, height: 8 }, 4, line);
  roundRect(ink.context, { x: at - 11, y: y - 18, width: 22, height: 36 }, 11, C.accent);
  ink.buttons.push({ id, ...rect, press: () => {}, slide });
}

/** Paints the panel; returns what can be pressed. */
export function paintPanel(
  context: CanvasRenderingContext2D,
  model: PanelModel,
  actions: Actions,
  extras: PanelExtras,
): BoardButton[] {
  const ink: Ink = { context, buttons: [], hover: model.hover };
  roundRect(context, { x: 0, y: 0, width: PANEL_WIDTH, height: PANEL_HEIGHT }, 28, C.panel);
  const page = model.pages.find((p) => p.id === extras.page);
  paintTabs(ink, model.pages, extras);
  if (page) paintPage(ink, page, extras);
  else paintResults(ink, model, actions, extras);
  return ink.buttons;
}

/** In the place of the table. */
function paintReading(ink: Ink, reading: Reading): void {
  words(ink, withoutResults(reading), 28, 110, 36, C.ink, { bold: true });
  const text = reading.failed ?? stageText(reading);
  const lines = text.match(/.{1,60}(?:\s|$)|.{60}/g) ?? [];
  for (const [i, line] of lines.slice(0, 8).entries()) {
    words(ink, line.trim(), 28, 164 + 42 * i, 30, C.soft, { width: PANEL_WIDTH - 56 });
  }
}

function paintResults(ink: Ink, model: PanelModel, actions: Actions, extras: PanelExtras): void {
  words(ink, "Result", 28, 38, 26, C.soft);
  COLUMNS.forEach(({ word }, i) => {
    words(ink, word, NAME_WIDTH + (i + 0.5) * CELL, 38, 26, C.soft, { align: "center" });
  });
  words(ink, "Off", NAME_WIDTH + (COLUMNS.length + 0.5) * CELL, 38, 26, C.soft, { align: "center" });
  model.shown.slice(0, PANEL_ROWS).forEach((shown, i) => {
    tableRow(ink, model, shown, 66 + i * (ROW + 4), actions);
  });
  const { state } = model;
  if (state.reading) paintReading(ink, state.reading);
  const top = PAGE_HEIGHT - 3 * (ROW + 14) - 14;
  const line = (i: number) => top + i * (ROW + 14);
  const many = model.steps.length > 1;
  button(ink, {
    id: "back",
    x: 24,
    y: line(0),
    width: 96,
    height: ROW,
    text: "‹",
    enabled: many,
    press: () => actions.stepBy(-1),
  });
  button(ink, {
    id: "play",
    x: 124,
    y: line(0),
    width: 150,
    height: ROW,
    text: state.playing ? "Pause" : "Play",
    on: state.playing,
    enabled: model.canPlay,
    press: () => actions.togglePlay(),
  });
  button(ink, {
    id: "next",
    x: 278,
    y: line(0),
    width: 96,
    height: ROW,
    text: "›",
    enabled: many,
    press: () => actions.stepBy(1),
  });
  scrubber(ink, model, { x: 392, y: line(0), width: 608, height: ROW }, actions);
  const modes = [
    ["off", "Undeformed"],
    ["true", "True scale"],
    ["auto", "5 %"],
  ] as const;
  modes.forEach(([mode, text], i) => {
    button(ink, {
      id: `deform:${mode}`,
      x: 24 + i * 190,
      y: line(1),
      width: 186,
      height: ROW,
      text,
      on: state.deformMode === mode,
      press: () => actions.setDeform(mode),
    });
  });
  words(ink, `deformation × ${numberText(model.factor, 4)}`, 610, line(1) + ROW / 2, 29, C.ink, {
    width: 390,
  });
  const last = [
    ["table", "Table", false, extras.table],
    ["true-size", "Size 1:1", false, extras.trueSize],
    ["sound", state.sound ? "Sound on" : "Muted", state.sound, () => actions.toggle("sound")],
    ["touch", state.touch ? "Touch on" : "Touch off", state.touch, () => actions.toggle("touch")],
    ["leave", "Leave VR", false, extras.leave],
  ] as const;
  last.forEach(([id, text, on, press], i) => {
    button(ink, { id, x: 24 + i * 196, y: line(2), width: 192, height: ROW, text, on, press });
  });
}
