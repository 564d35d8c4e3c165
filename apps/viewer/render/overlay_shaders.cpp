// SPDX-License-Identifier: Apache-2.0
// Shaders of what stands in the room besides the model.
#include "viewer/render/shaders.hpp"

namespace feelem::viewer {
namespace {

/// Where the person is, for what turns to them: between the eyes, so that both see the same.
constexpr std::string_view kPerson = R"(
uniform vec3 person;
uniform vec3 up;
uniform float pixel;
// Of a picture on a screen texts are level with it; in a headset they turn to the person.
uniform vec3 screen;
)";

constexpr std::array kMarkVaryings{
    Varying{"", "vec2", "at"},  // 1 on the rim of dot or ring; of a line, x across it.
    Varying{"flat", "vec4", "tint"},
    Varying{"flat", "float", "kind"},
};

constexpr std::string_view kMarkVertex = R"(
layout(location = 0) in vec3 begin;
layout(location = 1) in vec3 end;
layout(location = 2) in vec2 corner;
layout(location = 3) in vec4 tint;
layout(location = 4) in vec2 kind_size;
vec3 across_of(vec3 direction, vec3 to_person) {
  vec3 side = cross(direction, to_person);
  float l = length(side);
  return l > 1.0e-9 ? side / l : vec3(1.0, 0.0, 0.0);
}
void place(EyeMatrices eye) {
  float kind = kind_size.x;
  vec3 at;
  float pull;
  // A pixel more than the shape, for its soft rim.
  if (kind == 2.0) {
    vec3 here = corner.y > 0.0 ? end : begin;
    vec3 to_person = person - here;
    float one = pixel * length(to_person);
    float half_width = max(0.5 * kind_size.y, 0.75 * one);
    float reach = half_width + one;
    at = here + across_of(end - begin, to_person) * corner.x * reach;
    to.at = vec2(corner.x * reach / half_width, 0.0);
    pull = 0.001;
  } else {
    vec3 to_person = person - begin;
    float distance = length(to_person);
    float one = pixel * distance;
    float radius = max(kind_size.y, (kind == 0.0 ? 2.5 : 5.0) * one);
    float reach = radius + 2.0 * one;
    vec3 facing = kind == 0.0 ? to_person / max(distance, 1.0e-9) : normalize(end);
    vec3 right = across_of(abs(dot(facing, up)) > 0.98 ? vec3(1.0, 0.0, 0.01) : up, facing);
    vec3 above = cross(facing, right);
    at = begin + reach * (corner.x * right + corner.y * above);
    to.at = corner * reach / radius;
    pull = min(1.5 * radius / max(distance, 1.0e-6), 0.5) + 0.001;
  }
  to.tint = tint;
  to.kind = kind;
  vec4 in_view = eye.view * vec4(at, 1.0);
  gl_Position = eye.projection * in_view;
  // Drawn where it is, but nearer in depth: a surface does not swallow what marks it.
  vec4 nearer = eye.projection * vec4(in_view.xyz * (1.0 - pull), 1.0);
  if (nearer.w > 0.0) gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
)";

constexpr std::string_view kMarkFragment = R"(
uniform float strength;
float within(float distance, float rim) {
  float soft = max(fwidth(distance), 1.0e-6);
  return clamp((rim - distance) / soft + 0.5, 0.0, 1.0);
}
vec4 colour_here() {
  if (from.kind == 2.0) return vec4(from.tint.rgb, strength * from.tint.a * within(abs(from.at.x), 1.0));
  float d = length(from.at);
  float whole = within(d, 1.0);
  // A dark rim, so that it is seen on light and dark alike.
  if (from.kind == 0.0) {
    float inner = within(d, 0.76);
    return vec4(mix(vec3(0.06), from.tint.rgb, inner), strength * whole);
  }
  float band = whole * (1.0 - within(d, 0.56));
  float bright = within(d, 0.92) * (1.0 - within(d, 0.66));
  return vec4(mix(vec3(0.06), from.tint.rgb, bright), strength * band);
}
)";

constexpr std::array kLabelVaryings{
    Varying{"", "vec2", "at"},
    Varying{"flat", "vec4", "tint"},
    Varying{"flat", "vec3", "plate"},  // Half size and 1; letters: 0.
};

