// SPDX-License-Identifier: Apache-2.0
// Values are interpolated and then mapped, so that bands are exact inside triangles.
#include "viewer/render/shaders.hpp"

namespace feelem::viewer {
namespace {

constexpr std::array kSkinVaryings{
    // At the middle of what is covered: at a silhouette no value is taken from beyond the triangle.
    Varying{"centroid", "float", "value"},
    // At the middle of the pixel, wherever that is: lines need its slope.
    Varying{"", "float", "running"},
    // More than 0 where a corner is beyond the range: between corners within it no rounding of what is tiny
    // on the
    // screen may say so.
    Varying{"centroid", "float", "above"},
    Varying{"centroid", "float", "below"},
    Varying{"centroid", "float", "missing"},
    Varying{"centroid", "float", "hatch"},
    Varying{"", "vec3", "normal"},
    Varying{"", "vec3", "to_eye"},
    Varying{"", "vec3", "place"},
    Varying{"flat", "float", "solid"},
};

constexpr std::string_view kCuts = R"(
uniform vec4 planes[3];
uniform int plane_count;
)";

// The stripes of cut material, which lie in its plane: the skin knows nothing of the values inside.
constexpr std::string_view kHatch = R"(
uniform float cap_hatch;
vec3 hatched(vec3 at) {
  float across = dot(at, vec3(0.62, 0.71, 0.53)) * cap_hatch;
  float stripe = fract(across);
  float soft = fwidth(across);
  // Too fine to be seen as stripes: their mean.
  float dark = soft > 0.7 ? 0.18 : 1.0 - smoothstep(0.18 - soft, 0.18 + soft, min(stripe, 1.0 - stripe) * 2.0);
  return mix(vec3(0.66, 0.68, 0.69), vec3(0.46, 0.48, 0.49), dark);
}
)";

/// Of both stages: planes, and where a value stands in the range.
constexpr std::string_view kSkinShared = R"(
uniform vec4 planes[3];
uniform int plane_count;
uniform float lo;
uniform float hi;
uniform float magnitude;
uniform int scale_kind;
const float SLACK = 3.0e-5;
float symmetric_log(float v) { return sign(v) * log2(1.0 + abs(v) / (1.0e-3 * magnitude)); }
float place_of(float v) {
  if (!(hi > lo)) return v < lo ? -1.0 : v > hi ? 2.0 : 0.5;
  if (scale_kind == 1) return v <= 0.0 ? -1.0 : (log2(v) - log2(lo)) / (log2(hi) - log2(lo));
  if (scale_kind == 2) return (v + magnitude) / (2.0 * magnitude);
  if (scale_kind == 3) return (symmetric_log(v) - symmetric_log(lo)) / (symmetric_log(hi) - symmetric_log(lo));
  return (v - lo) / (hi - lo);
}
)";

constexpr std::string_view kSkinVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
layout(location = 3) in float missing;
layout(location = 4) in vec3 displacement;
layout(location = 5) in vec3 displacement_im;
layout(location = 6) in vec4 part_low;
layout(location = 7) in vec4 part_size;
uniform float factor;
uniform float factor_im;
uniform float hatch_scale;
void place(EyeMatrices eye) {
  vec3 rest = part_low.xyz + position * part_size.xyz;
  vec3 moved = rest + displacement * factor + displacement_im * factor_im;
  vec4 in_view = eye.model * vec4(moved, 1.0);
  to.value = value;
  to.running = value;
  float at = place_of(value);
  to.above = at > 1.0 + SLACK ? 1.0 : 0.0;
  to.below = at < -SLACK ? 1.0 : 0.0;
  to.missing = missing;
  to.hatch = dot(rest, vec3(1.0)) * hatch_scale;
  to.normal = mat3(eye.normal) * normal;
  to.to_eye = -in_view.xyz;
  to.place = moved;
  to.solid = part_low.w;
  for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = planes[i].w - dot(planes[i].xyz, moved);
  gl_Position = eye.projection * in_view;
}
)";

