// SPDX-License-Identifier: Apache-2.0
// Each frame: what the held pointers are on is heard and felt; nothing is once they are let go.
import { Vector3 } from "three";
import { normalise } from "../present";
import type { Stage } from "../render";
import { createHaptics, createSound, EventWatch, type Haptics, type Sound, stopWhenLeft } from "../sense";
import type { PulseRecord } from "./api";
import type { ModelView, Shown } from "./model-view";
import { pulseEffect } from "./presentation-doc";
import type { ProbeReport } from "./probe-report";
import type { PointerState, Probing } from "./probing";
import type { Store } from "./store";

const SENSED = ["colour", "pitch", "ticks", "pulses"] as const;
/** Less than this of the range, and of the model's size, is standing still. */
const STILL_VALUE = 0.005;
const STILL_PLACE = 0.0025;
/** Browsers let a page sound from the person's first gesture on. */
const WAKING = ["pointerdown", "keydown"] as const;
const scratch = new Vector3();

/** Whether a pointer rests: place and value have not changed to speak of. */
class Rest {
  #point: readonly number[] = [];
  #values: readonly number[] = [];

  update(report: ProbeReport, shown: readonly Shown[], size: number): boolean {
    const values = report.results.map((r) => {
      const range = shown.find((s) => s.key === r.key)?.range;
      return range && r.value !== null ? normalise(r.value, range).u : -1;
    });
    const near = (a: readonly number[], b: readonly number[], limit: number) =>
      a.length === b.length && a.every((v, i) => Math.abs(v - (b[i] ?? 0)) <= limit);
    const rests =
      near(report.point, this.#point, STILL_PLACE * size) && near(values, this.#values, STILL_VALUE);
    if (!rests) {
      this.#point = [...report.point];
      this.#values = values;
    }
    return rests;
  }
}

interface Hand {
  readonly haptics: Haptics;
  readonly rest: Rest;
  readonly watches: Map<string, EventWatch>;
}

export class Senses {
  readonly #view: ModelView;
  readonly #probing: Probing;
  readonly #store: Store;
  readonly #stage: Stage;
  readonly #hands = new Map<string, Hand>();
  #context: AudioContext | null = null;
  #sound: Sound | null = null;
  #stopWatching: () => void;
  readonly #stopWaking: () => void;

  constructor(view: ModelView, probing: Probing, store: Store, stage: Stage) {
    this.#view = view;
    this.#probing = probing;
    this.#store = store;
    this.#stage = stage;
    this.#stopWatching = stopWhenLeft(() => this.stop());
    stage.onFrame(() => this.#frame(performance.now() / 1000));
    store.subscribe((state) => this.#sound?.setMuted(!state.sound));
    const wake = () => this.wake();
    for (const kind of WAKING) window.addEventListener(kind, wake);
    this.#stopWaking = () => {
      for (const kind of WAKING) window.removeEventListener(kind, wake);
    };
  }

  /** Sound needs a gesture of the person: call this from one. */
  wake(): void {
    if (!this.#context) {
      this.#context = new AudioContext({ latencyHint: "interactive" });
      const audio = this.#store.state.doc.audio as { master?: unknown; mono?: unknown } | undefined;
      this.#sound = createSound(this.#context, {
        master: typeof audio?.master === "number" ? Math.min(Math.max(audio.master, 0), 1) : 0.5,
        mono: audio?.mono === true,
      });
      this.#sound.setMuted(!this.#store.state.sound);
    }
    if (this.#context.state === "suspended") void this.#context.resume();
  }

