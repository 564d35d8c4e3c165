// SPDX-License-Identifier: Apache-2.0
// Extremes and hot spots of what is seen, or of everything that has a limit, by how much of it is used.
import { type HotSpot, hotSpots, type Place, placeOfVertex } from "../../probe";
import { type HotRow, hotListTemplate, numberText, type PanelPage, type Section, unitText } from "../../ui";
import type { App } from "../app";
import { extremePlaces } from "../extremes";
import { utilisation } from "../limits";
import type { Shown } from "../model-view";
import { statedExtremes } from "../ranges";
import type { HotOptions } from "../store";
import type { Feature, PlaceMark } from "./feature";

export interface FoundSpot {
  readonly shown: Shown;
  readonly spot: HotSpot;
  readonly utilisation: number | null;
  readonly place: Place | null;
}

export class HotSpots implements Feature {
  readonly id = "hot-spots";
  readonly #app: App;
  #key: readonly unknown[] = [];
  #found: readonly FoundSpot[] = [];

  constructor(app: App) {
    this.#app = app;
  }

  /** Found anew only when what they depend on is another. */
  found(): readonly FoundSpot[] {
    const { view, store } = this.#app;
    const { hot, hidden } = store.state;
    const key = [view.shown, hot, hidden, store.state.cuts];
    if (key.some((part, i) => part !== this.#key[i])) {
      this.#key = key;
      this.#found = this.#find();
    }
    return this.#found;
  }

  #of(shown: Shown, hot: HotOptions): FoundSpot[] {
    const { view, store } = this.#app;
    const { parts } = view.scene;
    // A limit from below is used most where the value is smallest.
    const largest =
      hot.by === "utilisation" ? (hot.end === "largest") === shown.limitIsUpper : hot.end === "largest";
    const spots = hotSpots({
      parts,
      fields: shown.fields,
      component: shown.componentIndex,
      hidden: (part) => store.state.hidden.includes(parts[part]?.index ?? -1),
      cuts: view.cuts,
      count: hot.count,
      separation: hot.share * view.diagonal,
      largest,
    });
    return spots.map((spot) => ({
      shown,
      spot,
      utilisation: utilisation(spot.value, shown),
      place: placeOfVertex(parts, spot.part, spot.vertex),
    }));
  }

  #find(): FoundSpot[] {
    const { view, store } = this.#app;
    const { hot } = store.state;
    const limited = view.shown.filter((s) => s.result && s.limit !== null);
    if (hot.by === "utilisation" && limited.length > 0) {
      const sign = hot.end === "largest" ? -1 : 1;
      const all = limited.flatMap((shown) => this.#of(shown, hot));
      all.sort((a, b) => sign * ((a.utilisation ?? 0) - (b.utilisation ?? 0)));
      return all.slice(0, hot.count);
    }
    const seen = view.shownAs("colour");
    return seen ? this.#of(seen, { ...hot, by: "value" }) : [];
  }

  #goTo(place: Place | null): (() => void) | null {
    return place && (() => this.#app.flyTo(place));
  }

  /** The solver's extremes of the whole model, then the spots of the skin. */
  #rows(): HotRow[] {
    const { view, store } = this.#app;
    const seen = view.shownAs("colour");
    const stated = seen?.result ? statedExtremes(seen.result, store.state.step) : null;
    const places = extremePlaces(view, seen, store.state.step);
    const ends = (["max", "min"] as const).flatMap((kind): HotRow[] => {
      const extreme = stated?.[kind];
      if (!seen || !extreme) return [];
      const place = places.find((p) => p.kind === kind)?.place ?? null;
      const where = extreme.element === undefined ? `node ${extreme.node}` : `element ${extreme.element}`;
      return [
        {
          word: kind === "max" ? "MX" : "MN",
          value: extreme.value,
          unit: seen.unit,
          label: place ? "" : "inside the model",
          where,
          utilisation: utilisation(extreme.value, seen),
          click: this.#goTo(place),
        },
      ];
    });
    const several = new Set(this.found().map((f) => f.shown)).size > 1;
    return [
      ...ends,
      ...this.found().map((f, i) => ({
        word: String(i + 1),
        value: f.spot.value,
        unit: f.shown.unit,
        label: several ? f.shown.label : "",
        where: `node ${f.spot.node}`,
        utilisation: f.utilisation,
        click: this.#goTo(f.place),
      })),
    ];
  }

  get #open(): boolean {
    return this.#app.store.state.open.includes(this.id);
  }

  section(): Section | null {
    const { view, store } = this.#app;
    const seen = view.shownAs("colour");
    const limited = view.shown.some((s) => s.result && s.limit !== null);
    if (!seen && !limited) return null;
    const { hot } = store.state;
    const summary = this.#open ? "" : `${hot.count} ${hot.end}`;
    return {
      id: this.id,
      title: "Extremes and hot spots",
      summary,
      body: () =>
        hotListTemplate({
          options: hot,
          rows: this.#rows(),
          hasLimit: limited,
          note: "MX and MN are of the whole model; the numbered ones are peaks of the visible skin.",
          change: (change) => store.set({ hot: { ...store.state.hot, ...change } }),
        }),
    };
  }

  page(): PanelPage | null {
    const rows = this.#rows().map((row, i) => ({
      text: `${row.word}   ${numberText(row.value)} ${unitText(row.unit)}`,
      detail:
        row.utilisation === null
          ? row.where
          : `${row.where} · ${numberText(100 * row.utilisation, 3)} % of the limit`,
      buttons: row.click ? [{ id: `go:${i}`, text: "Mark", press: row.click }] : [],
    }));
    return rows.length > 0 ? { id: this.id, title: "Hot spots", rows } : null;
  }

  marks(): PlaceMark[] {
    if (!this.#open || !this.#app.store.state.hot.marks) return [];
    return this.found().flatMap((f, i) =>
      f.place
        ? [{ kind: "hot" as const, id: `hot-${i}`, text: String(i + 1), detail: "", place: f.place }]
        : [],
    );
  }

  #cycle = -1;

  commands() {
    const next = (by: number) => () => {
      const found = this.found();
      if (found.length === 0) return;
      this.#cycle = (((this.#cycle + by) % found.length) + found.length) % found.length;
      const place = found[this.#cycle]?.place;
      if (place) this.#app.flyTo(place);
    };
    return [
      { keys: ["n"], shown: "N", text: "to the next hot spot", down: next(1) },
      { keys: ["b"], shown: "B", text: "to the hot spot before", down: next(-1) },
    ];
  }

  report() {
    if (!this.#open) return { hotSpots: null };
    return {
      hotSpots: this.found().map((f) => ({
        key: f.shown.key,
        value: f.spot.value,
        node: f.spot.node,
        part: this.#app.view.scene.parts[f.spot.part]?.index ?? 0,
        utilisation: f.utilisation,
      })),
    };
  }
}
