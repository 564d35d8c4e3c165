// SPDX-License-Identifier: Apache-2.0
// Path listening: through nodes that the person picks, along edges of the skin; a marker walks it and all senses follow.
import { findNode, placeOnWalk, type Walk, walkThrough } from "../../probe";
import { numberText, type PanelPage, pathTemplate, type Section, unitText } from "../../ui";
import type { App } from "../app";
import { chosenNode } from "../chosen-node";
import { PIN } from "../probing";
import type { Feature, PlaceMark } from "./feature";

/** Seconds of a walk: what there is to choose from. */
const PACES = [1, 2, 3, 5, 10] as const;

export class Path implements Feature {
  readonly id = "path";
  readonly #app: App;
  #nodes: readonly number[] = [];
  #walk: Walk | null = null;
  #seconds: number = 3;
  #running: { start: number; end: () => void } | null = null;
  #share: number | null = null;

  constructor(app: App) {
    this.#app = app;
    app.atEnd(app.stage.onFrame(() => this.#frame(performance.now() / 1000)));
  }

  /** The node pressed or gone to last becomes the next place of the path. */
  add(): void {
    const node = chosenNode(this.#app);
    if (node === null) {
      this.#app.say("Point at a node first, or go to one.");
      return;
    }
    if (node === this.#nodes.at(-1)) {
      this.#app.say(`Node ${node} is the path's end already.`);
      return;
    }
    const nodes = [...this.#nodes, node];
    const walk = walkThrough(this.#app.view.scene.parts, nodes);
    if (nodes.length > 1 && !walk) {
      this.#app.say(`No way along the skin leads from node ${nodes.at(-2)} to node ${node}.`);
      return;
    }
    this.#set(nodes, walk);
    this.#app.say(walk ? `Path of ${this.lengthText}.` : `The path begins at node ${node}.`);
  }

  clear(): void {
    this.#stop();
    this.#set([], null);
  }

  setSeconds(seconds: number): void {
    this.#seconds = seconds;
    this.#app.refreshPage();
  }

  #set(nodes: readonly number[], walk: Walk | null): void {
    this.#nodes = nodes;
    this.#walk = walk;
    this.#app.refreshPage();
  }

  get lengthText(): string {
    const unit = unitText(this.#app.view.scene.extras.lengthUnit?.name);
    return this.#walk ? `${numberText(this.#walk.length, 4)} ${unit}`.trim() : "";
  }

  /** Walks it, or stops. */
  play(): void {
    if (this.#running) {
      this.#stop();
      return;
    }
    if (!this.#walk) {
      this.#app.say("Mark two nodes of a path first.");
      return;
    }
    const { senses, stage, probing, view } = this.#app;
    senses.wake();
    this.#running = { start: performance.now() / 1000, end: stage.keepRunning() };
    probing.move(PIN, "keyboard", placeOnWalk(this.#walk, 0));
    const pin = probing.pinned;
    // What the path's values shake is the hand that has something to shake.
    if (pin) pin.actuator = [...probing.pointers].find((p) => p.actuator)?.actuator ?? null;
    probing.hold(PIN, "keyboard", true);
    const heard = ["pitch", "ticks", "pulses"] as const;
    if (!heard.some((slot) => view.shownAs(slot)))
      this.#app.say("Nothing is heard: give a result a tone first.");
    this.#app.refreshPage();
  }

  #frame(seconds: number): void {
    const running = this.#running;
    if (!running || !this.#walk) return;
    const { probing, senses } = this.#app;
    // Somebody let go of everything: the page lost its focus, or a key was lifted.
    if (!probing.pinned?.held) {
      this.#stop();
      return;
    }
    const share = (seconds - running.start) / this.#seconds;
    const before = this.#share ?? 0;
    this.#share = Math.min(share, 1);
    probing.move(PIN, "keyboard", placeOnWalk(this.#walk, this.#share));
    if (Math.floor(10 * before) < Math.floor(10 * this.#share) && share < 1) senses.mark();
    this.#app.invalidate();
    if (share >= 1) this.#stop();
  }

  #stop(): void {
    this.#running?.end();
    this.#running = null;
    const { probing } = this.#app;
    probing.hold(PIN, "keyboard", false);
    const pin = probing.pinned;
    if (pin) pin.actuator = null;
    if (this.#share !== null) this.#app.say(this.#caption());
    this.#share = null;
    this.#app.refreshPage();
  }

  /** "0.42 m: 187 MPa": how far, and what is there. */
  #caption(): string {
    const { view, probing } = this.#app;
    const way = (this.#walk?.length ?? 0) * (this.#share ?? 0);
    const length = `${numberText(way, 4)} ${unitText(view.scene.extras.lengthUnit?.name)}`.trim();
    const heard = view.shownAs("pitch") ?? view.shownAs("ticks") ?? view.shownAs("colour");
    const entry = probing.report()?.results.find((r) => r.key === heard?.key);
    return entry ? `${length}: ${numberText(entry.value, 4)} ${unitText(entry.unit)}` : length;
  }

  section(): Section {
    const model = {
      nodes: this.#nodes,
      length: this.lengthText,
      seconds: this.#seconds,
      paces: PACES,
      playing: this.#running !== null,
      ready: this.#walk !== null,
    };
    return {
      id: this.id,
      title: "Listen along a path",
      summary: this.lengthText,
      body: () => pathTemplate(model, this),
    };
  }

  page(): PanelPage {
    const text = this.#nodes.length === 0 ? "No node yet" : `${this.#nodes.join(" – ")}`;
    const playing = this.#running !== null;
    return {
      id: this.id,
      title: "Path",
      rows: [
        {
          text,
          detail: this.lengthText || "press a node on the model, then add it",
          buttons: [
            { id: "add", text: "Add node", press: () => this.add() },
            {
              id: "play",
              text: playing ? "Stop" : "Listen",
              on: playing,
              enabled: this.#walk !== null,
              press: () => this.play(),
            },
            { id: "clear", text: "Clear", press: () => this.clear() },
          ],
        },
        {
          text: `In ${this.#seconds} seconds`,
          buttons: PACES.map((pace) => ({
            id: `pace:${pace}`,
            text: `${pace} s`,
            on: pace === this.#seconds,
            press: () => this.setSeconds(pace),
          })),
        },
      ],
    };
  }

  marks(): PlaceMark[] {
    const { parts } = this.#app.view.scene;
    return this.#nodes.flatMap((node, i): PlaceMark[] => {
      const place = findNode(parts, node);
      return place ? [{ kind: "ruler", id: `path-${i}`, text: `path ${i + 1}`, detail: "", place }] : [];
    });
  }

  commands() {
    return [
      { keys: ["2"], shown: "2", text: "add this node to the path", down: () => this.add() },
      { keys: ["3"], shown: "3", text: "listen along the path", down: () => this.play() },
    ];
  }

  report() {
    const path = {
      nodes: [...this.#nodes],
      length: this.#walk?.length ?? 0,
      seconds: this.#seconds,
      at: this.#share,
    };
    return { path };
  }
}
