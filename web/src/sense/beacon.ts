// SPDX-License-Identifier: Apache-2.0
// A beacon: ticks that come from where a place is, also from behind; the faster, the nearer one points at it.
import { tickBurst } from "./signals";
import { TickClock } from "./tick-clock";

/** A direction from the middle of the head: right, up, back (as WebGL's eye space has it). */
export type HeadDirection = readonly [number, number, number];

const [slowest, span] = [1.5, 8];
/** Degrees: nearer than the first is on it, further than the last as far as can be. */
const [onIt, beside] = [2, 60];

const AHEAD: HeadDirection = [0, 0, -1];

/** Ticks a second from the angle between where one points and where the place is, radians. */
export function beaconRate(angle: number): number {
  const degrees = (angle * 180) / Math.PI;
  const u = 1 - Math.min(Math.max((degrees - onIt) / (beside - onIt), 0), 1);
  return slowest * span ** u;
}

/** "ahead", "to the left", "behind, to the right, above": where it is, in words. */
export function directionWords([right, up, back]: HeadDirection): string {
  const size = Math.hypot(right, up, back) || 1;
  const words = [
    back > 0.35 * size ? "behind" : "",
    Math.abs(right) > 0.25 * size ? (right > 0 ? "to the right" : "to the left") : "",
    Math.abs(up) > 0.35 * size ? (up > 0 ? "above" : "below") : "",
  ].filter((word) => word !== "");
  return words.length > 0 ? words.join(", ") : "ahead";
}

export class Beacon {
  readonly #context: BaseAudioContext;
  readonly #panner: PannerNode;
  readonly #ticks: TickClock;

  /** `output`: where the master's level and the limiter begin. */
  constructor(context: BaseAudioContext, output: AudioNode) {
    this.#context = context;
    this.#panner = new PannerNode(context, {
      panningModel: "HRTF",
      distanceModel: "linear",
      rolloffFactor: 0,
    });
    this.#panner.connect(output);
    const burst = tickBurst(context);
    this.#ticks = new TickClock((time) => {
      const source = new AudioBufferSourceNode(context, { buffer: burst });
      source.connect(this.#panner);
      source.start(time);
      return () => source.disconnect();
    });
  }

  /** Once a frame; null: silence. Mono: the same in both ears, where is told by the rate alone. */
  update(direction: HeadDirection | null, rate: number, mono: boolean): void {
    const now = this.#context.currentTime;
    if (!direction) {
      this.#ticks.stop(now);
      return;
    }
    // Straight ahead is the same in both ears.
    const from = mono ? AHEAD : direction;
    const size = Math.hypot(...from) || 1;
    const { positionX, positionY, positionZ } = this.#panner;
    [positionX, positionY, positionZ].forEach((axis, i) => {
      axis.setTargetAtTime((from[i] ?? 0) / size, now, 0.02);
    });
    this.#ticks.update(now, rate);
  }

  dispose(): void {
    this.#ticks.stop(0);
    this.#panner.disconnect();
  }
}
