// SPDX-License-Identifier: Apache-2.0
// Elements of one mesh put into another: for domains that are merged and sectors that are repeated.
#pragma once

#include "model/mesh_builder.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace feelem::rst {

/// What becomes of nodes and element ids.
struct CopyRules {
    std::function<NodeId(NodeIndex)> node;
    std::function<bool(ElementId)> wanted;
    std::int64_t id_offset = 0;
};
void copy_elements(const Mesh& from, const CopyRules& rules, MeshBuilder& to);

}  // namespace feelem::rst
