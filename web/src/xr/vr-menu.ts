// SPDX-License-Identifier: Apache-2.0
// The menu at a hand: on the wrist of the hand that holds, or over a palm that is turned up.
import { Matrix4, type Scene, Vector3 } from "three";
import type { ViewState } from "../app/store";
import { Board, BOARD_COLOURS as C, reportOf, roundRect } from "./board";
import { button, type Ink } from "./panel-ink";

const COLUMNS = 4;
const CELL = { width: 158, height: 96 } as const;
const EDGE = 10;
const SIZE = { width: 2 * EDGE + COLUMNS * CELL.width, height: 2 * EDGE + 3 * CELL.height } as const;
const METRES = 0.24;
/** Over the hand. */
const ABOVE = 0.12;
/** Of the palm's direction along the way up or to the eyes: from here it shows, and until there it stays. */
const SHOWS = 0.7;
const STAYS = 0.5;

export interface MenuWays {
  home(): void;
  table(): void;
  trueSize(): void;
  note(): void;
  toggle(what: "sound" | "touch"): void;
  nextResult(): void;
  stepBy(count: number): void;
  togglePlay(): void;
  cut(): void;
  leave(): void;
}

/** A hand that may bear the menu. */
export interface MenuHand {
  readonly name: string;
  readonly at: Vector3;
  /** Where the palm looks; null: a controller. */
  readonly palm: Vector3 | null;
}

const back = new Matrix4();

/** Which way a palm looks, from the pose of its wrist: joints have their backs along +y. */
export function palmOf(wrist: ArrayLike<number>): Vector3 {
  return new Vector3(0, -1, 0).transformDirection(back.fromArray(wrist as number[]));
}

export class VrMenu {
  readonly board = new Board(SIZE.width, SIZE.height, METRES);
  readonly #ways: MenuWays;
  #bearer: string | null = null;
  #onWrist = false;
  #painted: { state: ViewState; hover: string | null } | null = null;

  constructor(scene: Scene, ways: MenuWays) {
    this.#ways = ways;
    this.board.mesh.visible = false;
    // Over panel and model: it is in the hand.
    this.board.mesh.renderOrder = 7;
    scene.add(this.board.mesh);
  }

  /** The button that calls it, and sends it away. */
  toggle(): void {
    this.#onWrist = !this.#onWrist;
  }

  /** Once a frame: `holding` is the hand that does not point. */
  update(hands: readonly MenuHand[], holding: string, eye: Vector3): void {
    const bearer = hands.find((hand) => this.#bears(hand, holding, eye)) ?? null;
    this.#bearer = bearer?.name ?? null;
    this.board.mesh.visible = bearer !== null;
    if (!bearer) return;
    this.board.mesh.position.copy(bearer.at).y += ABOVE;
    this.board.mesh.lookAt(eye);
    this.board.mesh.updateMatrixWorld(true);
  }

  #bears({ name, at, palm }: MenuHand, holding: string, eye: Vector3): boolean {
    if (!palm) return this.#onWrist && name.startsWith(holding);
    const towards = Math.max(palm.y, palm.dot(eye.clone().sub(at).normalize()));
    return towards > (this.#bearer === name ? STAYS : SHOWS);
  }

  /** The hand that bears it does not point. */
  get bearer(): string | null {
    return this.#bearer;
  }

  paint(state: ViewState, hover: string | null, canPlay: boolean): void {
    if (!this.board.mesh.visible) return;
    if (this.#painted?.state === state && this.#painted.hover === hover) return;
    this.#painted = { state, hover };
    const ways = this.#ways;
    const cells: readonly [string, string, () => void, boolean?, boolean?][] = [
      ["home", "Home", () => ways.home()],
      ["table", "Table", () => ways.table()],
      ["true-size", "Size 1:1", () => ways.trueSize()],
      ["note", "Note", () => ways.note()],
      ["sound", state.sound ? "Sound on" : "Muted", () => ways.toggle("sound"), state.sound],
      ["touch", state.touch ? "Touch on" : "Touch off", () => ways.toggle("touch"), state.touch],
      ["result", "Result ›", () => ways.nextResult()],
      ["cut", "Section", () => ways.cut(), state.cuts.some((cut) => cut.on)],
      ["back", "‹ Step", () => ways.stepBy(-1)],
      ["play", state.playing ? "Pause" : "Play", () => ways.togglePlay(), state.playing, canPlay],
      ["next", "Step ›", () => ways.stepBy(1)],
      ["leave", "Leave VR", () => ways.leave()],
    ];
    this.board.paint((context) => {
      roundRect(context, { x: 0, y: 0, ...SIZE }, 22, C.panel);
      const ink: Ink = { context, buttons: [], hover };
      cells.forEach(([id, text, press, on = false, enabled = true], i) => {
        button(ink, {
          id: `menu:${id}`,
          x: EDGE + (i % COLUMNS) * CELL.width,
          y: EDGE + Math.floor(i / COLUMNS) * CELL.height,
          ...CELL,
          text,
          on,
          enabled,
          press,
        });
      });
      return ink.buttons;
    });
  }

  report() {
    const board = reportOf(this.board);
    return board && { ...board, hand: this.#bearer, buttons: this.board.buttonPlaces() };
  }

  dispose(): void {
    this.board.dispose();
  }
}
