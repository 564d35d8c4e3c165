// SPDX-License-Identifier: Apache-2.0
// Measures on sampled sound.

export const sampleRate = 48000;

export const decibel = (ratio: number) => 20 * Math.log10(ratio);
export const part = (x: Float32Array, from: number, to: number) =>
  x.subarray(Math.round(from * sampleRate), Math.round(to * sampleRate));

export function peak(x: Float32Array): number {
  let largest = 0;
  for (const v of x) largest = Math.max(largest, Math.abs(v));
  return largest;
}

export function rms(x: Float32Array): number {
  let sum = 0;
  for (const v of x) sum += v * v;
  return Math.sqrt(sum / x.length);
}

/** Amplitude of the component at a frequency (Hann window). */
export function amplitudeAt(x: Float32Array, hz: number): number {
  let [re, im, weight] = [0, 0, 0];
  for (let i = 0; i < x.length; i++) {
    const window = 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / (x.length - 1));
    const phase = (2 * Math.PI * hz * i) / sampleRate;
    re += (x[i] ?? 0) * window * Math.cos(phase);
    im += (x[i] ?? 0) * window * Math.sin(phase);
    weight += window;
  }
  return (2 * Math.hypot(re, im)) / weight;
}

function correlation(x: Float32Array, lag: number): number {
  const count = x.length - lag;
  let sum = 0;
  for (let i = 0; i < count; i++) sum += (x[i] ?? 0) * (x[i + lag] ?? 0);
  return sum / count;
}

function peakNear(x: Float32Array, lag: number, reach: number): number {
  let best = Math.round(lag);
  for (let l = Math.round(lag - reach); l <= lag + reach; l++) {
    if (correlation(x, l) > correlation(x, best)) best = l;
  }
  const [a, b, c] = [correlation(x, best - 1), correlation(x, best), correlation(x, best + 1)];
  return best + (0.5 * (a - c)) / (a - 2 * b + c);
}

/** Fundamental of a steady tone between 100 and 1200 Hz, by autocorrelation refined over sixteen periods. */
export function fundamental(x: Float32Array): number {
  const shortest = Math.floor(sampleRate / 1200);
  const longest = Math.ceil(sampleRate / 100);
  let largest = 0;
  const all: number[] = [];
  for (let lag = shortest; lag <= longest; lag++) {
    all.push(correlation(x, lag));
    largest = Math.max(largest, all.at(-1) ?? 0);
  }
  // The first of the equal peaks is the period; the others are its multiples.
  let first = all.findIndex((v) => v > 0.95 * largest);
  while ((all[first + 1] ?? 0) > (all[first] ?? 0)) first++;
  let period = peakNear(x, shortest + first, 2);
  for (const count of [2, 4, 8, 16]) period = peakNear(x, count * period, 2) / count;
  return sampleRate / period;
}

/** Fourth-order Butterworth high-pass, as two sections. */
export function highPass(x: Float32Array, hz: number): Float32Array {
  let y = Float64Array.from(x);
  for (const q of [0.5411961, 1.306563]) {
    const w = (2 * Math.PI * hz) / sampleRate;
    const [cos, alpha] = [Math.cos(w), Math.sin(w) / (2 * q)];
    const a0 = 1 + alpha;
    const [b0, b1] = [(1 + cos) / 2 / a0, -(1 + cos) / a0];
    const [a1, a2] = [(-2 * cos) / a0, (1 - alpha) / a0];
    const out = new Float64Array(y.length);
    let [x1, x2, y1, y2] = [0, 0, 0, 0];
    for (let i = 0; i < y.length; i++) {
      const v = y[i] ?? 0;
      const o = b0 * v + b1 * x1 + b0 * x2 - a1 * y1 - a2 * y2;
      [x2, x1, y2, y1] = [x1, v, y1, o];
      out[i] = o;
    }
    y = out;
  }
  return Float32Array.from(y);
}

/** Times at which a burst begins: first sample above the level after 20 ms below it. */
export function onsets(x: Float32Array, level: number): number[] {
  const times: number[] = [];
  let quietSince = Number.NEGATIVE_INFINITY;
  let loud = false;
  for (let i = 0; i < x.length; i++) {
    if (Math.abs(x[i] ?? 0) > level) {
      if (!loud && i - quietSince > 0.02 * sampleRate) times.push(i / sampleRate);
      loud = true;
      quietSince = i;
    } else if (i - quietSince > 0.02 * sampleRate) {
      loud = false;
    }
  }
  return times;
}
