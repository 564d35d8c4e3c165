// SPDX-License-Identifier: Apache-2.0
// Controllers, hands and pinches of a session as pointers: ray, trigger, grip, actuator.
import {
  CapsuleGeometry,
  CylinderGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Ray,
  Vector3,
  type WebGLRenderer,
} from "three";
import type { PointerKind } from "../input/pointer";
import { type Actuator, actuatorOf } from "../sense";
import type { GripPose } from "./grab";

const SLOTS = 4;
const RAY_LENGTH = 4;
const FORWARD = new Vector3(0, 0, -1);

export interface VrPointer {
  readonly name: string;
  readonly kind: PointerKind;
  readonly source: XRInputSource;
  readonly target: Object3D;
  readonly grip: Object3D;
  readonly actuator: Actuator | null;
  readonly ray: Ray;
  /** What touches: the front of a controller, the end of an index finger; null: nothing is known of it. */
  tip: Vector3 | null;
}

/** A pinch that shows where one looks only when it begins: from then on the hand moves what was aimed at. */
interface Anchor {
  readonly origin: Vector3;
  readonly at: Vector3;
  readonly grip: Vector3;
}

export interface VrPointerHost {
  connected(pointer: VrPointer): void;
  disconnected(pointer: VrPointer): void;
  select(pointer: VrPointer, on: boolean): void;
  squeeze(pointer: VrPointer, on: boolean): void;
}

function kindOf(source: XRInputSource): PointerKind {
  const mode = source.targetRayMode as string;
  if (mode === "transient-pointer") return "transient";
  if (mode === "gaze") return "gaze";
  return source.hand ? "hand" : "controller";
}

function nameOf(source: XRInputSource, slot: number): string {
  const side = source.handedness === "none" ? `slot-${slot}` : source.handedness;
  return `${side}-${kindOf(source)}`;
}

/** A joint of a hand, in the room; null for what has none, or while it is not seen. */
export function jointOf(
  pointer: VrPointer,
  name: XRHandJoint,
  frame: XRFrame | undefined,
  space: XRReferenceSpace | null,
): { position: Vector3; matrix: Float32Array } | null {
  const joint = pointer.source.hand?.get(name);
  const pose = joint && space ? frame?.getJointPose?.(joint, space) : null;
  if (!pose) return null;
  const { x, y, z } = pose.transform.position;
  return { position: new Vector3(x, y, z), matrix: pose.transform.matrix };
}

/** A thin ray that ends where the pointer hits, and a handle in the hand. */
class Looks {
  readonly ray = new Group();
  readonly #beam: Mesh;
  readonly #handle: Mesh;

  constructor(target: Object3D, grip: Object3D, kind: PointerKind) {
    const material = new MeshBasicMaterial({ color: 0xdfeef0, transparent: true, opacity: 0.75 });
    this.#beam = new Mesh(
      new CylinderGeometry(0.0012, 0.0012, 1, 8).rotateX(Math.PI / 2).translate(0, 0, -0.5),
      material,
    );
    this.ray.add(this.#beam);
    target.add(this.ray);
    this.#handle = new Mesh(
      new CapsuleGeometry(0.014, 0.09, 6, 16).rotateX(Math.PI / 2.6),
      new MeshBasicMaterial({ color: 0x39474f }),
    );
    this.#handle.visible = kind === "controller";
    grip.add(this.#handle);
  }

  /** null: it does not point. */
  setLength(length: number | null): void {
    this.#beam.visible = length !== null;
    if (length !== null) this.#beam.scale.z = length;
  }

  get length(): number | null {
    return this.#beam.visible ? this.#beam.scale.z : null;
  }

  dispose(): void {
    for (const mesh of [this.#beam, this.#handle]) {
      mesh.geometry.dispose();
      (mesh.material as MeshBasicMaterial).dispose();
      mesh.removeFromParent();
    }
    this.ray.removeFromParent();
  }
}

export class VrPointers {
  readonly #pointers = new Map<number, { pointer: VrPointer; looks: Looks }>();
  readonly #removals: (() => void)[] = [];
  readonly #anchors = new Map<VrPointer, Anchor>();

