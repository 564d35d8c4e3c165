// SPDX-License-Identifier: Apache-2.0
// Buttons and sticks of controllers (xr-standard mapping) as wishes; each counts once when it is pressed.
import type { VrPointer } from "./vr-pointers";

export interface VrWishes {
  /** Note where this hand points. */
  note(pointer: VrPointer): void;
  /** To the table again, as large as at first. */
  home(): void;
  /** The menu at the other hand comes, or goes. */
  menu(): void;
  /** Another result is seen. */
  nextResult(): void;
  stepBy(count: number): void;
  toggleSound(): void;
  /** Degrees to the left. */
  turn(degrees: number): void;
  /** While the stick is up: where one would stand; null: it was let go, go there. */
  aimWalk(pointer: VrPointer | null): void;
  /** While it is held the first plane follows this hand; null: it stays. */
  carryPlane(pointer: VrPointer | null): void;
}

const STICK = 3;
const LOWER = 4;
const UPPER = 5;
const ON = 0.7;
const OFF = 0.4;
export const TURN_DEGREES = 30;

interface Before {
  readonly buttons: boolean[];
  x: -1 | 0 | 1;
  y: -1 | 0 | 1;
}

/** -1, 0 or 1 with some play, so that a trembling thumb is one push. */
function pushed(value: number, before: -1 | 0 | 1): -1 | 0 | 1 {
  const limit = before === 0 ? ON : OFF;
  if (Math.abs(value) < limit) return 0;
  return value > 0 ? 1 : -1;
}

export class VrButtons {
  readonly #wishes: VrWishes;
  readonly #before = new Map<string, Before>();

  constructor(wishes: VrWishes) {
    this.#wishes = wishes;
  }

  /** Once a frame and pointer. `pointing`: the hand that points, the other one holds; left-handed swaps them. */
  update(pointer: VrPointer, pointing: "left" | "right"): void {
    const { gamepad, handedness } = pointer.source;
    if (!gamepad || (handedness !== "left" && handedness !== "right")) return;
    const known = this.#before.get(pointer.name) ?? { buttons: [], x: 0 as const, y: 0 as const };
    const down = (i: number) => gamepad.buttons[i]?.pressed ?? false;
    const once = (i: number) => down(i) && !known.buttons[i];
    const x = pushed(gamepad.axes[2] ?? 0, known.x);
    const y = pushed(gamepad.axes[3] ?? 0, known.y);
    if (handedness === pointing) this.#pointingHand(pointer, { once, x, y }, known);
    else this.#otherHand(pointer, { once, down, x }, known);
    this.#before.set(pointer.name, {
      buttons: [0, 1, 2, STICK, LOWER, UPPER].reduce<boolean[]>((all, i) => {
        all[i] = down(i);
        return all;
      }, []),
      x,
      y,
    });
  }

  #pointingHand(
    pointer: VrPointer,
    now: { once: (i: number) => boolean; x: -1 | 0 | 1; y: -1 | 0 | 1 },
    before: Before,
  ): void {
    const wishes = this.#wishes;
    if (now.once(LOWER)) wishes.note(pointer);
    if (now.once(UPPER)) wishes.menu();
    if (now.once(STICK)) wishes.home();
    if (now.x !== 0 && before.x === 0) wishes.turn(-now.x * TURN_DEGREES);
    // The stick's y grows towards the person.
    if (now.y === -1) wishes.aimWalk(pointer);
    else if (before.y === -1) wishes.aimWalk(null);
  }

  #otherHand(
    pointer: VrPointer,
    now: { once: (i: number) => boolean; down: (i: number) => boolean; x: -1 | 0 | 1 },
    before: Before,
  ): void {
    const wishes = this.#wishes;
    if (now.down(LOWER)) wishes.carryPlane(pointer);
    else if (before.buttons[LOWER]) wishes.carryPlane(null);
    if (now.once(UPPER)) wishes.nextResult();
    if (now.once(STICK)) wishes.toggleSound();
    if (now.x !== 0 && before.x === 0) wishes.stepBy(now.x);
  }

  forget(name: string): void {
    const before = this.#before.get(name);
    if (before?.buttons[LOWER]) this.#wishes.carryPlane(null);
    this.#before.delete(name);
  }
}
