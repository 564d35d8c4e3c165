// SPDX-License-Identifier: Apache-2.0
// One stay in the headset: pointers probe and press, grips move the model, boards show table, legend and numbers.
import { Color, GridHelper, Matrix4, Vector3 } from "three";
import type { App } from "../app/app";
import { Grab } from "./grab";
import { onTable, type Stand, standOf, TABLE_SIZE } from "./room";
import { VrBoards } from "./vr-boards";
import { VrButtons } from "./vr-buttons";
import { VrDots } from "./vr-dots";
import { VrMarkers } from "./vr-markers";
import { VrPlanes } from "./vr-planes";
import { type VrPointer, VrPointers } from "./vr-pointers";
import { VrWalk } from "./vr-walk";
import { vrWishes } from "./vr-wishes";

/** Metres. */
const NEAR = 0.05;
const FAR = 200;
const ROOM_COLOUR = new Color(0x20282d);
/** What one pixel of a headset covers, radians (20 to 25 pixels a degree). */
const PIXEL_ANGLE = 0.0008;
const scratchMatrix = new Matrix4();
const scratchHead = new Vector3();

export class VrSession {
  readonly #app: App;
  readonly #session: XRSession;
  readonly #pointers: VrPointers;
  readonly #markers: VrMarkers;
  readonly #grab = new Grab();
  readonly #boards: VrBoards;
  readonly #walk: VrWalk;
  readonly #planes: VrPlanes;
  readonly #buttons: VrButtons;
  readonly #dots: VrDots;
  readonly #removals: (() => void)[] = [];
  /** Stands still whatever the hands do with the model: something to hold on to for the eyes. */
  readonly #floor = new GridHelper(8, 16, 0x44525a, 0x323d44);
  readonly #head = new Matrix4();
  #stand: Stand | null = null;

