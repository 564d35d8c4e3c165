// SPDX-License-Identifier: Apache-2.0
// What the controllers' buttons do.
import type { Vector3 } from "three";
import type { App } from "../app/app";
import type { Notes } from "../app/features/notes";
import { assign, drivenBy } from "../app/presentation-doc";
import type { VrWishes } from "./vr-buttons";
import type { VrPlanes } from "./vr-planes";
import type { VrWalk } from "./vr-walk";

/** What of the stay the buttons reach. */
export interface VrRoom {
  readonly head: Vector3;
  home(): void;
  nextPage(): void;
}

export function vrWishes(app: App, walk: VrWalk, planes: VrPlanes, room: VrRoom): VrWishes {
  const { store, actions } = app;
  return {
    note: (pointer) => {
      const state = app.probing.pointer(pointer.name, pointer.kind);
      if (state.place) app.feature<Notes>("notes").pinHere();
    },
    home: () => room.home(),
    nextPage: () => room.nextPage(),
    nextResult: () => {
      const keys = app.view.shown.filter((s) => s.result).map((s) => s.key);
      const next = keys[(keys.indexOf(drivenBy(store.state.doc, "colour") ?? "") + 1) % keys.length];
      if (next) store.set({ doc: assign(store.state.doc, next, "colour") });
    },
    stepBy: (count) => actions.stepBy(count),
    toggleSound: () => actions.toggle("sound"),
    turn: (degrees) => walk.turn(degrees, room.head),
    aimWalk: (pointer) => {
      if (pointer) walk.aim(pointer);
      else walk.go(room.head);
    },
    carryPlane: (pointer) => {
      if (pointer) planes.carry(pointer, app.view.model.worldMatrix());
    },
  };
}
