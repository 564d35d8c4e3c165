// SPDX-License-Identifier: Apache-2.0
// Planes that cut the model: direction, place along it, which side goes.
import { html, type TemplateResult } from "lit";
import type { CutState } from "../app/store";
import { numberText, unitText } from "./format";
import { icon } from "./icons";

export interface CutRow {
  readonly cut: CutState;
  /** Where along its normal the model begins and ends, model units. */
  readonly from: number;
  readonly to: number;
  /** What is to be said of its section; empty: nothing. */
  readonly section: string;
}

export interface CutListModel {
  readonly rows: readonly CutRow[];
  readonly most: number;
  readonly lengthUnit: string | null;
  /** What is said of the opened inside. */
  readonly insideText: string;
}

export type CutDirection = "x" | "y" | "z" | "view";

export interface CutActions {
  add(): void;
  remove(index: number): void;
  change(index: number, change: Partial<CutState>): void;
  point(index: number, direction: CutDirection): void;
  flip(index: number): void;
}

const DIRECTIONS: readonly CutDirection[] = ["x", "y", "z", "view"];

/** The axis a plane looks along, whatever side it takes away. */
export function axisOf(normal: CutState["normal"]): CutDirection | null {
  const axis = normal.findIndex((n) => Math.abs(n) > 0.999999);
  return axis < 0 ? null : (DIRECTIONS[axis] ?? null);
}

function plane(entry: CutRow, index: number, model: CutListModel, actions: CutActions): TemplateResult {
  const { cut, from, to } = entry;
  const name = `plane ${index + 1}`;
  const along = axisOf(cut.normal);
  const typed = (event: Event) => {
    const value = Number((event.target as HTMLInputElement).value.replace(",", "."));
    if (Number.isFinite(value)) actions.change(index, { offset: value });
  };
  const turned = (event: Event) => {
    const numbers = (event.target as HTMLInputElement).value
      .trim()
      .split(/[\s;]+/)
      .map(Number);
    const length = Math.hypot(...numbers);
    const [x, y, z] = numbers;
    if (numbers.length === 3 && Number.isFinite(length) && length > 0)
      actions.change(index, { normal: [(x ?? 0) / length, (y ?? 0) / length, (z ?? 0) / length] });
  };
  return html`<li class="cut">
    <div class="row">
      <button type="button" class="cell" aria-pressed=${cut.on ? "true" : "false"} aria-label="${name} cuts" title="cut, or not"
        @click=${() => actions.change(index, { on: !cut.on })}>${icon("cut")}</button>
      <div class="segments" role="group" aria-label="direction of ${name}">${DIRECTIONS.map(
        (d) => html`<button type="button" aria-pressed=${along === d ? "true" : "false"}
          title=${d === "view" ? "as I look now" : `across ${d}`} @click=${() => actions.point(index, d)}>${d}</button>`,
      )}</div>
      <button type="button" class="push" aria-label="other side of ${name}" @click=${() => actions.flip(index)}>other side</button>
      <button type="button" class="cell" aria-label="remove ${name}" title="remove" @click=${() => actions.remove(index)}>${icon("close")}</button>
    </div>
    <div class="row">
      <input class="cut-slider" type="range" min=${from} max=${to} step=${(to - from) / 400 || 1} .value=${String(cut.offset)} aria-label="place of ${name}"
        @input=${typed} />
      <input class="number cut-place" inputmode="decimal" aria-label="place of ${name}, typed" .value=${numberText(cut.offset)} @change=${typed} />
      <span class="unit">${unitText(model.lengthUnit)}</span>
    </div>
    ${entry.section ? html`<p class="cut-section" data-cut=${index}>${entry.section}</p>` : null}
    <label class="cut-normal"><span>normal</span><input inputmode="decimal" aria-label="normal of ${name}"
      .value=${cut.normal.map((n) => numberText(n, 4)).join(" ")} @change=${turned} /></label>
  </li>`;
}

export function cutListTemplate(model: CutListModel, actions: CutActions): TemplateResult {
  return html`<ul class="plainlist cuts">${model.rows.map((entry, i) => plane(entry, i, model, actions))}</ul>
    <div class="row"><button type="button" class="push" ?disabled=${model.rows.length >= model.most} @click=${() => actions.add()}>Add a plane</button></div>
    <p class="hint">${model.insideText}</p>`;
}
