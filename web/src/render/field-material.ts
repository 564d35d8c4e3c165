// SPDX-License-Identifier: Apache-2.0
// Material of the skin: the value is interpolated and then mapped, so that bands are exact inside triangles.
import {
  Color,
  DataTexture,
  DoubleSide,
  NearestFilter,
  NoColorSpace,
  RGBAFormat,
  ShaderMaterial,
  UnsignedByteType,
  Vector3,
} from "three";
import type { ColourEffect, Rgb, ValueRange } from "../present";
import { makePalette, type Palette } from "./palette";

const VERTEX = /* glsl */ `
attribute float value;
attribute float missing;
attribute vec3 displacement;
uniform float factor;
uniform float hatchScale;
varying float vValue;
varying float vMissing;
varying float vHatch;
varying vec3 vNormal;
varying vec3 vToEye;
void main() {
  vec3 moved = position + displacement * factor;
  vec4 inView = modelViewMatrix * vec4(moved, 1.0);
  vValue = value;
  vMissing = missing;
  vHatch = dot(position, vec3(1.0, 1.0, 1.0)) * hatchScale;
  vNormal = normalMatrix * normal;
  vToEye = -inView.xyz;
  gl_Position = projectionMatrix * inView;
}`;

// Colours leave as the sRGB bytes of the palette: no lighting, no tone mapping, no conversion in between.
const FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D palette;
uniform float paletteSize;
uniform float lo;
uniform float hi;
uniform float magnitude;
uniform int scaleKind;
uniform bool coloured;
uniform vec3 plainColour;
uniform vec3 aboveColour;
uniform vec3 belowColour;
uniform vec3 missingColour;
uniform float shadeFloor;
varying float vValue;
varying float vMissing;
varying float vHatch;
varying vec3 vNormal;
varying vec3 vToEye;
const float SLACK = 3.0e-5;
float symmetricLog(float v) {
  return sign(v) * log2(1.0 + abs(v) / (1.0e-3 * magnitude));
}
float place(float v) {
  if (scaleKind == 1) return (log2(v) - log2(lo)) / (log2(hi) - log2(lo));
  if (scaleKind == 2) return (v + magnitude) / (2.0 * magnitude);
  if (scaleKind == 3) return (symmetricLog(v) - symmetricLog(lo)) / (symmetricLog(hi) - symmetricLog(lo));
  return (v - lo) / (hi - lo);
}
vec3 mapped(float v) {
  if (!(hi > lo)) return v < lo ? belowColour : v > hi ? aboveColour : texture2D(palette, vec2(0.5, 0.5)).rgb;
  float t = scaleKind == 1 && v <= 0.0 ? -1.0 : place(v);
  if (t < -SLACK) return belowColour;
  if (t > 1.0 + SLACK) return aboveColour;
  float texel = min(floor(clamp(t, 0.0, 1.0) * paletteSize), paletteSize - 1.0);
  return texture2D(palette, vec2((texel + 0.5) / paletteSize, 0.5)).rgb;
}
void main() {
  vec3 colour = plainColour;
  if (coloured) {
    if (vMissing > 1.0e-6) {
      colour = missingColour * (fract(vHatch) < 0.25 ? 0.72 : 1.0);
    } else {
      colour = mapped(vValue);
    }
  }
  float facing = abs(dot(normalize(vNormal), normalize(vToEye)));
  float floorHere = coloured ? shadeFloor : 0.55;
  // In linear light, as a lamp at the eye would do it.
  float shade = floorHere + (1.0 - floorHere) * facing;
  gl_FragColor = vec4(colour * pow(shade, 1.0 / 2.2), 1.0);
}`;

function vectorOf(colour: Rgb): Vector3 {
  return new Vector3(colour[0] / 255, colour[1] / 255, colour[2] / 255);
}

const SCALES: Record<ValueRange["scale"], number> = { linear: 0, log: 1, signed: 2, symlog: 3 };

/** One material serves all parts; its uniforms are the state of colour and deformation. */
export class FieldMaterial extends ShaderMaterial {
  #palette: Palette | null = null;

  constructor() {
    super({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
      uniforms: {
        factor: { value: 0 },
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
        shadeFloor: { value: 1 },
      },
    });
  }

  #set(name: string, value: unknown): void {
    const uniform = this.uniforms[name];
    if (uniform) uniform.value = value;
  }

  get palette(): Palette | null {
    return this.#palette;
  }

  /** No effect: plain, shaded. */
  setColour(effect: ColourEffect | null, range: ValueRange | null): void {
    this.#set("coloured", effect !== null && range !== null);
    if (!effect || !range) return;
    this.#palette = makePalette(effect);
    const texture = new DataTexture(
      this.#palette.texels,
      this.#palette.count,
      1,
      RGBAFormat,
      UnsignedByteType,
    );
    texture.magFilter = NearestFilter;
    texture.minFilter = NearestFilter;
    texture.colorSpace = NoColorSpace;
    texture.needsUpdate = true;
    (this.uniforms.palette?.value as DataTexture | null)?.dispose();
    this.#set("palette", texture);
    this.#set("paletteSize", this.#palette.count);
    const magnitude = Math.max(Math.abs(range.lo), Math.abs(range.hi));
    // A logarithm over a range that reaches zero is the symmetric one, as in present.
    const scale = range.scale === "log" && !(range.lo > 0) ? "symlog" : range.scale;
    this.#set("lo", scale === "signed" ? -magnitude : range.lo);
    this.#set("hi", scale === "signed" ? magnitude : range.hi);
    this.#set("magnitude", magnitude || 1);
    this.#set("scaleKind", magnitude === 0 ? 0 : SCALES[scale]);
    this.#set("aboveColour", vectorOf(effect.above));
    this.#set("belowColour", vectorOf(effect.below));
    this.#set("missingColour", vectorOf(effect.missing));
  }

  setFactor(factor: number): void {
    this.#set("factor", factor);
  }

  /** 1: true colours; less: a lamp at the eye darkens what turns away, down to this share. */
  setShadeFloor(floor: number): void {
    this.#set("shadeFloor", floor);
  }

  /** Stripes of the missing colour stand this far apart, model units. */
  setHatchSpacing(length: number): void {
    this.#set("hatchScale", length > 0 ? 1 / length : 1);
  }

  override dispose(): void {
    (this.uniforms.palette?.value as DataTexture | null)?.dispose();
    super.dispose();
  }
}

const EDGE_VERTEX = /* glsl */ `
attribute vec3 displacement;
uniform float factor;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + displacement * factor, 1.0);
}`;

const EDGE_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 colour;
uniform float opacity;
void main() { gl_FragColor = vec4(colour, opacity); }`;

/** Element edges: they follow the deformation and fade when elements become smaller than a few pixels. */
export class EdgeMaterial extends ShaderMaterial {
  constructor() {
    super({
      vertexShader: EDGE_VERTEX,
      fragmentShader: EDGE_FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: {
        factor: { value: 0 },
        opacity: { value: 0.5 },
        colour: { value: new Color(0x0b0d10) },
      },
    });
  }

  setFactor(factor: number): void {
    if (this.uniforms.factor) this.uniforms.factor.value = factor;
  }

  setOpacity(opacity: number): void {
    if (this.uniforms.opacity) this.uniforms.opacity.value = opacity;
    this.visible = opacity > 0.02;
  }
}