  constructor(renderer: WebGLRenderer, parent: Object3D, host: VrPointerHost) {
    for (let slot = 0; slot < SLOTS; ++slot) {
      const target = renderer.xr.getController(slot);
      const grip = renderer.xr.getControllerGrip(slot);
      parent.add(target, grip);
      const here = () => this.#pointers.get(slot)?.pointer;
      const connected = (event: { data: XRInputSource }) => {
        const source = event.data;
        const kind = kindOf(source);
        const actuator = actuatorOf(source.gamepad);
        const name = nameOf(source, slot);
        const pointer = { name, kind, source, target, grip, actuator, ray: new Ray(), tip: null };
        this.#pointers.set(slot, { pointer, looks: new Looks(target, grip, kind) });
        host.connected(pointer);
      };
      const disconnected = () => {
        const gone = this.#pointers.get(slot);
        this.#pointers.delete(slot);
        gone?.looks.dispose();
        if (gone) this.#anchors.delete(gone.pointer);
        if (gone) host.disconnected(gone.pointer);
      };
      // Only start and end count: some runtimes fire 'select' on the press.
      const on = (
        type: "selectstart" | "selectend" | "squeezestart" | "squeezeend",
        act: (p: VrPointer) => void,
      ) => {
        const listener = () => {
          const pointer = here();
          if (pointer) act(pointer);
        };
        target.addEventListener(type, listener);
        this.#removals.push(() => target.removeEventListener(type, listener));
      };
      target.addEventListener("connected", connected);
      target.addEventListener("disconnected", disconnected);
      on("selectstart", (p) => host.select(p, true));
      on("selectend", (p) => host.select(p, false));
      on("squeezestart", (p) => host.squeeze(p, true));
      on("squeezeend", (p) => host.squeeze(p, false));
      this.#removals.push(() => {
        target.removeEventListener("connected", connected);
        target.removeEventListener("disconnected", disconnected);
        disconnected();
        parent.remove(target, grip);
      });
    }
  }

  /** Pointers with their rays and tips of this frame, world metres. */
  *rays(frame: XRFrame | undefined, space: XRReferenceSpace | null): Generator<VrPointer> {
    for (const { pointer } of this.#pointers.values()) {
      if (!pointer.target.visible) continue;
      this.refresh(pointer);
      if (pointer.kind === "controller") pointer.tip = pointer.ray.origin;
      else pointer.tip = jointOf(pointer, "index-finger-tip", frame, space)?.position ?? null;
      yield pointer;
    }
  }

  /** The pointer's ray as it is now. */
  refresh(pointer: VrPointer): void {
    pointer.target.updateWorldMatrix(true, false);
    pointer.ray.origin.setFromMatrixPosition(pointer.target.matrixWorld);
    pointer.ray.direction.copy(FORWARD).transformDirection(pointer.target.matrixWorld);
    const anchor = this.#anchors.get(pointer);
    if (!anchor) return;
    pointer.grip.updateWorldMatrix(true, false);
    const moved = new Vector3().setFromMatrixPosition(pointer.grip.matrixWorld).sub(anchor.grip);
    pointer.ray.origin.copy(anchor.origin);
    pointer.ray.direction.copy(anchor.at).add(moved).sub(anchor.origin).normalize();
  }

  /** A pinch that comes and goes began: what lies so far along its ray follows the hand. */
  anchor(pointer: VrPointer, distance: number): void {
    if (pointer.kind !== "transient" || !pointer.source.gripSpace) return;
    const { origin, direction } = pointer.ray;
    const grip = new Vector3().setFromMatrixPosition(pointer.grip.matrixWorld);
    const at = direction.clone().multiplyScalar(distance).add(origin);
    this.#anchors.set(pointer, { origin: origin.clone(), at, grip });
  }

  letGo(pointer: VrPointer): void {
    this.#anchors.delete(pointer);
  }

  /** Where the hands are, by pointer name. */
  grips(): Map<string, GripPose> {
    const poses = new Map<string, GripPose>();
    for (const { pointer } of this.#pointers.values()) {
      pointer.grip.updateWorldMatrix(true, false);
      const { matrixWorld } = pointer.grip;
      const pose = { position: new Vector3(), quaternion: pointer.grip.quaternion.clone() };
      matrixWorld.decompose(pose.position, pose.quaternion, new Vector3());
      poses.set(pointer.name, pose);
    }
    return poses;
  }

  /** The beam ends where it hits, or nowhere ("free"); null: it does not point. */
  showRay(pointer: VrPointer, distance: number | "free" | null): void {
    for (const entry of this.#pointers.values())
      if (entry.pointer === pointer) entry.looks.setLength(distance === "free" ? RAY_LENGTH : distance);
  }

  /** How far each ray is drawn; null: it is not. */
  report() {
    return [...this.#pointers.values()].map(({ pointer, looks }) => ({
      pointer: pointer.name,
      ray: pointer.target.visible ? looks.length : null,
    }));
  }

  dispose(): void {
    for (const remove of this.#removals) remove();
  }
}
