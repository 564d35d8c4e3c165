// SPDX-License-Identifier: Apache-2.0
// What leaves the page as a file: picture, tables.
import { type Section, saveTemplate, withoutResults } from "../../ui";
import type { App } from "../app";
import { takePicture } from "../picture";
import { fileStem, saveFile } from "../save";
import { type Separator, tableLines, tablePieces } from "../table";
import { historyTable, nodeTable, placeTable } from "../tables";
import type { Feature } from "./feature";
import type { History } from "./history";
import type { Links } from "./links";

export type Saved = "picture" | "nodes" | "places" | "history" | "presentation";
const TABLES = { nodes: nodeTable, places: placeTable, history: historyTable };

export class Save implements Feature {
  readonly id = "save";
  readonly #app: App;
  #separator: Separator = ",";

  constructor(app: App) {
    this.#app = app;
  }

  async save(what: Saved): Promise<void> {
    const stem = fileStem(this.#app.view.scene.extras.title || "feelem");
    try {
      if (what === "picture") {
        saveFile(`${stem}.png`, await takePicture(this.#app));
        return;
      }
      const { reading } = this.#app.store.state;
      if (reading) throw new Error(withoutResults(reading));
      if (what === "presentation") {
        const { doc } = this.#app.store.state;
        const { doc: _, ...page } = this.#app.feature<Links>("links").view();
        const view = { ...(typeof doc.view === "object" ? doc.view : {}), page };
        const text = `${JSON.stringify({ ...doc, view }, null, 2)}\n`;
        saveFile(`${stem}.presentation.json`, new Blob([text], { type: "application/json" }));
        return;
      }
      const table = TABLES[what](this.#app);
      const tabs = this.#separator === "\t";
      const pieces = tablePieces(tableLines(table.head, table.rows, this.#separator));
      const type = tabs ? "text/tab-separated-values" : "text/csv";
      saveFile(
        `${stem}-${what}.${tabs ? "tsv" : "csv"}`,
        new Blob(pieces, { type: `${type};charset=utf-8` }),
      );
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      this.#app.store.set({ problem: `It cannot be saved: ${reason}` });
    }
  }

  section(): Section {
    const body = () =>
      saveTemplate({
        separator: this.#separator,
        hasHistory: this.#app.feature<History>("history").lines().length > 0,
        save: (what) => void this.save(what),
        separate: (separator) => {
          this.#separator = separator === "\t" || separator === ";" ? separator : ",";
        },
        openFile: () => this.#app.openFile(),
      });
    return { id: this.id, title: "Save and open", summary: "", body };
  }

  commands() {
    return [{ keys: ["w"], shown: "W", text: "save a picture", down: () => void this.save("picture") }];
  }
}
