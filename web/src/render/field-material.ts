// SPDX-License-Identifier: Apache-2.0
// Materials of skin and edges. They share one set of uniforms: colour, shape, parts and cuts are set once for all.
import {
  Color,
  DataTexture,
  DoubleSide,
  type IUniform,
  NearestFilter,
  NoColorSpace,
  RGBAFormat,
  ShaderMaterial,
  UnsignedByteType,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import type { ColourEffect, Rgb, ValueRange } from "../present";
import { makePalette, type Palette } from "./palette";
import type { PartTable } from "./part-table";
import { EDGE_FRAGMENT, EDGE_VERTEX, FIELD_FRAGMENT, FIELD_VERTEX } from "./shaders";

/** A plane in model units: what lies on the side its normal points to is cut away. */
export interface CutPlane {
  readonly normal: readonly [number, number, number];
  readonly offset: number;
}
export const MAX_CUTS = 3;

/** Which parts a pass draws: those that are shown, the clear ones, or both. */
const PASS = { shown: 0, clear: 1, both: 2 } as const;
const SCALES: Record<ValueRange["scale"], number> = { linear: 0, log: 1, signed: 2, symlog: 3 };

function vectorOf(colour: Rgb): Vector3 {
  return new Vector3(colour[0] / 255, colour[1] / 255, colour[2] / 255);
}

export type Uniforms = Record<string, IUniform>;

export function sharedUniforms(parts: PartTable): Uniforms {
  return {
    factor: { value: 0 },
    factorIm: { value: 0 },
    parts: { value: parts.texture },
    partsSize: { value: new Vector2(parts.width, parts.height) },
    planes: { value: Array.from({ length: MAX_CUTS }, () => new Vector4()) },
    planeCount: { value: 0 },
    capHatch: { value: 1 },
    hatchScale: { value: 1 },
    palette: { value: null },
    paletteSize: { value: 1 },
    lo: { value: 0 },
    hi: { value: 1 },
    magnitude: { value: 1 },
    scaleKind: { value: 0 },
    coloured: { value: false },
    plainColour: { value: new Vector3(0.72, 0.75, 0.78) },
    aboveColour: { value: new Vector3(1, 0, 1) },
    belowColour: { value: new Vector3(1, 1, 0) },
    missingColour: { value: new Vector3(0.5, 0.5, 0.5) },
    missingHatch: { value: true },
    shadeFloor: { value: 1 },
    isolines: { value: false },
    limit: { value: 0 },
    limitSign: { value: 0 },
  };
}

function set(uniforms: Uniforms, name: string, value: unknown): void {
  const uniform = uniforms[name];
  if (uniform) uniform.value = value;
}

/** Colour, range and palette into the uniforms; null: plain. Gives the palette in force. */
export function setColourUniforms(
  uniforms: Uniforms,
  effect: ColourEffect | null,
  range: ValueRange | null,
): Palette | null {
  set(uniforms, "coloured", effect !== null && range !== null);
  if (!effect || !range) return null;
  const palette = makePalette(effect);
  const texture = new DataTexture(palette.texels, palette.count, 1, RGBAFormat, UnsignedByteType);
  texture.magFilter = NearestFilter;
  texture.minFilter = NearestFilter;
  texture.colorSpace = NoColorSpace;
  texture.needsUpdate = true;
  (uniforms.palette?.value as DataTexture | null)?.dispose();
  set(uniforms, "palette", texture);
  set(uniforms, "paletteSize", palette.count);
  const magnitude = Math.max(Math.abs(range.lo), Math.abs(range.hi));
  // A logarithm over a range that reaches zero is the symmetric one, as in present.
  const scale = range.scale === "log" && !(range.lo > 0) ? "symlog" : range.scale;
  set(uniforms, "lo", scale === "signed" ? -magnitude : range.lo);
  set(uniforms, "hi", scale === "signed" ? magnitude : range.hi);
  set(uniforms, "magnitude", magnitude || 1);
  set(uniforms, "scaleKind", magnitude === 0 ? 0 : SCALES[scale]);
  set(uniforms, "aboveColour", vectorOf(effect.above));
  set(uniforms, "belowColour", vectorOf(effect.below));
  set(uniforms, "missingColour", vectorOf(effect.missing));
  return palette;
}

export function setCutUniforms(uniforms: Uniforms, planes: readonly CutPlane[]): void {
  const list = uniforms.planes?.value as Vector4[];
  for (const [i, vector] of list.entries()) {
    const plane = planes[i];
    if (plane) vector.set(...plane.normal, plane.offset);
  }
  set(uniforms, "planeCount", Math.min(planes.length, MAX_CUTS));
}

export { set as setUniform };

/** What cuts it not: no plane of its own (the skin), or none and both its sides are seen (a surface inside). */
export const OWN_PLANE = { skin: -1, surface: -2 } as const;

/** One of the skin's two passes, what is shown or what is clear; or what lies in both. */
export class FieldMaterial extends ShaderMaterial {
  constructor(uniforms: Uniforms, pass: keyof typeof PASS) {
    const clear = pass === "clear";
    super({
      vertexShader: FIELD_VERTEX,
      fragmentShader: FIELD_FRAGMENT,
      side: DoubleSide,
      transparent: clear,
      depthWrite: !clear,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.uniforms = {
      ...uniforms,
      pass: { value: PASS[pass] },
      ownPlane: { value: OWN_PLANE.skin },
      opacity: { value: clear ? 0.22 : 1 },
    };
  }

  setCut(on: boolean): void {
    if (on === "CUT" in this.defines) return;
    if (on) this.defines.CUT = "";
    else delete this.defines.CUT;
    this.needsUpdate = true;
  }
}

/** Element edges and the ghost's: they follow the deformation, or stay where the model was. */
export class EdgeMaterial extends ShaderMaterial {
  constructor(uniforms: Uniforms, colour: number, still = false) {
    super({ vertexShader: EDGE_VERTEX, fragmentShader: EDGE_FRAGMENT, transparent: true, depthWrite: false });
    this.uniforms = {
      ...uniforms,
      ...(still ? { factor: { value: 0 }, factorIm: { value: 0 } } : {}),
      pass: { value: PASS.both },
      ownPlane: { value: OWN_PLANE.skin },
      colour: { value: new Color(colour) },
      opacity: { value: 0.5 },
    };
  }

  setOpacity(opacity: number): void {
    if (this.uniforms.opacity) this.uniforms.opacity.value = opacity;
    this.visible = opacity > 0.02;
  }

  setCut(on: boolean): void {
    if (on === "CUT" in this.defines) return;
    if (on) this.defines.CUT = "";
    else delete this.defines.CUT;
    this.needsUpdate = true;
  }
}
