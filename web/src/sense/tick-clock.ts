// SPDX-License-Identifier: Apache-2.0
// When ticks sound: even in time at the rate of the moment, scheduled a little ahead, taken back when the rate changes.

/** Seconds that ticks are scheduled ahead: longer than a slow frame. */
const ahead = 0.25;
/** Ticks never come closer than this, whatever is asked. */
export const shortestInterval = 0.08;

interface PlannedTick {
  readonly time: number;
  readonly cancel: () => void;
}

export class TickClock {
  readonly #play: (time: number) => () => void;
  #planned: PlannedTick[] = [];
  #rate = 0;
  #last = Number.NEGATIVE_INFINITY;
  #next = 0;

  /** `play` starts a tick at a time and returns what takes it back before then. */
  constructor(play: (time: number) => () => void) {
    this.#play = play;
  }

  /** Once a frame, with the context's time and the rate from now on. */
  update(now: number, rate: number): void {
    if (!(rate > 0)) {
      this.stop(now);
      return;
    }
    this.#settle(now);
    if (this.#rate === 0) this.#next = Math.max(now, this.#last + shortestInterval);
    else if (rate !== this.#rate) this.#change(now, rate);
    this.#rate = rate;
    const period = Math.max(1 / rate, shortestInterval);
    if (this.#next < now) this.#next = now;
    while (this.#next < now + ahead) {
      this.#planned.push({ time: this.#next, cancel: this.#play(this.#next) });
      this.#next += period;
    }
  }

  stop(now: number): void {
    this.#settle(now);
    this.#takeBack();
    this.#rate = 0;
  }

  /** Forgets what has sounded, and remembers when the last of it did. */
  #settle(now: number): void {
    let first = this.#planned[0];
    while (first && first.time <= now) {
      this.#last = first.time;
      this.#planned.shift();
      first = this.#planned[0];
    }
  }

  #takeBack(): void {
    for (const tick of this.#planned) tick.cancel();
    this.#planned = [];
  }

  /** The part of the beat that is still to go keeps its share of the new period. */
  #change(now: number, rate: number): void {
    const upcoming = this.#planned[0]?.time ?? this.#next;
    this.#takeBack();
    const share = Math.min(Math.max((upcoming - now) * this.#rate, 0), 1);
    this.#next = Math.max(now + share / rate, this.#last + shortestInterval);
  }
}
