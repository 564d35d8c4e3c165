// SPDX-License-Identifier: Apache-2.0
// Limits: typed, drawn, used; and the lines and colours that say where a value stands.
import {
  type LimitRow,
  limitListTemplate,
  numberText,
  type PanelPage,
  type Section,
  unitText,
} from "../../ui";
import type { App } from "../app";
import { utilisation } from "../limits";
import type { Shown } from "../model-view";
import { colourEntry, setColour, setLimit, setRange } from "../presentation-doc";
import { skinRange, statedExtremes } from "../ranges";
import type { Feature } from "./feature";

/** One press of the panel's buttons, as a share of the limit. */
const NUDGE = 0.05;

export class Limits implements Feature {
  readonly id = "limits";
  readonly #app: App;

  constructor(app: App) {
    this.#app = app;
  }

  #set(key: string, limit: Parameters<typeof setLimit>[2]): void {
    this.#app.store.set({ doc: setLimit(this.#app.store.state.doc, key, limit) });
  }

  #most(shown: Shown): { used: number | null; at: string } {
    if (shown.limit === null || !shown.result) return { used: null, at: "" };
    const stated = statedExtremes(shown.result, this.#app.store.state.step);
    const extreme = shown.limitIsUpper ? stated?.max : stated?.min;
    if (extreme) {
      const at = extreme.element === undefined ? `at node ${extreme.node}` : `at element ${extreme.element}`;
      return { used: utilisation(extreme.value, shown), at };
    }
    const skin = skinRange(shown.fields, shown.componentIndex);
    return { used: utilisation(skin && (shown.limitIsUpper ? skin.hi : skin.lo), shown), at: "on the skin" };
  }

  #rows(): LimitRow[] {
    return this.#app.view.shown
      .filter((shown) => shown.result)
      .map((shown) => {
        const { used, at } = this.#most(shown);
        const { key, label, unit, limit, limitIsUpper: isUpper, limitLabel: name } = shown;
        return { key, label, unit, limit, isUpper, name, used, usedAt: at };
      });
  }

  section(): Section | null {
    const rows = this.#rows();
    if (rows.length === 0) return null;
    const past = rows.filter((row) => row.used !== null && row.used > 1).length;
    const set = rows.filter((row) => row.limit !== null).length;
    const summary = past > 0 ? `${past} passed` : set > 0 ? `${set} kept` : "none set";
    const body = () => limitListTemplate(rows, (key, limit) => this.#set(key, limit));
    return { id: this.id, title: "Limits", summary, body };
  }

  page(): PanelPage | null {
    const rows = this.#rows().map((row) => {
      const kind = row.isUpper ? "above" : "below";
      const start = this.#app.view.shown.find((s) => s.key === row.key)?.range;
      const value = row.limit ?? (start ? start.lo + 0.8 * (start.hi - start.lo) : 1);
      const press = (share: number) => () =>
        this.#set(row.key, { value: Number((value * share).toPrecision(4)), kind, label: row.name });
      const word =
        row.limit === null
          ? "no limit"
          : `${row.isUpper ? "at most" : "at least"} ${numberText(row.limit)} ${unitText(row.unit)}`;
      return {
        text: row.label,
        detail: row.used === null ? word : `${word} · ${numberText(100 * row.used, 3)} % used`,
        buttons: [
          { id: `less:${row.key}`, text: "− 5 %", enabled: row.limit !== null, press: press(1 - NUDGE) },
          { id: `more:${row.key}`, text: "+ 5 %", enabled: row.limit !== null, press: press(1 + NUDGE) },
          {
            id: `on:${row.key}`,
            text: row.limit === null ? "Set" : "None",
            press: row.limit === null ? press(1) : () => this.#set(row.key, null),
          },
        ],
      };
    });
    const { doc } = this.#app.store.state;
    const lines = colourEntry(doc)?.isolines === true;
    const isolines = { id: "isolines", text: "Lines", on: lines, press: () => this.toggleIsolines() };
    const lock = { id: "lock", text: "Lock", on: this.locked, press: () => this.toggleLock() };
    const first = { text: "Lines between bands, range held over steps", buttons: [isolines, lock] };
    return { id: this.id, title: "Limits", rows: [first, ...rows] };
  }

  toggleIsolines(): void {
    const { doc } = this.#app.store.state;
    this.#app.store.set({ doc: setColour(doc, { isolines: colourEntry(doc)?.isolines !== true }) });
  }

  get locked(): boolean {
    return this.#app.view.shownAs("colour")?.rangeMode === "manual";
  }

  /** The range of what is seen stays as it is over all steps, or follows the step again. */
  toggleLock(): void {
    const seen = this.#app.view.shownAs("colour");
    if (!seen) return;
    const { lo, hi } = seen.range;
    const change = this.locked ? { mode: "auto" as const } : { mode: "manual" as const, lo, hi };
    this.#app.store.set({ doc: setRange(this.#app.store.state.doc, seen.key, change) });
  }

  commands() {
    return [
      { keys: ["o"], shown: "O", text: "lines between bands", down: () => this.toggleIsolines() },
      { keys: ["r"], shown: "R", text: "hold the range over steps", down: () => this.toggleLock() },
    ];
  }

  report() {
    return {
      limits: this.#rows()
        .filter((row) => row.limit !== null)
        .map(({ key, limit, isUpper, used }) => ({
          key,
          value: limit,
          kind: isUpper ? "above" : "below",
          used,
        })),
    };
  }
}