// Colours leave as the sRGB bytes of the palette: no lighting, no tone mapping, no conversion in between.
// Where the nearest that is left of a solid is seen from behind, the eye looks into the material.
constexpr std::string_view kSkinFragment = R"(
uniform sampler2D palette;
uniform float palette_size;
uniform vec3 above_colour;
uniform vec3 below_colour;
uniform vec3 missing_colour;
uniform vec3 plain_colour;
uniform bool coloured;
uniform float shade_floor;
uniform float opacity;
uniform bool isolines;
uniform float limit;
uniform bool has_limit;
vec3 mapped(float t) {
  if (t < -SLACK && from.below > 0.0) return below_colour;
  if (t > 1.0 + SLACK && from.above > 0.0) return above_colour;
  float texel = min(floor(clamp(t, 0.0, 1.0) * palette_size), palette_size - 1.0);
  return texelFetch(palette, ivec2(int(texel), 0), 0).rgb;
}
vec3 cap_colour() {
  vec3 eye = eyes[from.eye].eye_in_model.xyz;
  vec3 along = from.place - eye;
  float enters = 0.0;
  for (int i = 0; i < plane_count; ++i) {
    float down = dot(planes[i].xyz, along);
    if (down < 0.0) enters = max(enters, (planes[i].w - dot(planes[i].xyz, eye)) / down);
  }
  vec3 at = eye + along * clamp(enters, 0.0, 1.0);
  return hatched(at);
}
// 1 on a line where the quantity passes a whole number, about `width` pixels wide.
float line_at(float quantity, float slope, float width) {
  if (!(slope > 0.0) || slope > 0.5) return 0.0;
  float off = abs(fract(quantity + 0.5) - 0.5) / slope;
  return 1.0 - smoothstep(width * 0.5 - 0.5, width * 0.5 + 0.5, off);
}
vec4 colour_here() {
  // Derivatives are asked for before the ways part.
  float t = place_of(from.value);
  float bands = place_of(from.running) * palette_size;
  float band_slope = fwidth(bands);
  float slope = fwidth(from.running);
  vec3 cap = cap_colour();
  if (plane_count > 0 && !gl_FrontFacing && from.solid > 0.5) return vec4(cap, 1.0);
  vec3 colour = plain_colour;
  if (coloured) {
    if (from.missing > 1.0e-6) {
      colour = missing_colour * (fract(from.hatch) < 0.25 ? 0.72 : 1.0);
    } else {
      colour = mapped(t);
      if (isolines && t > 0.0 && t < 1.0 && palette_size < 100.0)
        colour = mix(colour, vec3(0.08), 0.8 * line_at(bands, band_slope, 1.2));
      if (has_limit) {
        float off = slope > 0.0 ? abs(from.running - limit) / slope : 1.0e9;
        colour = mix(colour, vec3(1.0), 1.0 - smoothstep(2.4, 3.2, off));
        colour = mix(colour, vec3(0.0), 1.0 - smoothstep(1.0, 1.8, off));
      }
    }
  }
  float facing = abs(dot(normalize(from.normal), normalize(from.to_eye)));
  float floor_here = coloured ? shade_floor : 0.55;
  // In linear light, as a lamp at the eye would do it.
  float shade = floor_here + (1.0 - floor_here) * facing;
  return vec4(colour * pow(shade, 1.0 / 2.2), opacity);
}
)";

// A little nearer to the eye than they are, so that the skin does not swallow them.
constexpr std::string_view kEdgeVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 8) in uint vertex;
uniform samplerBuffer moves;
uniform samplerBuffer moves_im;
uniform float factor;
uniform float factor_im;
vec3 move_of(samplerBuffer all, float by) {
  if (by == 0.0) return vec3(0.0);
  int first = 3 * int(vertex);
  return by * vec3(texelFetch(all, first).r, texelFetch(all, first + 1).r, texelFetch(all, first + 2).r);
}
void place(EyeMatrices eye) {
  vec3 moved = position + move_of(moves, factor) + move_of(moves_im, factor_im);
  vec4 in_view = eye.model * vec4(moved, 1.0);
  for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = planes[i].w - dot(planes[i].xyz, moved);
  gl_Position = eye.projection * vec4(in_view.xyz * 0.9992, 1.0);
}
)";

constexpr std::string_view kEdgeFragment = R"(
uniform vec4 line_colour;
vec4 colour_here() { return line_colour; }
)";

constexpr std::array kCapVaryings{Varying{"", "vec3", "place"}};

// The plane of a cut, as far as the model reaches.
constexpr std::string_view kCapVertex = R"(
uniform vec3 cap_middle;
uniform vec3 cap_right;
uniform vec3 cap_up;
void place(EyeMatrices eye) {
  vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
  to.place = cap_middle + corner.x * cap_right + corner.y * cap_up;
  for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = planes[i].w - dot(planes[i].xyz, to.place);
  gl_Position = eye.projection * eye.model * vec4(to.place, 1.0);
}
)";

constexpr std::string_view kCapFragment = R"(
vec4 colour_here() { return vec4(hatched(from.place), 1.0); }
)";

// Derivatives are known in fragments alone.
const std::string& skin_fragment() {
    static const std::string text = std::string(kHatch) + std::string(kSkinFragment);
    return text;
}
const std::string& cap_fragment() {
    static const std::string text = std::string(kHatch) + std::string(kCapFragment);
    return text;
}

}  // namespace

ProgramText skin_text() {
    return {"skin", kSkinVaryings, false, true, kSkinShared, kSkinVertex, skin_fragment()};
}

ProgramText cap_text() {
    return {"caps", kCapVaryings, false, true, kCuts, kCapVertex, cap_fragment()};
}

ProgramText edge_text() {
    return {"edges", {}, true, true, kCuts, kEdgeVertex, kEdgeFragment};
}

}  // namespace feelem::viewer
