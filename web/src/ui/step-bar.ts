// SPDX-License-Identifier: Apache-2.0
// Steps and modes with play, and the deformation with its factor.
import { html, type TemplateResult } from "lit";
import type { DeformMode } from "../app/store";
import type { SceneStep } from "../scene";
import type { Actions } from "./actions";
import { numberText, stepText } from "./format";
import { icon } from "./icons";

export interface StepBarModel {
  readonly steps: readonly SceneStep[];
  readonly step: number;
  readonly playing: boolean;
  readonly canPlay: boolean;
  readonly deformMode: DeformMode;
  readonly factor: number;
  readonly automaticFactor: number;
  readonly hasShape: boolean;
}

const MODES: readonly [DeformMode, string, string][] = [
  ["off", "undeformed", "draw the model as it was"],
  ["true", "true scale", "draw displacements as they are (1)"],
  ["auto", "5 %", "largest displacement = 5 % of the largest side"],
];

function deformTemplate(model: StepBarModel, actions: Actions): TemplateResult {
  const typed = (event: Event) => {
    const field = event.target as HTMLInputElement;
    const value = Number(field.value.trim().replace(",", "."));
    if (field.value.trim() !== "" && Number.isFinite(value)) actions.setDeform("factor", value);
    else field.value = numberText(model.factor, 4);
  };
  return html`<div class="deform" role="group" aria-label="Deformation">
    <span class="label">Deformation</span>
    <div class="segments">${MODES.map(
      ([
        mode,
        word,
        title,
      ]) => html`<button type="button" aria-pressed=${model.deformMode === mode ? "true" : "false"}
        ?disabled=${!model.hasShape} title=${title} @click=${() => actions.setDeform(mode)}>${word}</button>`,
    )}</div>
    <label class="factor" title="deformation factor"><span aria-hidden="true">×</span
      ><input class="number" inputmode="decimal" aria-label="deformation factor" ?disabled=${!model.hasShape}
        .value=${numberText(model.factor, 4)} @change=${typed} /></label>
  </div>`;
}

export function stepBarTemplate(model: StepBarModel, actions: Actions): TemplateResult {
  const index = model.steps.findIndex((s) => s.id === model.step);
  const many = model.steps.length > 1;
  return html`<footer class="stepbar" aria-label="Steps">
    <div class="steps" role="group" aria-label="Step" ?hidden=${model.steps.length === 0}>
      <button type="button" class="tool" aria-label="previous step" title="previous step  ," ?disabled=${!many} @click=${() => actions.stepBy(-1)}>${icon("back")}</button>
      <button type="button" class="tool play" aria-label=${model.playing ? "pause" : "play"} title="play  Space"
        aria-pressed=${model.playing ? "true" : "false"} ?disabled=${!model.canPlay} @click=${() => actions.togglePlay()}>${icon(model.playing ? "pause" : "play")}</button>
      <button type="button" class="tool" aria-label="next step" title="next step  ." ?disabled=${!many} @click=${() => actions.stepBy(1)}>${icon("next")}</button>
      <select class="step-select" aria-label="step" @change=${(e: Event) => actions.setStep(Number((e.target as HTMLSelectElement).value))}>
        ${model.steps.map((s) => html`<option value=${s.id} ?selected=${s.id === model.step}>${stepText(s)}</option>`)}
      </select>
      ${
        many
          ? html`<input class="step-slider" type="range" min="0" max=${model.steps.length - 1} step="1" .value=${String(index)}
              aria-label="step" @input=${(e: Event) => actions.setStep(model.steps[Number((e.target as HTMLInputElement).value)]?.id ?? model.step)} />`
          : null
      }
    </div>
    ${deformTemplate(model, actions)}
  </footer>`;
}
