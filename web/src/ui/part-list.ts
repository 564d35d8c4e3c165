// SPDX-License-Identifier: Apache-2.0
// The parts of the model: shown, clear or hidden, one by one or one alone.
import { html, type TemplateResult } from "lit";
import { icon } from "./icons";

export interface PartRow {
  readonly id: number;
  readonly name: string;
  readonly kind: string;
  readonly triangles: number;
  readonly hidden: boolean;
  readonly clear: boolean;
}

export interface PartListActions {
  show(id: number, on: boolean): void;
  clear(id: number, on: boolean): void;
  isolate(id: number): void;
  showAll(): void;
}

export function partListTemplate(parts: readonly PartRow[], actions: PartListActions): TemplateResult {
  const touched = parts.some((p) => p.hidden || p.clear);
  return html`<ul class="parts">
      ${parts.map(
        (part) => html`<li data-part=${part.id} class=${part.hidden ? "gone" : ""}>
          <button type="button" class="cell" aria-pressed=${part.hidden ? "false" : "true"} title=${part.hidden ? "show" : "hide"}
            aria-label="show ${part.name}" @click=${() => actions.show(part.id, part.hidden)}>${icon("eye")}</button>
          <span class="part-name">${part.name}<small>${part.kind} · ${part.triangles.toLocaleString("en")} triangles</small></span>
          <button type="button" class="cell" aria-pressed=${part.clear ? "true" : "false"} title="see through it" ?disabled=${part.hidden}
            aria-label="see through ${part.name}" @click=${() => actions.clear(part.id, !part.clear)}>${icon("glass")}</button>
          <button type="button" class="cell" title="this part alone" ?disabled=${parts.length < 2}
            aria-label="only ${part.name}" @click=${() => actions.isolate(part.id)}>${icon("target")}</button>
        </li>`,
      )}
    </ul>
    <div class="row"><button type="button" class="push" ?disabled=${!touched} @click=${() => actions.showAll()}>Show everything</button></div>`;
}
