// SPDX-License-Identifier: Apache-2.0
// Which key does what.
import type { KeyCommand } from "../input/keyboard";
import type { Actions } from "../ui";

/** 1, -1 or 0: which way an arrow key points. */
const along = (key: string, up: string, down: string) =>
  Number(key === `Arrow${up}`) - Number(key === `Arrow${down}`);

/** `pressed`: the model was pressed last, not a control of the page; Tab is then free for results. */
export function keyCommands(
  actions: Actions,
  hold: (on: boolean) => void,
  pressed: () => boolean,
): KeyCommand[] {
  const focusSearch = () => document.querySelector<HTMLInputElement>(".goto input")?.focus();
  return [
    { keys: ["s"], shown: "S", text: "hold: hear and feel", down: () => hold(true), up: () => hold(false) },
    { keys: [" "], shown: "Space", text: "play, pause", down: () => actions.togglePlay() },
    { keys: [","], shown: ",", text: "step before", down: () => actions.stepBy(-1) },
    { keys: ["."], shown: ".", text: "step after", down: () => actions.stepBy(1) },
    { keys: ["f"], shown: "F", text: "fit", down: () => actions.fit() },
    { keys: ["1"], shown: "1", text: "true scale", down: () => actions.setDeform("true") },
    { keys: ["0"], shown: "0", text: "undeformed", down: () => actions.setDeform("off") },
    { keys: ["5"], shown: "5", text: "deformation 5 %", down: () => actions.setDeform("auto") },
    {
      keys: ["Tab"],
      shown: "Tab",
      text: "next result is seen, after a press on the model; Esc gives Tab back to the page",
      when: (event) => pressed() && !event.shiftKey,
      down: () => actions.nextResult(),
    },
    { keys: ["x"], shown: "X", text: "largest and smallest value", down: () => actions.toggle("extremes") },
    { keys: ["e"], shown: "E", text: "element edges", down: () => actions.toggle("edges") },
    { keys: ["l"], shown: "L", text: "shading", down: () => actions.toggle("shading") },
    { keys: ["m"], shown: "M", text: "mute", down: () => actions.toggle("sound") },
    { keys: ["v"], shown: "V", text: "touch on, off", down: () => actions.toggle("touch") },
    { keys: ["g"], shown: "G", text: "go to an id", down: focusSearch },
    {
      keys: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"],
      shown: "← → ↑ ↓",
      text: "to the next node that way",
      down: (key) => actions.stepPin(along(key, "Right", "Left"), along(key, "Down", "Up")),
    },
    {
      keys: ["shift+ArrowLeft", "shift+ArrowRight", "shift+ArrowUp", "shift+ArrowDown"],
      shown: "⇧ ← → ↑ ↓",
      text: "turn",
      down: (key) => actions.turn(15 * along(key, "Right", "Left"), 15 * along(key, "Down", "Up")),
    },
    {
      keys: ["ctrl+arrowleft", "ctrl+arrowright", "ctrl+arrowup", "ctrl+arrowdown"],
      shown: "Ctrl ← → ↑ ↓",
      text: "move",
      down: (key) => actions.move(0.08 * along(key, "Right", "Left"), 0.08 * along(key, "Down", "Up")),
    },
    { keys: ["PageUp"], shown: "PgUp", text: "nearer", down: () => actions.zoom(0.8) },
    { keys: ["PageDown"], shown: "PgDn", text: "further", down: () => actions.zoom(1.25) },
    { keys: ["t"], shown: "T", text: "dark, light", down: () => actions.cycleTheme() },
    { keys: ["Escape"], shown: "Esc", text: "let go of the pin", down: () => actions.unpin() },
  ];
}
