// SPDX-License-Identifier: Apache-2.0
// Inside the solids, when the server has them: the value at a typed place, and the surface of equal value.
import type { InteriorAnswer } from "../../probe";
import type { InsideMesh } from "../../render";
import {
  type InsideActions,
  insideTemplate,
  numberText,
  type PanelPage,
  type Section,
  unitText,
  withoutResults,
} from "../../ui";
import type { App } from "../app";
import { InsideClient, isGivenUp } from "../inside-client";
import { askedFields, ownersOf, subjectOf } from "../inside-subject";
import type { Feature } from "./feature";

/** A value that has not changed for so long is asked for. */
const REST = 150;
/** One press of the panel's buttons, as a share of the range. */
const NUDGE = 0.05;

const UNDER_SKIN = "It lies under the skin: see through it, or cut it.";

type SurfaceState = "off" | "waiting" | "shown" | "none";

export class Inside implements Feature, InsideActions {
  readonly id = "inside";
  readonly #app: App;
  readonly #client: InsideClient | null;
  #place: [string, string, string] = ["", "", ""];
  #answer: InteriorAnswer | null = null;
  #said = "";
  #wanted = false;
  /** Null: the middle of the range. */
  #level: number | null = null;
  #key = "";
  #timer = 0;
  #mesh: InsideMesh | null = null;
  #state: SurfaceState = "off";
  #text = "";
  #area = 0;

