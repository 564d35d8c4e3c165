// SPDX-License-Identifier: Apache-2.0
// The shaders of skin and edges. Values are interpolated and then mapped, so that bands are exact inside triangles.

/** Which parts this pass draws, and where a vertex stands now. */
const PART_AND_SHAPE = /* glsl */ `
attribute float owner;
attribute vec3 displacement;
attribute vec3 displacementIm;
uniform float factor;
uniform float factorIm;
uniform sampler2D parts;
uniform vec2 partsSize;
uniform int pass;
vec4 partState() {
  vec2 at = vec2(mod(owner, partsSize.x), floor(owner / partsSize.x));
  return texture2D(parts, (at + 0.5) / partsSize);
}
bool drawnHere(vec4 state) {
  if (pass == 0) return state.r > 0.75;
  if (pass == 1) return state.r > 0.25 && state.r < 0.75;
  return state.r > 0.25;
}
vec3 movedTo() { return position + displacement * factor + displacementIm * factorIm; }
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
`;

/** Planes that cut the model: what lies on the positive side of one is gone. In model units. */
const CUT = /* glsl */ `
#ifdef CUT
uniform vec4 planes[3];
uniform int planeCount;
uniform int ownPlane;
bool cutAway(vec3 at) {
  for (int i = 0; i < 3; ++i) if (i < planeCount && i != ownPlane && dot(planes[i].xyz, at) > planes[i].w) return true;
  return false;
}
#endif
`;

/** Of both stages: where a value stands in the range. */
const RANGE = /* glsl */ `
uniform float lo;
uniform float hi;
uniform float magnitude;
uniform int scaleKind;
const float SLACK = 3.0e-5;
float symmetricLog(float v) {
  return sign(v) * log2(1.0 + abs(v) / (1.0e-3 * magnitude));
}
float placeOf(float v) {
  if (!(hi > lo)) return v < lo ? -1.0 : v > hi ? 2.0 : 0.5;
  if (scaleKind == 1) return v <= 0.0 ? -1.0 : (log2(v) - log2(lo)) / (log2(hi) - log2(lo));
  if (scaleKind == 2) return (v + magnitude) / (2.0 * magnitude);
  if (scaleKind == 3) return (symmetricLog(v) - symmetricLog(lo)) / (symmetricLog(hi) - symmetricLog(lo));
  return (v - lo) / (hi - lo);
}
`;

// Taken at the middle of what is covered, so that at a silhouette no value comes from beyond the triangle; vRunning at the
// middle of the pixel, wherever that is, because lines need its slope. vAbove and vBelow are more than 0 where a corner is
// beyond the range: between corners within it no rounding of what is tiny on the screen may say so.
const SKIN_VARYINGS = /* glsl */ `
centroid varying float vValue;
varying float vRunning;
centroid varying float vAbove;
centroid varying float vBelow;
centroid varying float vMissing;
centroid varying float vHatch;
varying vec3 vNormal;
varying vec3 vToEye;
varying vec3 vPlace;
varying float vSolid;
`;

export const FIELD_VERTEX = /* glsl */ `
${PART_AND_SHAPE}
${RANGE}
${SKIN_VARYINGS}
attribute float value;
attribute float missing;
uniform float hatchScale;
#ifdef CUT
varying vec3 vEye;
#endif
void main() {
  vec4 state = partState();
  vec3 moved = movedTo();
  vec4 inView = modelViewMatrix * vec4(moved, 1.0);
  vValue = value;
  vRunning = value;
  float at = placeOf(value);
  vAbove = at > 1.0 + SLACK ? 1.0 : 0.0;
  vBelow = at < -SLACK ? 1.0 : 0.0;
  vMissing = missing;
  vHatch = dot(position, vec3(1.0, 1.0, 1.0)) * hatchScale;
  vNormal = normalMatrix * normal;
  vToEye = -inView.xyz;
  vPlace = moved;
  vSolid = state.g;
#ifdef CUT
  vEye = (inverse(modelViewMatrix) * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
#endif
  gl_Position = drawnHere(state) ? projectionMatrix * inView : NOWHERE;
}`;

// Colours leave as the sRGB bytes of the palette: no lighting, no tone mapping, no conversion in between.
const COLOUR = /* glsl */ `
uniform sampler2D palette;
uniform float paletteSize;
uniform vec3 aboveColour;
uniform vec3 belowColour;
vec3 mapped(float t) {
  if (t < -SLACK && vBelow > 0.0) return belowColour;
  if (t > 1.0 + SLACK && vAbove > 0.0) return aboveColour;
  float texel = min(floor(clamp(t, 0.0, 1.0) * paletteSize), paletteSize - 1.0);
  return texture2D(palette, vec2((texel + 0.5) / paletteSize, 0.5)).rgb;
}
`;

/** The stripes of cut material, which lie in its plane: the skin knows nothing of the values inside. */
const HATCH = /* glsl */ `
uniform float capHatch;
vec3 hatched(vec3 at) {
  float across = dot(at, vec3(0.62, 0.71, 0.53)) * capHatch;
  float stripe = fract(across);
  float soft = fwidth(across);
  // Too fine to be seen as stripes: their mean.
  float dark = soft > 0.7 ? 0.18 : 1.0 - smoothstep(0.18 - soft, 0.18 + soft, min(stripe, 1.0 - stripe) * 2.0);
  return mix(vec3(0.66, 0.68, 0.69), vec3(0.46, 0.48, 0.49), dark);
}
`;

