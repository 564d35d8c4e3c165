// SPDX-License-Identifier: Apache-2.0
// What sound and touch mean, and how the person wants them.
import { html, type TemplateResult } from "lit";
import type { Person } from "../app/person";

export interface ListeningModel {
  readonly person: Person;
  readonly guide: boolean;
  /** Legends that can be played, with the result each is of. */
  readonly legends: readonly { readonly id: string; readonly text: string; readonly play: () => void }[];
  readonly change: (change: Partial<Person>) => void;
  readonly toggleGuide: () => void;
}

export function listeningTemplate(model: ListeningModel): TemplateResult {
  const { person, change } = model;
  const check = (key: "mono" | "captions" | "leftHanded", text: string) =>
    html`<label class="check"><input type="checkbox" .checked=${person[key]} @change=${(e: Event) => change({ [key]: (e.target as HTMLInputElement).checked })} />${text}</label>`;
  const slider = (key: "master" | "strength", text: string, most: number) =>
    html`<label class="wide"><span>${text}</span><input type="range" min="0" max=${most} step="0.05" aria-label=${text} .value=${String(person[key])}
      @input=${(e: Event) => change({ [key]: Number((e.target as HTMLInputElement).value) })} /></label>`;
  return html`<div class="row">${model.legends.map((l) => html`<button type="button" class="push" data-legend=${l.id} @click=${l.play}>${l.text}</button>`)}
      <button type="button" class="push" aria-pressed=${model.guide ? "true" : "false"} @click=${() => model.toggleGuide()}>Find the largest by ear</button></div>
    <div class="fields listening">
      ${slider("master", "volume", 1)} ${slider("strength", "vibration", 1.5)}
      ${check("mono", "same sound in both ears")} ${check("captions", "captions of what sounds")} ${check("leftHanded", "left-handed")}
    </div>`;
}
