// SPDX-License-Identifier: Apache-2.0
// The limit of each result, typed, and how much of it the model uses.
import { html, type TemplateResult } from "lit";
import { numberText, unitText } from "./format";

export interface LimitRow {
  readonly key: string;
  readonly label: string;
  readonly unit: string | null;
  readonly limit: number | null;
  readonly isUpper: boolean;
  readonly name: string;
  /** Of the most used place of the whole model; null: no limit. */
  readonly used: number | null;
  readonly usedAt: string;
}

export type LimitChange = (
  key: string,
  limit: { value: number; kind: "above" | "below"; label: string } | null,
) => void;

function row(entry: LimitRow, change: LimitChange): TemplateResult {
  const kind = entry.isUpper ? "above" : "below";
  const typed = (event: Event) => {
    const text = (event.target as HTMLInputElement).value.trim().replace(",", ".");
    if (text === "") change(entry.key, null);
    else if (Number.isFinite(Number(text)))
      change(entry.key, { value: Number(text), kind, label: entry.name });
    else (event.target as HTMLInputElement).value = entry.limit === null ? "" : numberText(entry.limit);
  };
  const turned = (event: Event) => {
    const next = (event.target as HTMLSelectElement).value as "above" | "below";
    if (entry.limit !== null) change(entry.key, { value: entry.limit, kind: next, label: entry.name });
  };
  const past = entry.used !== null && entry.used > 1;
  return html`<li data-key=${entry.key} class=${past ? "past" : ""}>
    <span class="limit-name">${entry.label}</span>
    <select aria-label="alarm of ${entry.label}" ?disabled=${entry.limit === null} @change=${turned}>
      <option value="above" ?selected=${entry.isUpper}>at most</option><option value="below" ?selected=${!entry.isUpper}>at least</option></select>
    <input class="number" inputmode="decimal" placeholder="none" aria-label="limit of ${entry.label}"
      .value=${entry.limit === null ? "" : numberText(entry.limit)} @change=${typed} />
    <span class="unit">${unitText(entry.unit)}</span>
    ${
      entry.used === null
        ? null
        : html`<span class="limit-used"><meter min="0" max="1.25" high="1" .value=${Math.min(entry.used, 1.25)}></meter>
          <b>${numberText(100 * entry.used, 4)} %</b> used ${entry.usedAt}</span>`
    }
  </li>`;
}

export function limitListTemplate(rows: readonly LimitRow[], change: LimitChange): TemplateResult {
  return html`<ul class="limits">${rows.map((entry) => row(entry, change))}</ul>
    <p class="hint">Past its limit a result is seen as a line on the model and the card's frame, heard as a flutter, felt as quicker pulses; crossing it beeps and knocks twice.</p>`;
}
