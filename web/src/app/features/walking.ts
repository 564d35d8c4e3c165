// SPDX-License-Identifier: Apache-2.0
// Walking at the desk with W, A, S and D, for who wants that: as long as a key is down, never by itself.
import { html } from "lit";
import type { KeyCommand } from "../../input/keyboard";
import type { Section } from "../../ui";
import type { App } from "../app";
import type { Feature } from "./feature";
import type { Listening } from "./listening";

/** Of the model's diagonal a second. */
const SPEED = 0.4;
/** Longer pauses between pictures are not made up for, seconds. */
const LONGEST = 0.25;
const WAYS: Readonly<Record<string, readonly [number, number]>> = {
  w: [0, 1],
  s: [0, -1],
  a: [-1, 0],
  d: [1, 0],
};

export class Walking implements Feature {
  readonly id = "walking";
  readonly #app: App;
  readonly #down = new Set<string>();
  #stopRunning: (() => void) | null = null;
  #last = 0;

  constructor(app: App) {
    this.#app = app;
    app.atEnd(app.stage.onFrame((seconds) => this.#frame(seconds)));
  }

  get #on(): boolean {
    const { person, session } = this.#app.store.state;
    return person.walkKeys && session === "none";
  }

  #press(key: string): void {
    this.#down.add(key.toLowerCase());
    this.#stopRunning ??= this.#app.stage.keepRunning();
  }

  #release(key: string): void {
    this.#down.delete(key);
    if (this.#down.size > 0) return;
    this.#stopRunning?.();
    this.#stopRunning = null;
  }

  #frame(seconds: number): void {
    const passed = Math.min(Math.max(seconds - this.#last, 0), LONGEST);
    this.#last = seconds;
    if (this.#down.size === 0 || !this.#on) return;
    let [right, ahead] = [0, 0];
    for (const key of this.#down) {
      const [x, z] = WAYS[key] ?? [0, 0];
      right += x;
      ahead += z;
    }
    const { stage, view } = this.#app;
    const way = SPEED * passed * 2 * view.model.sphere().radius;
    stage.orbit.walk(right * way, ahead * way);
    this.#app.invalidate();
  }

  commands(): readonly KeyCommand[] {
    const walk = (key: string, text: string): KeyCommand => ({
      keys: [key],
      shown: key.toUpperCase(),
      text: `hold: ${text}, where walking is on (else, and with Shift, as below)`,
      when: (event) => this.#on && !event.shiftKey,
      down: (pressed) => this.#press(pressed),
      up: () => this.#release(key),
    });
    return [walk("w", "walk ahead"), walk("a", "to the left"), walk("s", "back"), walk("d", "to the right")];
  }

  section(): Section {
    const { walkKeys } = this.#app.store.state.person;
    const change = (event: Event) =>
      this.#app
        .feature<Listening>("listening")
        .change({ walkKeys: (event.target as HTMLInputElement).checked });
    const body =
      () => html`<label class="check"><input type="checkbox" .checked=${walkKeys} @change=${change} />
        walk with W, A, S, D</label>
      <p class="hint">While it is on, Shift with these keys gives what they mean otherwise.</p>`;
    return { id: this.id, title: "Walking", summary: walkKeys ? "W A S D" : "off", body };
  }
}
