// SPDX-License-Identifier: Apache-2.0
// Colour for stock viewers: texture coordinates, palettes, materials, variants, swatches.
#pragma once

#include "scene/scene_build.hpp"

#include <array>

namespace feelem {

inline constexpr std::size_t kMostColoured = 4;  ///< A fifth texture coordinate breaks three and Babylon.

/// The results of the presentation that get colours, those with a colour effect first.
void choose_coloured(SceneBuild& build);
/// TEXCOORD_<set> of all parts from a field.
void write_texcoords(SceneBuild& build, const SurfaceField& field, std::size_t set);

/// The value at t in 0..1 of a range: what the numbers beside the legend say.
double value_at(double t, const ValueRange& range);
/// Place of a value along the palette texture; `missing` is {0.5, 1}.
std::array<float, 2> texcoord_of(double value, const ValueRange& range);

}  // namespace feelem
