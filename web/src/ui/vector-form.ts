// SPDX-License-Identifier: Apache-2.0
// Which result is drawn as arrows, how long and how many.
import { html, type TemplateResult } from "lit";

export interface VectorFormModel {
  readonly results: readonly { readonly id: string; readonly name: string }[];
  readonly chosen: string;
  /** Per cent of the model's diagonal. */
  readonly length: number;
  readonly density: string;
  readonly text: string;
}

export interface VectorFormActions {
  choose(id: string): void;
  setLength(percent: number): void;
  setDensity(density: string): void;
}

export function vectorTemplate(model: VectorFormModel, actions: VectorFormActions): TemplateResult {
  const value = (event: Event) => (event.target as HTMLSelectElement).value;
  return html`<div class="fields">
      <label class="wide">shown<select aria-label="result drawn as arrows" @change=${(e: Event) => actions.choose(value(e))}>
        <option value="" ?selected=${model.chosen === ""}>none</option>
        ${model.results.map((r) => html`<option value=${r.id} ?selected=${r.id === model.chosen}>${r.name}</option>`)}
      </select></label>
      <label>number<select aria-label="number of arrows" @change=${(e: Event) => actions.setDensity(value(e))}>
        ${["few", "some", "many"].map((d) => html`<option ?selected=${d === model.density}>${d}</option>`)}
      </select></label>
      <label>length<input type="range" min="2" max="20" step="1" aria-label="length of arrows in per cent of the model" .value=${String(model.length)}
        @input=${(e: Event) => actions.setLength(Number(value(e)))} /></label>
    </div>
    <p class="hint" aria-live="polite">${model.text}</p>`;
}
