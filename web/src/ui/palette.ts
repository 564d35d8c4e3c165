// SPDX-License-Identifier: Apache-2.0
// The palette of commands: every function by its words.
import { html, type TemplateResult } from "lit";

export interface PaletteEntry {
  readonly text: string;
  /** The key that does the same; "" if none. */
  readonly shown: string;
  readonly run: () => void;
}

/** How well words are meant by what was typed; 0: not at all. Every typed word must begin or stand in one. */
export function matching(text: string, typed: string): number {
  const words = text.toLowerCase().split(/[\s,:·−]+/);
  let score = 1;
  for (const part of typed
    .toLowerCase()
    .split(/\s+/)
    .filter((w) => w !== "")) {
    if (words.some((w) => w === part)) score += 4;
    else if (words.some((w) => w.startsWith(part))) score += 3;
    else if (text.toLowerCase().includes(part)) score += 1;
    else return 0;
  }
  return score;
}

export function found(entries: readonly PaletteEntry[], typed: string, most = 12): PaletteEntry[] {
  return entries
    .map((entry, i) => ({ entry, i, score: matching(entry.text, typed) }))
    .filter(({ score }) => score > 0)
    .sort((a, b) => b.score - a.score || a.i - b.i)
    .slice(0, most)
    .map(({ entry }) => entry);
}

export interface PaletteModel {
  readonly typed: string;
  readonly entries: readonly PaletteEntry[];
  readonly at: number;
  readonly type: (text: string) => void;
  readonly move: (by: number) => void;
  readonly run: (entry: PaletteEntry) => void;
  readonly close: () => void;
}

export function paletteTemplate(model: PaletteModel): TemplateResult {
  const key = (event: KeyboardEvent) => {
    const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    const entry = model.entries[model.at];
    if (by !== 0) model.move(by);
    else if (event.key === "Enter" && entry) model.run(entry);
    else if (event.key === "Escape") model.close();
    else return;
    event.preventDefault();
  };
  return html`<div class="palette-box">
    <input role="combobox" aria-expanded="true" aria-controls="palette-list" aria-label="command" autocomplete="off" spellcheck="false"
      aria-activedescendant=${model.entries.length > 0 ? `palette-${model.at}` : ""} placeholder="What shall be done? A number goes to that node." .value=${model.typed}
      @input=${(e: Event) => model.type((e.target as HTMLInputElement).value)} @keydown=${key} />
    <ul id="palette-list" role="listbox" aria-label="commands">
      ${model.entries.map(
        (
          entry,
          i,
        ) => html`<li id="palette-${i}" role="option" aria-selected=${i === model.at ? "true" : "false"} @click=${() => model.run(entry)}>
          <span>${entry.text}</span>${entry.shown ? html`<kbd>${entry.shown}</kbd>` : null}</li>`,
      )}
    </ul>
    ${model.entries.length === 0 ? html`<p class="hint">Nothing of that name.</p>` : null}
  </div>`;
}
