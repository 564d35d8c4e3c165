// SPDX-License-Identifier: Apache-2.0
// Each frame: what the held pointers are on is heard and felt; nothing is once they are let go.
import { Vector3 } from "three";
import { normalise } from "../present";
import type { Stage } from "../render";
import {
  Beacon,
  createHaptics,
  createSound,
  type EventKind,
  EventWatch,
  guideRate,
  type Haptics,
  type HeadDirection,
  type SensedLegend,
  type Sound,
  stopWhenLeft,
} from "../sense";
import type { PulseRecord } from "./api";
import type { ModelView, Shown } from "./model-view";
import type { Person } from "./person";
import { pulseEffect } from "./presentation-doc";
import type { ProbeReport } from "./probe-report";
import type { PointerState, Probing } from "./probing";
import type { Store } from "./store";

const SENSED = ["colour", "pitch", "ticks", "pulses"] as const;
/** Less than this of the range, and of the model's size, is standing still. */
const STILL_VALUE = 0.005;
const STILL_PLACE = 0.0025;
/** From here on a value counts as the largest. */
const TOP_RANK = 0.99;
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
  /** The largest value was reached and said. */
  onTop: boolean;
  /** Its pulses reach a hand, not the eye alone. */
  felt: boolean;
}

export class Senses {
  readonly #view: ModelView;
  readonly #probing: Probing;
  readonly #store: Store;
  readonly #stage: Stage;
  readonly #hands = new Map<string, Hand>();
  #context: AudioContext | null = null;
  #sound: Sound | null = null;
  #legend: { legend: SensedLegend; start: number; at: number | null; end: () => void } | null = null;
  #rank: (value: number) => number = () => 0;
  #guideRate = 0;
  #marked = false;
  #beacon: Beacon | null = null;
  readonly #listeners = new Set<(kind: EventKind) => void>();
  readonly #leavers = new Set<() => void>();
  #stopWatching: () => void;
  readonly #stopWaking: () => void;

