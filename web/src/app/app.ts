// SPDX-License-Identifier: Apache-2.0
// Wires scene, state, drawing, pointers, senses and panels: the only file that knows them all.
import { attachKeyboard, type KeyCommand } from "../input/keyboard";
import { findElement, findNode, type Place } from "../probe";
import { Stage } from "../render";
import type { SceneData } from "../scene";
import { type Actions, type PaletteEntry, type PanelPage, type ViewName, withoutResults } from "../ui";
import type { ApiSource, PageState } from "./api";
import { attachDeskPointer } from "./desk-pointer";
import type { Feature } from "./features/feature";
import type { Links } from "./features/links";
import { makeFeatures } from "./features/list";
import type { Walking } from "./features/walking";
import { firstState } from "./first-state";
import { keyCommands } from "./keys";
import { makeActions } from "./make-actions";
import { ModelView } from "./model-view";
import type { Reading } from "./opening";
import { Overlay } from "./overlay";
import type { Page } from "./page";
import { PageView } from "./page-view";
import { placeChoices } from "./place-menu";
import { Player } from "./player";
import { PIN, Probing } from "./probing";
import { Senses } from "./senses";
import { fitModel, flyTo, lookFrom, turnTo } from "./sight";
import { type Arrow, neighbourPlace } from "./step-pin";
import { Store, type ViewState } from "./store";
import { applyTheme, followSystem } from "./theme";
import { ViewModels } from "./view-models";
import { VrEntry } from "./vr-entry";

export interface AppOptions {
  readonly sceneUrl: string;
  readonly antialias: boolean;
  /** The picture gets coarser while it moves, where frames would take too long. */
  readonly governed: boolean;
  /** That are drawn, where the scene has levels of detail. */
  readonly mostTriangles: number;
  /** The scene is the server's own, so that it can be asked about the inside. */
  readonly served: boolean;
  /** Asks for a file and opens it. */
  readonly openFile: () => void;
}

/** How far results are changes nothing of the picture: to draw it again would keep the reader waiting. */
function isNewsAlone(state: ViewState, before: ViewState): boolean {
  const keys = Object.keys(state) as (keyof ViewState)[];
  return keys.every((key) => (key === "reading") === (state[key] !== before[key]));
}

export class App implements ApiSource {
  readonly stage: Stage;
  readonly store: Store;
  readonly view: ModelView;
  readonly probing: Probing;
  readonly actions: Actions;
  readonly senses: Senses;
  readonly models: ViewModels;
  readonly overlay: Overlay;
  readonly features: readonly Feature[];
  readonly keys: readonly KeyCommand[];
  readonly player: Player;
  readonly #page: Page;
  readonly #pageView: PageView;
  readonly #vr: VrEntry;
  readonly #removals: (() => void)[] = [];
  readonly #options: AppOptions;
  #stale = true;
  #pressed = false;
  #refreshed: Promise<void> = Promise.resolve();

