// SPDX-License-Identifier: Apache-2.0
// Wires scene, state, drawing, pointers, senses and panels: the only file that knows them all.
import { Ray } from "three";
import { attachKeyboard, type KeyCommand } from "../input/keyboard";
import { attachMouse } from "../input/mouse";
import { findElement, findNode, type Place } from "../probe";
import { Stage } from "../render";
import type { SceneData } from "../scene";
import type { Actions, Marker, ViewName } from "../ui";
import type { ApiSource } from "./api";
import { type ExtremePlace, extremePlaces } from "./extremes";
import { firstState } from "./first-state";
import { keyCommands } from "./keys";
import { makeActions } from "./make-actions";
import { ModelView } from "./model-view";
import type { Page } from "./page";
import { Player } from "./player";
import { PIN, Probing } from "./probing";
import { Senses } from "./senses";
import { fitModel, inSight, lookFrom, turnTo } from "./sight";
import { type Arrow, neighbourPlace } from "./step-pin";
import { Store, type ViewState } from "./store";
import { applyTheme, followSystem } from "./theme";
import { ViewModels } from "./view-models";
import { VrEntry } from "./vr-entry";

const MOUSE = "mouse";
const scratchRay = new Ray();

export interface AppOptions {
  readonly sceneUrl: string;
  readonly antialias: boolean;
}

export class App implements ApiSource {
  readonly stage: Stage;
  readonly store: Store;
  readonly view: ModelView;
  readonly probing: Probing;
  readonly actions: Actions;
  readonly senses: Senses;
  readonly #page: Page;
  readonly #player: Player;
  readonly #models: ViewModels;
  readonly #vr: VrEntry;
  readonly #keys: readonly KeyCommand[];
  #extremes: readonly ExtremePlace[] = [];
  #stale = true;

  constructor(page: Page, scene: SceneData, options: AppOptions) {
    this.#page = page;
    this.stage = new Stage(page.stageHost, { antialias: options.antialias });
    this.store = new Store(firstState(scene));
    this.view = new ModelView(scene, this.store, () => this.#reshown());
    this.stage.holder.add(this.view.model.group);
    this.probing = new Probing(this.view, this.store);
    this.senses = new Senses(this.view, this.probing, this.store, this.stage);
    this.#player = new Player(this.view, this.store, this.stage);
    this.#models = new ViewModels(this.view, this.store, this.probing, this.#player);
    const boards = {
      panelModel: (hover: string | null) => this.#models.panel(hover),
      legendModel: () => this.#models.legend(),
      cardModel: () => this.#models.card(),
      marks: () => this.#marks(),
    };
    this.#vr = new VrEntry(this, boards, () => {
      this.#render();
      this.#invalidate();
    });
    this.actions = makeActions(this, this.#player);
    this.#keys = keyCommands(this.actions, (on) => this.#hold(on));
    attachKeyboard(this.#keys);
    this.#attachPointer();
    this.store.subscribe((state, before) => this.#stateChanged(state, before));
    this.stage.onFrame(() => this.#frame());
    applyTheme(this.store.state.theme, this.stage);
    followSystem(() => applyTheme(this.store.state.theme, this.stage));
  }

  async start(): Promise<void> {
    await this.view.refresh();
    this.fit();
    await this.view.picker.build();
    await this.#vr.ask();
  }

  enterVr(): Promise<void> {
    return this.#vr.enter();
  }

  extras() {
    return this.view.scene.extras;
  }

  state() {
    const { doc, step, session } = this.store.state;
    return { presentation: doc, step, deformationFactor: this.view.factor, session };
  }

  report() {
    return this.probing.report();
  }

  pulses() {
    return this.senses.pulses();
  }

  fit(): void {
    fitModel(this.stage, this.view);
  }

  lookFrom(name: ViewName): void {
    lookFrom(this.stage, this.view, name);
  }

  goTo(kind: "node" | "element", id: number): void {
    const { parts } = this.view.scene;
    const place = kind === "node" ? findNode(parts, id) : findElement(parts, id);
    if (!place) {
      this.store.set({ problem: `${kind} ${id} is not on the skin of this model.` });
      return;
    }
    this.store.set({ problem: null });
    this.pin(place);
  }

  pin(place: Place | null): void {
    if (place) this.probing.move(PIN, "keyboard", place);
    else this.probing.remove(PIN);
    if (place) turnTo(this.stage, this.view, place);
    this.#invalidate();
  }

  stepPin(arrow: Arrow): void {
    const from = this.probing.pinned?.place;
    const start = this.probing.current()?.place ?? this.#extremes[0]?.place ?? null;
    const to = from ? neighbourPlace(this.view, this.stage, from, arrow) : start;
    if (to) this.pin(to);
  }

  #attachPointer(): void {
    const { stage } = this;
    const pick = (x: number, y: number) =>
      this.view.picker.ray(stage.rayThrough(x, y, scratchRay), this.view.model.worldMatrix());
    attachMouse({
      canvas: stage.canvas,
      hitsModel: (x, y) => pick(x, y) !== null,
      hover: (x, y, kind) => {
        this.probing.move(MOUSE, kind, pick(x, y));
        this.#invalidate();
      },
      leave: () => {
        this.probing.move(MOUSE, "mouse", null);
        this.#invalidate();
      },
      hold: (on) => this.#hold(on),
      turn: (dx, dy) => stage.orbit.turn(dx * 0.008, dy * 0.008),
      pan: (dx, dy) => stage.orbit.pan(dx, dy, stage.canvas.clientHeight),
      zoom: (scale, x, y) => stage.orbit.zoom(scale, pick(x, y)?.world ?? null),
    });
  }

  /** Hear and feel what the mouse, or else the pin, is on. */
  #hold(on: boolean): void {
    const pointer = this.probing.current();
    if (on && pointer) this.probing.hold(pointer.name, pointer.kind, true);
    else this.probing.releaseAll();
    this.#invalidate();
  }

  #invalidate(): void {
    this.#stale = true;
    this.stage.invalidate();
  }

