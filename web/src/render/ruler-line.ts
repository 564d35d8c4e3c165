// SPDX-License-Identifier: Apache-2.0
// A straight line between two places of the room, seen through the model.
import { BufferAttribute, BufferGeometry, Line, LineBasicMaterial, type Scene, type Vector3 } from "three";

export class RulerLine {
  readonly #line: Line<BufferGeometry, LineBasicMaterial>;

  constructor(scene: Scene) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(6), 3));
    this.#line = new Line(
      geometry,
      new LineBasicMaterial({ color: 0xd0167f, depthTest: false, transparent: true }),
    );
    this.#line.frustumCulled = false;
    this.#line.renderOrder = 4;
    this.#line.visible = false;
    scene.add(this.#line);
  }

  /** World metres; null: no line. */
  set(from: Vector3 | null, to: Vector3 | null): void {
    this.#line.visible = from !== null && to !== null;
    if (!from || !to) return;
    const places = this.#line.geometry.getAttribute("position") as BufferAttribute;
    places.setXYZ(0, from.x, from.y, from.z);
    places.setXYZ(1, to.x, to.y, to.z);
    places.needsUpdate = true;
  }
}
