// SPDX-License-Identifier: Apache-2.0
// The fixed signals of the sound engine, computed once and always the same.

/** A repeatable row of numbers in -1..1 (xorshift32). */
function noiseFrom(seed: number): () => number {
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2147483648 - 1;
  };
}

const tickSeconds = 0.016;
const tickPeak = 0.2;

/** One tick: white noise through a band-pass at 3.2 kHz, Q 4; 1 ms attack, decay of 4 ms, 16 ms in all. */
export function tickSamples(sampleRate: number): Float32Array<ArrayBuffer> {
  const samples = new Float32Array(Math.round(tickSeconds * sampleRate));
  const noise = noiseFrom(0x2545f491);
  const w = (2 * Math.PI * 3200) / sampleRate;
  const alpha = Math.sin(w) / 8;
  const [b, a1, a2] = [alpha / (1 + alpha), (-2 * Math.cos(w)) / (1 + alpha), (1 - alpha) / (1 + alpha)];
  let [x1, x2, y1, y2] = [0, 0, 0, 0];
  let peak = 0;
  const warmUp = 200;
  for (let i = -warmUp; i < samples.length; i++) {
    const x = noise();
    const y = b * (x - x2) - a1 * y1 - a2 * y2;
    [x2, x1, y2, y1] = [x1, x, y1, y];
    if (i < 0) continue;
    const t = i / sampleRate;
    const end = Math.min(1, (tickSeconds - t) / 0.002);
    samples[i] = y * Math.min(1, t / 0.001) * Math.exp(-Math.max(0, t - 0.001) / 0.004) * Math.max(0, end);
    peak = Math.max(peak, Math.abs(samples[i] ?? 0));
  }
  for (let i = 0; i < samples.length; i++) samples[i] = ((samples[i] ?? 0) * tickPeak) / peak;
  return samples;
}

function buffer(context: BaseAudioContext, samples: Float32Array<ArrayBuffer>): AudioBuffer {
  const made = context.createBuffer(1, samples.length, context.sampleRate);
  made.copyToChannel(samples, 0);
  return made;
}

export const tickBurst = (context: BaseAudioContext) => buffer(context, tickSamples(context.sampleRate));

/** Two seconds of pink noise (Kellet's filter), peak 1. */
export function pinkNoise(context: BaseAudioContext): AudioBuffer {
  const samples = new Float32Array(2 * context.sampleRate);
  const noise = noiseFrom(0x9e3779b9);
  let [b0, b1, b2] = [0, 0, 0];
  let peak = 0;
  for (let i = 0; i < samples.length; i++) {
    const white = noise();
    b0 = 0.99765 * b0 + white * 0.099046;
    b1 = 0.963 * b1 + white * 0.2965164;
    b2 = 0.57 * b2 + white * 1.0526913;
    samples[i] = b0 + b1 + b2 + white * 0.1848;
    peak = Math.max(peak, Math.abs(samples[i] ?? 0));
  }
  for (let i = 0; i < samples.length; i++) samples[i] = (samples[i] ?? 0) / peak;
  return buffer(context, samples);
}

const ceiling = 10 ** (-6 / 20);
const knee = 0.4;

/** Untouched up to the knee, then bent so that nothing passes -6 dBFS. */
export function limited(x: number): number {
  const size = Math.abs(x);
  if (size <= knee) return x;
  return Math.sign(x) * (knee + (ceiling - knee) * Math.tanh((size - knee) / (ceiling - knee)));
}

/** `limited` for a WaveShaperNode: odd length, so that silence stays exactly silent. */
export function limiterCurve(): Float32Array<ArrayBuffer> {
  const half = 5000;
  return Float32Array.from({ length: 2 * half + 1 }, (_, i) => limited((i - half) / half));
}
