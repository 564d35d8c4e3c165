// SPDX-License-Identifier: Apache-2.0
// One stay in the headset: pointers probe and press, grips move the model, boards show table, legend and numbers.
import { Color, GridHelper, Matrix4, Vector3 } from "three";
import type { App } from "../app/app";
import type { Cuts } from "../app/features/cuts";
import type { Listening } from "../app/features/listening";
import type { Notes } from "../app/features/notes";
import { Grab } from "./grab";
import { movePage } from "./move-page";
import { onTable, type Stand, standOf, TABLE_SIZE } from "./room";
import { VrBar } from "./vr-bar";
import { VrBoards } from "./vr-boards";
import { VrButtons } from "./vr-buttons";
import { VrDots } from "./vr-dots";
import { VrHands } from "./vr-hands";
import { VrMarkers } from "./vr-markers";
import { VrMenu } from "./vr-menu";
import { VrPlanes } from "./vr-planes";
import { type VrPointer, VrPointers } from "./vr-pointers";
import { VrVignette } from "./vr-vignette";
import { VrWalk } from "./vr-walk";
import { vrWishes } from "./vr-wishes";

/** Metres. */
const NEAR = 0.05;
const FAR = 200;
const ROOM_COLOUR = new Color(0x20282d);
/** What one pixel of a headset covers, radians (20 to 25 pixels a degree). */
const PIXEL_ANGLE = 0.0008;
const scratchMatrix = new Matrix4();

export class VrSession {
  readonly #app: App;
  readonly #session: XRSession;
  readonly #pointers: VrPointers;
  readonly #markers: VrMarkers;
  readonly #grab = new Grab();
  readonly #boards: VrBoards;
  readonly #menu: VrMenu;
  readonly #walk: VrWalk;
  readonly #planes: VrPlanes;
  readonly #bar: VrBar;
  readonly #buttons: VrButtons;
  readonly #dots: VrDots;
  readonly #hands: VrHands;
  readonly #vignette: VrVignette;
  readonly #removals: (() => void)[] = [];
  /** Stands still whatever the hands do with the model: something to hold on to for the eyes. */
  readonly #floor = new GridHelper(8, 16, 0x44525a, 0x323d44);
  readonly #head = new Matrix4();
  #stand: Stand | null = null;
  /** The person has walked, or turned by so many degrees: the boards come along with the next frame. */
  #walked: number | null = null;
  #seconds = 0;

