// SPDX-License-Identifier: Apache-2.0
// Pages of the panel beside the table of results: rows of words and buttons, and the tabs that lead to them.
import type { PanelPage } from "../ui";
import { BOARD_COLOURS as C } from "./board";
import { button, type Ink, words } from "./panel-ink";
import { PAGE_HEIGHT, PANEL_WIDTH, type PanelExtras } from "./vr-panel";

const ROW = 84;
export const ROWS_A_PAGE = 9;
const BUTTON = 132;
const TABS_A_ROW = 7;
const TAB = 80;

/** "Results" and one tab a page, along the lower edge. */
export function paintTabs(ink: Ink, pages: readonly PanelPage[], extras: PanelExtras): void {
  const tabs = [{ id: "results", title: "Results" }, ...pages];
  const rows = tabs.length > TABS_A_ROW ? 2 : 1;
  const inRow = Math.ceil(tabs.length / rows);
  const width = Math.min(190, (PANEL_WIDTH - 40) / inRow);
  tabs.forEach(({ id, title }, i) => {
    button(ink, {
      id: `tab:${id}`,
      x: 20 + (i % inRow) * width,
      y: PAGE_HEIGHT + 4 + Math.floor(i / inRow) * TAB,
      width: width - 4,
      height: TAB - 6,
      text: title,
      on: extras.page === id,
      press: () => extras.open(id, 0),
    });
  });
}

export function paintPage(ink: Ink, page: PanelPage, extras: PanelExtras): void {
  words(ink, page.title, 28, 40, 32, C.ink, { bold: true });
  const first = Math.min(extras.first, Math.max(page.rows.length - 1, 0));
  page.rows.slice(first, first + ROWS_A_PAGE).forEach((row, i) => {
    const y = 84 + i * (ROW + 8);
    const room = PANEL_WIDTH - 60 - row.buttons.length * BUTTON;
    words(ink, row.text, 28, y + (row.detail ? 28 : ROW / 2), 29, C.ink, { bold: true, width: room });
    if (row.detail) words(ink, row.detail, 28, y + 61, 26, C.soft, { width: room });
    row.buttons.forEach((spec, k) => {
      button(ink, {
        ...spec,
        id: `${page.id}:${spec.id}`,
        x: PANEL_WIDTH - 20 - (row.buttons.length - k) * BUTTON,
        y,
        width: BUTTON - 4,
        height: ROW,
      });
    });
  });
  if (page.rows.length <= ROWS_A_PAGE) return;
  const turn = (to: number) => () => extras.open(page.id, to);
  const ways = [
    ["up", "▲", first > 0, Math.max(first - ROWS_A_PAGE, 0)],
    ["down", "▼", first + ROWS_A_PAGE < page.rows.length, first + ROWS_A_PAGE],
  ] as const;
  ways.forEach(([id, text, enabled, to], i) => {
    button(ink, {
      id: `page:${id}`,
      x: PANEL_WIDTH - 220 + i * 100,
      y: 4,
      width: 96,
      height: 72,
      text,
      enabled,
      press: turn(to),
    });
  });
}
