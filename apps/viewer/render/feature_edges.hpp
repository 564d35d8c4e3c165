// SPDX-License-Identifier: Apache-2.0
// The lines that show a shape: edges where the skin ends or bends sharply. No OpenGL.
#pragma once

#include "viewer/scene/loaded_scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace feelem::viewer {

/// Pairs of vertices of one part: edges of one triangle, and those where two meet at more than 30 degrees.
/// Vertices of the same node are one; those without node are made up, and so are the edges to them.
std::vector<std::array<std::uint32_t, 2>> feature_edges(const Geometry& geometry, const PartRange& part);

/// Median length of the element edges, model units; 0 without edges.
float typical_edge(const Geometry& geometry);

}  // namespace feelem::viewer
