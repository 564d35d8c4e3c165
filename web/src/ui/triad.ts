// SPDX-License-Identifier: Apache-2.0
// The model's axes as the camera sees them; each end is a standard view.
import { html, svg, type TemplateResult } from "lit";
import { type Matrix4, type PerspectiveCamera, Vector3 } from "three";
import type { Actions, ViewName } from "./actions";

const AXES: readonly { name: "x" | "y" | "z"; direction: readonly [number, number, number] }[] = [
  { name: "x", direction: [1, 0, 0] },
  { name: "y", direction: [0, 1, 0] },
  { name: "z", direction: [0, 0, 1] },
];
const SIZE = 36;

/** Direction in world axes of a direction of the model; unit length. */
export function modelDirection(matrix: Matrix4, direction: readonly [number, number, number]): Vector3 {
  return new Vector3(...direction).transformDirection(matrix);
}

export function triadTemplate(camera: PerspectiveCamera, matrix: Matrix4, actions: Actions): TemplateResult {
  const ends = AXES.flatMap(({ name, direction }) => {
    const seen = modelDirection(matrix, direction).transformDirection(camera.matrixWorldInverse);
    return [1, -1].map((sign) => ({
      name,
      sign,
      x: seen.x * sign * SIZE,
      y: -seen.y * sign * SIZE,
      z: seen.z * sign,
    }));
  }).sort((a, b) => a.z - b.z);
  return html`<div class="triad" role="group" aria-label="Standard views">
    <svg viewBox="-52 -52 104 104">
      ${ends.map(({ name, sign, x, y }) => {
        const view = `${sign > 0 ? "+" : "-"}${name}` as ViewName;
        return svg`<g class="axis axis-${name} ${sign > 0 ? "plus" : "minus"}" role="button" tabindex="0" aria-label="view from ${view}"
            @click=${() => actions.view(view)} @keydown=${(e: KeyboardEvent) => e.key === "Enter" && actions.view(view)}>
          ${sign > 0 ? svg`<line x1="0" y1="0" x2=${x} y2=${y}></line>` : null}
          <circle cx=${x} cy=${y} r=${sign > 0 ? 9 : 6}></circle>
          ${sign > 0 ? svg`<text x=${x} y=${y + 3.6}>${name}</text>` : null}
        </g>`;
      })}
      <g role="button" tabindex="0" class="axis home" aria-label="view from a corner" @click=${() => actions.view("iso")}
        @keydown=${(e: KeyboardEvent) => e.key === "Enter" && actions.view("iso")}><circle r="5"></circle></g>
    </svg>
  </div>`;
}
