// SPDX-License-Identifier: Apache-2.0
// The sound engine: one tone, ticks, and short earcons, into a limiter. Built on any BaseAudioContext, so that tests
// render the very graph that people hear. Made of plain nodes whose parameters move sample by sample: no clicks, and
// no worklet, which pages without a certificate do not get.
import { negativePartials, tonePartials } from "../present";
import { type EventKind, earcons } from "./earcons";
import { limiterCurve, pinkNoise, tickBurst } from "./signals";
import { TickClock } from "./tick-clock";

/** What is to be heard now. Everything is optional but silence is said by passing null instead. */
export interface SoundFrame {
  /** Pitch of the tone; absent or gain 0: no tone. */
  readonly hz?: number;
  /** Equal-loudness gain of the tone, 0..1 (Tone.gain). */
  readonly gain?: number;
  /** The hollow tone of negative values (Tone.negative). */
  readonly negative?: boolean;
  /** Ticks a second; 0 or absent: none. */
  readonly tickRate?: number;
  /** Where it comes from: -1 left .. 1 right. Never carries a value. */
  readonly pan?: number;
  /** Flutter while the value is beyond the limit, or above the range where there is no limit. */
  readonly tremolo?: boolean;
  /** Dull tone while the value is below the range. */
  readonly dull?: boolean;
  /** A quiet sine beside the tone: the mean of what the tone is the largest of. */
  readonly second?: { readonly hz: number; readonly gain: number } | null;
  /** Neither the place nor the value has changed to speak of: after 2 s the tone steps back by 18 dB. */
  readonly still?: boolean;
}

export interface SoundOptions {
  /** 0..1 */
  readonly master: number;
  readonly mono: boolean;
  /** Peak of the tone before loudness and master: 0.1 is -20 dBFS. */
  readonly toneGain: number;
}
export const defaultSound: SoundOptions = Object.freeze({ master: 0.5, mono: false, toneGain: 0.1 });

export interface Sound {
  /** Once a frame. Null releases the voices (80 ms). Without a call for 0.6 s the voices release by themselves. */
  update(frame: SoundFrame | null): void;
  /** Plays an earcon over the ducked voices; false when it was too soon after the last, or one of more weight runs. */
  event(kind: EventKind): boolean;
  /** Silence at once (20 ms): blur, end of the session, lost focus. */
  stop(): void;
  setMuted(muted: boolean): void;
  setMaster(master: number): void;
  setMono(mono: boolean): void;
  readonly muted: boolean;
  /** Where other sounds join: master level, mute and limiter come after it. */
  readonly input: AudioNode;
  /** The last node before the loudspeakers, for taps and meters. */
  readonly output: AudioNode;
  dispose(): void;
}

// Time constants in seconds.
const pitchTau = 0.015;
const gainTau = 0.01;
const attackTau = 0.007;
const releaseTau = 0.01;
const stopTau = 0.004;
const patience = 0.6;
const stillAfter = 2;
/** The second sine against the tone: -9 dB. */
const besides = 10 ** (-9 / 20);
const steppedBack = 10 ** (-18 / 20);
const baseHz = 261.6255653005986;

/** Leaves the parameter where it is and then moves it, sample by sample, towards the target. */
function glide(parameter: AudioParam, target: number, now: number, tau: number): void {
  parameter.cancelScheduledValues(now);
  parameter.setTargetAtTime(target, now, tau);
}

function jump(parameter: AudioParam, value: number, now: number): void {
  parameter.cancelScheduledValues(now);
  parameter.setValueAtTime(value, now);
}

/** Fades to exactly nothing; returns when that is. */
function fadeOut(parameter: AudioParam, at: number, tau: number): number {
  const end = at + 11 * tau;
  parameter.setTargetAtTime(0, at, tau);
  parameter.setValueAtTime(0, end);
  return end;
}

function wave(context: BaseAudioContext, partials: readonly number[]): PeriodicWave {
  const real = new Float32Array(partials.length + 1);
  const imag = new Float32Array([0, ...partials]);
  return context.createPeriodicWave(real, imag, { disableNormalization: true });
}

function gainNode(context: BaseAudioContext, value: number, ...inputs: AudioNode[]): GainNode {
  const node = new GainNode(context, { gain: value });
  for (const input of inputs) input.connect(node);
  return node;
}

/** Everything between the oscillators and the loudspeakers. */
class Graph {
  readonly tones: readonly OscillatorNode[];
  readonly sources: readonly AudioScheduledSourceNode[];
  readonly sine: OscillatorNode;
  readonly second: GainNode;
  readonly plain: GainNode;
  readonly hollow: GainNode;
  readonly filter: BiquadFilterNode;
  readonly tremolo: GainNode;
  readonly tremoloDepth: GainNode;
  readonly loudness: GainNode;
  readonly gate: GainNode;
  readonly tickInput: GainNode;
  readonly duck: GainNode;
  readonly panner: StereoPannerNode;
  readonly panned: GainNode;
  readonly centred: GainNode;
  readonly events: GainNode;
  readonly master: GainNode;
  readonly limiter: WaveShaperNode;
  readonly burst: AudioBuffer;