  /** Silence and stillness at once; nothing is held any more. */
  stop(): void {
    this.#probing.releaseAll();
    this.#sound?.stop();
    for (const { haptics } of this.#hands.values()) haptics.stop();
  }

  /** In a headset the session says when the person leaves, not the page. */
  watch(session: XRSession | null): void {
    this.#stopWatching();
    this.#stopWatching = stopWhenLeft(() => this.stop(), session);
  }

  pulses(): PulseRecord[] {
    return [...this.#hands]
      .flatMap(([pointer, { haptics }]) =>
        haptics
          .pulses()
          .map((p) => ({ time: p.time * 1000, pointer, amplitude: p.strength, ms: p.milliseconds })),
      )
      .sort((a, b) => a.time - b.time);
  }

  #hand(name: string): Hand {
    let hand = this.#hands.get(name);
    if (!hand) {
      hand = { haptics: createHaptics(), rest: new Rest(), watches: new Map() };
      this.#hands.set(name, hand);
    }
    return hand;
  }

  #frame(seconds: number): void {
    const leading = this.#probing.current();
    let heard = false;
    for (const pointer of this.#probing.pointers) {
      const hand = this.#hand(pointer.name);
      hand.haptics.setActuator(pointer.actuator);
      const report = pointer.held && this.#view.ready ? this.#probing.reportOf(pointer) : null;
      if (report) {
        const still = hand.rest.update(report, this.#view.shown, this.#view.model.largestSide);
        const beyond = this.#watch(hand, report, pointer === leading);
        this.#feel(hand, report, still, beyond);
        if (pointer === leading) {
          this.#hear(pointer, report, still, beyond);
          heard = true;
        }
      } else {
        hand.haptics.update(null);
        for (const watch of hand.watches.values()) watch.update(null);
      }
      hand.haptics.tick(seconds);
    }
    if (!heard) this.#sound?.update(null);
  }

  /** Limits and gaps of all results that some sense shows; true while one is past its limit. */
  #watch(hand: Hand, report: ProbeReport, leads: boolean): boolean {
    let beyond = false;
    const sensed = new Set(SENSED.map((slot) => this.#view.shownAs(slot)));
    for (const shown of sensed) {
      if (!shown) continue;
      let watch = hand.watches.get(shown.key);
      if (!watch) {
        watch = new EventWatch();
        hand.watches.set(shown.key, watch);
      }
      const limit =
        shown.limit === null
          ? null
          : ({ value: shown.limit, kind: shown.limitIsUpper ? "above" : "below" } as const);
      const value = report.results.find((r) => r.key === shown.key)?.value ?? Number.NaN;
      const event = watch.update({ value, range: shown.range, limit });
      beyond ||= watch.beyond;
      if (event && leads) this.#sound?.event(event);
      if (event && event !== "noValue" && this.#store.state.touch) hand.haptics.event(event);
    }
    return beyond;
  }

  #feel(hand: Hand, report: ProbeReport, still: boolean, beyond: boolean): void {
    const milliseconds = pulseEffect(this.#store.state.doc)?.milliseconds ?? 35;
    const { rate, amplitude } = report.pulse;
    hand.haptics.update(
      this.#store.state.touch ? { rate, amplitude, milliseconds, still, alarm: beyond } : null,
    );
  }

  #hear(pointer: PointerState, report: ProbeReport, still: boolean, beyond: boolean): void {
    const pitch = this.#view.shownAs("pitch");
    const value = report.results.find((r) => r.key === pitch?.key)?.value ?? Number.NaN;
    const place = pitch ? normalise(value, pitch.range) : null;
    this.#sound?.update({
      hz: report.hz,
      gain: report.gain,
      negative: report.negative,
      tickRate: report.tickRate,
      pan: this.#pan(pointer),
      tremolo: beyond || (place?.above === true && pitch?.limit === null),
      dull: place?.below === true,
      still,
    });
  }

  /** Left or right of where the person looks; never a value. */
  #pan(pointer: PointerState): number {
    if (!pointer.place) return 0;
    const { renderer, camera } = this.#stage;
    const eye = renderer.xr.isPresenting ? renderer.xr.getCamera() : camera;
    scratch.copy(this.#view.picker.worldOf(pointer.place, this.#view.model.worldMatrix()));
    scratch.applyMatrix4(eye.matrixWorldInverse);
    return Math.min(Math.max(scratch.x / Math.max(scratch.length(), 1e-6), -1), 1) * 0.8;
  }

  dispose(): void {
    this.#stopWatching();
    this.#stopWaking();
    this.#sound?.dispose();
    void this.#context?.close();
  }
}
