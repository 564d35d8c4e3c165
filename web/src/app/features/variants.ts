// SPDX-License-Identifier: Apache-2.0
// Components, averagings and layers: each presented result shows one of those that the scene holds.
import {
  averagingText,
  type PanelPage,
  type Section,
  type VariantActions,
  type VariantRow,
  variantListTemplate,
} from "../../ui";
import type { App } from "../app";
import { choicesOf, setVariant } from "../presentation-doc";
import type { Feature } from "./feature";

/** The word after this one, round and round. */
export function nextOf(words: readonly string[], now: string): string {
  return words[(words.indexOf(now) + 1) % words.length] ?? now;
}

export class Variants implements Feature, VariantActions {
  readonly id = "variants";
  readonly #app: App;

  constructor(app: App) {
    this.#app = app;
  }

  choose(key: string, change: { component?: string; averaging?: string; layer?: string }): void {
    this.#app.store.set({ doc: setVariant(this.#app.store.state.doc, key, change) });
  }

  #rows(): VariantRow[] {
    const { shown, scene } = this.#app.view;
    return shown
      .map((one) => ({
        key: one.key,
        label: one.label,
        component: one.component,
        averaging: one.result?.averaging ?? "",
        layer: one.result?.layer ?? "",
        ...choicesOf(one, scene.extras),
      }))
      .filter((row) => [row.components, row.averagings, row.layers].some((words) => words.length > 1));
  }

  section(): Section | null {
    const rows = this.#rows();
    if (rows.length === 0) return null;
    const averagings = new Set(rows.map((row) => row.averaging).filter((word) => word !== ""));
    const [only] = averagings;
    const summary = averagings.size === 1 && only ? averagingText(only) : "";
    return {
      id: "variants",
      title: "Components, averaging",
      summary,
      body: () => variantListTemplate(rows, this),
    };
  }

  page(): PanelPage | null {
    const rows = this.#rows().map((row) => {
      const button = (what: "component" | "averaging" | "layer", words: readonly string[]) =>
        words.length < 2
          ? []
          : [
              {
                id: `${what}:${row.key}`,
                text: what === "averaging" ? averagingText(row.averaging) : row[what].replace(/_/g, " "),
                press: () => this.choose(row.key, { [what]: nextOf(words, row[what]) }),
              },
            ];
      return {
        text: row.label,
        buttons: [
          ...button("component", row.components),
          ...button("averaging", row.averagings),
          ...button("layer", row.layers),
        ],
      };
    });
    return rows.length === 0 ? null : { id: "variants", title: "Components, averaging", rows };
  }

  report() {
    return {
      variants: this.#rows().map(({ key, component, averaging, layer }) => ({
        key,
        component,
        averaging,
        layer,
      })),
    };
  }
}
