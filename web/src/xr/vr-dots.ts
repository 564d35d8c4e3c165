// SPDX-License-Identifier: Apache-2.0
// A dot where each pointer's ray meets the model.
import { Mesh, MeshBasicMaterial, type Scene, SphereGeometry, type Vector3 } from "three";

export class VrDots {
  readonly #scene: Scene;
  readonly #dots = new Map<string, Mesh<SphereGeometry, MeshBasicMaterial>>();

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  get names(): IterableIterator<string> {
    return this.#dots.keys();
  }

  /** Of a pointer, world metres; null: nowhere. */
  show(name: string, at: Vector3 | null): void {
    let dot = this.#dots.get(name);
    if (!dot) {
      dot = new Mesh(new SphereGeometry(0.006, 16, 12), new MeshBasicMaterial({ color: 0xffffff }));
      this.#dots.set(name, dot);
      this.#scene.add(dot);
    }
    dot.visible = at !== null;
    if (at) dot.position.copy(at);
  }

  dispose(): void {
    for (const dot of this.#dots.values()) {
      dot.geometry.dispose();
      dot.material.dispose();
      dot.removeFromParent();
    }
  }
}
