// SPDX-License-Identifier: Apache-2.0
// The state of the page in one object; whoever shows it subscribes.
import type { Reading } from "./opening";
import type { Person } from "./person";
import type { PresentationDoc } from "./presentation-doc";

export type DeformMode = "off" | "true" | "auto" | "factor";

export interface ViewState {
  readonly doc: PresentationDoc;
  /** Id of the step that is shown. */
  readonly step: number;
  readonly deformMode: DeformMode;
  /** The typed factor, for deformMode "factor". */
  readonly typedFactor: number;
  readonly playing: boolean;
  readonly edges: boolean;
  readonly shading: boolean;
  readonly extremes: boolean;
  readonly theme: "auto" | "light" | "dark";
  readonly sound: boolean;
  readonly touch: boolean;
  readonly session: "none" | "immersive-vr";
  /** What went wrong last, for people; null: nothing. */
  readonly problem: string | null;
  /** What happened last, for people and screen readers. */
  readonly notice: string;
  /** Only the shape is there; null: the scene is. */
  readonly reading: Reading | null;
  /** Ids of parts that are not drawn, and of those one sees through. */
  readonly hidden: readonly number[];
  readonly clear: readonly number[];
  /** Sections of the page that are unfolded. */
  readonly open: readonly string[];
  readonly hot: HotOptions;
  readonly cuts: readonly CutState[];
  /** The undeformed shape as lines. */
  readonly pins: readonly PinState[];
  /** Node ids: none, where it starts, or both ends. */
  readonly ruler: readonly number[];
  readonly person: Person;
  /** Ticks lead to the largest value instead of meaning one. */
  readonly guide: boolean;
  readonly ghost: boolean;
  /** Of playing; 1: as usual. */
  readonly speed: number;
}

/** A note at a node. */
export interface PinState {
  readonly id: number;
  /** Solver's id. */
  readonly node: number;
  readonly note: string;
}

/** A plane that cuts the model, in the coordinates of the solver; the side its normal points to is gone. */
export interface CutState {
  readonly normal: readonly [number, number, number];
  readonly offset: number;
  readonly on: boolean;
}

/** Which places of largest or smallest value are listed. */
export interface HotOptions {
  readonly count: number;
  /** Of the model's diagonal: nearer ones count as the same place. */
  readonly share: number;
  readonly by: "value" | "utilisation";
  readonly end: "largest" | "smallest";
  /** Their numbers stand on the model. */
  readonly marks: boolean;
}

export type Listener = (state: ViewState, before: ViewState) => void;

export class Store {
  #state: ViewState;
  readonly #listeners = new Set<Listener>();

  constructor(state: ViewState) {
    this.#state = state;
  }

  get state(): ViewState {
    return this.#state;
  }

  set(change: Partial<ViewState>): void {
    const before = this.#state;
    this.#state = { ...before, ...change };
    for (const listener of this.#listeners) listener(this.#state, before);
  }

  subscribe(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}
