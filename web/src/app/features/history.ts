// SPDX-License-Identifier: Apache-2.0
// The chosen node's values over all steps; how fast steps are played; the ghost of the undeformed shape.
import { nearestNode } from "../../probe";
import {
  type HistoryLine,
  historyTemplate,
  numberText,
  type PanelPage,
  type Section,
  stepText,
  unitText,
} from "../../ui";
import type { App } from "../app";
import { type HistoryPoint, readHistory, stepPositions } from "../history-data";
import type { Shown } from "../model-view";
import type { Feature } from "./feature";

interface Kept {
  readonly key: string;
  readonly shown: Shown;
  points: readonly HistoryPoint[];
}

export interface Chosen {
  readonly part: number;
  readonly vertex: number;
  readonly node: number;
}

export class History implements Feature {
  readonly id = "history";
  readonly #app: App;
  #key = "";
  #kept: Kept[] = [];
  #reading = false;

  constructor(app: App) {
    this.#app = app;
    app.store.subscribe((state, before) => {
      if (state.ghost !== before.ghost) app.view.applyGhost();
    });
  }

  get #steps() {
    return this.#app.view.scene.extras.steps;
  }

  /** The node that was pressed or gone to last. */
  chosen(): Chosen | null {
    const place = this.#app.probing.chosen;
    const part = place && this.#app.view.scene.parts[place.part];
    const node = part && nearestNode(part, place);
    return node && place ? { part: place.part, vertex: node.vertex, node: node.id } : null;
  }

  /** Starts reading when node or results are others; what is known so far is shown as it comes. */
  #follow(): void {
    const chosen = this.chosen();
    const shown = this.#app.view.shown.filter((s) => s.result);
    const key = chosen ? [chosen.part, chosen.vertex, ...shown.map((s) => s.key)].join("|") : "";
    if (key === this.#key) return;
    this.#key = key;
    this.#kept = chosen ? shown.map((s) => ({ key: s.key, shown: s, points: [] })) : [];
    if (chosen) void this.#read(chosen, key);
  }

  async #read(chosen: Chosen, key: string): Promise<void> {
    this.#reading = true;
    for (const kept of this.#kept) {
      const { result, componentIndex: component } = kept.shown;
      if (!result) continue;
      await readHistory(this.#app.view.scene, { result, component, ...chosen }, (points) => {
        kept.points = points;
        return this.#key === key;
      });
      if (this.#key !== key) return;
      this.#app.refreshPage();
    }
    this.#reading = false;
    this.#app.refreshPage();
  }

  lines(): HistoryLine[] {
    const positions = stepPositions(this.#steps);
    return this.#kept.map(({ shown, points }) => ({
      label: shown.label,
      unit: shown.unit,
      limit: shown.limit,
      points: points.map((p) => ({ ...p, at: positions.get(p.step) ?? p.step })),
    }));
  }

  #axis(): string {
    const units = new Set(this.#steps.map((s) => s.unit ?? ""));
    const positions = [...stepPositions(this.#steps).values()];
    const numbered = positions.every((p, i) => p === i + 1);
    return numbered ? "" : units.size === 1 ? unitText([...units][0]) : "";
  }

  section(): Section | null {
    if (this.#steps.length < 2) return null;
    const { state } = this.#app.store;
    if (state.open.includes(this.id)) this.#follow();
    const node = this.chosen()?.node ?? null;
    const body = () =>
      historyTemplate({
        node,
        lines: this.lines(),
        step: state.step,
        axis: this.#axis(),
        reading: this.#reading,
        stepName: (id) => stepText(this.#steps.find((s) => s.id === id) ?? { id, kind: "" }),
        go: (step) => this.#app.actions.setStep(step),
      });
    return { id: this.id, title: "Over all steps", summary: node === null ? "" : `node ${node}`, body };
  }

  page(): PanelPage | null {
    if (this.#steps.length < 2) return null;
    this.#follow();
    const seen = this.#kept.find((k) => k.key === this.#app.view.shownAs("colour")?.key) ?? this.#kept[0];
    const rows = this.#steps.map((step) => {
      const value = seen?.points.find((p) => p.step === step.id)?.value ?? null;
      const detail = seen ? `${numberText(value)} ${value === null ? "" : unitText(seen.shown.unit)}` : "";
      const on = step.id === this.#app.store.state.step;
      const go = { id: `go:${step.id}`, text: "Show", on, press: () => this.#app.actions.setStep(step.id) };
      return { text: stepText(step), detail, buttons: [go] };
    });
    const node = this.chosen()?.node;
    return { id: this.id, title: node === undefined ? "Steps" : `Steps · node ${node}`, rows };
  }

  commands() {
    const speed = (by: number) => () => {
      const next = Math.min(Math.max(this.#app.store.state.speed * by, 0.125), 8);
      this.#app.store.set({ speed: next });
      this.#app.say(`Playing at ${numberText(next)} times the usual speed.`);
    };
    return [
      {
        keys: ["u"],
        shown: "U",
        text: "undeformed shape as lines",
        down: () => this.#app.actions.toggle("ghost"),
      },
      { keys: ["+"], shown: "+", text: "play faster", down: speed(2) },
      { keys: ["-"], shown: "−", text: "play slower", down: speed(0.5) },
    ];
  }

  report() {
    const { ghost, speed, open } = this.#app.store.state;
    const chosen = open.includes(this.id) ? this.chosen() : null;
    const history = chosen && {
      node: chosen.node,
      results: this.#kept.map(({ key, points }) => ({ key, points })),
    };
    return { ghost, speed, history, swing: this.#app.view.swing };
  }
}
