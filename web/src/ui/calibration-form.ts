// SPDX-License-Identifier: Apache-2.0
// The steps of setting up ears, hands and eyes, one at a time.
import { html, svg, type TemplateResult } from "lit";
import type { Person } from "../app/person";
import { mapColour } from "../present";

export const CALIBRATION_STEPS = ["level", "ears", "pitch", "touch", "colour", "try"] as const;
export type CalibrationStep = (typeof CALIBRATION_STEPS)[number];

export interface CalibrationModel {
  readonly step: CalibrationStep | null;
  readonly person: Person;
  readonly pair: number;
  readonly pairs: number;
  readonly pulse: number;
  readonly canFeel: boolean;
}

export interface CalibrationActions {
  start(): void;
  next(): void;
  stop(): void;
  playLevel(): void;
  setLevel(master: number): void;
  playEar(side: "left" | "right"): void;
  setMono(mono: boolean): void;
  playPair(): void;
  answer(said: "first" | "second"): void;
  playPulse(): void;
  feel(felt: boolean): void;
  choose(map: string): void;
  find(): void;
  forget(): void;
}

/** Offered where bands must be told apart: the default, one made for every colour vision, one between. */
const MAPS = ["batlow", "cividis", "viridis"] as const;
const BANDS = 9;

const push = (text: string, click: () => void) =>
  html`<button type="button" class="push" @click=${click}>${text}</button>`;

const strip = (map: string) =>
  svg`<svg class="strip" viewBox="0 0 ${BANDS} 1" preserveAspectRatio="none" aria-hidden="true">${Array.from(
    { length: BANDS },
    (_, i) =>
      svg`<rect x=${i} y="0" width="1.02" height="1" fill="rgb(${mapColour(map, i / (BANDS - 1)).join(" ")})"></rect>`,
  )}</svg>`;

function stepBody(model: CalibrationModel, actions: CalibrationActions): TemplateResult {
  switch (model.step) {
    case "level":
      return html`<p>Set the volume so that the softer of the two tones is just comfortable.</p>
        <label class="wide"><span>volume</span><input type="range" min="0" max="1" step="0.05" aria-label="volume while setting up"
          .value=${String(model.person.master)} @input=${(e: Event) => actions.setLevel(Number((e.target as HTMLInputElement).value))} /></label>
        <div class="row">${push("Play", () => actions.playLevel())}</div>`;
    case "ears":
      return html`<p>Does each side sound on its side? If not, or with one ear, take the same sound in both.</p>
        <div class="row">${push("Left", () => actions.playEar("left"))} ${push("Right", () => actions.playEar("right"))}
          <button type="button" class="push" aria-pressed=${model.person.mono ? "true" : "false"} @click=${() => actions.setMono(!model.person.mono)}>Same in both</button></div>`;
    case "pitch":
      return html`<p>Two tones, two per cent of the range apart: which is higher? <b>${model.pair} of ${model.pairs}</b></p>
        <div class="row">${push("Play both", () => actions.playPair())} ${push("The first", () => actions.answer("first"))} ${push("The second", () => actions.answer("second"))}</div>`;
    case "touch":
      return model.canFeel
        ? html`<p>Pulses that grow: say when you feel them. Now ${Math.round(100 * model.pulse)} %.</p>
          <div class="row">${push("Play", () => actions.playPulse())} ${push("Not felt", () => actions.feel(false))} ${push("I feel it", () => actions.feel(true))}</div>`
        : html`<p>Nothing here can shake: ticks stand in for pulses. In the headset the panel's tab <i>Set up</i> asks for the pulses.</p>`;
    case "colour":
      return html`<p>Take the strip whose nine fields you tell apart best.</p>
        <div class="strips">${MAPS.map((map) => html`<button type="button" class="strip-choice" @click=${() => actions.choose(map)}>${strip(map)}<span>${map}</span></button>`)}</div>`;
    default:
      return html`<p>Find the largest value by ear: press on the model and sweep; ticks are fastest at the top.</p>
        <div class="row">${push("Try it", () => actions.find())}</div>`;
  }
}

export function calibrationTemplate(model: CalibrationModel, actions: CalibrationActions): TemplateResult {
  const number = model.step ? CALIBRATION_STEPS.indexOf(model.step) + 1 : 0;
  if (!model.step)
    return html`<p class="hint">A minute and a half, kept on this device; each step can be left out.</p>
      <div class="row">${push("Begin", () => actions.start())} ${
        model.person.wide || model.person.weakest !== null ? push("Forget it", () => actions.forget()) : null
      }</div>`;
  return html`<div class="calibration" data-step=${model.step}><p class="hint">step ${number} of ${CALIBRATION_STEPS.length}</p>
    ${stepBody(model, actions)}
    <div class="row ways">${push(number < CALIBRATION_STEPS.length ? "Next" : "Done", () => actions.next())} ${push("Stop", () => actions.stop())}</div></div>`;
}
