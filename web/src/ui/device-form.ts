// SPDX-License-Identifier: Apache-2.0
// What this device can do, as text.
import { html, type TemplateResult } from "lit";

export interface DeviceModel {
  readonly text: string;
  readonly measuring: boolean;
}

export function deviceTemplate(
  model: DeviceModel,
  actions: { measure(): Promise<void>; copy(): Promise<void> },
): TemplateResult {
  return html`<div class="row">
      <button type="button" class="push" ?disabled=${model.measuring} @click=${() => void actions.measure()}>${model.measuring ? "Measuring …" : "Measure"}</button>
      <button type="button" class="push" ?disabled=${model.text === ""} @click=${() => void actions.copy()}>Copy</button>
    </div>
    ${model.text ? html`<textarea class="device" readonly rows="14" aria-label="what this device can do" .value=${model.text}></textarea>` : null}
    <p class="hint">Nothing of this leaves the page by itself.</p>`;
}
