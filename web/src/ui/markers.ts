// SPDX-License-Identifier: Apache-2.0
// Labels that stand at places of the model: largest and smallest value, the pinned place.
import { html, type TemplateResult } from "lit";

export interface Marker {
  readonly kind: "max" | "min" | "pin" | "reticle" | "hot" | "note" | "ruler";
  readonly text: string;
  readonly detail: string;
  readonly x: number;
  readonly y: number;
  /** Behind the model as it is drawn: shown weaker. */
  readonly hidden: boolean;
  /** The label stands to the left: there is no room on the right. */
  readonly flipped: boolean;
  readonly click: (() => void) | null;
}

export function markersTemplate(markers: readonly Marker[]): TemplateResult {
  return html`${markers.map(
    (
      m,
    ) => html`<div class="marker marker-${m.kind} ${m.hidden ? "hidden-behind" : ""} ${m.flipped ? "flipped" : ""}"
      .style=${`transform: translate(${m.x.toFixed(1)}px, ${m.y.toFixed(1)}px)`}>
      <i></i>${
        m.text === ""
          ? null
          : html`<button type="button" tabindex="-1" @click=${m.click ?? (() => undefined)}><b>${m.text}</b>${m.detail ? html`<span>${m.detail}</span>` : null}</button>`
      }
    </div>`,
  )}`;
}
