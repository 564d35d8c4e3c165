// SPDX-License-Identifier: Apache-2.0
// The palette as a dialog: typing narrows, arrows choose, Enter runs, Escape closes.
import { render } from "lit";
import { type PaletteEntry, paletteTemplate } from "../ui";

export class PaletteView {
  readonly #dialog = document.createElement("dialog");
  #find: (typed: string) => PaletteEntry[] = () => [];
  #typed = "";
  #at = 0;

  constructor(host: HTMLElement) {
    this.#dialog.className = "palette";
    this.#dialog.setAttribute("aria-label", "commands");
    this.#dialog.addEventListener("click", (event) => {
      if (event.target === this.#dialog) this.#close();
    });
    host.append(this.#dialog);
  }

  show(find: (typed: string) => PaletteEntry[]): void {
    this.#find = find;
    this.#typed = "";
    this.#at = 0;
    this.#render();
    if (!this.#dialog.open) this.#dialog.showModal();
    this.#dialog.querySelector("input")?.focus();
  }

  /** Keys go to the page again, not to the field that is gone. */
  #close(): void {
    this.#dialog.close();
    this.#dialog.querySelector("input")?.blur();
  }

  #render(): void {
    const entries = this.#find(this.#typed);
    this.#at = Math.min(this.#at, Math.max(entries.length - 1, 0));
    const model = {
      typed: this.#typed,
      entries,
      at: this.#at,
      type: (typed: string) => {
        this.#typed = typed;
        this.#at = 0;
        this.#render();
      },
      move: (by: number) => {
        this.#at = (this.#at + by + entries.length) % Math.max(entries.length, 1);
        this.#render();
      },
      run: (entry: PaletteEntry) => {
        this.#close();
        entry.run();
      },
      close: () => this.#close(),
    };
    render(paletteTemplate(model), this.#dialog);
  }
}
