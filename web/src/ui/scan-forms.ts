// SPDX-License-Identifier: Apache-2.0
// Listening along a path and through the model.
import { html, type TemplateResult } from "lit";

export interface PathModel {
  readonly nodes: readonly number[];
  readonly length: string;
  readonly seconds: number;
  readonly paces: readonly number[];
  readonly playing: boolean;
  readonly ready: boolean;
}

export interface PathActions {
  add(): void;
  clear(): void;
  play(): void;
  setSeconds(seconds: number): void;
}

export function pathTemplate(model: PathModel, actions: PathActions): TemplateResult {
  const way = model.nodes.length > 0 ? model.nodes.join(" – ") : "no node yet";
  return html`<p class="ruler"><span>${way}</span><span>${model.length}</span></p>
    <div class="row">
      <button type="button" class="push" @click=${() => actions.add()}>Add this node</button>
      <button type="button" class="push" aria-pressed=${model.playing ? "true" : "false"} ?disabled=${!model.ready}
        @click=${() => actions.play()}>${model.playing ? "Stop" : "Listen"}</button>
      <button type="button" class="push" ?disabled=${model.nodes.length === 0} @click=${() => actions.clear()}>Clear</button>
    </div>
    <div class="row"><span class="hint">seconds</span><div class="segments" role="group" aria-label="seconds of the walk">${model.paces.map(
      (pace) =>
        html`<button type="button" aria-pressed=${pace === model.seconds ? "true" : "false"} @click=${() => actions.setSeconds(pace)}>${pace}</button>`,
    )}</div></div>
    <p class="hint">Press or go to a node, add it, go to the next. The way leads along edges of elements; what is under the marker is heard and felt.</p>`;
}

export interface SweepModel<Axis extends string> {
  readonly axis: Axis;
  readonly axes: readonly Axis[];
  readonly backwards: boolean;
  readonly playing: boolean;
  /** Result that is heard. */
  readonly what: string;
}

export interface SweepActions<Axis extends string> {
  play(): void;
  setAxis(axis: Axis): void;
  toggleBackwards(): void;
}

export function sweepTemplate<Axis extends string>(
  model: SweepModel<Axis>,
  actions: SweepActions<Axis>,
): TemplateResult {
  return html`<div class="row">
      <div class="segments" role="group" aria-label="axis of the sweep">${model.axes.map(
        (axis) =>
          html`<button type="button" aria-pressed=${axis === model.axis ? "true" : "false"} @click=${() => actions.setAxis(axis)}>${axis}</button>`,
      )}</div>
      <button type="button" class="push" aria-pressed=${model.backwards ? "true" : "false"} @click=${() => actions.toggleBackwards()}>backwards</button>
      <button type="button" class="push" aria-pressed=${model.playing ? "true" : "false"} ?disabled=${model.what === ""} @click=${() => actions.play()}>Listen</button>
    </div>
    <p class="hint">${model.what ? `${model.what}: ` : ""}the tone is the largest value of each slab, the quiet sine beside it the mean over its area.</p>`;
}

export interface BeaconModel {
  readonly on: boolean;
  /** "1: 873 MPa" */
  readonly spot: string;
  /** Where it is; empty while off. */
  readonly words: string;
}

export function beaconTemplate(
  model: BeaconModel,
  actions: { toggle(): void; next(): void },
): TemplateResult {
  return html`<div class="row">
      <button type="button" class="push" aria-pressed=${model.on ? "true" : "false"} @click=${() => actions.toggle()}>Beacon ${model.on ? "on" : "off"}</button>
      <button type="button" class="push" @click=${() => actions.next()}>Next hot spot</button>
    </div>
    <p class="ruler"><span>hot spot ${model.spot}</span><span>${model.words}</span></p>
    <p class="hint">Ticks come from where the hot spot is, also from behind; they are the faster the nearer you point at it.</p>`;
}
