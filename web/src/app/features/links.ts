// SPDX-License-Identifier: Apache-2.0
// The address holds the whole view, so that a link shows another person the same; undo and redo.
import { findNode } from "../../probe";
import type { App } from "../app";
import { decodeView, encodeView, LINKED, snapshotOf } from "../link";
import type { ViewState } from "../store";
import { Undo } from "../undo";
import type { Feature } from "./feature";

const KEY = "view=";
/** The address follows when nothing has changed for so long. */
const QUIET_MS = 500;

export class Links implements Feature {
  readonly id = "links";
  readonly #app: App;
  readonly #undo: Undo;
  #timer = 0;
  #written = "";
  /** While a view is being brought in, the address stays as it is. */
  #settled = false;
  /** What was asked for while only the shape was there. */
  #asked: Partial<ViewState> = {};

  constructor(app: App) {
    this.#app = app;
    this.#undo = new Undo(app.store);
    app.store.subscribe((state, before) => {
      if (state.doc !== before.doc || LINKED.some((key) => state[key] !== before[key])) this.later();
    });
    const changed = () => void this.read();
    window.addEventListener("hashchange", changed);
    app.atEnd(() => {
      window.removeEventListener("hashchange", changed);
      clearTimeout(this.#timer);
    });
  }

  /** The view as data: what a link and a presentation file hold. */
  view(): Record<string, unknown> {
    const { store, stage, probing, view } = this.#app;
    const { target, yaw, pitch, distance } = stage.orbit;
    const round = (v: number) => Number(v.toPrecision(7));
    const own = view.scene.extras.presentation;
    return {
      // The scene's own presentation need not be said again.
      ...(store.state.doc === own ? {} : { doc: store.state.doc }),
      ...Object.fromEntries(LINKED.map((key) => [key, store.state[key]])),
      camera: [target.x, target.y, target.z, yaw, pitch, distance].map(round),
      node: probing.pinned ? (probing.report()?.nodeId ?? null) : null,
    };
  }

  /** Brings a view in; what is wrong in it is said. */
  show(value: unknown): void {
    const { store, stage, view } = this.#app;
    const { state, camera, node } = snapshotOf(value);
    const { step, doc, ...rest } = state;
    if (view.isPreview) {
      this.#asked = { ...this.#asked, ...state };
      store.set(rest);
    } else store.set({ ...rest, ...(doc && { doc }), ...this.#known(step) });
    if (camera) stage.orbit.place(camera);
    const place = node === null ? null : findNode(view.scene.parts, node);
    if (place) this.#app.mark(place);
  }

  #known(step: number | undefined): Partial<ViewState> {
    const isKnown = this.#app.view.scene.extras.steps.some((s) => s.id === step);
    return isKnown && step !== undefined ? { step } : {};
  }

  /** Results have come for the shape that is shown: `first` is how they want to be seen, `before` how the shape did. What
   * was asked for comes first, and what the person has done meanwhile stays. */
  settle(first: ViewState, before: ViewState): void {
    const { state } = this.#app.store;
    const { doc, step, deformMode, typedFactor, ghost, person, problem } = first;
    const isFree = state.deformMode === "auto" && this.#asked.deformMode === undefined;
    this.#undo.settle({
      doc: this.#asked.doc ?? doc,
      step,
      ...this.#known(this.#asked.step),
      ...(state.step !== before.step && this.#known(state.step)),
      ...(isFree && { deformMode, typedFactor }),
      ...(!state.ghost && this.#asked.ghost === undefined && { ghost }),
      ...(problem !== null && { problem }),
      person,
    });
    this.#asked = {};
    this.#settled = true;
    this.later();
  }

  /** Takes the view from the address, if it has one. */
  async read(): Promise<void> {
    const { hash } = location;
    const text = hash.startsWith(`#${KEY}`) ? hash.slice(1 + KEY.length) : "";
    if (text !== "" && hash !== this.#written) {
      try {
        this.show(await decodeView(text));
      } catch (error) {
        const reason = error instanceof Error ? error.message : String(error);
        this.#app.store.set({ problem: `The view in this link cannot be shown: ${reason}` });
      }
    }
    this.#settled = !this.#app.view.isPreview;
  }

  /** The address will follow. */
  later(): void {
    if (!this.#settled) return;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => void this.write(), QUIET_MS);
  }

  async write(): Promise<string> {
    const hash = `#${KEY}${await encodeView(this.view())}`;
    this.#written = hash;
    if (location.hash !== hash) history.replaceState(history.state, "", hash);
    return location.href;
  }

  async copy(): Promise<void> {
    const link = await this.write();
    try {
      await navigator.clipboard.writeText(link);
      this.#app.say("The link to this view is copied.");
    } catch {
      this.#app.say("The address of this page now holds the whole view: copy it from there.");
    }
  }

  commands() {
    const step = (done: boolean, word: string) => {
      if (!done) this.#app.say(`Nothing to ${word}.`);
    };
    return [
      { keys: ["ctrl+z"], shown: "Ctrl Z", text: "undo", down: () => step(this.#undo.undo(), "undo") },
      {
        keys: ["ctrl+shift+z", "ctrl+y"],
        shown: "Ctrl Y",
        text: "redo",
        down: () => step(this.#undo.redo(), "redo"),
      },
      { keys: ["j"], shown: "J", text: "copy a link to this view", down: () => void this.copy() },
    ];
  }

  report() {
    return { canUndo: this.#undo.canUndo, canRedo: this.#undo.canRedo, camera: this.view().camera };
  }
}