  #reshown(): void {
    this.#extremes = extremePlaces(this.view, this.view.shownAs("colour"), this.store.state.step);
    this.#render();
    this.#invalidate();
  }

  #stateChanged(state: ViewState, before: ViewState): void {
    if (state.step !== before.step || state.doc !== before.doc) void this.view.refresh();
    if (state.deformMode !== before.deformMode || state.typedFactor !== before.typedFactor)
      this.view.applyFactor();
    if (state.theme !== before.theme) applyTheme(state.theme, this.stage);
    if (state.shading !== before.shading)
      this.view.model.material.setShadeFloor(state.shading ? this.#shadeFloor() : 1);
    this.view.model.setEdges(state.edges);
    this.#render();
    this.#invalidate();
  }

  #shadeFloor(): number {
    const effects = this.store.state.doc.effects;
    const colour = Array.isArray(effects) ? effects.find((e) => e?.type === "colour") : undefined;
    return typeof colour?.shadeFloor === "number" ? Math.min(Math.max(colour.shadeFloor, 0), 1) : 0.75;
  }

  #render(): void {
    const { state } = this.store;
    const { extras, parts } = this.view.scene;
    const triangles = parts.reduce((sum, part) => sum + part.indices.length / 3, 0);
    const title = extras.title || "Untitled model";
    document.title = `${title} · Feelem`;
    this.#page.renderTop(
      {
        title,
        triangles,
        lengthUnit: extras.lengthUnit?.name ?? null,
        state,
        vr: this.#vr.answer.vr,
        vrHint: this.#vr.answer.hint,
      },
      this.actions,
    );
    this.#page.renderLeft(this.#models.table(), this.#keys, this.actions);
    this.#page.renderBottom(
      {
        steps: extras.steps,
        step: state.step,
        playing: state.playing,
        canPlay: this.#player.canPlay,
        deformMode: state.deformMode,
        factor: this.view.factor,
        automaticFactor: this.view.automaticFactor,
        hasShape: this.view.hasShape,
      },
      this.actions,
    );
    this.#page.renderBanner(state.problem, state.loading, this.actions);
    this.#renderLegend();
  }

  #renderLegend(): void {
    this.#page.renderLegend(this.#models.legend(), this.actions);
  }

  /** Whatever follows the camera or the pointer. */
  #frame(): void {
    const { stage, view } = this;
    if (stage.renderer.xr.isPresenting) return;
    view.model.fadeEdges(stage.orbit.pixelSize(stage.canvas.clientHeight));
    if (!this.#stale && !this.store.state.playing) return;
    this.#stale = false;
    const matrix = view.model.worldMatrix();
    this.#page.renderTriad(stage, matrix, this.actions);
    const current = this.probing.current();
    const place = current?.place ?? null;
    const at = place && stage.project(view.picker.worldOf(place, matrix));
    this.#page.renderCard(this.#models.card(), at, () => this.pin(null));
    this.#page.renderMarkers(this.#markers(at, current?.name === PIN));
    this.#renderLegend();
  }

  /** The extremes in the room, metres. */
  #marks() {
    if (!this.store.state.extremes) return [];
    const matrix = this.view.model.worldMatrix();
    return this.#extremes.map(({ kind, text, detail, place }) => ({
      kind,
      text,
      detail,
      at: this.view.picker.worldOf(place, matrix),
    }));
  }

  #markers(reticle: { x: number; y: number } | null, pinned: boolean): Marker[] {
    const { stage, view } = this;
    const matrix = view.model.worldMatrix();
    const markers: Marker[] = [];
    if (this.store.state.extremes) {
      for (const { kind, text, detail, place } of this.#extremes) {
        const at = stage.project(view.picker.worldOf(place, matrix));
        if (!at) continue;
        markers.push({
          kind,
          text,
          detail,
          ...at,
          hidden: !inSight(stage, view, place),
          flipped: at.x > stage.canvas.clientWidth - 190,
          click: () => this.pin(place),
        });
      }
    }
    if (reticle)
      markers.push({
        kind: pinned ? "pin" : "reticle",
        text: "",
        detail: "",
        ...reticle,
        hidden: false,
        flipped: false,
        click: null,
      });
    return markers;
  }
}
