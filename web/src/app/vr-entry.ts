// SPDX-License-Identifier: Apache-2.0
// From the page into the headset and back.
import { askForVr, requestVr, type VrAnswer, VrSession } from "../xr";
import type { App } from "./app";
import { applyTheme } from "./theme";

/** Frames a second where the headset does not say. */
const HEADSET_RATE = 72;

export class VrEntry {
  answer: VrAnswer = { vr: "unknown", hint: "" };
  readonly #app: App;
  readonly #changed: () => void;
  #stay: VrSession | null = null;

  constructor(app: App, changed: () => void) {
    this.#app = app;
    this.#changed = changed;
  }

  async ask(): Promise<void> {
    const again = async () => {
      this.answer = await askForVr();
      this.#changed();
    };
    navigator.xr?.addEventListener("devicechange", again);
    await again();
  }

  /** Called from a click: browsers give a headset only to a gesture. */
  async enter(): Promise<void> {
    const { senses, stage, store } = this.#app;
    senses.wake();
    try {
      const session = await requestVr();
      stage.renderer.xr.setReferenceSpaceType("local-floor");
      await stage.renderer.xr.setSession(session);
      stage.quality.setFrameRate(session.frameRate ?? HEADSET_RATE);
      store.set({ session: "immersive-vr", problem: null });
      senses.watch(session);
      this.#stay = new VrSession(this.#app, session, () => this.#left());
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      store.set({ problem: `The headset cannot be entered: ${reason}` });
    }
  }

  /** The room of the headset; null at the desk. */
  report() {
    return this.#stay?.report() ?? null;
  }

  /** What is shown has come, maybe some time after it was asked for. */
  renew(): void {
    this.#stay?.renew();
  }

  #left(): void {
    this.#stay = null;
    const { senses, stage, store } = this.#app;
    senses.watch(null);
    store.set({ session: "none" });
    applyTheme(store.state.theme, stage);
    stage.refit();
    this.#changed();
  }
}
