// SPDX-License-Identifier: Apache-2.0
// The difference of two steps as a result like any other: seen, heard, felt, read.
import { differenceTemplate, type Section, stepText } from "../../ui";
import type { App } from "../app";
import { addDifference, assign } from "../presentation-doc";
import type { Feature } from "./feature";

export class Difference implements Feature {
  readonly id = "difference";
  readonly #app: App;

  constructor(app: App) {
    this.#app = app;
  }

  add(key: string, step: number): void {
    const { store, view } = this.#app;
    const added = addDifference(store.state.doc, view.scene.extras, key, step);
    if (added) store.set({ doc: assign(added.doc, added.key, "colour") });
  }

  section(): Section | null {
    const { steps } = this.#app.view.scene.extras;
    const results = this.#app.view.shown.filter((s) => s.result && !s.result.minus);
    if (steps.length < 2 || results.length === 0) return null;
    const body = () =>
      differenceTemplate({
        results: results.map(({ key, label }) => ({ key, label })),
        steps: steps.map((step) => ({ id: step.id, name: stepText(step) })),
        add: (key, step) => this.add(key, step),
      });
    return { id: this.id, title: "Difference of steps", summary: "", body };
  }

  commands() {
    const down = () => {
      const seen = this.#app.view.shownAs("colour");
      if (seen?.result && !seen.result.minus) this.add(seen.key, this.#app.store.state.step);
      else this.#app.say("First see a result as colour.");
    };
    return [{ keys: ["d"], shown: "D", text: "difference to the step shown", down }];
  }
}
