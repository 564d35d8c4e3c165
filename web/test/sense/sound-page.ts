// SPDX-License-Identifier: Apache-2.0
// Runs in the browser of the sound tests: renders a script of calls through the sound engine, faster than real time.
import { createSound, type EventKind, type SoundFrame, type SoundOptions } from "../../src/sense";

export type Step =
  | { at: number; update: SoundFrame | null }
  | { at: number; event: EventKind }
  | { at: number; call: "stop" | "mute" | "unmute" };

export interface Script {
  seconds: number;
  options: Partial<SoundOptions>;
  steps: Step[];
  /** Samples the device asks for at once: what is called meanwhile is heard from the next on. */
  block?: number;
}

const sampleRate = 48000;

async function render(script: Script): Promise<string[]> {
  const context = new OfflineAudioContext(2, Math.round(script.seconds * sampleRate), sampleRate);
  const sound = createSound(context, script.options);
  const apply = (step: Step) => {
    if ("update" in step) sound.update(step.update);
    else if ("event" in step) sound.event(step.event);
    else if (step.call === "stop") sound.stop();
    else sound.setMuted(step.call === "mute");
  };
  // Calls are heard from the next block on, as they are live.
  const size = script.block ?? 128;
  const byBlock = new Map<number, Step[]>();
  for (const step of script.steps) {
    const block = Math.ceil((step.at * sampleRate) / size - 1e-6);
    byBlock.set(block, [...(byBlock.get(block) ?? []), step]);
  }
  for (const [block, steps] of byBlock) {
    if (block === 0) {
      steps.forEach(apply);
      continue;
    }
    context.suspend((block * size) / sampleRate).then(() => {
      steps.forEach(apply);
      void context.resume();
    });
  }
  const buffer = await context.startRendering();
  return [0, 1].map((channel) => {
    const bytes = new Uint8Array(buffer.getChannelData(channel).buffer);
    let text = "";
    for (let i = 0; i < bytes.length; i += 32768)
      text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
  });
}

/** A live context made before anybody touched the page, fed a tone once a frame. */
class Live {
  readonly context = new AudioContext();
  readonly #sound = createSound(this.context, { master: 1, mono: true });
  readonly #tap = new AnalyserNode(this.context, { fftSize: 16384 });
  frame: SoundFrame | null = null;

  constructor() {
    this.#sound.output.connect(this.#tap);
    const step = () => {
      this.#sound.update(this.frame);
      requestAnimationFrame(step);
    };
    step();
    addEventListener("pointerdown", () => void this.context.resume());
  }
  state(): string {
    return this.context.state;
  }
  stop(): void {
    this.frame = null;
    this.#sound.stop();
  }
  heard(): number[] {
    const samples = new Float32Array(this.#tap.fftSize);
    this.#tap.getFloatTimeDomainData(samples);
    return [this.context.sampleRate, ...samples];
  }
}

Object.assign(globalThis, { render, live: new Live() });
