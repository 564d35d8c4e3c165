// SPDX-License-Identifier: Apache-2.0
// What the controllers' buttons do.
import type { Vector3 } from "three";
import type { App } from "../app/app";
import type { Notes } from "../app/features/notes";
import type { VrWishes } from "./vr-buttons";
import type { VrPlanes } from "./vr-planes";
import type { VrWalk } from "./vr-walk";

/** What of the stay the buttons reach. */
export interface VrRoom {
  readonly head: Vector3;
  home(): void;
  callMenu(): void;
  /** Degrees to the left. */
  turn(degrees: number): void;
  walked(): void;
}

export function vrWishes(app: App, walk: VrWalk, planes: VrPlanes, room: VrRoom): VrWishes {
  const { actions } = app;
  return {
    note: (pointer) => {
      const state = app.probing.pointer(pointer.name, pointer.kind);
      if (state.place) app.feature<Notes>("notes").pinHere();
    },
    home: () => room.home(),
    menu: () => room.callMenu(),
    nextResult: () => actions.nextResult(),
    stepBy: (count) => actions.stepBy(count),
    toggleSound: () => actions.toggle("sound"),
    turn: (degrees) => room.turn(degrees),
    aimWalk: (pointer) => {
      if (pointer) walk.aim(pointer);
      else if (walk.go(room.head)) room.walked();
    },
    carryPlane: (pointer) => {
      if (pointer) planes.carry(pointer, app.view.model.worldMatrix());
    },
  };
}
