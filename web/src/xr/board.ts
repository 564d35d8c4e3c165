// SPDX-License-Identifier: Apache-2.0
// A flat board in the room, drawn with a 2D canvas: system fonts, one draw call, its widgets hit by position.
import { CanvasTexture, LinearFilter, Mesh, MeshBasicMaterial, PlaneGeometry, SRGBColorSpace } from "three";

export { BOARD_COLOURS } from "./board-colours";

export interface BoardRect {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Something on a board that can be pressed. */
export interface BoardButton extends BoardRect {
  readonly id: string;
  readonly press: () => void;
  /** Of a slider: while it is held, the share of its width where the pointer is. */
  readonly slide?: (share: number) => void;
}

export const BOARD_FONT = 'system-ui, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif';

export class Board {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  readonly context: CanvasRenderingContext2D;
  readonly width: number;
  readonly height: number;
  readonly #texture: CanvasTexture;
  #buttons: readonly BoardButton[] = [];

  /** `metres`: width of the board in the room; pixels give its sharpness and aspect. */
  constructor(width: number, height: number, metres: number) {
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext("2d");
    if (!context) throw new Error("this browser gives no 2D canvas");
    this.context = context;
    this.width = width;
    this.height = height;
    this.#texture = new CanvasTexture(canvas);
    this.#texture.colorSpace = SRGBColorSpace;
    this.#texture.minFilter = LinearFilter;
    this.#texture.generateMipmaps = false;
    const material = new MeshBasicMaterial({ map: this.#texture, toneMapped: false, transparent: true });
    this.mesh = new Mesh(new PlaneGeometry(metres, (metres * height) / width), material);
    this.mesh.renderOrder = 5;
  }

  get buttons(): readonly BoardButton[] {
    return this.#buttons;
  }

  /** Draws anew; the painter returns what can be pressed. */
  paint(painter: (context: CanvasRenderingContext2D) => readonly BoardButton[]): void {
    this.context.clearRect(0, 0, this.width, this.height);
    this.#buttons = painter(this.context);
    this.#texture.needsUpdate = true;
  }

  /** The button at a place of the board, u and v from its lower left corner. */
  buttonAt(u: number, v: number): BoardButton | null {
    const x = u * this.width;
    const y = (1 - v) * this.height;
    const inside = (b: BoardRect) => x >= b.x && x < b.x + b.width && y >= b.y && y < b.y + b.height;
    return this.#buttons.find(inside) ?? null;
  }

  /** How far along a button the place `u` of the board is, 0..1. */
  shareOf(button: BoardRect, u: number): number {
    return Math.min(Math.max((u * this.width - button.x) / button.width, 0), 1);
  }

  /** Buttons and where they are, for reports. */
  buttonPlaces() {
    return this.#buttons.map(({ id, x, y, width, height }) => ({ id, x, y, width, height }));
  }

  dispose(): void {
    this.#texture.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.removeFromParent();
  }
}

export function roundRect(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  rect: BoardRect,
  radius: number,
  fill: string,
): void {
  context.beginPath();
  context.roundRect(rect.x, rect.y, rect.width, rect.height, radius);
  context.fillStyle = fill;
  context.fill();
}

/** Where a board is and how large; null while nobody sees it. Metres, the matrix column by column, size in pixels. */
export function reportOf({ mesh, width, height }: Board) {
  const { width: metresWide, height: metresHigh } = mesh.geometry.parameters;
  return mesh.visible ? { matrix: mesh.matrixWorld.toArray(), metresWide, metresHigh, width, height } : null;
}
