// SPDX-License-Identifier: Apache-2.0
// The legend for ear and hand, the way to the largest value by ear, and how the person wants sound and touch.

import { MISSING } from "../../scene";
import { type EventKind, pitchLegend, pulseLegend, rankOf, tickLegend } from "../../sense";
import { listeningTemplate, numberText, type PanelPage, type Section, unitText } from "../../ui";
import type { App } from "../app";
import type { Shown } from "../model-view";
import { type Person, rememberPerson } from "../person";
import { personalPitch, personalPulse } from "../personal";
import { pitchEffect, pulseEffect, pulseFallback, tickEffect } from "../presentation-doc";
import type { Feature } from "./feature";

const CAPTIONS: Partial<Record<EventKind, string>> = {
  limitUp: "limit passed",
  limitDown: "back within the limit",
  noValue: "no value here",
  maximum: "the largest value",
  minimum: "the smallest value",
};

export class Listening implements Feature {
  readonly id = "listening";
  readonly #app: App;
  #sorted: { key: readonly unknown[]; values: Float32Array } = { key: [], values: new Float32Array() };
  #next = 0;

  constructor(app: App) {
    this.#app = app;
    app.senses.setRank((value) => this.#rank(value));
    app.senses.onEvent((kind) => {
      const caption = CAPTIONS[kind];
      if (caption && app.store.state.person.captions) app.say(caption);
    });
    document.documentElement.dataset.hand = app.store.state.person.leftHanded ? "left" : "right";
  }

  change(change: Partial<Person>): void {
    const person = { ...this.#app.store.state.person, ...change };
    rememberPerson(person);
    this.#app.store.set({ person });
    document.documentElement.dataset.hand = person.leftHanded ? "left" : "right";
  }

  /** Rank of a value of what is seen among all visible nodes, sorted once. */
  #rank(value: number): number {
    const { view, store } = this.#app;
    const seen = view.shownAs("colour");
    if (!seen) return 0;
    const key = [seen.fields, seen.componentIndex, store.state.hidden];
    if (key.some((k, i) => k !== this.#sorted.key[i])) this.#sorted = { key, values: this.#visible(seen) };
    return rankOf(this.#sorted.values, value);
  }

  #visible(seen: Shown): Float32Array {
    const { parts } = this.#app.view.scene;
    const out = new Float32Array(parts.reduce((sum, part) => sum + part.nodeIds.length, 0));
    let count = 0;
    for (const [index, part] of parts.entries()) {
      const field = seen.fields[index];
      if (!field || this.#app.store.state.hidden.includes(part.index)) continue;
      for (let v = 0; v < part.nodeIds.length; ++v) {
        if (part.nodeIds[v] === 0 || field.state[v] === MISSING) continue;
        out[count] = field.values[v * field.components + seen.componentIndex] ?? 0;
        count += 1;
      }
    }
    return out.slice(0, count).sort();
  }

  #legends() {
    const { view, store, senses } = this.#app;
    const { doc, person } = store.state;
    const pitch = personalPitch(pitchEffect(doc), person);
    const ticks = tickEffect(doc);
    const pulses = personalPulse(pulseEffect(doc), person);
    const standIn = senses.canVibrate ? null : pulseFallback(doc);
    const ends = (s: Shown) =>
      `${numberText(s.range.lo, 4)} to ${numberText(s.range.hi, 4)} ${unitText(s.unit)}`;
    const ways = [
      { id: "pitch", shown: view.shownAs("pitch"), legend: pitch && pitchLegend(pitch), verb: "Hear" },
      { id: "ticks", shown: view.shownAs("ticks"), legend: ticks && tickLegend(ticks), verb: "Hear" },
      {
        id: "pulses",
        shown: view.shownAs("pulses"),
        legend: pulses && (standIn ? tickLegend(standIn) : pulseLegend(pulses)),
        verb: standIn ? "Hear" : "Feel",
      },
    ];
    return ways.flatMap(({ id, shown, legend, verb }) => {
      if (!shown || !legend) return [];
      const play = () => {
        senses.playLegend(legend);
        if (store.state.person.captions) this.#app.say(`${shown.label}: ${ends(shown)}`);
      };
      return [{ id, text: `${verb} ${shown.label}`, play }];
    });
  }

  toggleGuide(): void {
    const guide = !this.#app.store.state.guide;
    this.#app.store.set({ guide });
    this.#app.say(
      guide ? "Press and sweep: the ticks are fastest at the largest value." : "Ticks mean values again.",
    );
  }

  section(): Section {
    const { person, guide } = this.#app.store.state;
    const body = () =>
      listeningTemplate({
        person,
        guide,
        legends: this.#legends(),
        change: (change) => this.change(change),
        toggleGuide: () => this.toggleGuide(),
      });
    return { id: this.id, title: "Sound and touch", summary: guide ? "finding the largest" : "", body };
  }

  page(): PanelPage {
    const { person, guide } = this.#app.store.state;
    const step = (key: "master" | "strength", by: number, most: number) => () =>
      this.change({ [key]: Math.min(Math.max(Number((person[key] + by).toFixed(2)), 0), most) });
    const flip = (key: "mono" | "captions" | "leftHanded", text: string) => ({
      id: key,
      text,
      on: person[key],
      press: () => this.change({ [key]: !person[key] }),
    });
    const rows = [
      ...this.#legends().map((l) => ({
        text: l.text,
        buttons: [{ id: `play:${l.id}`, text: "Play", press: l.play }],
      })),
      {
        text: "Find the largest by ear",
        buttons: [{ id: "guide", text: guide ? "On" : "Off", on: guide, press: () => this.toggleGuide() }],
      },
      {
        text: "Volume",
        detail: `${Math.round(100 * person.master)} %`,
        buttons: [
          { id: "quieter", text: "−", press: step("master", -0.1, 1) },
          { id: "louder", text: "+", press: step("master", 0.1, 1) },
        ],
      },
      {
        text: "Vibration",
        detail: `${Math.round(100 * person.strength)} %`,
        buttons: [
          { id: "weaker", text: "−", press: step("strength", -0.25, 1.5) },
          { id: "stronger", text: "+", press: step("strength", 0.25, 1.5) },
        ],
      },
      {
        text: "Ears, words, hands",
        buttons: [flip("mono", "Mono"), flip("captions", "Captions"), flip("leftHanded", "Left")],
      },
    ];
    return { id: this.id, title: "Sound", rows };
  }

  commands() {
    const next = () => {
      const legends = this.#legends();
      legends[this.#next % Math.max(legends.length, 1)]?.play();
      this.#next += 1;
    };
    return [
      { keys: ["q"], shown: "Q", text: "hear and feel the legends, one after the other", down: next },
      { keys: ["z"], shown: "Z", text: "find the largest value by ear", down: () => this.toggleGuide() },
    ];
  }

  report() {
    const { person, guide } = this.#app.store.state;
    return { person, guide, legendAt: this.#app.senses.legendAt, guideRate: this.#app.senses.guideRate };
  }
}
