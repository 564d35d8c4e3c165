// SPDX-License-Identifier: Apache-2.0
// Sections of the left column that fold, and the pages of the headset's panel: the same functions, two shapes.
import { html, type TemplateResult } from "lit";

export interface Section {
  readonly id: string;
  readonly title: string;
  /** Said beside the title, also while folded. */
  readonly summary: string;
  /** Called only while unfolded. */
  readonly body: () => TemplateResult;
}

export interface PanelButton {
  readonly id: string;
  readonly text: string;
  readonly on?: boolean;
  readonly enabled?: boolean;
  readonly press: () => void;
}
export interface PanelRow {
  readonly text: string;
  readonly detail?: string;
  readonly buttons: readonly PanelButton[];
}
/** A page of the panel in the headset. */
export interface PanelPage {
  readonly id: string;
  readonly title: string;
  readonly rows: readonly PanelRow[];
}

export function sectionsTemplate(
  sections: readonly Section[],
  open: readonly string[],
  toggle: (id: string, on: boolean) => void,
): TemplateResult {
  return html`${sections.map((section) => {
    const on = open.includes(section.id);
    const changed = (event: Event) => toggle(section.id, (event.target as HTMLDetailsElement).open);
    return html`<details class="section" data-section=${section.id} ?open=${on} @toggle=${changed}>
      <summary><span class="section-title">${section.title}</span><span class="section-note">${section.summary}</span></summary>
      ${on ? html`<div class="section-body">${section.body()}</div>` : null}
    </details>`;
  })}`;
}
