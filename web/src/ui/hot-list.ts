// SPDX-License-Identifier: Apache-2.0
// Smallest, largest and hottest places as a list: number, node, and a way there.
import { html, type TemplateResult } from "lit";
import type { HotOptions } from "../app/store";
import { numberText, unitText } from "./format";

export interface HotRow {
  readonly word: string;
  readonly value: number;
  readonly unit: string | null;
  /** Which result it is of, where several are listed. */
  readonly label: string;
  readonly where: string;
  /** Part of the limit; null: the result has none. */
  readonly utilisation: number | null;
  readonly click: (() => void) | null;
}

export interface HotListModel {
  readonly options: HotOptions;
  readonly rows: readonly HotRow[];
  readonly hasLimit: boolean;
  readonly note: string;
  readonly change: (change: Partial<HotOptions>) => void;
}

function choice<T extends string>(
  label: string,
  words: readonly (readonly [T, string])[],
  value: T,
  change: (value: T) => void,
): TemplateResult {
  return html`<label><span>${label}</span><select aria-label=${label}
      @change=${(e: Event) => change((e.target as HTMLSelectElement).value as T)}
      >${words.map(([word, text]) => html`<option value=${word} ?selected=${word === value}>${text}</option>`)}</select></label>`;
}

function row(entry: HotRow): TemplateResult {
  const share = entry.utilisation === null ? "" : `${numberText(100 * entry.utilisation, 4)} %`;
  return html`<tr class=${entry.utilisation !== null && entry.utilisation > 1 ? "alarm" : ""}>
    <td><button type="button" class="link" ?disabled=${!entry.click} @click=${entry.click ?? (() => undefined)}>${entry.word}</button></td>
    <td class="number">${numberText(entry.value)} <span class="unit">${unitText(entry.unit)}</span></td>
    <td class="number">${share}</td><td>${entry.where}${entry.label ? html`<small>${entry.label}</small>` : null}</td>
  </tr>`;
}

export function hotListTemplate(model: HotListModel): TemplateResult {
  const { options, change } = model;
  const number = (event: Event) => Number((event.target as HTMLInputElement).value.replace(",", "."));
  const count = (event: Event) =>
    change({ count: Math.min(Math.max(Math.round(number(event)) || 1, 1), 50) });
  const share = (event: Event) => change({ share: Math.min(Math.max(number(event) || 0, 0), 100) / 100 });
  return html`<div class="fields">
      ${choice(
        "values",
        [
          ["largest", "largest"],
          ["smallest", "smallest"],
        ],
        options.end,
        (end) => change({ end }),
      )}
      ${choice(
        "by",
        model.hasLimit
          ? [
              ["value", "value"],
              ["utilisation", "utilisation"],
            ]
          : [["value", "value"]],
        options.by,
        (by) => change({ by }),
      )}
      <label><span>places</span><input class="number" type="number" min="1" max="50" aria-label="how many places" .value=${String(options.count)} @change=${count} /></label>
      <label><span>apart, %</span><input class="number" inputmode="decimal" aria-label="apart, percent of the model's diagonal" .value=${numberText(100 * options.share, 3)} @change=${share} /></label>
      <label class="check"><input type="checkbox" .checked=${options.marks} @change=${(e: Event) => change({ marks: (e.target as HTMLInputElement).checked })} />number them on the model</label>
    </div>
    <table class="hot"><thead><tr><th scope="col">place</th><th scope="col">value</th><th scope="col">of limit</th><th scope="col">where</th></tr></thead>
      <tbody>${model.rows.map(row)}</tbody></table>
    ${model.note ? html`<p class="hint">${model.note}</p>` : null}`;
}
