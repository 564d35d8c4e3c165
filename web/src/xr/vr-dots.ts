// SPDX-License-Identifier: Apache-2.0
// Where each pointer is on the model: a dot, a ring that stands in for pulses where nothing shakes, and the ring that
// offers a note to a pinch that rests.
import {
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  type Scene,
  SphereGeometry,
  Vector3,
} from "three";

/** Seconds that the ring of a pulse is seen. */
const FLASH = 0.22;
const scratch = new Vector3();

interface Dot {
  readonly dot: Mesh<SphereGeometry, MeshBasicMaterial>;
  readonly pulse: Mesh<RingGeometry, MeshBasicMaterial>;
  readonly offer: Mesh<RingGeometry, MeshBasicMaterial>;
  /** Pulses shown so far, and the last of them. */
  count: number;
  strength: number;
  age: number;
}

function ring(inner: number, outer: number, color: number): Dot["pulse"] {
  const material = new MeshBasicMaterial({ color, side: DoubleSide, transparent: true, depthTest: false });
  const mesh = new Mesh(new RingGeometry(inner, outer, 40), material);
  mesh.renderOrder = 6;
  mesh.visible = false;
  return mesh;
}

export class VrDots {
  readonly #scene: Scene;
  readonly #dots = new Map<string, Dot>();

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  get names(): IterableIterator<string> {
    return this.#dots.keys();
  }

  #of(name: string): Dot {
    let entry = this.#dots.get(name);
    if (!entry) {
      entry = {
        dot: new Mesh(new SphereGeometry(0.006, 16, 12), new MeshBasicMaterial({ color: 0xffffff })),
        pulse: ring(0.9, 1, 0xffffff),
        offer: ring(0.72, 0.9, 0x74c9c6),
        count: 0,
        strength: 0,
        age: FLASH,
      };
      entry.dot.visible = false;
      this.#dots.set(name, entry);
      this.#scene.add(entry.dot, entry.pulse, entry.offer);
    }
    return entry;
  }

  /** Of a pointer, world metres; null: nowhere. */
  show(name: string, at: Vector3 | null): void {
    const { dot } = this.#of(name);
    dot.visible = at !== null;
    if (at) dot.position.copy(at);
  }

  /** What would be felt is seen: a ring that opens as wide as the pulse is strong. */
  pulse(name: string, strength: number): void {
    const entry = this.#of(name);
    entry.count += 1;
    entry.strength = strength;
    entry.age = 0;
  }

  /** How far the ring round a resting pinch has opened, 0..1; 0: there is none. */
  offer(name: string, share: number): void {
    const { offer } = this.#of(name);
    offer.visible = share > 0;
    offer.userData.share = share;
  }

  /** Once a frame: rings face the eyes and are as large for them at any distance. */
  update(passed: number, eye: Vector3): void {
    for (const entry of this.#dots.values()) {
      const { dot, pulse, offer } = entry;
      const size = 0.03 * Math.max(scratch.copy(dot.position).distanceTo(eye), 0.2);
      entry.age += passed;
      pulse.visible = dot.visible && entry.age < FLASH;
      pulse.material.opacity = Math.max(1 - entry.age / FLASH, 0);
      for (const [mesh, share] of [
        [pulse, (0.4 + 0.6 * entry.strength) * Math.min(0.4 + entry.age / FLASH, 1)],
        [offer, Number(offer.userData.share ?? 0)],
      ] as const) {
        mesh.position.copy(dot.position);
        mesh.scale.setScalar(Math.max(size * share, 1e-6));
        mesh.lookAt(eye);
      }
    }
  }

  /** For reports: rings shown for pulses, and those that offer a note. */
  report() {
    return [...this.#dots].map(([pointer, entry]) => ({
      pointer,
      pulses: entry.count,
      strength: entry.strength,
      offer: entry.offer.visible ? Number(entry.offer.userData.share) : 0,
    }));
  }

  dispose(): void {
    for (const { dot, pulse, offer } of this.#dots.values()) {
      for (const mesh of [dot, pulse, offer]) {
        mesh.geometry.dispose();
        mesh.material.dispose();
        mesh.removeFromParent();
      }
    }
  }
}
