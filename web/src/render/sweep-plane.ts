// SPDX-License-Identifier: Apache-2.0
// A pane that goes through the model: where one listens now.
import { type Box3, DoubleSide, Mesh, MeshBasicMaterial, type Object3D, PlaneGeometry, Vector3 } from "three";

/** How far the pane stands out of the model on each side. */
const MARGIN = 1.08;

export class SweepPlane {
  readonly #pane = new Mesh(
    new PlaneGeometry(1, 1),
    new MeshBasicMaterial({
      color: 0xd0167f,
      transparent: true,
      opacity: 0.28,
      side: DoubleSide,
      depthWrite: false,
    }),
  );

  /** `model`: what holds the model in its own units. */
  constructor(model: Object3D) {
    this.#pane.visible = false;
    this.#pane.renderOrder = 3;
    model.add(this.#pane);
  }

  /** Across an axis of the model at a place of it. */
  show(box: Box3, axis: 0 | 1 | 2, at: number): void {
    const middle = box.getCenter(new Vector3());
    const size = box.getSize(new Vector3()).multiplyScalar(MARGIN);
    middle.setComponent(axis, at);
    this.#pane.position.copy(middle);
    this.#pane.rotation.set(axis === 1 ? Math.PI / 2 : 0, axis === 0 ? Math.PI / 2 : 0, 0);
    this.#pane.scale.set(axis === 0 ? size.z : size.x, axis === 1 ? size.z : size.y, 1);
    this.#pane.visible = true;
  }

  hide(): void {
    this.#pane.visible = false;
  }

  dispose(): void {
    this.#pane.geometry.dispose();
    this.#pane.material.dispose();
    this.#pane.removeFromParent();
  }
}