  constructor(app: App, session: XRSession, ended: () => void) {
    this.#app = app;
    this.#session = session;
    const { stage, store } = app;
    stage.scene.add(this.#floor);
    this.#boards = new VrBoards(app, stage.scene, {
      table: () => this.putOnTable(),
      trueSize: () => this.putAtTrueSize(),
      leave: () => this.leave(),
      pages: () => [...app.panelPages(), this.#movePage()],
    });
    this.#menu = this.#makeMenu();
    this.#boards.pressable.push(this.#menu.board);
    this.#markers = new VrMarkers(stage.scene);
    this.#dots = new VrDots(stage.scene);
    this.#walk = new VrWalk(stage.renderer, stage.scene);
    this.#planes = new VrPlanes(app, stage.scene);
    this.#bar = new VrBar(stage.scene);
    this.#vignette = new VrVignette(stage.scene);
    this.#buttons = new VrButtons(vrWishes(app, this.#walk, this.#planes, this));
    this.#pointers = new VrPointers(stage.renderer, stage.scene, {
      connected: (pointer) => this.#hands.greet(pointer),
      disconnected: (pointer) => this.#forget(pointer),
      select: (pointer, on) => this.#hands.select(pointer, on, this.#seconds),
      squeeze: (pointer, on) => this.#hands.squeeze(pointer, on),
    });
    this.#hands = new VrHands(app, {
      pointers: this.#pointers,
      boards: this.#boards,
      planes: this.#planes,
      bar: this.#bar,
      dots: this.#dots,
      grab: this.#grab,
    });
    this.#removals.push(
      stage.onFrame((seconds, frame) => this.#frame(seconds, frame)),
      store.subscribe((state, before) => {
        this.#boards.renew();
        if (state.person.leftHanded !== before.person.leftHanded) this.#placeBoards();
      }),
      stage.keepRunning(),
    );
    session.addEventListener("end", () => {
      this.#dispose();
      ended();
    });
    session.addEventListener("visibilitychange", () => {
      if (session.visibilityState !== "visible") this.#hands.letGoOfAll();
    });
    // The desk's camera keeps its distance from the model; here hands come close.
    stage.camera.near = NEAR;
    stage.camera.far = FAR;
    stage.renderer.xr.setFoveation(0.3);
    stage.renderer.setClearColor(ROOM_COLOUR);
  }

  #makeMenu(): VrMenu {
    const { stage, actions } = this.#app;
    return new VrMenu(stage.scene, {
      home: () => this.home(),
      table: () => this.putOnTable(),
      trueSize: () => this.putAtTrueSize(),
      note: () => this.#app.feature<Notes>("notes").pinHere(),
      toggle: (what) => actions.toggle(what),
      nextResult: () => actions.nextResult(),
      stepBy: (count) => actions.stepBy(count),
      togglePlay: () => actions.togglePlay(),
      cut: () => this.#app.feature<Cuts>("cuts").toggle(),
      leave: () => this.leave(),
    });
  }

  #movePage() {
    return movePage(this.#app.store.state.person, {
      step: (right, ahead) => {
        this.#walk.step(right, ahead, this.#stand?.yaw ?? 0);
        this.walked();
      },
      turn: (degrees) => this.turn(degrees),
      home: () => this.home(),
      table: () => this.putOnTable(),
      trueSize: () => this.putAtTrueSize(),
      change: (change) => this.#app.feature<Listening>("listening").change(change),
    });
  }

  leave(): void {
    void this.#session.end();
  }

  #forget(pointer: VrPointer): void {
    this.#hands.forget(pointer);
    this.#buttons.forget(pointer.name);
  }

  #frame(seconds: number, frame: XRFrame | undefined): void {
    const { view, store } = this.#app;
    const space = this.#app.stage.renderer.xr.getReferenceSpace();
    const pose = space && frame?.getViewerPose(space);
    // While nobody is tracked nothing happens.
    if (!pose) return;
    this.#head.fromArray(pose.transform.matrix);
    this.#settle();
    const passed = Math.max(seconds - this.#seconds, 0);
    this.#seconds = seconds;
    const { person } = store.state;
    const moved = this.#grab.move(this.#pointers.grips(), person.upright);
    if (moved) this.#setModel(moved);
    const world = view.model.worldMatrix(scratchMatrix);
    const eye = this.head;
    const distance = Math.max(
      view.model.box.getCenter(new Vector3()).applyMatrix4(world).distanceTo(eye),
      0.1,
    );
    view.model.fadeEdges(PIXEL_ANGLE * distance);
    const radius = (view.diagonal / 2) * new Vector3().setFromMatrixScale(world).x;
    this.#vignette.update(passed, this.#head, world, { radius, distance }, person.vignette);
    this.#planes.update(world);
    this.#bar.update(view.model.box, world, eye);
    const [pointing, holding] = person.leftHanded
      ? (["left", "right"] as const)
      : (["right", "left"] as const);
    let hover: string | null = null;
    const bearers = [];
    for (const pointer of this.#pointers.rays(frame, space)) {
      this.#buttons.update(pointer, pointing);
      bearers.push(...this.#hands.menuHand(pointer, frame, space));
      const bears = pointer.kind === "hand" && pointer.name === this.#menu.bearer;
      const on = bears ? this.#hands.rest(pointer) : this.#hands.point(pointer, world, seconds);
      hover ??= on;
    }
    this.#menu.update(bearers, holding, eye);
    this.#menu.paint(store.state, hover, this.#app.player.canPlay);
    this.#dots.update(passed, eye);
    this.#boards.paint(hover, world, eye);
    this.#markers.update(this.#app.overlay.vrMarks(), eye);
  }

  /** First frame: the person's place is known, the room is laid out round it. After a walk the boards follow. */
  #settle(): void {
    if (!this.#stand) {
      this.#stand = standOf(this.#head);
      this.#placeBoards();
      this.putOnTable();
    } else if (this.#walked !== null) {
      const yaw = this.#stand.yaw + (this.#walked * Math.PI) / 180;
      this.#stand = { position: this.head, yaw };
      this.#placeBoards();
    }
    this.#walked = null;
  }

  #placeBoards(): void {
    if (this.#stand) this.#boards.place(this.#stand, this.head.y);
  }

  /** The middle of the eyes. */
  get head(): Vector3 {
    return new Vector3().setFromMatrixPosition(this.#head);
  }

  /** Everything is where it was at first: before the person, as they stand now. */
  home(): void {
    this.#stand = null;
  }

  callMenu(): void {
    this.#menu.toggle();
  }

  /** Degrees to the left. */
  turn(degrees: number): void {
    this.#walk.turn(degrees, this.head);
    this.#walked = (this.#walked ?? 0) + degrees;
  }

  walked(): void {
    this.#walked ??= 0;
  }

  /** What the boards show has changed. */
  renew(): void {
    this.#boards.renew();
  }

  /** What tests and scripts may know of the room. */
  report() {
    return {
      head: { position: this.head.toArray(), yaw: standOf(this.#head).yaw },
      ...this.#boards.report(),
      labels: this.#markers.report(),
      menu: this.#menu.report(),
      knobs: this.#planes.places,
      bar: this.#bar.place,
      rays: this.#pointers.report(),
      touching: this.#hands.touching,
      rings: this.#dots.report(),
      vignette: this.#vignette.alpha,
      model: this.#app.view.model.worldMatrix().toArray(),
    };
  }

  putOnTable(): void {
    const sphere = this.#app.view.model.sphere();
    const { model } = this.#app.view;
    const metres = model.largestSide * new Vector3().setFromMatrixScale(model.group.matrix).x;
    if (this.#stand) this.#setModel(onTable(this.#stand, sphere, TABLE_SIZE / Math.max(metres, 1e-9)));
    this.#vignette.jump();
  }

  putAtTrueSize(): void {
    if (this.#stand) this.#setModel(onTable(this.#stand, this.#app.view.model.sphere(), 1));
    this.#vignette.jump();
  }

  #setModel(matrix: Matrix4): void {
    const { holder } = this.#app.stage;
    holder.matrixAutoUpdate = false;
    holder.matrix.copy(matrix);
    holder.matrixWorldNeedsUpdate = true;
    holder.updateMatrixWorld(true);
  }

  #dispose(): void {
    const { stage, probing, senses } = this.#app;
    senses.stop();
    for (const remove of this.#removals) remove();
    this.#pointers.dispose();
    for (const name of this.#dots.names) probing.remove(name);
    const parts = [this.#markers, this.#walk, this.#planes, this.#bar, this.#vignette, this.#menu];
    for (const part of [...parts, this.#boards, this.#dots, this.#floor]) part.dispose();
    this.#floor.removeFromParent();
    stage.holder.matrix.identity();
    stage.holder.updateMatrixWorld(true);
    stage.orbit.apply();
  }
}