  constructor(app: App, session: XRSession, ended: () => void) {
    this.#app = app;
    this.#session = session;
    const { stage, store } = app;
    stage.scene.add(this.#floor);
    this.#boards = new VrBoards(app, stage.scene, {
      table: () => this.putOnTable(),
      trueSize: () => this.putAtTrueSize(),
      leave: () => this.leave(),
      pages: () => app.panelPages(),
    });
    this.#markers = new VrMarkers(stage.scene);
    this.#dots = new VrDots(stage.scene);
    this.#walk = new VrWalk(stage.renderer, stage.scene);
    this.#planes = new VrPlanes(app, stage.scene);
    this.#buttons = new VrButtons(vrWishes(app, this.#walk, this.#planes, this));
    this.#pointers = new VrPointers(stage.renderer, stage.scene, {
      connected: (pointer) => {
        app.probing.pointer(pointer.name, pointer.kind).actuator = pointer.actuator;
      },
      disconnected: (pointer) => this.#forget(pointer),
      select: (pointer, on) => this.#select(pointer, on),
      squeeze: (pointer, on) => this.#squeeze(pointer, on),
    });
    this.#removals.push(
      stage.onFrame((_seconds, frame) => this.#frame(frame)),
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
      if (session.visibilityState !== "visible") this.#grab.letGoOfAll();
    });
    // The desk's camera keeps its distance from the model; here hands come close.
    stage.camera.near = NEAR;
    stage.camera.far = FAR;
    stage.renderer.xr.setFoveation(0.3);
    stage.renderer.setClearColor(ROOM_COLOUR);
  }

  leave(): void {
    void this.#session.end();
  }

  #forget(pointer: VrPointer): void {
    const { probing, stage } = this.#app;
    // The hand stops before it goes, so that its last pulse is not left running.
    probing.pointer(pointer.name, pointer.kind).actuator = null;
    probing.hold(pointer.name, pointer.kind, false);
    probing.move(pointer.name, pointer.kind, null);
    this.#grab.letGo(pointer.name, stage.holder.matrix);
    this.#planes.letGo(pointer.name);
    this.#buttons.forget(pointer.name);
    this.#boards.letGo(pointer.name);
    this.#dots.show(pointer.name, null);
  }

  #select(pointer: VrPointer, on: boolean): void {
    const { probing } = this.#app;
    this.#refresh(pointer);
    const pressed = on ? this.#boards.hit(pointer.ray) : null;
    if (pressed) {
      this.#boards.press(pointer.name, pressed);
      return;
    }
    if (!on && this.#boards.letGo(pointer.name)) return;
    if (on && this.#planes.take(pointer, this.#app.view.model.worldMatrix())) return;
    if (!on && this.#planes.letGo(pointer.name)) return;
    if (this.#pinchesAir(pointer, on)) {
      this.#squeeze(pointer, on);
      return;
    }
    probing.hold(pointer.name, pointer.kind, on);
  }

  /** Hands have no grip: a pinch on nothing takes hold of the model. */
  #pinchesAir(pointer: VrPointer, on: boolean): boolean {
    const { view } = this.#app;
    if (pointer.kind === "controller") return false;
    if (!on) return this.#grab.holds(pointer.name);
    return view.picker.ray(pointer.ray, view.model.worldMatrix()) === null;
  }

  #squeeze(pointer: VrPointer, on: boolean): void {
    const { holder } = this.#app.stage;
    const pose = this.#pointers.grips().get(pointer.name);
    if (on && pose) this.#grab.take(pointer.name, pose, holder.matrix);
    else this.#grab.letGo(pointer.name, holder.matrix);
  }

  #refresh(pointer: VrPointer): void {
    pointer.target.updateWorldMatrix(true, false);
    pointer.ray.origin.setFromMatrixPosition(pointer.target.matrixWorld);
    pointer.ray.direction.set(0, 0, -1).transformDirection(pointer.target.matrixWorld);
  }

  #frame(frame: XRFrame | undefined): void {
    const { view, probing } = this.#app;
    if (!this.#findHead(frame)) return;
    if (!this.#stand) this.#settle();
    const moved = this.#grab.move(this.#pointers.grips());
    if (moved) this.#setModel(moved);
    const world = view.model.worldMatrix(scratchMatrix);
    view.model.fadeEdges(PIXEL_ANGLE * this.#distanceTo(world));
    let hover: string | null = null;
    this.#planes.update(world);
    const pointing = this.#app.store.state.person.leftHanded ? "left" : "right";
    for (const pointer of this.#pointers.rays()) {
      this.#buttons.update(pointer, pointing);
      if (this.#planes.drag(pointer, world)) continue;
      const board = this.#boards.hit(pointer.ray);
      if (this.#boards.slide(pointer.name, board)) continue;
      const hit = view.picker.ray(pointer.ray, world);
      const onBoard = board !== null && (!hit || board.distance < hit.distance);
      if (onBoard) hover ??= board.board.buttonAt(board.u, board.v)?.id ?? null;
      probing.move(pointer.name, pointer.kind, onBoard ? null : hit);
      this.#pointers.showHit(pointer, onBoard ? board.distance : (hit?.distance ?? null));
      this.#dots.show(pointer.name, onBoard ? null : (hit?.world ?? null));
    }
    const eye = scratchHead.setFromMatrixPosition(this.#head);
    this.#boards.paint(hover, world, eye);
    this.#markers.update(this.#app.overlay.vrMarks(), eye);
  }

  /** The middle of the eyes; false while nobody is tracked. */
  #findHead(frame: XRFrame | undefined): boolean {
    const space = this.#app.stage.renderer.xr.getReferenceSpace();
    const pose = space && frame?.getViewerPose(space);
    if (pose) this.#head.fromArray(pose.transform.matrix);
    return pose !== null && pose !== undefined;
  }

  /** First frame: the person's place is known, the room is laid out round it. */
  #settle(): void {
    const stand = standOf(this.#head);
    this.#stand = stand;
    this.#placeBoards();
    this.putOnTable();
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

  nextPage(): void {
    const ids = ["results", ...this.#app.panelPages().map((page) => page.id)];
    this.#boards.open(ids[(ids.indexOf(this.#boards.report().page) + 1) % ids.length] ?? "results");
  }

  /** What tests and scripts may know of the room. */
  report() {
    return {
      head: { position: this.head.toArray(), yaw: standOf(this.#head).yaw },
      ...this.#boards.report(),
      labels: this.#markers.report(),
      knobs: this.#planes.places,
      model: this.#app.view.model.worldMatrix().toArray(),
    };
  }

  putOnTable(): void {
    const sphere = this.#app.view.model.sphere();
    const { model } = this.#app.view;
    const metres = model.largestSide * new Vector3().setFromMatrixScale(model.group.matrix).x;
    if (this.#stand) this.#setModel(onTable(this.#stand, sphere, TABLE_SIZE / Math.max(metres, 1e-9)));
  }

  putAtTrueSize(): void {
    if (this.#stand) this.#setModel(onTable(this.#stand, this.#app.view.model.sphere(), 1));
  }

  #setModel(matrix: Matrix4): void {
    const { holder } = this.#app.stage;
    holder.matrixAutoUpdate = false;
    holder.matrix.copy(matrix);
    holder.matrixWorldNeedsUpdate = true;
    holder.updateMatrixWorld(true);
  }

  /** From the eyes to the model's middle, metres. */
  #distanceTo(world: Matrix4): number {
    const middle = this.#app.view.model.box.getCenter(new Vector3()).applyMatrix4(world);
    return Math.max(middle.distanceTo(scratchHead.setFromMatrixPosition(this.#head)), 0.1);
  }

  #dispose(): void {
    const { stage, probing, senses } = this.#app;
    senses.stop();
    for (const remove of this.#removals) remove();
    this.#pointers.dispose();
    this.#markers.dispose();
    this.#walk.dispose();
    this.#planes.dispose();
    this.#boards.dispose();
    for (const name of this.#dots.names) probing.remove(name);
    this.#dots.dispose();
    this.#floor.removeFromParent();
    this.#floor.dispose();
    stage.holder.matrix.identity();
    stage.holder.updateMatrixWorld(true);
    stage.orbit.apply();
  }
}
