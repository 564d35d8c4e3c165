// SPDX-License-Identifier: Apache-2.0
// Canvas, renderer, camera and the frame loop. Draws only when something changed, or in a headset.
import { Group, PerspectiveCamera, type Ray, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { FINEST, type Level } from "./governor";
import { Orbit } from "./orbit";
import { Quality } from "./quality";

export type FrameListener = (seconds: number, frame: XRFrame | undefined) => void;

const scratchPoint = new Vector3();

export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  /** Holds the model; grips in a headset move it. */
  readonly holder = new Group();
  readonly camera = new PerspectiveCamera(30, 1, 0.01, 100);
  readonly orbit: Orbit;
  readonly quality: Quality;
  readonly #frames = new Set<FrameListener>();
  readonly #lateFrames = new Set<FrameListener>();
  readonly #pictures = new Set<() => void>();
  readonly #host: HTMLElement;
  readonly #resizeObserver: ResizeObserver;
  #dirty = true;
  #drawnLevel: Level;
  #running = 0;

  constructor(host: HTMLElement, options: { antialias: boolean; governed: boolean }) {
    this.quality = new Quality(options.governed);
    this.renderer = new WebGLRenderer({
      antialias: options.antialias,
      // Counts what cuts open.
      stencil: true,
      powerPreference: "high-performance",
    });
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    host.prepend(this.canvas);
    this.scene.add(this.holder);
    this.orbit = new Orbit(this.camera, () => this.invalidate());
    this.#drawnLevel = this.quality.drawn;
    this.renderer.xr.enabled = true;
    this.#host = host;
    this.#resizeObserver = new ResizeObserver(() => this.refit());
    this.#resizeObserver.observe(host);
    this.refit();
    this.renderer.setAnimationLoop((time, frame) => this.#frame(time / 1000, frame));
  }

  /** Something changed: draw the next frame. */
  invalidate(): void {
    this.#dirty = true;
  }

  /** Frames are drawn one after the other until the returned function is called. */
  keepRunning(): () => void {
    this.#running += 1;
    let on = true;
    return () => {
      if (on) this.#running -= 1;
      on = false;
    };
  }

  onFrame(listener: FrameListener): () => void {
    this.#frames.add(listener);
    return () => this.#frames.delete(listener);
  }

  /** Like onFrame, but after all of those: what follows from where the pointers are in this very frame. */
  onLateFrame(listener: FrameListener): () => void {
    this.#lateFrames.add(listener);
    return () => this.#lateFrames.delete(listener);
  }

  /** Before a picture is taken, which is always at the finest. */
  onPicture(listener: () => void): () => void {
    this.#pictures.add(listener);
    return () => this.#pictures.delete(listener);
  }

  get size(): Vector2 {
    return this.renderer.getSize(new Vector2());
  }

  /** Fills its place on the page again. */
  refit(): void {
    if (this.renderer.xr.isPresenting) return;
    this.quality.setFrameRate(null);
    const { clientWidth, clientHeight } = this.#host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(this.#pixelRatio);
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.orbit.reshaped();
  }

  get #fullRatio(): number {
    return Math.min(window.devicePixelRatio, 2);
  }

  get #pixelRatio(): number {
    return this.#fullRatio * this.quality.drawn.resolution;
  }

  /** The level of the governor, before anybody sets up this frame. */
  #applyLevel(frame: XRFrame | undefined): void {
    const { drawn } = this.quality;
    if (this.renderer.xr.isPresenting) {
      const space = this.renderer.xr.getReferenceSpace();
      const views = (space && frame?.getViewerPose(space)?.views) ?? [];
      for (const view of views) view.requestViewportScale?.(drawn.resolution);
    } else if (drawn !== this.#drawnLevel) this.renderer.setPixelRatio(this.#pixelRatio);
    this.#drawnLevel = drawn;
  }

  #frame(seconds: number, frame: XRFrame | undefined): void {
    const active = this.#dirty || this.#running > 0 || this.renderer.xr.isPresenting;
    if (this.quality.next(seconds, active)) this.#dirty = true;
    this.#applyLevel(frame);
    for (const listener of this.#frames) listener(seconds, frame);
    for (const listener of this.#lateFrames) listener(seconds, frame);
    if (!this.#dirty && this.#running === 0 && !this.renderer.xr.isPresenting) return;
    this.#dirty = false;
    this.renderer.render(this.scene, this.camera);
  }

  /** Draws now at the finest, so that the canvas can be read. */
  draw(): void {
    if (this.#drawnLevel !== FINEST) {
      this.#drawnLevel = FINEST;
      this.renderer.setPixelRatio(this.#fullRatio);
    }
    for (const listener of this.#pictures) listener();
    this.renderer.render(this.scene, this.camera);
  }

  /** Ray through a point of the canvas, CSS pixels from its upper left corner. */
  rayThrough(x: number, y: number, target: Ray): Ray {
    const { width, height } = this.canvas.getBoundingClientRect();
    const camera = this.camera;
    target.origin.setFromMatrixPosition(camera.matrixWorld);
    scratchPoint.set((2 * x) / width - 1, 1 - (2 * y) / height, 0.5).unproject(camera);
    target.direction.copy(scratchPoint).sub(target.origin).normalize();
    return target;
  }

  /** Where a world point is on the canvas, CSS pixels; null behind the camera. */
  project(point: Vector3): { x: number; y: number } | null {
    const { clientWidth, clientHeight } = this.canvas;
    scratchPoint.copy(point).project(this.camera);
    if (scratchPoint.z > 1 || scratchPoint.z < -1) return null;
    return { x: ((scratchPoint.x + 1) / 2) * clientWidth, y: ((1 - scratchPoint.y) / 2) * clientHeight };
  }

  dispose(): void {
    this.#resizeObserver.disconnect();
    this.renderer.setAnimationLoop(null);
    this.renderer.dispose();
    this.canvas.remove();
  }
}
