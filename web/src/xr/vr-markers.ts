// SPDX-License-Identifier: Apache-2.0
// MX and MN in the headset: a dot at the place and its label, as large for the eyes at any distance.
import { Mesh, MeshBasicMaterial, type Scene, SphereGeometry, type Vector3 } from "three";
import { BOARD_FONT, Board, BOARD_COLOURS as C, reportOf, roundRect } from "./board";

export interface VrMark {
  readonly kind: "max" | "min" | "hot" | "note" | "ruler";
  readonly id: string;
  readonly text: string;
  readonly detail: string;
  /** World metres. */
  readonly at: Vector3;
}

const WIDTH = 560;
const HEIGHT = 96;
/** Width of a label at one metre. */
const METRES = 0.2;

interface Shown {
  readonly board: Board;
  readonly dot: Mesh<SphereGeometry, MeshBasicMaterial>;
  text: string;
}

export class VrMarkers {
  readonly #scene: Scene;
  readonly #shown = new Map<string, Shown>();

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  update(marks: readonly VrMark[], eye: Vector3): void {
    for (const [id, shown] of this.#shown) {
      const here = marks.some((mark) => mark.id === id);
      shown.board.mesh.visible = here;
      shown.dot.visible = here;
    }
    for (const mark of marks) this.#place(mark, eye);
  }

  #place(mark: VrMark, eye: Vector3): void {
    const shown = this.#shown.get(mark.id) ?? this.#make(mark.id);
    const distance = Math.max(mark.at.distanceTo(eye), 0.2);
    shown.dot.position.copy(mark.at);
    shown.dot.scale.setScalar(distance);
    const { mesh } = shown.board;
    mesh.scale.setScalar(distance);
    mesh.position.copy(mark.at).lerp(eye, 0.03);
    mesh.position.y += (mark.kind === "min" ? -0.035 : 0.035) * distance;
    mesh.lookAt(eye);
    const text = `${mark.text}  ${mark.detail}`;
    if (shown.text === text) return;
    shown.text = text;
    shown.board.paint((context) => {
      roundRect(context, { x: 0, y: 0, width: WIDTH, height: HEIGHT }, 22, C.panel);
      context.textBaseline = "middle";
      context.textAlign = "center";
      context.font = `600 40px ${BOARD_FONT}`;
      context.fillStyle = C.ink;
      context.fillText(text, WIDTH / 2, HEIGHT / 2, WIDTH - 30);
      return [];
    });
  }

  /** Where labels are, as boards are told. */
  report() {
    return [...this.#shown.values()].flatMap(({ board }) => reportOf(board) ?? []);
  }

  #make(id: string): Shown {
    const board = new Board(WIDTH, HEIGHT, METRES);
    const dot = new Mesh(new SphereGeometry(0.005, 12, 10), new MeshBasicMaterial({ color: 0xffffff }));
    this.#scene.add(board.mesh, dot);
    const shown = { board, dot, text: "" };
    this.#shown.set(id, shown);
    return shown;
  }

  dispose(): void {
    for (const { board, dot } of this.#shown.values()) {
      board.dispose();
      dot.geometry.dispose();
      dot.material.dispose();
      dot.removeFromParent();
    }
    this.#shown.clear();
  }
}
