// SPDX-License-Identifier: Apache-2.0
// What hands do in the room: touch, point, press, hold, carry, and leave a note by a pinch that rests.
import { type Matrix4, Vector3 } from "three";
import type { App } from "../app/app";
import type { Notes } from "../app/features/notes";
import type { Grab } from "./grab";
import { PinchRest } from "./pinch-rest";
import type { VrBar } from "./vr-bar";
import type { BoardHit, VrBoards } from "./vr-boards";
import type { VrDots } from "./vr-dots";
import { type MenuHand, palmOf } from "./vr-menu";
import type { VrPlanes } from "./vr-planes";
import { jointOf, type VrPointer, type VrPointers } from "./vr-pointers";
import { VrTouch } from "./vr-touch";

/** How far before it a pinch on nothing takes hold, metres. */
const ARM = 1;

/** What of the room hands reach. */
export interface HandReach {
  readonly pointers: VrPointers;
  readonly boards: VrBoards;
  readonly planes: VrPlanes;
  readonly bar: VrBar;
  readonly dots: VrDots;
  readonly grab: Grab;
}

export class VrHands {
  readonly #app: App;
  readonly #room: HandReach;
  readonly #touch = new VrTouch();
  /** Hands that press on the model, and those that are heard and felt for it. */
  readonly #pressing = new Set<string>();
  readonly #held = new Set<string>();
  readonly #rests = new Map<string, PinchRest>();

  constructor(app: App, room: HandReach) {
    this.#app = app;
    this.#room = room;
  }

  greet(pointer: VrPointer): void {
    const state = this.#app.probing.pointer(pointer.name, pointer.kind);
    state.actuator = pointer.actuator;
    // Where nothing shakes the eye gets the pulses; the ear has ticks in their stead.
    state.shows = pointer.actuator
      ? null
      : { pulse: (strength) => this.#room.dots.pulse(pointer.name, strength) };
  }

  forget(pointer: VrPointer): void {
    const { probing, stage } = this.#app;
    const { name, kind } = pointer;
    const { grab, planes, boards, dots } = this.#room;
    // The hand stops before it goes, so that its last pulse is not left running.
    const state = probing.pointer(name, kind);
    state.actuator = null;
    state.shows = null;
    this.#pressing.delete(name);
    this.#held.delete(name);
    this.#rests.delete(name);
    this.#touch.forget(name);
    probing.hold(name, kind, false);
    probing.move(name, kind, null);
    grab.letGo(name, stage.holder.matrix);
    planes.letGo(name);
    boards.letGo(name);
    dots.show(name, null);
    dots.offer(name, 0);
  }

  letGoOfAll(): void {
    this.#room.grab.letGoOfAll();
    this.#pressing.clear();
    this.#held.clear();
    this.#rests.clear();
  }

  select(pointer: VrPointer, on: boolean, seconds: number): void {
    this.#room.pointers.refresh(pointer);
    if (on) this.#take(pointer);
    else this.#release(pointer, seconds);
  }

  /** The nearest of board, knob, bar and model is what is meant; a touch goes before all. */
  #take(pointer: VrPointer): void {
    const { view } = this.#app;
    const { boards, planes, bar, pointers } = this.#room;
    const world = view.model.worldMatrix();
    const touched = this.#touch.of(pointer.name);
    const hit = touched ?? view.picker.ray(pointer.ray, world);
    const board = touched ? null : this.#boardBefore(pointer, hit?.distance);
    if (board) {
      pointers.anchor(pointer, board.distance);
      boards.press(pointer.name, board);
      return;
    }
    const knob = touched ? null : planes.take(pointer, world);
    const onBar = touched ? null : bar.hit(pointer.ray);
    pointers.anchor(pointer, knob ?? hit?.distance ?? onBar ?? ARM);
    if (knob !== null) return;
    // Hands have no grip: a pinch on the bar, or on nothing, takes hold of the model.
    const byBar = onBar !== null && (!hit || onBar < hit.distance);
    if (byBar || (!hit && pointer.kind !== "controller")) this.squeeze(pointer, true);
    else {
      this.#pressing.add(pointer.name);
      this.#sense(pointer);
    }
  }

