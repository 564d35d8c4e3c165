// SPDX-License-Identifier: Apache-2.0
// Programs for both eyes, put together from the shaders of one eye. Each shader is written once; how the eyes
// are told apart is added here.
#pragma once

#include "viewer/render/gl_objects.hpp"
#include "viewer/render/renderer.hpp"

#include <glm/mat4x4.hpp>

#include <array>
#include <span>
#include <string_view>

namespace feelem::viewer {

/// What goes from the vertex to the fragment: written as `to.name`, read as `from.name`.
struct Varying {
    std::string_view qualifier;  ///< "", "flat", "centroid"
    std::string_view type, name;
};

struct ProgramText {
    std::string_view name;
    std::span<const Varying> varyings;
    bool is_lines = false;
    bool is_clipped = false;    ///< Writes gl_ClipDistance[0..2].
    std::string_view shared;    ///< Of both stages: uniforms, functions.
    std::string_view vertex;    ///< Declarations, and `void place(EyeMatrices eye)`.
    std::string_view fragment;  ///< Declarations, and `vec4 colour_here()`.
};
Program make_program(const ProgramText& text, StereoPath path);

/// std140 of `EyeMatrices eyes[2]` at kEyesBinding.
struct EyeMatrices {
    glm::mat4 view{1}, projection{1};
    glm::mat4 model{1};   ///< Model units -> eye's metres.
    glm::mat4 normal{1};  ///< Of `model`, for directions.
    glm::vec4 eye_in_model{0};
};
using BothEyes = std::array<EyeMatrices, 2>;
inline constexpr GLuint kEyesBinding = 0;

/// The path that this context can go.
StereoPath best_stereo();

}  // namespace feelem::viewer
