// SPDX-License-Identifier: Apache-2.0
// A scene that its server is still making: how far it is (docs/serving.md). No DOM but the page's head.

/** What the server says of the scene. */
export interface OpeningNews {
  readonly state: "reading" | "ready" | "failed";
  /** To ask for later news only. */
  readonly version: number;
  readonly stage: string;
  readonly percent: number;
  /** Why it failed. */
  readonly text: string;
}

/** What the page says while it shows the shape alone. */
export interface Reading {
  readonly stage: string;
  readonly percent: number;
  /** Why there will be no results; null: they are still being read. */
  readonly failed: string | null;
}

/** A server that does not answer is asked again: a network may stumble. */
const TRIES = 3;
const PAUSE_MS = 700;
const STAGES: Readonly<Record<string, string>> = {
  results: "reading results",
  levels: "making levels of detail",
  hash: "checking the files",
  write: "making the scene",
};

/** "reading results, 40 %" */
export function stageText({ stage, percent }: Reading): string {
  return `${STAGES[stage] ?? "reading results"}, ${percent} %`;
}

export class Opening {
  /** Address of a scene of the shape alone, until the scene itself is there. */
  readonly shape = "shape.glb";
  readonly #address: string;
  readonly #pause: (milliseconds: number) => Promise<void>;

  constructor(
    address: string,
    pause = (milliseconds: number) => new Promise<void>((later) => setTimeout(later, milliseconds)),
  ) {
    this.#address = address;
    this.#pause = pause;
  }

  /** Null: the page's server has the scene. */
  static find(): Opening | null {
    const meta = document.querySelector<HTMLMetaElement>("meta[name=feelem-opening]");
    return meta ? new Opening(meta.content) : null;
  }

  /** What is new since that version, as soon as something is; 0: what is known now. */
  async ask(after: number): Promise<OpeningNews> {
    for (let tries = 1; ; ++tries) {
      try {
        const response = await fetch(`${this.#address}?after=${after}`);
        if (response.ok) return (await response.json()) as OpeningNews;
      } catch {
        // Asked again below.
      }
      if (tries >= TRIES) throw new Error("Feelem was ended before they were read");
      await this.#pause(PAUSE_MS);
    }
  }
}
