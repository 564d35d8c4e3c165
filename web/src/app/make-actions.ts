// SPDX-License-Identifier: Apache-2.0
// The controls' wishes, turned into changes of state.
import type { Actions } from "../ui";
import type { App } from "./app";
import type { Limits } from "./features/limits";
import type { Palette } from "./features/palette";
import type { Player } from "./player";
import { addResult, assign, drivenBy, release, setColour, setRange, slotsOf } from "./presentation-doc";

const THEMES = { auto: "light", light: "dark", dark: "auto" } as const;

export function makeActions(app: App, player: Player): Actions {
  const store = () => app.store;
  const doc = () => app.store.state.doc;
  return {
    assign: (key, slot) => store().set({ doc: assign(doc(), key, slot) }),
    release: (slot) => store().set({ doc: release(doc(), slot) }),
    releaseAll: (key) =>
      store().set({ doc: slotsOf(doc(), key).reduce((d, slot) => release(d, slot), doc()) }),
    nextResult: () => {
      const keys = app.view.shown.filter((s) => s.result).map((s) => s.key);
      const next = keys[(keys.indexOf(drivenBy(doc(), "colour") ?? "") + 1) % keys.length];
      if (next) store().set({ doc: assign(doc(), next, "colour") });
    },
    addResult: (result, component) => store().set({ doc: addResult(doc(), result, component).doc }),
    setRange: (key, change) => store().set({ doc: setRange(doc(), key, change) }),
    setColour: (change) => store().set({ doc: setColour(doc(), change) }),
    toggleLock: () => {
      const limits = app.features.find((f) => f.id === "limits") as Limits | undefined;
      limits?.toggleLock();
    },
    setStep: (step) => {
      if (step !== store().state.step) store().set({ step });
    },
    stepBy: (count) => player.stepBy(count),
    togglePlay: () => store().set({ playing: !store().state.playing && player.canPlay }),
    setDeform: (deformMode, factor) =>
      store().set(factor === undefined ? { deformMode } : { deformMode, typedFactor: factor }),
    toggle: (what) => store().set({ [what]: !store().state[what] }),
    cycleTheme: () => store().set({ theme: THEMES[store().state.theme] }),
    fit: () => app.fit(),
    view: (name) => app.lookFrom(name),
    turn: (right, down) => app.stage.orbit.turn((right * Math.PI) / 180, (down * Math.PI) / 180),
    move: (right, down) => {
      const { clientWidth, clientHeight } = app.stage.canvas;
      app.stage.orbit.pan(right * clientWidth, down * clientHeight, clientHeight);
    },
    zoom: (scale) => app.stage.orbit.zoom(scale, null),
    goTo: (kind, id) => app.goTo(kind, id),
    unpin: () => app.pin(null),
    stepPin: (right, down) => app.stepPin([right, down]),
    enterVr: () => void app.enterVr(),
    openPalette: () => app.feature<Palette>("palette").open(),
    openSection: (id, on) => {
      const { open } = store().state;
      if (open.includes(id) !== on) store().set({ open: on ? [...open, id] : open.filter((o) => o !== id) });
    },
    dismissProblem: () => store().set({ problem: null }),
  };
}
