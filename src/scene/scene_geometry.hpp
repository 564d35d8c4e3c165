// SPDX-License-Identifier: Apache-2.0
// Parts of the scene: positions, normals, node and element ids, triangles and element edges.
#pragma once

#include "scene/scene_build.hpp"

#include "feelem/diagnostics.hpp"

namespace feelem {

/// Box, origin, and the list of parts that have something to draw.
void plan_parts(SceneBuild& build, Diagnostics& diagnostics);
void write_geometry(SceneBuild& build);
/// Nodes of the tree: "model" with the matrix to metres, then what stands beside it. The children of a node
/// in `beside` are meshes and get nodes of their own.
void write_tree(SceneBuild& build, const std::vector<gltf::Node>& beside);

/// Column-major: model units and axes -> metres, +Y up.
std::array<double, 16> model_matrix(char up, double metres);
/// Metres of one model unit: declared, or such that the largest side is 0.8 m.
double scale_to_metres(const SceneBuild& build);
/// A point of the model in the scene's metres.
Point3 to_metres(const SceneBuild& build, const Point3& point);

}  // namespace feelem
