// SPDX-License-Identifier: Apache-2.0
// Mouse, pen and fingers as pointers on the model.
import { Ray } from "three";
import { attachMouse } from "../input/mouse";
import type { PointerKind } from "../input/pointer";
import type { App } from "./app";
import type { Notes } from "./features/notes";

const MOUSE = "mouse";
const scratchRay = new Ray();

/** Returns its own removal. */
export function attachDeskPointer(app: App): () => void {
  const { stage, view, probing } = app;
  const cast = (x: number, y: number) =>
    view.picker.cast(stage.rayThrough(x, y, scratchRay), view.model.worldMatrix());
  const hover = (x: number, y: number, kind: PointerKind) => {
    const { hit, inside } = cast(x, y);
    probing.move(MOUSE, kind, hit);
    app.setInside(inside ? { x, y } : null);
    app.invalidate();
  };
  return attachMouse({
    canvas: stage.canvas,
    hitsModel: (x, y) => cast(x, y).hit !== null,
    hover,
    leave: () => {
      probing.move(MOUSE, "mouse", null);
      app.setInside(null);
      app.invalidate();
    },
    hold: (on) => app.hold(on),
    keep: () => app.feature<Notes>("notes").pinHere(),
    turn: (dx, dy) => stage.orbit.turn(dx * 0.008, dy * 0.008),
    pan: (dx, dy) => stage.orbit.pan(dx, dy, stage.canvas.clientHeight),
    zoom: (scale, x, y) => stage.orbit.zoom(scale, cast(x, y).hit?.world ?? null),
  });
}
