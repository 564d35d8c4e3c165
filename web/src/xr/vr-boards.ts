// SPDX-License-Identifier: Apache-2.0
// The boards of the room: panel, legend and card, where they stand, what is on them, and what of them is pressed.
import { type Matrix4, type Object3D, type Ray, Raycaster, type Scene, Vector3 } from "three";
import type { App } from "../app/app";
import type { PanelPage } from "../ui";
import { Board, type BoardButton, reportOf } from "./board";
import { placeBefore, type Stand } from "./room";
import { CARD_SIZE, LEGEND_SIZE, paintVrCard, paintVrLegend } from "./vr-legend";
import { PANEL_HEIGHT, PANEL_WIDTH, paintPanel } from "./vr-panel";

/** Metres: so wide that their smallest letters cover half a degree, and both within forty degrees of straight ahead. */
const PANEL_METRES = 0.56;
const LEGEND_METRES = 0.28;
const CARD_METRES = 0.34;
const AWAY = 1.145;
const PANEL_ASIDE = (26.2 * Math.PI) / 180;
const LEGEND_ASIDE = (31.5 * Math.PI) / 180;
/** Below the eyes; on the table's side of straight ahead. */
const BELOW_EYES = 0.1;

/** What the boards ask of the stay. */
export interface BoardWays {
  table(): void;
  trueSize(): void;
  leave(): void;
  pages(): readonly PanelPage[];
}

export interface BoardHit {
  readonly board: Board;
  readonly u: number;
  readonly v: number;
  readonly distance: number;
}

export class VrBoards {
  readonly #app: App;
  readonly #ways: BoardWays;
  readonly #panel = new Board(PANEL_WIDTH, PANEL_HEIGHT, PANEL_METRES);
  readonly #legend = new Board(LEGEND_SIZE.width, LEGEND_SIZE.height, LEGEND_METRES);
  readonly #card = new Board(CARD_SIZE.width, CARD_SIZE.height, CARD_METRES);
  readonly #raycaster = new Raycaster();
  readonly #slides = new Map<string, { board: Board; button: BoardButton }>();
  /** Boards that rays press, beside the panel. */
  readonly pressable: Board[] = [this.#panel];
  #page = { page: "results", first: 0 };
  #stale = true;
  #hover: string | null = null;
  #cardText = "";

  constructor(app: App, scene: Scene, ways: BoardWays) {
    this.#app = app;
    this.#ways = ways;
    for (const board of [this.#panel, this.#legend, this.#card]) {
      board.mesh.visible = false;
      scene.add(board.mesh);
    }
  }

  /** Something that they show has changed. */
  renew(): void {
    this.#stale = true;
  }

  /** Panel and legend to the sides of the person's place; the other way round for the left-handed. */
  place(stand: Stand, eyeHeight: number): void {
    const eye = new Vector3(stand.position.x, eyeHeight, stand.position.z);
    const hand = this.#app.store.state.person.leftHanded ? -1 : 1;
    const aside = (radians: number) =>
      placeBefore(stand, hand * AWAY * Math.sin(radians), eyeHeight - BELOW_EYES, AWAY * Math.cos(radians));
    this.#put(this.#panel.mesh, aside(-PANEL_ASIDE), eye);
    this.#put(this.#legend.mesh, aside(LEGEND_ASIDE), eye);
    this.#stale = true;
  }

  #put(mesh: Object3D, at: Vector3, eye: Vector3): void {
    mesh.position.copy(at);
    mesh.lookAt(eye);
    mesh.visible = true;
    mesh.updateMatrixWorld(true);
  }

  open(page: string, first = 0): void {
    this.#page = { page, first };
    this.#stale = true;
  }

  /** The nearest board that a ray meets. */
  hit(ray: Ray): BoardHit | null {
    this.#raycaster.ray.copy(ray);
    let best: BoardHit | null = null;
    for (const board of this.pressable) {
      if (!board.mesh.visible) continue;
      const hit = this.#raycaster.intersectObject(board.mesh, false)[0];
      if (hit?.uv && (!best || hit.distance < best.distance))
        best = { board, u: hit.uv.x, v: hit.uv.y, distance: hit.distance };
    }
    return best;
  }

  /** Presses what is there; a button that slides is held until the pointer lets go. */
  press(name: string, { board, u, v }: BoardHit): void {
    const button = board.buttonAt(u, v);
    if (button?.slide) {
      this.#slides.set(name, { board, button });
      button.slide(board.shareOf(button, u));
    } else button?.press();
  }

  /** The pointer's slider follows it, also beside the board; false: it holds none. */
  slide(name: string, hit: BoardHit | null): boolean {
    const held = this.#slides.get(name);
    if (held && hit?.board === held.board) held.button.slide?.(held.board.shareOf(held.button, hit.u));
    return held !== undefined;
  }

  letGo(name: string): boolean {
    return this.#slides.delete(name);
  }

  /** Once a frame: `hover` is the button of the panel that a ray is on. */
  paint(hover: string | null, world: Matrix4, eye: Vector3): void {
    const { probing, view, models, store } = this.#app;
    const { reading } = store.state;
    if (this.#stale || hover !== this.#hover) this.#paintPanel(hover);
    const card = models.card();
    const text = card ? JSON.stringify([card.report.nodeId, card.report.elementId, card.report.results]) : "";
    if (this.#stale || text !== this.#cardText) {
      this.#legend.paint((context) => {
        paintVrLegend(context, models.legend(), reading);
        return [];
      });
      if (card) {
        this.#card.paint((context) => {
          paintVrCard(context, card);
          return [];
        });
      }
      this.#cardText = text;
    }
    this.#stale = false;
    const place = probing.current()?.place;
    this.#card.mesh.visible = card !== null && place !== null && place !== undefined;
    if (place) this.#placeCard(view.picker.worldOf(place, world), eye);
  }

  #paintPanel(hover: string | null): void {
    this.#hover = hover;
    const model = { ...this.#app.models.panel(hover), pages: this.#ways.pages() };
    const extras = {
      table: () => this.#ways.table(),
      trueSize: () => this.#ways.trueSize(),
      leave: () => this.#ways.leave(),
      ...this.#page,
      open: (page: string, first: number) => this.open(page, first),
    };
    this.#panel.paint((context) => paintPanel(context, model, this.#app.actions, extras));
  }

  /** Above the place, facing the eyes, as large for them at any distance. */
  #placeCard(at: Vector3, eye: Vector3): void {
    const distance = Math.max(at.distanceTo(eye), 0.2);
    const { mesh } = this.#card;
    mesh.scale.setScalar(distance);
    mesh.position.copy(at).lerp(eye, 0.12);
    mesh.position.y += 0.11 * distance;
    mesh.lookAt(eye);
  }

  report() {
    const panel = reportOf(this.#panel);
    return {
      page: this.#page.page,
      panel: panel && { ...panel, buttons: this.#panel.buttonPlaces() },
      legend: reportOf(this.#legend),
      card: reportOf(this.#card),
    };
  }

  dispose(): void {
    for (const board of [this.#panel, this.#legend, this.#card]) board.dispose();
  }
}
