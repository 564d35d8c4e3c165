// SPDX-License-Identifier: Apache-2.0
// Undo and redo of what a person changed on the view: not of where the camera is, nor of the step that is shown. No DOM.
import { LINKED } from "./link";
import type { Store, ViewState } from "./store";

const KEYS = ["doc", ...LINKED.filter((key) => key !== "step" && key !== "open")] as const;
/** Changes of the same thing that follow each other this soon are one: a slider, a knob. */
const TOGETHER_MS = 600;
const MOST = 200;

type Kept = Pick<ViewState, (typeof KEYS)[number]>;

function keep(state: ViewState): Kept {
  return Object.fromEntries(KEYS.map((key) => [key, state[key]])) as unknown as Kept;
}

export class Undo {
  readonly #store: Store;
  readonly #now: () => number;
  #past: Kept[] = [];
  #future: Kept[] = [];
  #last = { what: "", at: Number.NEGATIVE_INFINITY };
  #moving = false;

  constructor(store: Store, now: () => number = () => performance.now()) {
    this.#store = store;
    this.#now = now;
    store.subscribe((state, before) => this.#changed(state, before));
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }
  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  #changed(state: ViewState, before: ViewState): void {
    if (this.#moving) return;
    const what = KEYS.filter((key) => state[key] !== before[key]).join(" ");
    if (what === "") return;
    const at = this.#now();
    const goesOn = what === this.#last.what && at - this.#last.at < TOGETHER_MS;
    this.#last = { what, at };
    this.#future = [];
    if (goesOn) return;
    this.#past.push(keep(before));
    if (this.#past.length > MOST) this.#past.shift();
  }

  #go(from: Kept[], to: Kept[]): boolean {
    const next = from.pop();
    if (!next) return false;
    to.push(keep(this.#store.state));
    this.#moving = true;
    this.#store.set(next);
    this.#moving = false;
    this.#last = { what: "", at: Number.NEGATIVE_INFINITY };
    return true;
  }

  /** A change that nobody made: it is not undone, and what is undone keeps it. */
  settle(change: Partial<ViewState>): void {
    this.#moving = true;
    this.#store.set(change);
    this.#moving = false;
    const own = Object.fromEntries(Object.entries(change).filter(([key]) => KEYS.some((k) => k === key)));
    const settled = (kept: Kept): Kept => ({ ...kept, ...own });
    this.#past = this.#past.map(settled);
    this.#future = this.#future.map(settled);
  }

  undo(): boolean {
    return this.#go(this.#past, this.#future);
  }
  redo(): boolean {
    return this.#go(this.#future, this.#past);
  }
}