constexpr std::string_view kLabelVertex = R"(
layout(location = 0) in vec3 anchor;
layout(location = 1) in vec2 offset;
layout(location = 2) in vec2 texel;
layout(location = 3) in vec4 tint;
layout(location = 4) in vec3 plate;
layout(location = 5) in float height;
void place(EyeMatrices eye) {
  vec3 to_person = person - anchor;
  float distance = max(length(to_person), 1.0e-6);
  vec3 facing = dot(screen, screen) > 0.0 ? screen : to_person / distance;
  vec3 upright = abs(dot(facing, up)) > 0.97 ? normalize(up + 0.2 * vec3(0.0, 0.0, -1.0)) : up;
  vec3 right = normalize(cross(upright, facing));
  vec3 above = cross(facing, right);
  // The angle stays beyond a metre. Not below eight pixels a capital.
  float unit = max(height * max(distance, 1.0), 8.0 * pixel * distance) / 9.0;
  vec3 at = anchor + unit * (offset.x * right + offset.y * above);
  to.at = texel;
  to.tint = tint;
  to.plate = plate;
  vec4 in_view = eye.view * vec4(at, 1.0);
  gl_Position = eye.projection * in_view;
  float pull = min(12.0 * unit / distance, 0.5);
  vec4 nearer = eye.projection * eye.view * vec4(anchor + to_person * pull, 1.0);
  if (nearer.w > 0.0) gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
)";

constexpr std::string_view kLabelFragment = R"(
uniform sampler2D atlas;
uniform float strength;
vec4 colour_here() {
  if (from.plate.z > 0.0) {
    // A rectangle with round corners.
    const float round_by = 3.2;
    vec2 beyond = abs(from.at) - from.plate.xy + round_by;
    float d = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - round_by;
    float soft = max(fwidth(d), 1.0e-6);
    return vec4(from.tint.rgb, strength * from.tint.a * clamp(0.5 - d / soft, 0.0, 1.0));
  }
  // Font units from the middle of the stroke.
  float d = 2.0 * (1.0 - texture(atlas, from.at).r);
  vec2 size = vec2(textureSize(atlas, 0));
  float texels = length(vec2(length(dFdx(from.at) * size), length(dFdy(from.at) * size))) * 0.7071;
  float soft = max(texels / 4.0, 1.0e-6);
  // Thin strokes stay at least a pixel and a quarter wide.
  float half_width = max(0.68, 0.62 * soft);
  return vec4(from.tint.rgb, strength * clamp((half_width - d) / soft + 0.5, 0.0, 1.0));
}
)";

constexpr std::array kPanelVaryings{Varying{"", "vec2", "at"}};

constexpr std::string_view kPanelVertex = R"(
uniform mat4 world_from_panel;
uniform vec2 size;
uniform bool top_first;
void place(EyeMatrices eye) {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  to.at = vec2(corner.x, top_first ? 1.0 - corner.y : corner.y);
  gl_Position = eye.projection * eye.view * world_from_panel * vec4((corner - 0.5) * size, 0.0, 1.0);
}
)";

constexpr std::string_view kPanelFragment = R"(
uniform sampler2D picture;
vec4 colour_here() {
  vec4 colour = texture(picture, from.at);
  if (colour.a < 0.002) discard;
  return colour;
}
)";

constexpr std::array kFloorVaryings{Varying{"", "vec2", "at"}};

constexpr std::string_view kFloorVertex = R"(
uniform float level;
void place(EyeMatrices eye) {
  vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
  to.at = 4.0 * corner;
  gl_Position = eye.projection * eye.view * vec4(to.at.x, level, to.at.y, 1.0);
}
)";

constexpr std::string_view kFloorFragment = R"(
float line_of(float along, float width) {
  float soft = max(fwidth(along), 1.0e-6);
  float off = abs(fract(along + 0.5) - 0.5) / soft;
  // Where lines are nearer than pixels they fade.
  return clamp(width * 0.5 + 0.5 - off, 0.0, 1.0) * clamp(0.5 / soft - 0.5, 0.0, 1.0);
}
vec4 colour_here() {
  vec2 cell = from.at * 2.0;
  float line = max(line_of(cell.x, 1.4), line_of(cell.y, 1.4));
  bool middle = min(abs(from.at.x), abs(from.at.y)) < 0.25 * max(fwidth(from.at.x), fwidth(from.at.y)) + 0.01;
  vec3 colour = middle ? vec3(0.267, 0.322, 0.353) : vec3(0.196, 0.239, 0.267);
  float far = 1.0 - smoothstep(2.5, 4.0, length(from.at));
  return vec4(colour, line * far);
}
)";

}  // namespace

ProgramText mark_text() {
    return {"marks", kMarkVaryings, false, false, kPerson, kMarkVertex, kMarkFragment};
}

ProgramText label_text() {
    return {"labels", kLabelVaryings, false, false, kPerson, kLabelVertex, kLabelFragment};
}

ProgramText panel_text() {
    return {"panels", kPanelVaryings, false, false, "", kPanelVertex, kPanelFragment};
}

ProgramText floor_text() {
    return {"floor", kFloorVaryings, false, false, "", kFloorVertex, kFloorFragment};
}

}  // namespace feelem::viewer
