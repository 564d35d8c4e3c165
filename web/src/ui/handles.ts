// SPDX-License-Identifier: Apache-2.0
// Knobs that stand on the model and are dragged.
import { html, type TemplateResult } from "lit";

export interface Handle {
  readonly id: string;
  readonly label: string;
  /** Canvas pixels. */
  readonly x: number;
  readonly y: number;
  /** Pixels since it was taken. */
  readonly drag: (dx: number, dy: number) => void;
}

/** What a drag started with stays in force until it ends, though the knob is drawn anew meanwhile. */
function take(event: PointerEvent, handle: Handle): void {
  const knob = event.currentTarget as HTMLElement;
  const [x, y] = [event.clientX, event.clientY];
  knob.setPointerCapture(event.pointerId);
  const move = (e: PointerEvent) => handle.drag(e.clientX - x, e.clientY - y);
  const end = () => {
    knob.removeEventListener("pointermove", move);
    knob.removeEventListener("pointerup", end);
    knob.removeEventListener("pointercancel", end);
  };
  knob.addEventListener("pointermove", move);
  knob.addEventListener("pointerup", end);
  knob.addEventListener("pointercancel", end);
}

export function handlesTemplate(handles: readonly Handle[]): TemplateResult {
  return html`${handles.map(
    (handle) => html`<div class="handle" data-handle=${handle.id} title=${handle.label}
      .style=${`transform: translate(${handle.x.toFixed(1)}px, ${handle.y.toFixed(1)}px)`}
      @pointerdown=${(e: PointerEvent) => take(e, handle)}></div>`,
  )}`;
}