// Where the nearest that is left of a solid is seen from behind, the eye looks into the material.
const MATERIAL = /* glsl */ `
#ifdef CUT
${HATCH}
varying vec3 vEye;
vec4 capColour() {
  vec3 along = vPlace - vEye;
  float enters = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (i >= planeCount) break;
    float down = dot(planes[i].xyz, along);
    if (down < 0.0) enters = max(enters, (planes[i].w - dot(planes[i].xyz, vEye)) / down);
  }
  return vec4(hatched(vEye + along * clamp(enters, 0.0, 1.0)), 1.0);
}
#endif
`;

export const FIELD_FRAGMENT = /* glsl */ `
precision highp float;
${CUT}
${RANGE}
${SKIN_VARYINGS}
${COLOUR}
uniform bool coloured;
uniform vec3 plainColour;
uniform vec3 missingColour;
uniform bool missingHatch;
uniform float shadeFloor;
uniform float opacity;
uniform bool isolines;
uniform float limit;
uniform float limitSign;
${MATERIAL}
/** 1 on a line where the quantity passes a whole number, about \`width\` pixels wide. */
float lineAt(float quantity, float slope, float width) {
  if (!(slope > 0.0) || slope > 0.5) return 0.0;
  float off = abs(fract(quantity + 0.5) - 0.5) / slope;
  return 1.0 - smoothstep(width * 0.5 - 0.5, width * 0.5 + 0.5, off);
}
void main() {
  // Derivatives are asked for before the ways part.
  float t = placeOf(vValue);
  float bands = placeOf(vRunning) * paletteSize;
  float bandSlope = fwidth(bands);
  float slope = fwidth(vRunning);
#ifdef CUT
  vec4 cap = capColour();
  if (cutAway(vPlace)) discard;
  if (!gl_FrontFacing && vSolid > 0.5 && ownPlane == -1) {
    gl_FragColor = cap;
    return;
  }
#endif
  vec3 colour = plainColour;
  if (coloured) {
    if (vMissing > 1.0e-6) {
      colour = missingColour * (missingHatch && fract(vHatch) < 0.25 ? 0.72 : 1.0);
    } else {
      colour = mapped(t);
      if (isolines && t > 0.0 && t < 1.0 && paletteSize < 100.0)
        colour = mix(colour, vec3(0.08), 0.8 * lineAt(bands, bandSlope, 1.2));
      if (limitSign != 0.0) {
        float off = slope > 0.0 ? abs(vRunning - limit) / slope : 1.0e9;
        colour = mix(colour, vec3(1.0), 1.0 - smoothstep(2.4, 3.2, off));
        colour = mix(colour, vec3(0.0), 1.0 - smoothstep(1.0, 1.8, off));
      }
    }
  }
  float facing = abs(dot(normalize(vNormal), normalize(vToEye)));
  float floorHere = coloured ? shadeFloor : 0.55;
  // In linear light, as a lamp at the eye would do it.
  float shade = floorHere + (1.0 - floorHere) * facing;
  gl_FragColor = vec4(colour * pow(shade, 1.0 / 2.2), opacity);
}`;

export const EDGE_VERTEX = /* glsl */ `
${PART_AND_SHAPE}
varying vec3 vPlace;
void main() {
  vec3 moved = movedTo();
  vPlace = moved;
  gl_Position = drawnHere(partState()) ? projectionMatrix * modelViewMatrix * vec4(moved, 1.0) : NOWHERE;
}`;

export const EDGE_FRAGMENT = /* glsl */ `
precision highp float;
${CUT}
uniform vec3 colour;
uniform float opacity;
varying vec3 vPlace;
void main() {
#ifdef CUT
  if (cutAway(vPlace)) discard;
#endif
  gl_FragColor = vec4(colour, opacity);
}`;

/** Counts solids that a line of sight is in, by their skin: one plane alone, whatever the others take away. */
export const COUNT_VERTEX = /* glsl */ `
${PART_AND_SHAPE}
varying vec3 vPlace;
void main() {
  vec4 state = partState();
  vec3 moved = movedTo();
  vPlace = moved;
  bool counts = state.g > 0.5 && drawnHere(state);
  gl_Position = counts ? projectionMatrix * modelViewMatrix * vec4(moved, 1.0) : NOWHERE;
}`;

export const COUNT_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec4 planes[3];
uniform int ownPlane;
varying vec3 vPlace;
void main() {
  if (dot(planes[ownPlane].xyz, vPlace) > planes[ownPlane].w) discard;
  gl_FragColor = vec4(0.0);
}`;

/** The plane of a cut. */
export const CAP_VERTEX = /* glsl */ `
uniform vec3 middle;
uniform vec3 right;
uniform vec3 up;
uniform bool hasStencil;
varying vec3 vPlace;
void main() {
  vPlace = middle + position.x * right + position.y * up;
  gl_Position = hasStencil ? projectionMatrix * modelViewMatrix * vec4(vPlace, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}`;

export const CAP_FRAGMENT = /* glsl */ `
precision highp float;
${CUT}
${HATCH}
varying vec3 vPlace;
void main() {
  vec3 colour = hatched(vPlace);
  if (cutAway(vPlace)) discard;
  gl_FragColor = vec4(colour, 1.0);
}`;
