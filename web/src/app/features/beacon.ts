// SPDX-License-Identifier: Apache-2.0
// A hot spot that ticks from where it is: to the side, behind the person, or on the far side of the model. The nearer
// one points at it the faster; words on the page say the same.
import { Vector3 } from "three";
import { beaconRate, directionWords, type HeadDirection } from "../../sense";
import { beaconTemplate, numberText, type PanelPage, type Section, unitText } from "../../ui";
import type { App } from "../app";
import type { VrPose } from "../pointing";
import { pointingOf } from "../pointing";
import { inSight } from "../sight";
import type { Feature } from "./feature";
import type { FoundSpot, HotSpots } from "./hot-spots";

export class BeaconFeature implements Feature {
  readonly id = "beacon";
  readonly #app: App;
  #on = false;
  #which = 0;
  #run: (() => void) | null = null;
  #now: { rate: number; direction: HeadDirection; words: string } | null = null;

  constructor(app: App) {
    this.#app = app;
    app.atEnd(app.stage.onFrame(() => this.#frame()));
    app.senses.onStop(() => this.#set(false));
  }

  #spots(): readonly FoundSpot[] {
    return this.#app
      .feature<HotSpots>("hot-spots")
      .found()
      .filter((f) => f.place !== null);
  }

  #spot(): FoundSpot | null {
    const spots = this.#spots();
    return spots[this.#which % Math.max(spots.length, 1)] ?? null;
  }

  toggle(): void {
    if (!this.#on && !this.#spot()) {
      this.#app.sayNone("There is no hot spot of what is seen.");
      return;
    }
    this.#set(!this.#on);
  }

  next(): void {
    this.#which = (this.#which + 1) % Math.max(this.#spots().length, 1);
    this.#app.refreshPage();
  }

  #set(on: boolean): void {
    if (on === this.#on) return;
    this.#on = on;
    this.#run?.();
    this.#run = on ? this.#app.stage.keepRunning() : null;
    if (!on) {
      this.#app.senses.beacon(null);
      this.#now = null;
    }
    this.#app.refreshPage();
  }

  #frame(): void {
    if (!this.#on) return;
    const place = this.#spot()?.place;
    if (!place) {
      this.#set(false);
      return;
    }
    const { view, stage, senses } = this.#app;
    const at = view.picker.worldOf(place, view.model.worldMatrix());
    const pose: VrPose = pointingOf(this.#app);
    const local = at.clone().applyMatrix4(pose.toHead);
    const direction: HeadDirection = [local.x, local.y, local.z];
    const rate = beaconRate(pose.direction.angleTo(new Vector3().copy(at).sub(pose.origin)));
    const hidden = !stage.renderer.xr.isPresenting && !inSight(stage, view, place);
    const words = [directionWords(direction), hidden ? "on the far side of the model" : ""]
      .filter(Boolean)
      .join(", ");
    const before = this.#now?.words;
    this.#now = { rate, direction, words };
    senses.beacon(direction, rate);
    if (words !== before) {
      if (this.#app.store.state.person.captions) this.#app.say(`Hot spot ${this.#number}: ${words}`);
      this.#app.refreshPage();
    }
  }

  get #number(): number {
    return (this.#which % Math.max(this.#spots().length, 1)) + 1;
  }

  #text(): string {
    const spot = this.#spot();
    if (!spot) return "no hot spot";
    return `${this.#number}: ${numberText(spot.spot.value, 4)} ${unitText(spot.shown.unit)}`.trim();
  }

  section(): Section {
    // Hot spots are looked for when somebody wants them: a folded section costs nothing.
    const model = () => ({ on: this.#on, spot: this.#text(), words: this.#now?.words ?? "" });
    const summary = this.#on ? this.#text() : "";
    return { id: this.id, title: "Beacon of a hot spot", summary, body: () => beaconTemplate(model(), this) };
  }

  page(): PanelPage {
    const buttons = [
      { id: "on", text: this.#on ? "On" : "Off", on: this.#on, press: () => this.toggle() },
      { id: "next", text: "Next", press: () => this.next() },
    ];
    const detail = this.#now?.words || "ticks come from where it is";
    return { id: this.id, title: "Beacon", rows: [{ text: `Hot spot ${this.#text()}`, detail, buttons }] };
  }

  commands() {
    return [
      { keys: ["6"], shown: "6", text: "beacon: ticks from where a hot spot is", down: () => this.toggle() },
    ];
  }

  report() {
    const spot = this.#on ? this.#spot() : null;
    return { beacon: this.#on && this.#now ? { node: spot?.spot.node ?? null, ...this.#now } : null };
  }
}
