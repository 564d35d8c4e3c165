// SPDX-License-Identifier: Apache-2.0
// The rows of $Elements and $Nodes in every version and coding, one at a time.
#pragma once

#include "read/gmsh/gmsh_sections.hpp"
#include "read/gmsh/gmsh_types.hpp"

#include "feelem/ids.hpp"
#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace feelem::gmsh {

struct ElementIn {
    std::int64_t id = 0;
    const TypeRow* type = nullptr;
    std::int64_t physical = 0;  ///< Version 2 alone; 4 has it on the entity.
    std::int64_t entity = 0;
    std::span<const NodeId> nodes;  ///< In Feelem's order; empty for types that are not known.
    std::size_t offset = 0;
};
using UseElement = std::function<void(const ElementIn& element)>;
using UseNode = std::function<void(NodeId id, const Point3& place)>;

/// Throw Error on damaged rows.
void each_element(const Input& input, const Coding& coding, const Section& section, const UseElement& use);
void each_node(const Input& input, const Coding& coding, const Section& section, const UseNode& use);

}  // namespace feelem::gmsh
