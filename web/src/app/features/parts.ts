// SPDX-License-Identifier: Apache-2.0
// Parts: shown, clear or hidden, for the eye and for the ray alike.
import type { PartLook } from "../../render";
import { type PanelPage, type PartRow, partListTemplate, type Section } from "../../ui";
import type { App } from "../app";
import type { ViewState } from "../store";
import type { Feature } from "./feature";

type Looks = Pick<ViewState, "hidden" | "clear">;

export function lookOf(state: Looks, id: number): PartLook {
  if (state.hidden.includes(id)) return "hidden";
  return state.clear.includes(id) ? "clear" : "shown";
}

export function withPart(list: readonly number[], id: number, on: boolean): readonly number[] {
  return on ? [...list.filter((x) => x !== id), id].sort((a, b) => a - b) : list.filter((x) => x !== id);
}

export class Parts implements Feature {
  readonly id = "parts";
  readonly #app: App;

  constructor(app: App) {
    this.#app = app;
    app.store.subscribe((state, before) => {
      if (state.hidden !== before.hidden || state.clear !== before.clear) this.apply();
    });
  }

  apply(): void {
    const { view, store } = this.#app;
    const looks = view.scene.parts.map((part) => lookOf(store.state, part.index));
    view.model.setLooks(looks);
    view.picker.setLooks(looks);
  }

  show(id: number, on: boolean): void {
    const { hidden } = this.#app.store.state;
    this.#app.store.set({ hidden: withPart(hidden, id, !on) });
  }

  clear(id: number, on: boolean): void {
    this.#app.store.set({ clear: withPart(this.#app.store.state.clear, id, on) });
  }

  isolate(id: number): void {
    const others = this.#app.view.scene.parts.map((part) => part.index).filter((other) => other !== id);
    const { state } = this.#app.store;
    this.#app.store.set({ hidden: others, clear: withPart(state.clear, id, false) });
  }

  showAll(): void {
    this.#app.store.set({ hidden: [], clear: [] });
  }

  /** The part under the pointer. */
  #pointed(): number | null {
    const place = this.#app.probing.current()?.place;
    return place ? (this.#app.view.scene.parts[place.part]?.index ?? null) : null;
  }

  #rows(): PartRow[] {
    const { state } = this.#app.store;
    return this.#app.view.scene.parts.map(({ index, info, indices }) => ({
      id: index,
      name: info.name || `part ${index}`,
      kind: info.kind,
      triangles: indices.length / 3,
      hidden: state.hidden.includes(index),
      clear: state.clear.includes(index),
    }));
  }

  section(): Section {
    const rows = this.#rows();
    const gone = rows.filter((row) => row.hidden).length;
    const summary = gone > 0 ? `${rows.length - gone} of ${rows.length} shown` : String(rows.length);
    return { id: "parts", title: "Parts", summary, body: () => partListTemplate(rows, this) };
  }

  page(): PanelPage {
    const rows = this.#rows().map((row) => ({
      text: row.name,
      detail: row.hidden ? "hidden" : row.clear ? "clear" : row.kind,
      buttons: [
        { id: `show:${row.id}`, text: "Show", on: !row.hidden, press: () => this.show(row.id, row.hidden) },
        { id: `clear:${row.id}`, text: "Clear", on: row.clear, press: () => this.clear(row.id, !row.clear) },
        { id: `only:${row.id}`, text: "Only", press: () => this.isolate(row.id) },
      ],
    }));
    const all = { id: "all", text: "Show all", press: () => this.showAll() };
    return { id: "parts", title: "Parts", rows: [{ text: "", buttons: [all] }, ...rows] };
  }

  commands() {
    const on = (act: (id: number) => void) => () => {
      const id = this.#pointed();
      if (id === null) this.#app.say("Point at a part first.");
      else act(id);
    };
    return [
      { keys: ["h"], shown: "H", text: "hide the part pointed at", down: on((id) => this.show(id, false)) },
      { keys: ["i"], shown: "I", text: "that part alone", down: on((id) => this.isolate(id)) },
      {
        keys: ["y"],
        shown: "Y",
        text: "see through that part",
        down: on((id) => this.clear(id, !this.#app.store.state.clear.includes(id))),
      },
      { keys: ["a"], shown: "A", text: "show all parts", down: () => this.showAll() },
    ];
  }

  report() {
    const { hidden, clear } = this.#app.store.state;
    return { hidden, clear };
  }
}
