// SPDX-License-Identifier: Apache-2.0
// What this device can do, measured here and now, as text to copy into a report. `#diag` in the address unfolds it.
import { deviceTemplate, type Section } from "../../ui";
import type { App } from "../app";
import type { Feature } from "./feature";

const FRAMES = 60;

export class Device implements Feature {
  readonly id = "device";
  readonly #app: App;
  #text = "";
  #measuring = false;

  constructor(app: App) {
    this.#app = app;
    // Once the page stands: links take the address for themselves.
    if (location.hash === "#diag") queueMicrotask(() => this.#unfold());
  }

  #unfold(): void {
    const { open } = this.#app.store.state;
    this.#app.store.set({ open: [...open, this.id] });
    void this.measure();
  }

  async measure(): Promise<void> {
    if (this.#measuring) return;
    this.#measuring = true;
    this.#text = "";
    this.#app.refreshPage();
    const lines = [
      ...this.#browser(),
      ...this.#graphics(),
      ...(await this.#headset()),
      ...(await this.#sound()),
      ...this.#hands(),
      ...(await this.#frames()),
    ];
    this.#text = lines.map(([what, value]) => `${what}: ${value}`).join("\n");
    this.#measuring = false;
    this.#app.refreshPage();
  }

  async copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.#text);
      this.#app.say("Copied.");
    } catch {
      this.#app.say("This browser does not let the page copy: mark the text and copy it.");
    }
  }

  #browser(): [string, string][] {
    const { userAgent, hardwareConcurrency, language } = navigator;
    const screen = `${window.innerWidth} x ${window.innerHeight} at ${window.devicePixelRatio}`;
    return [
      ["browser", userAgent],
      ["language", language],
      ["threads", String(hardwareConcurrency)],
      ["window", screen],
      ["secure page", window.isSecureContext ? "yes" : "no: no headset"],
      ["animations", matchMedia("(prefers-reduced-motion: reduce)").matches ? "reduced" : "wanted"],
    ];
  }

  #graphics(): [string, string][] {
    const gl = this.#app.stage.renderer.getContext();
    const named = gl.getExtension("WEBGL_debug_renderer_info");
    const who = gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    return [
      ["graphics", String(who)],
      ["largest texture", String(gl.getParameter(gl.MAX_TEXTURE_SIZE))],
      ["triangles of this scene", String(this.#triangles())],
    ];
  }

  #triangles(): number {
    return this.#app.view.scene.parts.reduce((sum, part) => sum + part.indices.length / 3, 0);
  }

  async #headset(): Promise<[string, string][]> {
    if (!navigator.xr) return [["headset", "this browser has no WebXR"]];
    const ask = async (mode: XRSessionMode) => {
      try {
        return (await navigator.xr?.isSessionSupported(mode)) ? "yes" : "no";
      } catch {
        return "refused";
      }
    };
    return [
      ["headset (immersive-vr)", await ask("immersive-vr")],
      ["see-through (immersive-ar)", await ask("immersive-ar")],
    ];
  }

  async #sound(): Promise<[string, string][]> {
    const context = new AudioContext();
    const latency = 1000 * (context.baseLatency + (context.outputLatency || 0));
    const answer: [string, string][] = [
      ["sound", `${context.sampleRate} Hz, ${context.state}, ${latency.toFixed(1)} ms late`],
    ];
    await context.close();
    return answer;
  }

  #hands(): [string, string][] {
    const pointers = [...this.#app.probing.pointers].map(
      (p) => `${p.name}${p.actuator ? " (can shake)" : ""}`,
    );
    const pads = navigator.getGamepads?.().filter((pad) => pad !== null).length ?? 0;
    return [
      ["pointers seen so far", pointers.join(", ") || "none"],
      ["gamepads", String(pads)],
      ["phone's vibration", "vibrate" in navigator ? "there is a way" : "none"],
    ];
  }

  /** Times of frames that are drawn one after the other. */
  #frames(): Promise<[string, string][]> {
    const end = this.#app.stage.keepRunning();
    return new Promise((resolve) => {
      const times: number[] = [];
      let last = performance.now();
      const remove = this.#app.stage.onFrame(() => {
        const now = performance.now();
        times.push(now - last);
        last = now;
        if (times.length < FRAMES) return;
        remove();
        end();
        const sorted = times.slice(1).sort((a, b) => a - b);
        const at = (share: number) => (sorted[Math.floor(share * (sorted.length - 1))] ?? 0).toFixed(1);
        const { level, levels, budgetMs, resolution, edges } = this.#app.stage.quality.report();
        const lines = edges ? "with edges" : "without edges";
        const picture = `level ${level} of ${levels - 1}: ${Math.round(100 * resolution)} % of the pixels along each side, ${lines}`;
        const governed = `${picture}; wanted: ${budgetMs.toFixed(1)} ms a frame; finest at rest; values are the same at every level`;
        resolve([
          ["frames", `half within ${at(0.5)} ms, 95 % within ${at(0.95)} ms, of ${FRAMES}`],
          ["picture while it moves", governed],
        ]);
      });
    });
  }

  section(): Section {
    const model = { text: this.#text, measuring: this.#measuring };
    return { id: this.id, title: "This device", summary: "", body: () => deviceTemplate(model, this) };
  }

  report() {
    return { device: this.#text || null, governor: this.#app.stage.quality.report() };
  }
}
