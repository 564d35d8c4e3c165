// SPDX-License-Identifier: Apache-2.0
// Page of the headset's panel for who has no stick: steps, turns, places, and how comfortable moving is.
import type { Person } from "../app/person";
import type { PanelPage } from "../ui";
import { TURN_DEGREES } from "./vr-buttons";

/** Metres of one press. */
export const STEP_METRES = 0.5;

export interface MoveWays {
  /** Metres to the right and ahead of where the person looks. */
  step(right: number, ahead: number): void;
  /** Degrees to the left. */
  turn(degrees: number): void;
  home(): void;
  table(): void;
  trueSize(): void;
  change(change: Partial<Person>): void;
}

export function movePage(person: Person, ways: MoveWays): PanelPage {
  const go = (id: string, text: string, right: number, ahead: number) => ({
    id,
    text,
    press: () => ways.step(right * STEP_METRES, ahead * STEP_METRES),
  });
  const shade = (id: string, text: string, vignette: number) => ({
    id,
    text,
    on: person.vignette === vignette,
    press: () => ways.change({ vignette }),
  });
  const flip = (id: "upright" | "byTouch") => ({
    id,
    text: person[id] ? "On" : "Off",
    on: person[id],
    press: () => ways.change({ [id]: !person[id] }),
  });
  return {
    id: "move",
    title: "Move",
    rows: [
      {
        text: "Walk",
        detail: `half a metre a press`,
        buttons: [
          go("left", "◀", -1, 0),
          go("ahead", "▲", 0, 1),
          go("back", "▼", 0, -1),
          go("right", "▶", 1, 0),
        ],
      },
      {
        text: "Turn",
        detail: `${TURN_DEGREES}° a press`,
        buttons: [
          { id: "turn-left", text: "↶", press: () => ways.turn(TURN_DEGREES) },
          { id: "turn-right", text: "↷", press: () => ways.turn(-TURN_DEGREES) },
        ],
      },
      {
        text: "Model",
        detail: "before where one stands",
        buttons: [
          { id: "home", text: "Home", press: () => ways.home() },
          { id: "table", text: "Table", press: () => ways.table() },
          { id: "true-size", text: "Size 1:1", press: () => ways.trueSize() },
        ],
      },
      {
        text: "Dark edge while it moves",
        detail: "when the model surrounds one and moves fast",
        buttons: [
          shade("shade-off", "Off", 0),
          shade("shade-weak", "Weak", 0.5),
          shade("shade-full", "Full", 1),
        ],
      },
      { text: "Two hands keep it upright", buttons: [flip("upright")] },
      { text: "Hear and feel by touch alone", buttons: [flip("byTouch")] },
    ],
  };
}