  constructor(page: Page, scene: SceneData, options: AppOptions) {
    this.#page = page;
    this.#options = options;
    this.stage = new Stage(page.stageHost, options);
    this.store = new Store(firstState(scene));
    this.view = new ModelView(scene, this.store, () => this.#reshown());
    this.stage.holder.add(this.view.model.group);
    this.stage.canvas.setAttribute("role", "application");
    this.stage.canvas.setAttribute("aria-label", "The model: arrows go from node to node, S sounds");
    this.probing = new Probing(this.view, this.store);
    this.senses = new Senses(this.view, this.probing, this.store, this.stage);
    this.player = new Player(this.view, this.store, this.stage);
    this.models = new ViewModels(this.view, this.store, this.probing, this.player);
    this.overlay = new Overlay(this);
    this.#vr = new VrEntry(this, () => this.refreshPage());
    this.#pageView = new PageView(this, page, this.player);
    this.actions = makeActions(this, this.player);
    this.features = makeFeatures(this);
    this.keys = [
      ...this.feature<Walking>("walking").commands(),
      ...keyCommands(
        this.actions,
        (on) => this.hold(on),
        () => this.#pressed,
      ),
      ...this.features.filter((f) => f.id !== "walking").flatMap((f) => f.commands?.() ?? []),
    ];
    this.#removals.push(
      attachKeyboard(this.keys),
      attachDeskPointer(this),
      this.store.subscribe((state, before) => this.#stateChanged(state, before)),
      this.stage.onFrame(() => this.view.model.allowEdges(this.stage.quality.drawn.edges)),
      this.stage.onFrame(() => this.#frame()),
      followSystem(() => applyTheme(this.store.state.theme, this.stage)),
    );
    applyTheme(this.store.state.theme, this.stage);
  }

  async start(): Promise<void> {
    // The shape first, as soon as it is known; then colours, then all that one can point at.
    this.view.outline();
    this.fit();
    const shown = this.view.refresh();
    const pointed = this.view.picker.build(shown);
    await shown;
    this.fit();
    const links = this.feature<Links>("links");
    await links.read();
    this.stage.orbit.onMove(() => {
      links.later();
      // What stands at places of the model follows, also when the window took another size.
      this.#stale = true;
    });
    await this.view.edgesCame;
    await pointed;
    await this.#vr.ask();
  }

  /** How far results are that belong to the shape that is shown. */
  setReading(reading: Reading): void {
    if (this.view.isPreview) this.store.set({ reading });
  }

  /** The finished scene of the shape that is shown: camera, headset and what the person did meanwhile stay.
   * False: it is of another shape. */
  async adopt(scene: SceneData): Promise<boolean> {
    const before = firstState(this.view.scene);
    if (!this.view.adopt(scene)) return false;
    this.feature<Links>("links").settle(firstState(this.view.scene), before);
    // Until values are there as well nobody may take them for missing.
    await this.#allRefreshed();
    this.store.set({ reading: null });
    this.#reshown();
    this.say("The results are there.");
    return true;
  }

  /** Also what was asked for while it was waited. */
  async #allRefreshed(): Promise<void> {
    const refreshed = this.#refreshed;
    await refreshed;
    if (refreshed !== this.#refreshed) await this.#allRefreshed();
  }

  get vrAnswer() {
    return this.#vr.answer;
  }

  enterVr(): Promise<void> {
    return this.#vr.enter();
  }

  /** A feature by its id; the list of features holds it. */
  feature<T extends Feature>(id: string): T {
    const found = this.features.find((f) => f.id === id);
    if (!found) throw new Error(`there is no feature '${id}'`);
    return found as T;
  }

  /** Whether the scene came from the page's own server. */
  get served(): boolean {
    return this.#options.served;
  }

  /** Triangles that this page may draw at most. */
  get mostTriangles(): number {
    return this.#options.mostTriangles;
  }

  /** Asks the person for a scene or a presentation. */
  openFile(): void {
    this.#options.openFile();
  }

  extras() {
    return this.view.scene.extras;
  }

  state(): PageState {
    const { doc, step, session, reading } = this.store.state;
    const panelPages = session === "none" ? null : this.panelPages().map((page) => page.id);
    const own = {
      presentation: doc,
      step,
      deformationFactor: this.view.factor,
      session,
      reading,
      panelPages,
      headset: this.#vr.report(),
    };
    return Object.assign({}, ...this.features.map((f) => f.report?.() ?? {}), own);
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
    this.invalidate();
  }

  /** Marks a place; the camera stays. */
  mark(place: Place): void {
    this.probing.move(PIN, "keyboard", place);
    this.invalidate();
  }

  /** Something to undo when the app ends. */
  atEnd(remove: () => void): void {
    this.#removals.push(remove);
  }

  showPalette(find: (typed: string) => PaletteEntry[]): void {
    this.#page.palette.show(find);
  }

  /** A presentation from a file; with the view that it was saved with, if it has one. */
  openPresentation(value: unknown): void {
    const links = this.feature<Links>("links");
    const view = (value as { view?: { page?: unknown } } | null)?.view?.page;
    links.show({ ...(typeof view === "object" ? view : {}), doc: value });
  }

  /** Marks a place and, at the desk, brings the camera before it. */
  flyTo(place: Place): void {
    this.probing.move(PIN, "keyboard", place);
    if (this.store.state.session === "none") flyTo(this.stage, this.view, place);
    this.invalidate();
  }

  stepPin(arrow: Arrow): void {
    const from = this.probing.pinned?.place;
    const start = this.probing.current()?.place ?? this.overlay.firstExtreme;
    const to = from ? neighbourPlace(this.view, this.stage, from, arrow) : start;
    if (to) this.pin(to);
  }

  /** Hear and feel what the mouse, or else the pin, is on. */
  hold(on: boolean): void {
    const pointer = this.probing.current();
    if (on && pointer) this.probing.hold(pointer.name, pointer.kind, true);
    else this.probing.releaseAll();
    this.invalidate();
  }

  /** The model was pressed: until Esc, or until another control is, Tab goes through the results. */
  setPressed(on: boolean): void {
    this.#pressed = on;
    if (on) this.closePlaceMenu();
  }

  /** What is to be done at a place; canvas pixels. */
  showPlaceMenu(place: Place, at: { x: number; y: number }): void {
    const node = this.probing.report()?.nodeId;
    const close = () => this.closePlaceMenu();
    this.#page.renderPlaceMenu(node ? `node ${node}` : "here", placeChoices(this, place, close), at);
  }

  closePlaceMenu(): void {
    this.#page.renderPlaceMenu("", [], null);
  }

  /** The pointer is on the opened inside of the model, of which a skin knows no values; canvas pixels. */
  setInside(at: { x: number; y: number } | null): void {
    this.#page.renderInside(at, this.view.insideText);
  }

  /** Pages of the headset's panel beside the table of results. */
  panelPages(): PanelPage[] {
    return this.features.flatMap((f) => f.page?.() ?? []);
  }

  /** A short word for people and screen readers. */
  say(text: string): void {
    this.#page.toast(text);
  }

  /** There is nothing of results, for that reason or because they are still being read. */
  sayNone(text: string): void {
    const { reading } = this.store.state;
    this.say(reading ? withoutResults(reading) : text);
  }

  invalidate(): void {
    this.#stale = true;
    this.stage.invalidate();
  }

  refreshPage(): void {
    this.#pageView.render();
    this.invalidate();
  }

  /** The picture is finer or coarser than before: what is said of it follows. */
  redrawn(): void {
    this.#vr.renew();
    this.refreshPage();
  }

  #reshown(): void {
    this.overlay.renew();
    this.#vr.renew();
    this.refreshPage();
  }

  #stateChanged(state: ViewState, before: ViewState): void {
    if (isNewsAlone(state, before)) {
      this.#pageView.render();
      return;
    }
    if (state.step !== before.step || state.doc !== before.doc) this.#refreshed = this.view.refresh();
    if (state.deformMode !== before.deformMode || state.typedFactor !== before.typedFactor)
      this.view.applyFactor();
    if (state.theme !== before.theme) applyTheme(state.theme, this.stage);
    if (state.shading !== before.shading) this.view.applyShading();
    this.view.model.setEdges(state.edges);
    this.refreshPage();
  }

  #frame(): void {
    const { stage, view } = this;
    if (stage.renderer.xr.isPresenting) return;
    view.model.fadeEdges(stage.orbit.pixelSize(stage.canvas.clientHeight));
    if (!this.#stale && !this.store.state.playing) return;
    this.#stale = false;
    this.#pageView.follow();
  }

  dispose(): void {
    for (const remove of this.#removals) remove();
    this.senses.dispose();
    this.view.dispose();
    this.stage.dispose();
  }
}
