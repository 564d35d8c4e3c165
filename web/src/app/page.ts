// SPDX-License-Identifier: Apache-2.0
// The areas of the page, and rendering of state into them.
import { html, render } from "lit";
import type { Matrix4 } from "three";
import type { KeyCommand } from "../input/keyboard";
import type { Stage } from "../render";
import {
  type Actions,
  type CardModel,
  cardSentence,
  cardTemplate,
  type Handle,
  handlesTemplate,
  type LegendModel,
  legendTemplate,
  type Marker,
  markersTemplate,
  type PlaceChoice,
  paintLegend,
  placeMenuTemplate,
  readingTemplate,
  resultTableTemplate,
  type Section,
  type StepBarModel,
  sectionsTemplate,
  stepBarTemplate,
  type TableModel,
  type TopBarModel,
  topBarTemplate,
  triadTemplate,
} from "../ui";

import type { Reading } from "./opening";
import { PaletteView } from "./palette-view";

/** Speech follows at most twice a second. */
const SAY_EVERY_MS = 500;

function area(name: string, host: HTMLElement): HTMLElement {
  const element = document.createElement("div");
  element.className = `area-${name}`;
  host.append(element);
  return element;
}

function child(className: string, host: HTMLElement): HTMLElement {
  const element = document.createElement("div");
  element.className = className;
  host.append(element);
  return element;
}

export class Page {
  readonly stageHost: HTMLElement;
  readonly palette: PaletteView;
  readonly #top: HTMLElement;
  readonly #left: HTMLElement;
  readonly #right: HTMLElement;
  readonly #bottom: HTMLElement;
  readonly #markers: HTMLElement;
  readonly #triad: HTMLElement;
  readonly #card: HTMLElement;
  readonly #banner: HTMLElement;
  readonly #handles: HTMLElement;
  readonly #inside: HTMLElement;
  readonly #toast: HTMLElement;
  readonly #placeMenu: HTMLElement;
  #toastTimer = 0;
  readonly #said: HTMLElement;
  #sayTimer = 0;
  #toSay = "";

  constructor(host: HTMLElement) {
    host.replaceChildren();
    this.palette = new PaletteView(host);
    this.#top = area("top", host);
    this.#left = area("left", host);
    this.stageHost = area("stage", host);
    this.#right = area("right", host);
    this.#bottom = area("bottom", host);
    const overlay = child("overlay", this.stageHost);
    this.#markers = child("markers", overlay);
    this.#triad = child("triad-host", overlay);
    this.#card = child("card", overlay);
    this.#card.hidden = true;
    this.#handles = child("handles", overlay);
    this.#banner = child("banners", overlay);
    this.#inside = child("card inside", overlay);
    this.#inside.hidden = true;
    this.#toast = child("toast", overlay);
    this.#toast.hidden = true;
    this.#placeMenu = child("place-menu", overlay);
    this.#placeMenu.hidden = true;
    this.#said = child("said", host);
    this.#said.setAttribute("role", "status");
    this.#said.setAttribute("aria-live", "polite");
  }

