// SPDX-License-Identifier: Apache-2.0
// Materials, variants, the legend's quad and the swatches: what stock viewers show.
#pragma once

#include "scene/scene_build.hpp"

namespace feelem {

/// After the arrays and before the tree: gives parts and edges their materials and adds legend and swatches.
/// Returns the nodes that stand beside the model.
std::vector<gltf::Node> write_materials(SceneBuild& build);

}  // namespace feelem
