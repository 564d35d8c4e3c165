// SPDX-License-Identifier: Apache-2.0
// Measures frames, asks the governor, and says which level is drawn: coarser only while the picture moves.
import { AT_FIRST, FINEST, type Governor, govern, LEVELS, type Level, type Pace } from "./governor";

/** At the desk: 30 a second are enough, and most displays show 60. */
const DESK: Pace = { budget: 33, interval: 1000 / 60 };
/** Seconds without change after which the picture is drawn at its finest. */
const REST_SECONDS = 0.25;

export interface QualityReport {
  /** 0: the finest. */
  readonly level: number;
  readonly levels: number;
  readonly moving: boolean;
  readonly resolution: number;
  readonly edges: boolean;
  readonly budgetMs: number;
  /** Of the last frame that followed another at once; null before. */
  readonly frameMs: number | null;
}

export class Quality {
  readonly #governed: boolean;
  #governor: Governor = AT_FIRST;
  #drawn: Level = FINEST;
  #moving = false;
  #last: number | null = null;
  #lastActive = 0;
  #pace = DESK;
  #frameMs: number | null = null;

  constructor(governed: boolean) {
    this.#governed = governed;
  }

  /** What is drawn now. */
  get drawn(): Level {
    return this.#drawn;
  }

  /** A headset wants a frame each time it shows one; null: as at the desk. */
  setFrameRate(rate: number | null): void {
    this.#pace = rate ? { budget: 1000 / rate, interval: 1000 / rate } : DESK;
  }

  /** At each frame before it is drawn: `active` when something asks for it. True: draw it, the picture has come to rest. */
  next(seconds: number, active: boolean): boolean {
    if (!this.#governed) return false;
    if (!active) {
      this.#last = null;
      if (!this.#moving || seconds - this.#lastActive < REST_SECONDS) return false;
      this.#moving = false;
      const wasCoarse = this.#drawn !== FINEST;
      this.#drawn = FINEST;
      return wasCoarse;
    }
    if (this.#last !== null) {
      this.#moving = true;
      this.#frameMs = 1000 * (seconds - this.#last);
      this.#governor = govern(this.#governor, this.#frameMs, this.#pace);
    }
    this.#last = seconds;
    this.#lastActive = seconds;
    // A single change is drawn at its finest.
    this.#drawn = this.#moving ? (LEVELS[this.#governor.level] ?? FINEST) : FINEST;
    return false;
  }

  report(): QualityReport {
    return {
      level: this.#governor.level,
      levels: LEVELS.length,
      moving: this.#moving,
      resolution: this.#drawn.resolution,
      edges: this.#drawn.edges,
      budgetMs: this.#pace.budget,
      frameMs: this.#frameMs,
    };
  }
}
