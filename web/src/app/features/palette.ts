// SPDX-License-Identifier: Apache-2.0
// Every function of the page by its words: keys, results and senses, steps, views, sections, nodes.

import { colourMaps } from "../../present";
import { COLUMNS, found, type PaletteEntry, stepText } from "../../ui";
import type { App } from "../app";
import type { Feature } from "./feature";
import type { Save, Saved } from "./save";

const VIEWS = ["+x", "-x", "+y", "-y", "+z", "-z", "iso"] as const;
const FILES: readonly [Saved, string][] = [
  ["picture", "save a picture (PNG)"],
  ["presentation", "save the presentation"],
  ["nodes", "save a table of all visible nodes"],
  ["places", "save a table of notes and hot spots"],
  ["history", "save a table of the node over all steps"],
];

export class Palette implements Feature {
  readonly id = "palette";
  readonly #app: App;

  constructor(app: App) {
    this.#app = app;
  }

  /** All there is, in the order of the page. */
  entries(typed: string): PaletteEntry[] {
    const { keys, actions, view, models, features } = this.#app;
    const plain = (text: string, run: () => void) => ({ text, shown: "", run });
    const own = keys.filter((k) => !k.up && k.keys.length > 0 && !/arrow|^ctrl\+k$/i.test(k.keys[0] ?? ""));
    const id = Number(typed.trim());
    const numbers =
      typed.trim() !== "" && Number.isInteger(id) && id > 0
        ? [
            plain(`${id}: go to node`, () => actions.goTo("node", id)),
            plain(`${id}: go to element`, () => actions.goTo("element", id)),
          ]
        : [];
    const senses = view.shown.flatMap((shown) =>
      COLUMNS.filter(({ slot }) => slot !== "shape" || models.canShape(shown)).map(({ slot, verb }) =>
        plain(`${shown.label}: ${verb}`, () => actions.assign(shown.key, slot)),
      ),
    );
    return [
      ...numbers,
      ...own.map((k) => ({ text: k.text, shown: k.shown, run: () => k.down(k.keys[0] ?? "") })),
      plain("fit the model", () => actions.fit()),
      ...senses,
      ...view.scene.extras.steps.map((s) => plain(`step: ${stepText(s)}`, () => actions.setStep(s.id))),
      ...VIEWS.map((name) =>
        plain(`view from ${name === "iso" ? "a corner" : name}`, () => actions.view(name)),
      ),
      ...colourMaps().map((map) =>
        plain(`colour map: ${map.replace("_", " ")}`, () => actions.setColour({ map })),
      ),
      ...[0, 5, 9, 11].map((bands) =>
        plain(`bands: ${bands === 0 ? "smooth" : bands}`, () => actions.setColour({ bands })),
      ),
      ...features.flatMap((f) => {
        const section = f.section?.();
        return section
          ? [plain(`section: ${section.title}`, () => actions.openSection(section.id, true))]
          : [];
      }),
      ...FILES.map(([what, text]) => plain(text, () => void this.#app.feature<Save>("save").save(what))),
      plain("open a scene or presentation", () => this.#app.openFile()),
      plain("enter VR", () => actions.enterVr()),
    ];
  }

  open(): void {
    this.#app.showPalette((typed) => found(this.entries(typed), typed));
  }

  commands() {
    return [{ keys: ["ctrl+k", "/"], shown: "Ctrl K", text: "command palette", down: () => this.open() }];
  }
}