  constructor(view: ModelView, probing: Probing, store: Store, stage: Stage) {
    this.#view = view;
    this.#probing = probing;
    this.#store = store;
    this.#stage = stage;
    this.#stopWatching = stopWhenLeft(() => this.stop());
    // Pointers of a headset move in the frame: hearing them a frame later would be 14 ms for nothing.
    stage.onLateFrame(() => this.#frame(performance.now() / 1000));
    store.subscribe((state, before) => {
      this.#sound?.setMuted(!state.sound);
      if (state.person !== before.person) this.#heed(state.person);
    });
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
      const { master, mono } = this.#store.state.person;
      this.#sound = createSound(this.#context, { master, mono });
      this.#sound.setMuted(!this.#store.state.sound);
    }
    if (this.#context.state === "suspended") void this.#context.resume();
  }

  #heed({ master, mono, strength }: Person): void {
    this.#sound?.setMaster(master);
    this.#sound?.setMono(mono);
    for (const { haptics } of this.#hands.values()) haptics.setStrength(strength);
  }

  /** Whether any hand can feel. */
  get canVibrate(): boolean {
    return [...this.#probing.pointers].some((p) => p.actuator !== null);
  }

  /** How a value ranks among those that can be seen, 0..1. */
  setRank(rank: (value: number) => number): void {
    this.#rank = rank;
  }

  /** Called when the person leaves and everything falls silent. */
  onStop(listener: () => void): void {
    this.#leavers.add(listener);
  }

  onEvent(listener: (kind: EventKind) => void): void {
    this.#listeners.add(listener);
  }

  /** Place on the legend that sounds now; null: none is played. */
  get legendAt(): number | null {
    return this.#legend?.at ?? null;
  }

  /** Ticks from a direction of the head; null: none. */
  beacon(direction: HeadDirection | null, rate = 0): void {
    if (direction) this.wake();
    if (!this.#context || !this.#sound) return;
    if (direction) this.#beacon ??= new Beacon(this.#context, this.#sound.input);
    this.#beacon?.update(this.#store.state.sound ? direction : null, rate, this.#store.state.person.mono);
  }

  get legendPlays(): boolean {
    return this.#legend !== null;
  }

  /** A mark of the way on a path: one kind after the other, since each needs its rest. */
  mark(): void {
    this.#marked = !this.#marked;
    this.#sound?.event(this.#marked ? "bandUp" : "bandDown");
  }

  /** Ticks a second that lead to the largest value; 0: nothing is held. */
  get guideRate(): number {
    return this.#guideRate;
  }

  /** What low, middle and high sound and feel like. */
  playLegend(legend: SensedLegend): void {
    this.wake();
    this.#legend?.end();
    this.#legend = { legend, start: performance.now() / 1000, at: null, end: this.#stage.keepRunning() };
  }

  /** True while a legend plays. */
  #playing(seconds: number): boolean {
    const playing = this.#legend;
    if (!playing) return false;
    const time = seconds - playing.start;
    if (time > playing.legend.seconds) {
      playing.end();
      this.#legend = null;
      this.#sound?.update(null);
      for (const { haptics } of this.#hands.values()) haptics.update(null);
      return false;
    }
    const moment = playing.legend.at(time);
    playing.at = moment?.u ?? null;
    this.#sound?.update(this.#store.state.sound ? (moment?.sound ?? null) : null);
    for (const pointer of this.#probing.pointers) {
      const { haptics } = this.#hand(pointer.name);
      haptics.setActuator(pointer.actuator);
      haptics.update(this.#store.state.touch ? (moment?.haptic ?? null) : null);
      haptics.tick(seconds);
    }
    return true;
  }

  /** Silence and stillness at once; nothing is held any more. */
  stop(): void {
    this.#probing.releaseAll();
    this.#legend?.end();
    this.#legend = null;
    this.#sound?.stop();
    this.#beacon?.update(null, 0, false);
    for (const left of this.#leavers) left();
    for (const { haptics } of this.#hands.values()) haptics.stop();
  }

  /** In a headset the session says when the person leaves, not the page. */
  watch(session: XRSession | null): void {
    this.#stopWatching();
    this.#stopWatching = stopWhenLeft(() => this.stop(), session);
  }

  pulses(): PulseRecord[] {
    return [...this.#hands]
      .filter(([, { felt }]) => felt)
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
      hand = { haptics: createHaptics(), rest: new Rest(), watches: new Map(), onTop: false, felt: false };
      hand.haptics.setStrength(this.#store.state.person.strength);
      this.#hands.set(name, hand);
    }
    return hand;
  }

  #frame(seconds: number): void {
    if (this.#playing(seconds)) return;
    const leading = this.#probing.current();
    this.#guideRate = 0;
    let heard = false;
    for (const pointer of this.#probing.pointers) {
      const hand = this.#hand(pointer.name);
      hand.haptics.setActuator(pointer.actuator ?? pointer.shows);
      hand.felt ||= pointer.actuator !== null;
      const report = pointer.held && this.#view.ready ? this.#probing.reportOf(pointer) : null;
      if (report) {
        const still = hand.rest.update(report, this.#view.shown, this.#view.model.largestSide);
        const beyond = this.#watch(hand, report, pointer === leading);
        this.#feel(hand, report, still, beyond);
        if (pointer === leading) {
          if (this.#store.state.guide) this.#guide(hand, report);
          else this.#hear(pointer, report, still, beyond);
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
      if (event && leads) for (const listener of this.#listeners) listener(event);
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

  /** Ticks alone: the faster, the higher the value of what is seen ranks; at the top it is said once. */
  #guide(hand: Hand, report: ProbeReport): void {
    const seen = this.#view.shownAs("colour");
    const value = report.results.find((r) => r.key === seen?.key)?.value ?? null;
    const rank = value === null ? 0 : this.#rank(value);
    this.#guideRate = value === null ? 0 : guideRate(rank);
    const top = rank >= TOP_RANK;
    if (top && !hand.onTop) {
      this.#sound?.event("maximum");
      if (this.#store.state.touch) hand.haptics.event("maximum");
      for (const listener of this.#listeners) listener("maximum");
    }
    hand.onTop = top;
    this.#sound?.update({ tickRate: this.#guideRate });
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
    this.#beacon?.dispose();
    this.#sound?.dispose();
    void this.#context?.close();
  }
}
