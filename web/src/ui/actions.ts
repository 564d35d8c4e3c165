// SPDX-License-Identifier: Apache-2.0
// What the controls of the page can ask for; the app does it.
import type { ColourChange, RangeMode, Slot } from "../app/presentation-doc";
import type { DeformMode } from "../app/store";
import type { SceneResult } from "../scene";

export type ViewName = "+x" | "-x" | "+y" | "-y" | "+z" | "-z" | "iso";

export interface Actions {
  assign(key: string, slot: Slot): void;
  release(slot: Slot): void;
  releaseAll(key: string): void;
  /** The next result of the table is the one that is seen. */
  nextResult(): void;
  addResult(result: SceneResult, component: string): void;
  setRange(key: string, change: { mode: RangeMode; lo?: number; hi?: number; scale?: string }): void;
  setColour(change: ColourChange): void;
  toggleLock(): void;
  setStep(id: number): void;
  stepBy(count: number): void;
  togglePlay(): void;
  setDeform(mode: DeformMode, factor?: number): void;
  toggle(what: "edges" | "shading" | "extremes" | "sound" | "touch" | "ghost"): void;
  cycleTheme(): void;
  fit(): void;
  view(name: ViewName): void;
  /** Turns the camera, degrees to the right and down. */
  turn(right: number, down: number): void;
  /** Moves the picture by shares of its size. */
  move(right: number, down: number): void;
  /** Distance times this. */
  zoom(scale: number): void;
  goTo(kind: "node" | "element", id: number): void;
  unpin(): void;
  /** To the next node that way on the screen; the first press takes the pointer's place, or the largest value's. */
  stepPin(right: number, down: number): void;
  enterVr(): void;
  /** Every function by its words. */
  openPalette(): void;
  dismissProblem(): void;
  /** Unfolds or folds a section of the page. */
  openSection(id: string, on: boolean): void;
}
