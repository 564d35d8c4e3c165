// SPDX-License-Identifier: Apache-2.0
// Play: a mode swings between its two ends, any other result goes through its steps. Nothing in between is made up.
import type { Stage } from "../render";
import type { ModelView } from "./model-view";
import type { Store } from "./store";

/** Swings a second of a mode: never its real frequency. */
const SWINGS = 0.5;
/** Seconds a step stays. */
const STEP_SECONDS = 0.6;

export class Player {
  readonly #view: ModelView;
  readonly #store: Store;
  readonly #stage: Stage;
  #stopRunning: (() => void) | null = null;
  #started: number | null = null;
  #lastStep = 0;
  #angle = 0;
  /** The step that was asked for before its time. */
  #ahead = Number.NaN;

  constructor(view: ModelView, store: Store, stage: Stage) {
    this.#view = view;
    this.#store = store;
    this.#stage = stage;
    stage.onFrame((seconds) => this.#frame(seconds));
    store.subscribe((state, before) => {
      if (state.playing !== before.playing) this.#switch(state.playing);
    });
  }

  get canPlay(): boolean {
    if (this.#view.isPreview) return false;
    return this.#view.scene.extras.steps.length > 1 || (this.#turns && this.#view.hasShape);
  }

  get #turns(): boolean {
    return this.#view.step?.kind === "mode" || this.#view.isComplex;
  }

  get #swings(): boolean {
    return this.#turns && this.#view.hasShape && this.#view.factor !== 0;
  }

  #switch(on: boolean): void {
    this.#stopRunning?.();
    this.#stopRunning = on ? this.#stage.keepRunning() : null;
    this.#started = null;
    this.#angle = 0;
    if (!on) this.#view.applyFactor(0);
    this.#stage.invalidate();
  }

  #frame(seconds: number): void {
    if (!this.#store.state.playing) return;
    this.#started ??= seconds;
    if (this.#swings) {
      this.#angle += 2 * Math.PI * SWINGS * this.#store.state.speed * (seconds - this.#started);
      this.#started = seconds;
      this.#view.applyFactor(this.#angle);
      return;
    }
    if (this.#view.ready) this.#readAhead();
    if (!this.#view.ready || seconds - this.#lastStep < STEP_SECONDS / this.#store.state.speed) return;
    this.#lastStep = seconds;
    this.stepBy(1);
  }

  #stepAfter(count: number): number | null {
    const { steps } = this.#view.scene.extras;
    const index = steps.findIndex((s) => s.id === this.#store.state.step);
    return steps[(((index + count) % steps.length) + steps.length) % steps.length]?.id ?? null;
  }

  /** The next step comes while this one is looked at. */
  #readAhead(): void {
    const next = this.#stepAfter(1);
    if (next === null || next === this.#ahead) return;
    this.#ahead = next;
    this.#view.readAhead(next);
  }

  /** Forward or back, round at the ends. */
  stepBy(count: number): void {
    const step = this.#stepAfter(count);
    if (step !== null) this.#store.set({ step });
  }
}