  constructor(context: BaseAudioContext, options: SoundOptions) {
    const tone = (partials: readonly number[]) =>
      new OscillatorNode(context, { frequency: baseHz, periodicWave: wave(context, partials) });
    this.tones = [tone(tonePartials), tone(negativePartials)];
    const [plain, hollow] = this.tones as readonly [OscillatorNode, OscillatorNode];
    const noise = new AudioBufferSourceNode(context, { buffer: pinkNoise(context), loop: true });
    const hush = new BiquadFilterNode(context, { type: "lowpass", frequency: 4000 });
    const flutter = new OscillatorNode(context, { frequency: 8 });

    this.plain = gainNode(context, 1, plain);
    this.hollow = gainNode(context, 0, hollow, gainNode(context, 10 ** (-24 / 20), noise.connect(hush)));
    this.filter = new BiquadFilterNode(context, { type: "lowpass", frequency: 20000, Q: -3 });
    this.plain.connect(this.filter);
    this.hollow.connect(this.filter);
    this.tremolo = gainNode(context, 1, this.filter);
    this.tremoloDepth = gainNode(context, 0, flutter);
    this.tremoloDepth.connect(this.tremolo.gain);
    this.loudness = gainNode(context, 0, this.tremolo);
    this.sine = new OscillatorNode(context, { frequency: baseHz });
    this.second = gainNode(context, 0, this.sine);
    this.gate = gainNode(context, 0, this.loudness, this.second);
    this.tickInput = gainNode(context, 1);
    this.duck = gainNode(context, 1, gainNode(context, options.toneGain, this.gate), this.tickInput);
    this.panner = new StereoPannerNode(context);
    this.duck.connect(this.panner);
    this.panned = gainNode(context, options.mono ? 0 : 1, this.panner);
    this.centred = gainNode(context, options.mono ? Math.SQRT1_2 : 0, this.duck);
    this.events = gainNode(context, 1);
    this.master = gainNode(context, 0, this.panned, this.centred, this.events);
    this.limiter = new WaveShaperNode(context, { curve: limiterCurve() });
    this.master.connect(this.limiter).connect(context.destination);
    this.burst = tickBurst(context);
    this.sources = [plain, hollow, noise, flutter, this.sine];
    for (const source of this.sources) source.start();
  }
}

class Engine implements Sound {
  readonly #context: BaseAudioContext;
  readonly #graph: Graph;
  readonly #ticks: TickClock;
  #master: number;
  #muted = false;
  #open = false;
  /** From when on the gate is shut, unless it is opened before. */
  #silentFrom = 0;
  #stillSince = Number.POSITIVE_INFINITY;
  #eventEnds = 0;
  #eventWeight = 0;
  readonly #lastEvent = new Map<EventKind, number>();

