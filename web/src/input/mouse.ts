// SPDX-License-Identifier: Apache-2.0
// Mouse, pen and fingers over the canvas: hover reads, press on the model probes, else the camera moves.
import type { PointerKind } from "./pointer";

export interface MouseHost {
  readonly canvas: HTMLCanvasElement;
  /** Whether the model is at this point of the canvas. */
  hitsModel(x: number, y: number): boolean;
  hover(x: number, y: number, kind: PointerKind): void;
  leave(): void;
  /** Hear and feel starts, or ends. */
  hold(on: boolean): void;
  turn(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  zoom(scale: number, x: number, y: number): void;
  /** Pressed twice on the model. */
  keep(): void;
  /** The canvas was pressed. */
  pressed(): void;
  /** A finger rests on the model. */
  rests(x: number, y: number): void;
}

type Drag = "probe" | "turn" | "pan" | "pinch" | null;

/** A finger that stays so long within so many pixels rests. */
const REST_MS = 600;
const REST_PIXELS = 10;

/** Returns its own removal. */
export function attachMouse(host: MouseHost): () => void {
  const { canvas } = host;
  const fingers = new Map<number, { x: number; y: number }>();
  let drag: Drag = null;
  let last = { x: 0, y: 0 };
  let spread = 0;
  let resting: { timer: number; x: number; y: number } | null = null;
  const wake = () => {
    clearTimeout(resting?.timer);
    resting = null;
  };

  const at = (event: PointerEvent | WheelEvent) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const kindOf = (event: PointerEvent): PointerKind =>
    event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse";
  const stop = () => {
    wake();
    if (drag === "probe") host.hold(false);
    drag = null;
  };
  const pinch = () => {
    const [a, b] = [...fingers.values()];
    if (!a || !b) return null;
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, spread: Math.hypot(a.x - b.x, a.y - b.y) };
  };

  const down = (event: PointerEvent) => {
    canvas.focus({ preventScroll: true });
    host.pressed();
    const point = at(event);
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === "touch") fingers.set(event.pointerId, point);
    last = point;
    if (fingers.size === 2) {
      stop();
      const two = pinch();
      drag = "pinch";
      if (two) {
        last = two;
        spread = two.spread;
      }
      return;
    }
    if (event.button === 2) drag = "pan";
    else if (event.button === 1 || !host.hitsModel(point.x, point.y)) drag = "turn";
    else {
      drag = "probe";
      host.hover(point.x, point.y, kindOf(event));
      host.hold(true);
      if (event.pointerType === "touch") {
        const timer = window.setTimeout(() => host.rests(point.x, point.y), REST_MS);
        resting = { timer, ...point };
      }
    }
    if (event.button === 1) event.preventDefault();
  };
  const move = (event: PointerEvent) => {
    const point = at(event);
    if (fingers.has(event.pointerId)) fingers.set(event.pointerId, point);
    if (resting && Math.hypot(point.x - resting.x, point.y - resting.y) > REST_PIXELS) wake();
    if (drag === "pinch") {
      const two = pinch();
      if (!two) return;
      host.pan(two.x - last.x, two.y - last.y);
      if (two.spread > 0 && spread > 0) host.zoom(spread / two.spread, two.x, two.y);
      last = two;
      spread = two.spread;
      return;
    }
    if (drag === "turn") host.turn(point.x - last.x, point.y - last.y);
    else if (drag === "pan") host.pan(point.x - last.x, point.y - last.y);
    else host.hover(point.x, point.y, kindOf(event));
    last = point;
  };
  const up = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    stop();
    if (event.type === "pointercancel" || event.pointerType === "touch") host.leave();
  };
  const leave = (event: PointerEvent) => {
    if (drag === null && event.pointerType !== "touch") host.leave();
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const point = at(event);
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    host.zoom(Math.exp(Math.max(-240, Math.min(240, event.deltaY * lines)) * 0.0015), point.x, point.y);
  };
  const menu = (event: Event) => event.preventDefault();
  const twice = (event: MouseEvent) => {
    const box = canvas.getBoundingClientRect();
    if (host.hitsModel(event.clientX - box.left, event.clientY - box.top)) host.keep();
  };
  const blur = () => stop();

  canvas.addEventListener("pointerdown", down);
  canvas.addEventListener("pointermove", move);
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("pointerleave", leave);
  canvas.addEventListener("wheel", wheel, { passive: false });
  canvas.addEventListener("contextmenu", menu);
  canvas.addEventListener("dblclick", twice);
  window.addEventListener("blur", blur);
  return () => {
    canvas.removeEventListener("pointerdown", down);
    canvas.removeEventListener("pointermove", move);
    canvas.removeEventListener("pointerup", up);
    canvas.removeEventListener("pointercancel", up);
    canvas.removeEventListener("pointerleave", leave);
    canvas.removeEventListener("wheel", wheel);
    canvas.removeEventListener("contextmenu", menu);
    canvas.removeEventListener("dblclick", twice);
    window.removeEventListener("blur", blur);
  };
}
