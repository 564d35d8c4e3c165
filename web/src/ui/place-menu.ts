// SPDX-License-Identifier: Apache-2.0
// What can be done at a place of the model: the menu of a finger that rests there.
import { html, type TemplateResult } from "lit";

export interface PlaceChoice {
  readonly id: string;
  readonly text: string;
  readonly run: () => void;
}

export function placeMenuTemplate(title: string, choices: readonly PlaceChoice[]): TemplateResult {
  return html`<div role="group" aria-label=${title}><p>${title}</p>${choices.map(
    ({ id, text, run }) => html`<button type="button" data-choice=${id} @click=${run}>${text}</button>`,
  )}</div>`;
}
