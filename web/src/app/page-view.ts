// SPDX-License-Identifier: Apache-2.0
// State -> page: which model each area of the page gets, and what follows the camera.
import type { App } from "./app";
import type { Page } from "./page";
import type { Player } from "./player";

export class PageView {
  readonly #app: App;
  readonly #page: Page;
  readonly #player: Player;

  constructor(app: App, page: Page, player: Player) {
    this.#app = app;
    this.#page = page;
    this.#player = player;
  }

  render(): void {
    const { store, view, actions, models } = this.#app;
    const { state } = store;
    const { extras, parts } = view.scene;
    const title = extras.title || "Untitled model";
    document.title = `${title} · Feelem`;
    const { vr, hint } = this.#app.vrAnswer;
    this.#page.renderTop(
      {
        title,
        triangles: parts.reduce((sum, part) => sum + part.indices.length / 3, 0),
        lengthUnit: extras.lengthUnit?.name ?? null,
        state,
        vr,
        vrHint: hint,
      },
      actions,
    );
    const sections = this.#app.features.flatMap((f) => f.section?.() ?? []);
    this.#page.renderLeft(models.table(), sections, state.open, this.#app.keys, actions);
    this.#page.renderBottom(
      {
        steps: extras.steps,
        step: state.step,
        playing: state.playing,
        canPlay: this.#player.canPlay,
        deformMode: state.deformMode,
        factor: view.factor,
        automaticFactor: view.automaticFactor,
        hasShape: view.hasShape,
      },
      actions,
    );
    this.#page.renderBanner(state.problem, state.reading, actions);
    this.#page.renderLegend(models.legend(), state.reading, actions);
  }

  /** Whatever follows the camera or the pointer. */
  follow(): void {
    const { stage, store, view, probing, models, actions, overlay } = this.#app;
    const matrix = view.model.worldMatrix();
    this.#page.renderTriad(stage, matrix, actions);
    const place = probing.current()?.place ?? null;
    const at = place && stage.project(view.picker.worldOf(place, matrix));
    this.#page.renderCard(models.card(), at, () => this.#app.pin(null));
    this.#page.renderMarkers(overlay.markers(at));
    this.#page.renderHandles(this.#app.features.flatMap((f) => f.handles?.() ?? []));
    this.#page.renderLegend(models.legend(), store.state.reading, actions);
  }
}
