// SPDX-License-Identifier: Apache-2.0
// The assignment table: each result is seen, heard, felt, shapes the model, or is off.
import { html, type TemplateResult } from "lit";
import type { Shown } from "../app/model-view";
import type { Reading } from "../app/opening";
import { drivenBy, type PresentationDoc, type Slot } from "../app/presentation-doc";
import type { SceneResult } from "../scene";
import type { Actions } from "./actions";
import { numberText, unitText } from "./format";
import { type IconName, icon } from "./icons";
import { withoutResults } from "./reading";

export interface TableModel {
  readonly doc: PresentationDoc;
  readonly shown: readonly Shown[];
  readonly others: readonly { result: SceneResult; component: string }[];
  /** Only the shape is there. */
  readonly reading: Reading | null;
  /** Whether a result's quantity has displacement vectors that can shape the model. */
  canShape(shown: Shown): boolean;
  /** How touch reaches a person whose device cannot shake; "": it can, or nothing is to be felt. */
  readonly touchNote: string;
}

export const COLUMNS: readonly { slot: Slot; icon: IconName; word: string; verb: string }[] = [
  { slot: "colour", icon: "eye", word: "Colour", verb: "seen as colour" },
  { slot: "pitch", icon: "ear", word: "Tone", verb: "heard as pitch" },
  { slot: "ticks", icon: "ticks", word: "Ticks", verb: "heard as ticks" },
  { slot: "pulses", icon: "hand", word: "Touch", verb: "felt as pulses" },
  { slot: "shape", icon: "shape", word: "Shape", verb: "shown as shape" },
];

function cell(
  model: TableModel,
  shown: Shown,
  column: (typeof COLUMNS)[number],
  actions: Actions,
): TemplateResult {
  const on = drivenBy(model.doc, column.slot) === shown.key;
  const usable = shown.result !== null && (column.slot !== "shape" || model.canShape(shown));
  const click = () => (on ? actions.release(column.slot) : actions.assign(shown.key, column.slot));
  return html`<td><button type="button" class="cell" aria-pressed=${on ? "true" : "false"} ?disabled=${!usable}
    data-slot=${column.slot} aria-label="${shown.label}: ${column.verb}" title=${column.verb} @click=${click}>${icon(column.icon)}</button></td>`;
}

function row(model: TableModel, shown: Shown, actions: Actions): TemplateResult {
  const off = COLUMNS.every((column) => drivenBy(model.doc, column.slot) !== shown.key);
  const unit = unitText(shown.unit);
  return html`<tr data-key=${shown.key}>
    <th scope="row"><span class="result-name">${shown.label}</span>
      <span class="result-range">${
        shown.result
          ? html`<span>${numberText(shown.range.lo)} …</span> <span>${numberText(shown.range.hi)} ${unit}</span>`
          : "not in this scene"
      }</span></th>
    ${COLUMNS.map((column) => cell(model, shown, column, actions))}
    <td><button type="button" class="cell" aria-pressed=${off ? "true" : "false"} data-slot="off"
      aria-label="${shown.label}: off" title="off" @click=${() => actions.releaseAll(shown.key)}>${icon("off")}</button></td>
  </tr>`;
}

function tableTemplate(model: TableModel, actions: Actions): TemplateResult {
  return html`<table class="assign">
    <thead>
      <tr><th scope="col">Result</th>
        ${COLUMNS.map((column) => html`<th scope="col" title=${column.verb}>${column.word}</th>`)}
        <th scope="col">Off</th></tr>
    </thead>
    <tbody>${model.shown.map((shown) => row(model, shown, actions))}</tbody>
  </table>`;
}

export function resultTableTemplate(model: TableModel, actions: Actions): TemplateResult {
  return html`<section class="results" aria-label="Results and senses">
    ${model.reading ? null : tableTemplate(model, actions)}
    ${model.touchNote ? html`<p class="hint touch-note">${model.touchNote}</p>` : null}
    ${model.shown.length + model.others.length === 0 ? html`<p class="hint">${model.reading ? withoutResults(model.reading) : "This scene holds no results: only the shape can be looked at."}</p>` : null}
    ${
      model.others.length === 0
        ? null
        : html`<details class="others"><summary>Other results (${model.others.length})</summary>
            <ul>${model.others.map(
              ({ result, component }) => html`<li><button type="button" class="plain"
                @click=${() => actions.addResult(result, component)}>${icon("plus")}<span>${result.name}${
                  result.components.length > 1 ? ` ${component}` : ""
                }</span><span class="unit">${unitText(result.unit)}</span></button></li>`,
            )}</ul></details>`
    }
  </section>`;
}
