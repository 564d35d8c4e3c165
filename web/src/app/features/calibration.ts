// SPDX-License-Identifier: Apache-2.0
// Ears, hands and eyes of this person on this device: six short steps, each of which can be left out.
import { defaultPitch, toneOf, type ValueRange } from "../../present";
import type { LegendMoment } from "../../sense";
import {
  CALIBRATION_STEPS,
  type CalibrationStep,
  calibrationTemplate,
  type PanelPage,
  type Section,
} from "../../ui";
import type { App } from "../app";
import { rememberPerson, WEAKEST } from "../person";
import { personalPitch } from "../personal";
import { setColour } from "../presentation-doc";
import type { Feature } from "./feature";
import type { Listening } from "./listening";

const UNIT: ValueRange = { lo: 0, hi: 1, scale: "linear" };
/** Pairs differ by so much of the range; low, where the ear is worst. */
const STEP = 0.02;
const PAIRS = [0.05, 0.2, 0.4] as const;
const FIRST_PULSE = 0.05;
const LOUDER = 1.25;

export class Calibration implements Feature {
  readonly id = "calibration";
  readonly #app: App;
  #step: CalibrationStep | null = null;
  #started = 0;
  #pair = 0;
  #right = 0;
  #higher: "first" | "second" = "first";
  #pulse = FIRST_PULSE;

  constructor(app: App) {
    this.#app = app;
  }

  start(): void {
    this.#started = performance.now();
    this.#begin("level");
  }

