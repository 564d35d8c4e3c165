// SPDX-License-Identifier: Apache-2.0
// Mouse, pen and fingers as pointers on the model.
import { Ray } from "three";
import { attachMouse } from "../input/mouse";
import type { PointerKind } from "../input/pointer";
import { actuatorOfDevice } from "../sense";
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
    probing.pointer(MOUSE, kind).actuator = kind === "touch" ? actuatorOfDevice(navigator) : null;
    app.setInside(inside ? { x, y } : null);
    app.invalidate();
  };
  const { canvas } = stage;
  // Whoever leaves the model, or presses Esc, wants Tab for the page again.
  const leave = () => app.setPressed(false);
  const onEscape = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    app.setPressed(false);
    app.closePlaceMenu();
  };
  canvas.addEventListener("blur", leave);
  window.addEventListener("keydown", onEscape);
  const detach = attachMouse({
    canvas: stage.canvas,
    hitsModel: (x, y) => cast(x, y).hit !== null,
    hover,
    leave: () => {
      probing.move(MOUSE, "mouse", null);
      app.setInside(null);
      app.invalidate();
    },
    hold: (on) => app.hold(on),
    pressed: () => app.setPressed(true),
    rests: (x, y) => {
      const { hit } = cast(x, y);
      if (hit) app.showPlaceMenu(hit, { x, y });
    },
    keep: () => app.feature<Notes>("notes").pinHere(),
    turn: (dx, dy) => stage.orbit.turn(dx * 0.008, dy * 0.008),
    pan: (dx, dy) => stage.orbit.pan(dx, dy, stage.canvas.clientHeight),
    zoom: (scale, x, y) => stage.orbit.zoom(scale, cast(x, y).hit?.world ?? null),
  });
  return () => {
    detach();
    canvas.removeEventListener("blur", leave);
    window.removeEventListener("keydown", onEscape);
  };
}
