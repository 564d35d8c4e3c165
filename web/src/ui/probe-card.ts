// SPDX-License-Identifier: Apache-2.0
// The card under the pointer: every result with number and unit, node and element id.
import { html, type TemplateResult } from "lit";
import type { Reading } from "../app/opening";
import type { ProbeReport } from "../app/probe-report";
import { boundText, numberText, unitText } from "./format";
import { type IconName, icon } from "./icons";
import { withoutResults } from "./reading";

export interface CardRow {
  /** Of the presentation. */
  readonly key: string;
  readonly label: string;
  readonly unit: string | null;
  readonly value: number | null;
  readonly nodeValue: number | null;
  readonly state: string;
  readonly senses: readonly IconName[];
  /** "> 250 MPa yield" while the value is past the limit. */
  readonly alarm: string | null;
  /** Part of the limit that is used. */
  readonly utilisation: number | null;
  /** What the values may be off; 0: nothing. */
  readonly bound: number;
}

export interface CardModel {
  readonly report: ProbeReport;
  readonly rows: readonly CardRow[];
  readonly pinned: boolean;
  readonly lengthUnit: string | null;
  /** Only the shape is there: there are no values. */
  readonly reading: Reading | null;
  /** Null while nothing sounds. */
  readonly sounding: string | null;
}

function rowTemplate(row: CardRow): TemplateResult {
  const about = row.state === "interpolated" ? "~" : "";
  return html`<tr class=${row.alarm ? "alarm" : ""} data-key=${row.key}>
    <th scope="row">${row.senses.map((name) => icon(name))}<span>${row.label}</span></th>
    <td class=${row.value === null ? "none" : "value"}>${row.value === null ? "no value" : `${about}${numberText(row.value)}`}
      <span class="unit">${row.value === null ? "" : unitText(row.unit)}</span>
      ${row.value === null || !row.bound ? null : html`<span class="bound">± ${boundText(row.bound)}</span>`}</td>
    <td class="at-node">${row.nodeValue === null ? "–" : numberText(row.nodeValue)}</td>
  </tr>
  ${row.utilisation !== null && !row.alarm ? html`<tr class="used-text"><td colspan="3">${numberText(100 * row.utilisation, 3)} % of the limit</td></tr>` : null}
  ${row.alarm ? html`<tr class="alarm-text"><td colspan="3">${row.alarm}${row.utilisation === null ? "" : ` · ${numberText(100 * row.utilisation, 4)} %`}</td></tr>` : null}`;
}

/** What the values of a place inside are. */
export function interiorText(report: ProbeReport): string {
  const { interior, elementId } = report;
  if (!interior) return "";
  const element = `element ${elementId ?? "–"}`;
  if (!interior.exact) return `interior value as drawn, ${element}`;
  return `interior value by the shape functions of ${element} (${interior.elementType})`;
}

export function cardTemplate(model: CardModel, unpin: () => void): TemplateResult {
  const { report } = model;
  const node = report.nodeId === null ? "–" : String(report.nodeId);
  return html`${
    model.reading
      ? null
      : html`<table>
      <thead><tr><th scope="col"></th><th scope="col">here</th><th scope="col">node ${node}</th></tr></thead>
      <tbody>${model.rows.map(rowTemplate)}</tbody>
    </table>`
  }
    <p class="card-place"><span>node <b>${node}</b></span><span>element <b>${report.elementId ?? "–"}</b></span>
      <span class="xyz">${report.point.map((v) => numberText(v, 5)).join(" · ")} ${unitText(model.lengthUnit)}</span></p>
    ${report.interior ? html`<p class="card-interior">${interiorText(report)}</p>` : null}
    ${model.reading ? html`<p class="card-reading">No values. ${withoutResults(model.reading)}</p>` : null}
    ${model.sounding ? html`<p class="card-sound">${model.sounding}</p>` : null}
    ${model.pinned ? html`<button type="button" class="plain close" aria-label="let go of this place" @click=${unpin}>${icon("close")}</button>` : null}`;
}

/** One sentence for screen readers. */
export function cardSentence(model: CardModel): string {
  const values = model.rows.map((row) =>
    row.value === null
      ? `${row.label}: no value`
      : `${row.label} ${numberText(row.value)} ${unitText(row.unit)}${row.bound ? ` within ${boundText(row.bound)}` : ""}`,
  );
  const inside = model.report.interior ? "interior value, " : "";
  if (model.reading) values.push(`no values, ${withoutResults(model.reading).toLowerCase()}`);
  return `${inside}node ${model.report.nodeId ?? "none"}, element ${model.report.elementId ?? "none"}: ${values.join(", ")}`;
}