  constructor(context: BaseAudioContext, options: SoundOptions) {
    this.#context = context;
    this.#graph = new Graph(context, options);
    this.#ticks = new TickClock((time) => this.#playTick(time));
    this.#master = options.master;
    glide(this.#graph.master.gain, options.master, context.currentTime, 0.05);
  }

  get muted(): boolean {
    return this.#muted;
  }
  get input(): AudioNode {
    return this.#graph.master;
  }
  get output(): AudioNode {
    return this.#graph.limiter;
  }

  update(frame: SoundFrame | null): void {
    if (!this.#isRunning()) return;
    const now = this.#context.currentTime;
    if (!frame) {
      this.#release(now, releaseTau);
      return;
    }
    this.#ticks.update(now, frame.tickRate ?? 0);
    this.#steer(frame, now);
    const gain = frame.gain ?? 0;
    if (!(gain > 0) || !(Number(frame.hz) > 0)) {
      if (this.#open) this.#close(now, releaseTau);
      return;
    }
    this.#sing(frame.hz ?? 0, gain, frame, now);
  }

  #sing(hz: number, gain: number, frame: SoundFrame, now: number): void {
    const { tones, loudness, gate } = this.#graph;
    const cents = 1200 * Math.log2(hz / baseHz);
    const { level, tau } = this.#presence(frame.still ?? false, now);
    // A tone that starts anew starts at its pitch: nobody should hear where the last one ended.
    const anew = now >= this.#silentFrom;
    for (const { detune } of tones) {
      if (anew) jump(detune, cents, now);
      else glide(detune, cents, now, pitchTau);
    }
    if (anew) jump(loudness.gain, gain, now);
    else glide(loudness.gain, gain * level, now, tau);
    glide(this.#graph.sine.detune, 1200 * Math.log2((frame.second?.hz ?? hz) / baseHz), now, pitchTau);
    glide(this.#graph.second.gain, frame.second ? besides * frame.second.gain : 0, now, gainTau);
    glide(gate.gain, 1, now, attackTau);
    this.#silentFrom = fadeOut(gate.gain, now + patience, releaseTau);
    this.#open = true;
  }

  #presence(still: boolean, now: number): { level: number; tau: number } {
    if (!still) {
      this.#stillSince = now;
      return { level: 1, tau: gainTau };
    }
    this.#stillSince = Math.min(this.#stillSince, now);
    return now - this.#stillSince >= stillAfter
      ? { level: steppedBack, tau: 0.3 }
      : { level: 1, tau: gainTau };
  }

  #steer(frame: SoundFrame, now: number): void {
    const { plain, hollow, filter, tremolo, tremoloDepth, panner } = this.#graph;
    const negative = frame.negative ?? false;
    glide(plain.gain, negative ? 0 : 1, now, gainTau);
    glide(hollow.gain, negative ? 1 : 0, now, gainTau);
    glide(filter.frequency, frame.dull ? 400 : 20000, now, pitchTau);
    glide(tremolo.gain, frame.tremolo ? 0.75 : 1, now, gainTau);
    glide(tremoloDepth.gain, frame.tremolo ? 0.25 : 0, now, gainTau);
    glide(panner.pan, Math.min(Math.max(frame.pan ?? 0, -1), 1), now, pitchTau);
  }

  #close(now: number, tau: number): void {
    this.#graph.gate.gain.cancelScheduledValues(now);
    this.#silentFrom = Math.min(this.#silentFrom, fadeOut(this.#graph.gate.gain, now, tau));
    this.#open = false;
    this.#stillSince = Number.POSITIVE_INFINITY;
  }

  #release(now: number, tau: number): void {
    this.#ticks.stop(now);
    if (this.#open) this.#close(now, tau);
  }

  stop(): void {
    const now = this.#context.currentTime;
    this.#ticks.stop(now);
    this.#close(now, stopTau);
    this.#graph.events.gain.cancelScheduledValues(now);
    fadeOut(this.#graph.events.gain, now, stopTau);
    this.#eventEnds = now;
  }

  event(kind: EventKind): boolean {
    if (!this.#isRunning()) return false;
    const now = this.#context.currentTime;
    const { weight, seconds } = earcons[kind];
    if (now - (this.#lastEvent.get(kind) ?? Number.NEGATIVE_INFINITY) < 0.5) return false;
    if (now < this.#eventEnds && weight <= this.#eventWeight) return false;
    this.#lastEvent.set(kind, now);
    this.#eventEnds = now + seconds;
    this.#eventWeight = weight;
    const { events, duck } = this.#graph;
    events.gain.cancelScheduledValues(now);
    events.gain.setValueAtTime(1, now);
    earcons[kind].play(this.#context, events, now);
    glide(duck.gain, 0.5, now, gainTau);
    duck.gain.setTargetAtTime(1, now + seconds, 0.03);
    return true;
  }

  #playTick(time: number): () => void {
    const source = new AudioBufferSourceNode(this.#context, { buffer: this.#graph.burst });
    source.connect(this.#graph.tickInput);
    source.start(time);
    return () => source.disconnect();
  }

  setMuted(muted: boolean): void {
    this.#muted = muted;
    this.#setLevel();
  }
  setMaster(master: number): void {
    this.#master = Math.min(Math.max(master, 0), 1);
    this.#setLevel();
  }
  #setLevel(): void {
    const now = this.#context.currentTime;
    const { gain } = this.#graph.master;
    if (this.#muted) {
      gain.cancelScheduledValues(now);
      fadeOut(gain, now, releaseTau);
    } else {
      glide(gain, this.#master, now, 0.04);
    }
  }
  setMono(mono: boolean): void {
    const now = this.#context.currentTime;
    const { panned, centred } = this.#graph;
    panned.gain.cancelScheduledValues(now);
    centred.gain.cancelScheduledValues(now);
    if (mono) fadeOut(panned.gain, now, gainTau);
    else panned.gain.setTargetAtTime(1, now, gainTau);
    if (mono) centred.gain.setTargetAtTime(Math.SQRT1_2, now, gainTau);
    else fadeOut(centred.gain, now, gainTau);
  }

  /** A live context that nobody has let start stays silent and collects nothing. */
  #isRunning(): boolean {
    const live = typeof AudioContext !== "undefined" && this.#context instanceof AudioContext;
    return !live || this.#context.state === "running";
  }

  dispose(): void {
    this.#ticks.stop(0);
    for (const source of this.#graph.sources) source.stop();
    this.#graph.limiter.disconnect();
  }
}

/** Builds the voices on a context. Nothing sounds before `update`; the context itself needs a gesture to run. */
export function createSound(context: BaseAudioContext, options: Partial<SoundOptions> = {}): Sound {
  return new Engine(context, { ...defaultSound, ...options });
}
