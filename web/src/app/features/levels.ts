// SPDX-License-Identifier: Apache-2.0
// Which level of detail is drawn: as fine as the budget allows, with what may be wrong while it is. What is read, heard and
// felt comes from the full triangles at every level: they alone are picked.
import { HEADSET_TRIANGLES, levelWithin } from "../../render";
import type { App } from "../app";
import type { Feature } from "./feature";

export class Levels implements Feature {
  readonly id = "levels";
  readonly #app: App;
  readonly #all: number;
  readonly #coming = new Set<number>();

  constructor(app: App) {
    this.#app = app;
    this.#all = app.view.scene.parts.reduce((sum, part) => sum + part.indices.length / 3, 0);
    app.atEnd(app.stage.onFrame(() => this.#choose()));
    app.atEnd(app.stage.onPicture(() => this.#draw(this.#within(app.mostTriangles))));
  }

  /** Of those levels alone whose certificate says how wrong they may be of what is drawn; 0, all triangles, when none does. */
  #within(budget: number): number {
    if (this.#all <= budget) return 0;
    const { scene } = this.#app.view;
    const covered = (scene.extras.levels ?? []).flatMap((level, i) =>
      this.#app.view.isCovered(level) ? [{ number: i + 1, triangles: level.triangles }] : [],
    );
    const counts = covered.map(({ triangles }) => triangles);
    return covered[levelWithin(budget, this.#all, counts) - 1]?.number ?? 0;
  }

  get #counts(): readonly number[] {
    return (this.#app.view.scene.extras.levels ?? []).map((level) => level.triangles);
  }

  #choose(): void {
    const { stage, mostTriangles } = this.#app;
    const headset = stage.renderer.xr.isPresenting ? HEADSET_TRIANGLES : Number.POSITIVE_INFINITY;
    const budget = Math.min(stage.quality.drawn.triangles, headset, mostTriangles);
    this.#draw(this.#within(budget));
  }

  #draw(level: number): void {
    const { model } = this.#app.view;
    if (level === model.level) return;
    if (!model.hasLevel(level)) {
      void this.#load(level);
      return;
    }
    model.setLevel(level);
    this.#app.redrawn();
  }

  async #load(level: number): Promise<void> {
    if (this.#coming.has(level)) return;
    this.#coming.add(level);
    try {
      this.#app.view.model.addLevel(level, await this.#app.view.scene.loadLevel(level - 1));
      this.#app.invalidate();
    } catch (error) {
      // It stays among those that come: nobody asks for it again, and all triangles are drawn.
      const reason = error instanceof Error ? error.message : String(error);
      this.#app.store.set({ problem: `Level of detail: ${reason}` });
    }
  }

  report() {
    const { level } = this.#app.view.model;
    const triangles = level === 0 ? this.#all : (this.#counts[level - 1] ?? 0);
    return { levels: { drawn: level, of: this.#counts.length, triangles, text: this.#app.view.levelText } };
  }
}
