// SPDX-License-Identifier: Apache-2.0
// Fills what a plane opens, as the native viewer does. Along a line of sight that enters through a plane, backs of closed
// solids less their fronts are the solids that it is in at the plane: counted in the stencil, with that plane alone, whatever
// the others take away. So a slab between two planes is not seen through, although the line of sight meets none of its skin.
import {
  AlwaysStencilFunc,
  BackSide,
  BufferAttribute,
  BufferGeometry,
  type Camera,
  DecrementWrapStencilOp,
  FrontSide,
  Group,
  IncrementWrapStencilOp,
  KeepStencilOp,
  Mesh,
  NotEqualStencilFunc,
  ShaderMaterial,
  Sphere,
  Vector3,
  type WebGLRenderer,
} from "three";
import { type CutPlane, MAX_CUTS, setUniform, type Uniforms } from "./field-material";
import { CAP_FRAGMENT, CAP_VERTEX, COUNT_FRAGMENT, COUNT_VERTEX } from "./shaders";

const scratchEye = new Vector3();
/** After the skin, one plane after the other. */
const FIRST_ORDER = 0.5;
const STEP_ORDER = 0.1;

/** Counts one side of the skin. */
class CountMaterial extends ShaderMaterial {
  constructor(uniforms: Uniforms, side: typeof FrontSide | typeof BackSide, plane: number) {
    const op = side === BackSide ? IncrementWrapStencilOp : DecrementWrapStencilOp;
    super({
      vertexShader: COUNT_VERTEX,
      fragmentShader: COUNT_FRAGMENT,
      defines: { CUT: "" },
      side,
      colorWrite: false,
      depthTest: false,
      depthWrite: false,
      stencilWrite: true,
      stencilFunc: AlwaysStencilFunc,
      stencilFail: KeepStencilOp,
      stencilZFail: op,
      stencilZPass: op,
    });
    this.uniforms = { ...uniforms, pass: { value: 0 }, ownPlane: { value: plane } };
  }
}

/** The plane, as far as the model reaches, where something was counted. */
class CapMaterial extends ShaderMaterial {
  constructor(uniforms: Uniforms, plane: number) {
    super({
      vertexShader: CAP_VERTEX,
      fragmentShader: CAP_FRAGMENT,
      defines: { CUT: "" },
      // From the other side nobody looks into what the plane has opened.
      side: FrontSide,
      stencilWrite: true,
      stencilRef: 0,
      stencilFunc: NotEqualStencilFunc,
    });
    this.uniforms = {
      ...uniforms,
      ownPlane: { value: plane },
      middle: { value: new Vector3() },
      right: { value: new Vector3() },
      up: { value: new Vector3() },
      hasStencil: { value: true },
    };
  }
}

function squareGeometry(): BufferGeometry {
  const geometry = new BufferGeometry();
  const corners = [-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0];
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.boundingSphere = new Sphere();
  return geometry;
}

interface Cap {
  readonly meshes: readonly Mesh[];
  readonly material: CapMaterial;
}

export class CutCaps {
  readonly group = new Group();
  readonly #faces: BufferGeometry;
  readonly #square = squareGeometry();
  readonly #caps: readonly Cap[];
  #planes: readonly CutPlane[] = [];
  /** Whether a headset was presenting when the buffer was asked for its stencil. */
  #askedIn: boolean | null = null;
  #hasStencil = false;

  constructor(faces: BufferGeometry, uniforms: Uniforms) {
    this.#faces = faces;
    this.#caps = Array.from({ length: MAX_CUTS }, (_, plane) => this.#makeCap(uniforms, plane));
    this.hide();
  }

  #makeCap(uniforms: Uniforms, plane: number): Cap {
    const material = new CapMaterial(uniforms, plane);
    const counted = [BackSide, FrontSide].map(
      (side) => new Mesh(this.#faces, new CountMaterial(uniforms, side as typeof BackSide, plane)),
    );
    const cap = new Mesh(this.#square, material);
    for (const mesh of counted) {
      mesh.renderOrder = FIRST_ORDER + STEP_ORDER * plane;
      mesh.onBeforeRender = (_renderer, _scene, camera) => {
        // An eye that does not look into the plane needs no count.
        if (!this.#isOpenTo(camera, plane)) this.#faces.drawRange.count = 0;
      };
      mesh.onAfterRender = () => {
        this.#faces.drawRange.count = Number.POSITIVE_INFINITY;
      };
    }
    cap.renderOrder = FIRST_ORDER + STEP_ORDER * (plane + 0.5);
    cap.onBeforeRender = (renderer) => setUniform(material.uniforms, "hasStencil", this.#stencilOf(renderer));
    cap.onAfterRender = (renderer) => renderer.clearStencil();
    const meshes = [...counted, cap];
    for (const mesh of meshes) mesh.frustumCulled = false;
    this.group.add(...meshes);
    return { meshes, material };
  }

  #isOpenTo(camera: Camera, plane: number): boolean {
    const { normal, offset } = this.#planes[plane] ?? { normal: [0, 0, 0], offset: 0 };
    this.group.worldToLocal(scratchEye.setFromMatrixPosition(camera.matrixWorld));
    return normal[0] * scratchEye.x + normal[1] * scratchEye.y + normal[2] * scratchEye.z > offset;
  }

  /** Without one the whole plane would be drawn. The question waits for the card: once each time the buffer is another. */
  #stencilOf(renderer: WebGLRenderer): boolean {
    const { isPresenting } = renderer.xr;
    if (this.#askedIn !== isPresenting) {
      const gl = renderer.getContext();
      this.#hasStencil = gl.getParameter(gl.STENCIL_BITS) > 0;
      this.#askedIn = isPresenting;
    }
    return this.#hasStencil;
  }

  hide(): void {
    this.group.visible = false;
  }

  /** `filled`: of each plane, whether to; `middle` and `reach` of the model as it is drawn. */
  show(planes: readonly CutPlane[], filled: readonly boolean[], middle: Vector3, reach: number): void {
    this.#planes = planes;
    this.group.visible = filled.includes(true);
    for (const [i, { meshes, material }] of this.#caps.entries()) {
      const plane = planes[i];
      for (const mesh of meshes) mesh.visible = plane !== undefined && filled[i] === true;
      if (!plane) continue;
      const given = new Vector3(...plane.normal);
      const normal = given.clone().normalize();
      const aside = Math.abs(normal.x) < 0.6 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
      const right = aside.cross(normal).normalize();
      const off = (plane.offset - given.dot(middle)) / given.length();
      setUniform(material.uniforms, "middle", middle.clone().addScaledVector(normal, off));
      setUniform(material.uniforms, "up", normal.clone().cross(right).multiplyScalar(reach));
      setUniform(material.uniforms, "right", right.multiplyScalar(reach));
    }
  }

  dispose(): void {
    this.#square.dispose();
    for (const mesh of this.#caps.flatMap((cap) => cap.meshes)) (mesh.material as ShaderMaterial).dispose();
  }
}
