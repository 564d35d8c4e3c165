// SPDX-License-Identifier: Apache-2.0
// window.feelem: what tests and scripts may read (docs/page-api.md). It changes nothing.
import type { FeelemExtras } from "../scene";
import type { Reading } from "./opening";
import type { PresentationDoc } from "./presentation-doc";
import type { ProbeReport } from "./probe-report";

export interface PulseRecord {
  /** Milliseconds since the page was opened. */
  readonly time: number;
  readonly pointer: string;
  readonly amplitude: number;
  readonly ms: number;
}

export interface PageState {
  readonly presentation: PresentationDoc;
  /** Id of the step that is shown. */
  readonly step: number;
  readonly deformationFactor: number;
  readonly session: "none" | "immersive-vr";
  /** Only the shape is there. */
  readonly reading: Reading | null;
  /** What each feature says of itself (docs/page-api.md). */
  readonly [feature: string]: unknown;
}

export interface PageApi {
  /** Resolves when the scene is drawn; rejects when it cannot be. */
  readonly ready: Promise<void>;
  scene(): FeelemExtras | null;
  state(): PageState | null;
  lastProbe(): ProbeReport | null;
  pulses(): PulseRecord[];
}

declare global {
  interface Window {
    readonly feelem: PageApi;
  }
}

/** What the api reads; null until a scene is open. */
export interface ApiSource {
  extras(): FeelemExtras;
  state(): PageState;
  report(): ProbeReport | null;
  pulses(): readonly PulseRecord[];
}

/** Hands out copies, so that nobody can change the page through them. */
export function publishApi(ready: Promise<void>, source: () => ApiSource | null): void {
  const copy = <T>(value: T): T => structuredClone(value);
  const api: PageApi = {
    ready,
    scene: () => copy(source()?.extras() ?? null),
    state: () => copy(source()?.state() ?? null),
    lastProbe: () => copy(source()?.report() ?? null),
    pulses: () => copy([...(source()?.pulses() ?? [])]),
  };
  Object.defineProperty(window, "feelem", { value: Object.freeze(api), enumerable: true });
}