  #begin(step: CalibrationStep | null): void {
    this.#step = step;
    if (step === "pitch") {
      this.#pair = 0;
      this.#right = 0;
      this.#toss();
    }
    if (step === "touch") this.#pulse = FIRST_PULSE;
    if (step === null) {
      const seconds = Math.round((performance.now() - this.#started) / 1000);
      this.#app.say(`Set up for this device in ${seconds} s.`);
    }
    this.#app.refreshPage();
  }

  next(): void {
    const at = this.#step ? CALIBRATION_STEPS.indexOf(this.#step) : -1;
    this.#begin(CALIBRATION_STEPS[at + 1] ?? null);
  }

  stop(): void {
    this.#begin(null);
  }

  /** Plays moments one after the other, half a second each. */
  #play(moments: readonly Omit<LegendMoment, "u">[]): void {
    const length = 0.5;
    this.#app.senses.playLegend({
      seconds: moments.length * length,
      at: (time) => {
        const moment = moments[Math.floor(time / length)];
        return moment && time % length < 0.42 ? { u: 0, ...moment } : null;
      },
    });
  }

  #tone(u: number, pan = 0): Omit<LegendMoment, "u"> {
    const effect = personalPitch(defaultPitch, this.#app.store.state.person);
    return { sound: { ...toneOf(u, UNIT, effect), pan }, haptic: null };
  }

  playLevel(): void {
    this.#play([0, 1, 0, 1].map((u) => this.#tone(u)));
  }

  playEar(side: "left" | "right"): void {
    this.#play([this.#tone(0.5, side === "left" ? -1 : 1)]);
  }

  #toss(): void {
    this.#higher = crypto.getRandomValues(new Uint8Array(1))[0]! < 128 ? "first" : "second";
  }

  playPair(): void {
    const low = PAIRS[this.#pair] ?? 0;
    const pair = [this.#tone(low), this.#tone(low + STEP)];
    this.#play(this.#higher === "first" ? pair.reverse() : pair);
  }

  answer(said: "first" | "second"): void {
    if (said === this.#higher) this.#right += 1;
    this.#pair += 1;
    if (this.#pair < PAIRS.length) {
      this.#toss();
      this.#app.refreshPage();
      return;
    }
    const wide = this.#right < 2;
    this.#keep({ wide });
    this.#app.say(
      wide ? "Tones go over four octaves from now on." : `${this.#right} of 3: three octaves will do.`,
    );
    this.next();
  }

  get canFeel(): boolean {
    return this.#app.senses.canVibrate;
  }

  playPulse(): void {
    const haptic = { rate: 4, amplitude: this.#pulse, milliseconds: 35 };
    this.#play([
      { sound: null, haptic },
      { sound: null, haptic },
    ]);
  }

  feel(felt: boolean): void {
    if (!felt) {
      this.#pulse = Math.min(this.#pulse * LOUDER, 1);
      this.#app.refreshPage();
      this.playPulse();
      return;
    }
    const [least, most] = WEAKEST;
    this.#keep({ weakest: Number(Math.min(Math.max(1.5 * this.#pulse, least), most).toFixed(3)) });
    this.next();
  }

  choose(map: string): void {
    this.#app.store.set({ doc: setColour(this.#app.store.state.doc, { map }) });
    this.next();
  }

  find(): void {
    if (!this.#app.store.state.guide) this.#app.feature<Listening>("listening").toggleGuide();
    this.stop();
  }

  #keep(change: { wide?: boolean; weakest?: number | null }): void {
    const person = { ...this.#app.store.state.person, ...change };
    rememberPerson(person);
    this.#app.store.set({ person });
  }

  setLevel(master: number): void {
    this.#app.feature<Listening>("listening").change({ master });
  }

  setMono(mono: boolean): void {
    this.#app.feature<Listening>("listening").change({ mono });
  }

  forget(): void {
    this.#keep({ wide: false, weakest: null });
    this.#app.say("Tones and pulses are the presentation's again.");
  }

  #model() {
    return {
      step: this.#step,
      person: this.#app.store.state.person,
      pair: this.#pair + 1,
      pairs: PAIRS.length,
      pulse: this.#pulse,
      canFeel: this.canFeel,
    };
  }

  section(): Section {
    const { person } = this.#app.store.state;
    const summary = person.wide || person.weakest !== null ? "set up" : "";
    return {
      id: this.id,
      title: "Set up ears and hands",
      summary,
      body: () => calibrationTemplate(this.#model(), this),
    };
  }

  /** In the headset: what can be asked there, the pulses in the hand that will feel them. */
  page(): PanelPage {
    const { person } = this.#app.store.state;
    return {
      id: this.id,
      title: "Set up",
      rows: [
        {
          text: "Two tones: which is higher?",
          detail:
            this.#step === "pitch"
              ? `pair ${this.#pair + 1} of ${PAIRS.length}`
              : person.wide
                ? "four octaves"
                : "three octaves",
          buttons: [
            {
              id: "pair",
              text: "Play",
              press: () => (this.#step === "pitch" ? this.playPair() : this.#begin("pitch")),
            },
            {
              id: "first",
              text: "First",
              enabled: this.#step === "pitch",
              press: () => this.answer("first"),
            },
            {
              id: "second",
              text: "Second",
              enabled: this.#step === "pitch",
              press: () => this.answer("second"),
            },
          ],
        },
        {
          text: "The weakest pulse you feel",
          detail: person.weakest === null ? "as the presentation says" : `amplitude from ${person.weakest}`,
          buttons: [
            { id: "pulse", text: "Play", enabled: this.canFeel, press: () => this.playPulse() },
            { id: "no", text: "Not felt", enabled: this.canFeel, press: () => this.feel(false) },
            { id: "felt", text: "Felt", enabled: this.canFeel, press: () => this.feel(true) },
          ],
        },
        {
          text: "As the presentation says",
          buttons: [{ id: "forget", text: "Forget", press: () => this.forget() }],
        },
      ],
    };
  }

  commands() {
    return [{ keys: ["7"], shown: "7", text: "set up ears and hands", down: () => this.#open() }];
  }

  #open(): void {
    const { open } = this.#app.store.state;
    if (!open.includes(this.id)) this.#app.store.set({ open: [...open, this.id] });
    this.start();
  }

  report() {
    const calibration = this.#step && {
      step: this.#step,
      pair: this.#pair,
      higher: this.#step === "pitch" ? this.#higher : null,
      pulse: this.#pulse,
    };
    return { calibration };
  }
}