  constructor(app: App) {
    this.#app = app;
    this.#client = app.served ? InsideClient.find(app.view.scene.extras.origin ?? [0, 0, 0]) : null;
    if (!this.#client) return;
    app.atEnd(app.stage.onFrame(() => this.#check()));
    app.atEnd(() => this.#clear());
  }

  // --- a place

  type(axis: number, text: string): void {
    this.#place[axis] = text;
  }

  read(): void {
    void this.#read();
  }

  async #read(): Promise<void> {
    const at = this.#place.map((text) => (text.trim() === "" ? Number.NaN : Number(text.replace(",", "."))));
    if (at.some((v) => !Number.isFinite(v))) return this.#say("Type three numbers: x, y and z.", null);
    const { reading } = this.#app.store.state;
    if (reading) return this.#say(withoutResults(reading), null);
    try {
      const fields = askedFields(this.#app);
      const answer = await this.#client?.point("typed", at, fields, this.#app.store.state.step, null);
      if (!answer) return;
      if (answer.elementId === null) return this.#say("There is no volume element at this place.", null);
      const node = answer.nodeId === null ? "" : `; node ${answer.nodeId} counts most`;
      this.#say(`Interior value, element ${answer.elementId} (${answer.elementType})${node}.`, answer);
    } catch (error) {
      if (!isGivenUp(error)) this.#say(error instanceof Error ? error.message : String(error), null);
    }
  }

  #say(text: string, answer: InteriorAnswer | null): void {
    this.#said = text;
    this.#answer = answer;
    this.#app.refreshPage();
  }

  // --- a surface

  toggleSurface(): void {
    this.#wanted = !this.#wanted;
    this.#app.refreshPage();
  }

  setLevel(value: number): void {
    this.#level = value;
    this.#app.refreshPage();
  }

  toggleSeeThrough(): void {
    const { store, view } = this.#app;
    const all = view.scene.parts.map((part) => part.index);
    store.set({ clear: this.#seeThrough ? [] : all });
  }

  get #seeThrough(): boolean {
    const { clear } = this.#app.store.state;
    return this.#app.view.scene.parts.every((part) => clear.includes(part.index));
  }

  #range(): { lo: number; hi: number } {
    const range = this.#app.view.shownAs("colour")?.range;
    return { lo: range?.lo ?? 0, hi: range?.hi ?? 1 };
  }

  get #value(): number {
    const { lo, hi } = this.#range();
    return this.#level ?? (lo + hi) / 2;
  }

  #clear(): void {
    clearTimeout(this.#timer);
    this.#client?.giveUp("surface");
    this.#mesh?.remove();
    this.#mesh = null;
  }

  #check(): void {
    const subject = this.#wanted ? subjectOf(this.#app, "Surface") : null;
    let key = "";
    if (subject && "reason" in subject) key = `none ${subject.reason}`;
    else if (subject) key = JSON.stringify([subject.field, this.#value, subject.step, subject.shape]);
    if (key === this.#key) return;
    this.#key = key;
    this.#clear();
    this.#state = !subject ? "off" : "reason" in subject ? "none" : "waiting";
    this.#text = subject && "reason" in subject ? subject.reason : "Surface not yet computed.";
    if (this.#state === "waiting") this.#timer = window.setTimeout(() => void this.#ask(key), REST);
    this.#app.refreshPage();
  }

  async #ask(key: string): Promise<void> {
    const subject = subjectOf(this.#app, "Surface");
    if ("reason" in subject || !this.#client) return;
    const { field, step, shape } = subject;
    try {
      const data = await this.#client.surface("surface", field, this.#value, step, shape);
      if (key !== this.#key) return;
      const owners = ownersOf(this.#app, data);
      this.#mesh = this.#app.view.model.addInside({ ...data, owners, normal: null });
      this.#state = "shown";
      this.#area = data.area;
      const unit = unitText(this.#app.view.scene.extras.lengthUnit?.name);
      const size = `${numberText(data.area, 5)}${unit ? ` ${unit}²` : ""}`;
      this.#text =
        data.elements === 0
          ? "No volume element has this value inside."
          : `Through ${data.elements} elements, ${size}.`;
    } catch (error) {
      if (isGivenUp(error) || key !== this.#key) return;
      this.#state = "none";
      this.#text = `No surface: ${error instanceof Error ? error.message : String(error)}`;
    }
    this.#app.refreshPage();
  }

  // --- what it looks like

  #found() {
    if (this.#said === "") return null;
    const rows = this.#app.view.shown.flatMap(({ key, label, unit }) => {
      const read = this.#answer?.values.get(key);
      return read ? [{ label, unit, ...read }] : [];
    });
    return { text: this.#said, rows };
  }

  section(): Section | null {
    if (!this.#client || !this.#app.view.scene.parts.some((part) => part.info.kind === "solid")) return null;
    const shown = this.#app.view.shownAs("colour");
    const summary = this.#wanted ? `surface at ${numberText(this.#value)}` : "value, surface";
    const model = () => ({
      lengthUnit: this.#app.view.scene.extras.lengthUnit?.name ?? null,
      place: this.#place,
      found: this.#found(),
      surface: {
        on: this.#wanted,
        label: shown?.label ?? "",
        unit: shown?.unit ?? null,
        value: this.#value,
        ...this.#range(),
        text: this.#state === "shown" && !this.#seeThrough ? `${this.#text} ${UNDER_SKIN}` : this.#text,
      },
      seeThrough: this.#seeThrough,
    });
    return { id: this.id, title: "Inside", summary, body: () => insideTemplate(model(), this) };
  }

  page(): PanelPage | null {
    if (!this.section()) return null;
    const shown = this.#app.view.shownAs("colour");
    const { lo, hi } = this.#range();
    const nudge = (share: number) => this.setLevel(this.#value + share * (hi - lo));
    const value = `${numberText(this.#value)} ${unitText(shown?.unit ?? null)}`.trim();
    const rows = [
      {
        text: "Surface of equal value",
        detail: value,
        buttons: [
          {
            id: "on",
            text: this.#wanted ? "On" : "Off",
            on: this.#wanted,
            press: () => this.toggleSurface(),
          },
          ...[-NUDGE, NUDGE].map((share) => ({
            id: `by:${share}`,
            text: `${share > 0 ? "+" : "−"} ${100 * NUDGE} %`,
            enabled: this.#wanted,
            press: () => nudge(share),
          })),
        ],
      },
      {
        text: "Skin",
        buttons: [
          { id: "through", text: "See through", on: this.#seeThrough, press: () => this.toggleSeeThrough() },
        ],
      },
      { text: this.#wanted ? this.#text : "", buttons: [] },
    ];
    return { id: this.id, title: "Inside", rows };
  }

  commands() {
    if (!this.#client) return [];
    return [
      {
        keys: ["8"],
        shown: "8",
        text: "surface of equal value, inside the solids",
        down: () => this.toggleSurface(),
      },
    ];
  }

  report() {
    if (!this.#client) return { inside: null };
    const values = this.#answer && Object.fromEntries(this.#answer.values);
    const place = this.#answer && { element: this.#answer.elementId, node: this.#answer.nodeId, values };
    const surface = { state: this.#state, value: this.#value, area: this.#area, text: this.#text };
    return { inside: { place, surface } };
  }
}