  #boardBefore(pointer: VrPointer, distance = Number.POSITIVE_INFINITY): BoardHit | null {
    const board = this.#room.boards.hit(pointer.ray);
    return board && board.distance < distance ? board : null;
  }

  #release(pointer: VrPointer, seconds: number): void {
    const { boards, planes, grab, pointers, dots } = this.#room;
    const { name } = pointer;
    pointers.letGo(pointer);
    if (boards.letGo(name) || planes.letGo(name)) return;
    if (grab.holds(name)) this.squeeze(pointer, false);
    if ((this.#rests.get(name)?.share(seconds) ?? 0) > 0) this.#app.feature<Notes>("notes").pinHere();
    this.#rests.delete(name);
    dots.offer(name, 0);
    this.#pressing.delete(name);
    this.#sense(pointer);
  }

  squeeze(pointer: VrPointer, on: boolean): void {
    const { holder } = this.#app.stage;
    const pose = this.#room.pointers.grips().get(pointer.name);
    if (on && pose) this.#room.grab.take(pointer.name, pose, holder.matrix);
    else this.#room.grab.letGo(pointer.name, holder.matrix);
  }

  /** Heard and felt while pressed, or by touch alone where the person wants that. Only changes count: who was
   * silenced meanwhile stays silent until the next press. */
  #sense({ name, kind }: VrPointer): void {
    const { probing, store } = this.#app;
    const byTouch = store.state.person.byTouch && this.#touch.of(name) !== null;
    const wanted = this.#pressing.has(name) || byTouch;
    if (wanted === this.#held.has(name)) return;
    if (wanted) this.#held.add(name);
    else this.#held.delete(name);
    probing.hold(name, kind, wanted);
  }

  /** Once a frame: where it is on the model; gives the id of the button that it is on. */
  point(pointer: VrPointer, world: Matrix4, seconds: number): string | null {
    const { view, probing } = this.#app;
    const { boards, planes, bar, pointers, dots } = this.#room;
    const { name, kind } = pointer;
    if (planes.drag(pointer, world)) return null;
    const touched = this.#touch.update(pointer, view.picker, world);
    const over = touched ? null : boards.hit(pointer.ray);
    if (boards.slide(name, over)) return null;
    const hit = touched ?? view.picker.ray(pointer.ray, world);
    const board = over && (!hit || over.distance < hit.distance) ? over : null;
    const place = board ? null : hit;
    probing.move(name, kind, place);
    this.#sense(pointer);
    const free = bar.hit(pointer.ray) ?? "free";
    pointers.showRay(pointer, touched ? null : (board?.distance ?? hit?.distance ?? free));
    dots.show(name, place?.world ?? null);
    if (kind === "hand") dots.offer(name, this.#restAt(name, place?.world ?? null, seconds));
    return board ? (board.board.buttonAt(board.u, board.v)?.id ?? null) : null;
  }

  /** A pinch that rests on the model is offered a note. */
  #restAt(name: string, at: Vector3 | null, seconds: number): number {
    if (!this.#pressing.has(name)) return 0;
    const rest = this.#rests.get(name) ?? new PinchRest();
    this.#rests.set(name, rest);
    return rest.update(at, seconds);
  }

  /** A hand that bears the menu does not point. */
  rest(pointer: VrPointer): null {
    const { pointers, dots } = this.#room;
    pointers.showRay(pointer, null);
    this.#app.probing.move(pointer.name, pointer.kind, null);
    dots.show(pointer.name, null);
    return null;
  }

  /** Where a menu could stand at it. */
  menuHand(pointer: VrPointer, frame: XRFrame | undefined, space: XRReferenceSpace | null): MenuHand[] {
    const { name, kind, grip } = pointer;
    if (kind === "controller")
      return [{ name, at: new Vector3().setFromMatrixPosition(grip.matrixWorld), palm: null }];
    const wrist = jointOf(pointer, "wrist", frame, space);
    return wrist ? [{ name, at: wrist.position, palm: palmOf(wrist.matrix) }] : [];
  }

  /** Names of the hands whose tips touch the model. */
  get touching(): readonly string[] {
    return this.#touch.names;
  }
}