  renderTop(model: TopBarModel, actions: Actions): void {
    render(topBarTemplate(model, actions), this.#top);
  }

  renderLeft(
    model: TableModel,
    sections: readonly Section[],
    open: readonly string[],
    keys: readonly KeyCommand[],
    actions: Actions,
  ): void {
    render(
      html`${resultTableTemplate(model, actions)}
        ${sectionsTemplate(sections, open, (id, on) => actions.openSection(id, on))}
        <details class="help"><summary>Mouse and keys</summary><dl>
          <dt>Point at the model</dt><dd>read every value there</dd>
          <dt>Press on the model</dt><dd>hear and feel; drag to sweep</dd>
          <dt>Drag beside it, middle button</dt><dd>turn</dd>
          <dt>Right drag, wheel</dt><dd>move, zoom</dd>
          ${keys.map((k) => html`<dt><kbd>${k.shown}</kbd></dt><dd>${k.text}</dd>`)}
        </dl></details>`,
      this.#left,
    );
  }

  renderLegend(model: LegendModel | null, reading: Reading | null, actions: Actions): void {
    render(legendTemplate(model, reading, actions), this.#right);
    const canvas = this.#right.querySelector("canvas");
    if (model && canvas) paintLegend(canvas, model.palette);
  }

  renderBottom(model: StepBarModel, actions: Actions): void {
    render(stepBarTemplate(model, actions), this.#bottom);
  }

  renderTriad(stage: Stage, matrix: Matrix4, actions: Actions): void {
    render(triadTemplate(stage.camera, matrix, actions), this.#triad);
  }

  renderHandles(handles: readonly Handle[]): void {
    render(handlesTemplate(handles), this.#handles);
  }

  renderMarkers(markers: readonly Marker[]): void {
    render(markersTemplate(markers), this.#markers);
  }

  renderBanner(problem: string | null, reading: Reading | null, actions: Actions): void {
    render(
      html`${reading ? readingTemplate(reading) : null}
      ${problem ? html`<div class="banner" role="alert"><span>${problem}</span><button type="button" class="plain" @click=${() => actions.dismissProblem()}>close</button></div>` : null}`,
      this.#banner,
    );
  }

  /** The card beside a place of the stage, kept inside it; null hides it. */
  renderCard(model: CardModel | null, at: { x: number; y: number } | null, unpin: () => void): void {
    this.#card.hidden = !model || !at;
    if (!model || !at) return;
    render(cardTemplate(model, unpin), this.#card);
    this.#card.classList.toggle("pinned", model.pinned);
    this.#card.classList.toggle(
      "alarmed",
      model.rows.some((row) => row.alarm !== null),
    );
    const { clientWidth, clientHeight } = this.stageHost;
    const { offsetWidth, offsetHeight } = this.#card;
    const inside = (v: number, size: number, room: number) =>
      Math.min(Math.max(4, v), Math.max(4, room - size - 4));
    const narrow = clientWidth < 2 * offsetWidth;
    const right = at.x + 24 + offsetWidth < clientWidth;
    const beside = right ? at.x + 20 : at.x - 20 - offsetWidth;
    const above = at.y - offsetHeight - 28;
    const x = inside(narrow ? at.x - offsetWidth / 2 : beside, offsetWidth, clientWidth);
    const y = inside(
      narrow ? (above > 0 ? above : at.y + 28) : at.y - offsetHeight / 3,
      offsetHeight,
      clientHeight,
    );
    this.#place(this.#card, x, y);
    this.say(cardSentence(model));
  }

  /** Small screens have a place of their own for it. */
  #place({ style }: HTMLElement, x: number, y: number): void {
    style.setProperty("--x", `${Math.round(x)}px`);
    style.setProperty("--y", `${Math.round(y)}px`);
  }

  /** The pointer is on the inside that a cut has opened. */
  renderInside(at: { x: number; y: number } | null, text: string): void {
    this.#inside.hidden = !at;
    if (!at) return;
    this.#inside.textContent = text;
    const x = Math.min(at.x + 18, Math.max(4, this.stageHost.clientWidth - this.#inside.offsetWidth - 4));
    this.#place(this.#inside, x, at.y + 14);
    this.say(text);
  }

  /** What can be done at a place of the stage, beside it; null: nothing is asked. */
  renderPlaceMenu(title: string, choices: readonly PlaceChoice[], at: { x: number; y: number } | null): void {
    this.#placeMenu.hidden = !at;
    if (!at) return;
    render(placeMenuTemplate(title, choices), this.#placeMenu);
    const { clientWidth, clientHeight } = this.stageHost;
    const { offsetWidth, offsetHeight } = this.#placeMenu;
    const x = Math.min(Math.max(4, at.x + 28), Math.max(4, clientWidth - offsetWidth - 4));
    const y = Math.min(Math.max(4, at.y - offsetHeight / 2), Math.max(4, clientHeight - offsetHeight - 4));
    this.#placeMenu.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  /** A word that goes away by itself. */
  toast(text: string): void {
    this.#toast.textContent = text;
    this.#toast.hidden = false;
    this.say(text);
    clearTimeout(this.#toastTimer);
    this.#toastTimer = window.setTimeout(() => {
      this.#toast.hidden = true;
    }, 3500);
  }

  /** There is no scene to show. */
  showFailure(text: string): void {
    render(html`<div class="banner" role="alert"><span>${text}</span></div>`, this.#banner);
  }

  say(sentence: string): void {
    this.#toSay = sentence;
    if (this.#sayTimer) return;
    this.#sayTimer = window.setTimeout(() => {
      this.#sayTimer = 0;
      if (this.#said.textContent !== this.#toSay) this.#said.textContent = this.#toSay;
    }, SAY_EVERY_MS);
  }
}
