// SPDX-License-Identifier: Apache-2.0
// Title and size of the model, going to an id, switches of the view, the way into the headset.
import { html, type TemplateResult } from "lit";
import type { ViewState } from "../app/store";
import type { Actions } from "./actions";
import { unitText } from "./format";
import { type IconName, icon } from "./icons";

export interface TopBarModel {
  readonly title: string;
  readonly triangles: number;
  readonly lengthUnit: string | null;
  readonly state: ViewState;
  readonly vr: "yes" | "no" | "unknown";
  readonly vrHint: string;
}

function toggle(name: IconName, word: string, key: string, on: boolean, click: () => void): TemplateResult {
  return html`<button type="button" class="tool" aria-pressed=${on ? "true" : "false"} aria-label=${word} title="${word}  ${key}" @click=${click}>${icon(name)}</button>`;
}

function search(actions: Actions): TemplateResult {
  const submit = (event: Event) => {
    event.preventDefault();
    const form = event.target as HTMLFormElement;
    const kind = (form.elements.namedItem("kind") as HTMLSelectElement).value;
    const id = Number((form.elements.namedItem("id") as HTMLInputElement).value.trim());
    if (Number.isInteger(id) && id > 0) actions.goTo(kind === "element" ? "element" : "node", id);
  };
  return html`<form class="goto" role="search" @submit=${submit}>
    <select name="kind" aria-label="what to go to"><option value="node">node</option><option value="element">element</option></select>
    <input name="id" class="number" inputmode="numeric" placeholder="id" aria-label="id to go to" autocomplete="off" />
    <button type="submit" class="tool" aria-label="go to" title="go to  G">${icon("search")}</button>
  </form>`;
}

export function topBarTemplate(model: TopBarModel, actions: Actions): TemplateResult {
  const { state } = model;
  const unit = model.lengthUnit
    ? unitText(model.lengthUnit)
    : "length unit unknown: size on screen is not true";
  return html`<header class="topbar">
    <span class="mark" aria-hidden="true"><i></i><i></i><i></i></span>
    <div class="title"><h1>${model.title}</h1><p>${model.triangles.toLocaleString("en")} triangles · ${unit}</p></div>
    ${search(actions)}
    <button type="button" class="tool" aria-label="commands" title="commands  Ctrl K" @click=${() => actions.openPalette()}>${icon("prompt")}</button>
    <div class="tools" role="group" aria-label="View">
      <button type="button" class="tool" aria-label="fit" title="fit  F" @click=${() => actions.fit()}>${icon("fit")}</button>
      ${toggle("mesh", "element edges", "E", state.edges, () => actions.toggle("edges"))}
      ${toggle("pins", "largest and smallest value", "X", state.extremes, () => actions.toggle("extremes"))}
      ${toggle("lamp", "shading", "L", state.shading, () => actions.toggle("shading"))}
      ${toggle(state.sound ? "sound" : "mute", "sound", "M", state.sound, () => actions.toggle("sound"))}
      ${toggle("hand", "touch", "V", state.touch, () => actions.toggle("touch"))}
      <button type="button" class="tool" aria-label="colours of the page: ${state.theme}" title="dark or light  T" @click=${() => actions.cycleTheme()}>${icon("theme")}</button>
    </div>
    <button type="button" class="vr" ?disabled=${model.vr !== "yes"} title=${model.vrHint} @click=${() => actions.enterVr()}>${icon("headset")}<span>Enter VR</span></button>
  </header>`;
}
