// SPDX-License-Identifier: Apache-2.0
// Comfort: while a model that surrounds the person moves faster than a stroll the edge of sight goes dark.
import { BackSide, Matrix4, Mesh, type Scene, ShaderMaterial, SphereGeometry, Vector3 } from "three";

/** Metres a second of the world about the head. */
export const FASTEST = 0.3;
/** A model that covers less than this to each side of its middle (tangent) is a thing, not the world. */
const SURROUNDS = 0.7;
/** Seconds to come and to go. */
const FADE = 0.15;
/** Cosine of the angle from straight ahead where it begins and where it is full, at strength 1. */
const OPEN = 0.92;
const SHUT = 0.78;

const scratch = new Vector3();
const moved = new Matrix4();

/** Metres that a world which has gone from `before` to `now` has moved about a head. */
export function wayAbout(head: Vector3, before: Matrix4, now: Matrix4): number {
  moved.copy(before).invert().premultiply(now);
  return scratch.copy(head).applyMatrix4(moved).distanceTo(head);
}

export class VrVignette {
  readonly #mesh: Mesh<SphereGeometry, ShaderMaterial>;
  readonly #before = new Matrix4();
  #known = false;
  #alpha = 0;

  constructor(scene: Scene) {
    const material = new ShaderMaterial({
      side: BackSide,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      uniforms: { alpha: { value: 0 }, open: { value: OPEN } },
      vertexShader: `varying vec3 way;
        void main() { way = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
      fragmentShader: `uniform float alpha; uniform float open; varying vec3 way;
        void main() {
          float ahead = -normalize(way).z;
          gl_FragColor = vec4(0.0, 0.0, 0.0, alpha * (1.0 - smoothstep(${SHUT.toFixed(2)}, open, ahead)));
        }`,
    });
    this.#mesh = new Mesh(new SphereGeometry(0.5, 32, 20), material);
    this.#mesh.renderOrder = 100;
    this.#mesh.frustumCulled = false;
    this.#mesh.visible = false;
    scene.add(this.#mesh);
  }

  /** What comes next is another place, not a way there. */
  jump(): void {
    this.#known = false;
  }

  /** How dark the edge of sight is, 0..1. */
  get alpha(): number {
    return this.#alpha;
  }

  /** Once a frame: where the world and the head are, how large the world is, and how much of this the person wants. */
  update(
    passed: number,
    head: Matrix4,
    world: Matrix4,
    size: { radius: number; distance: number },
    strength: number,
  ): void {
    const eye = new Vector3().setFromMatrixPosition(head);
    const speed = this.#known && passed > 0 ? wayAbout(eye, this.#before, world) / passed : 0;
    this.#before.copy(world);
    this.#known = true;
    const fast = speed > FASTEST && size.radius > SURROUNDS * size.distance;
    const wanted = fast ? strength : 0;
    const step = passed / FADE;
    this.#alpha += Math.min(Math.max(wanted - this.#alpha, -step), step);
    this.#mesh.visible = this.#alpha > 0;
    this.#mesh.matrixAutoUpdate = false;
    this.#mesh.matrix.copy(head);
    this.#mesh.material.uniforms.alpha = { value: this.#alpha };
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#mesh.material.dispose();
    this.#mesh.removeFromParent();
  }
}
