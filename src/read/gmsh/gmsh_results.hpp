// SPDX-License-Identifier: Apache-2.0
// $NodeData, $ElementData and $ElementNodeData: what they hold, and their values.
#pragma once

#include "read/gmsh/gmsh_sections.hpp"
#include "read/listed_source.hpp"

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace feelem::gmsh {

/// The rows of one section.
struct Rows {
    std::size_t first = 0, last = 0;
    std::size_t count = 0;
};
struct Listed {
    ResultInfo info;
    std::vector<Rows> rows;  ///< Partitions of a view are sections of their own.
    std::vector<std::uint32_t> places;
};
struct Contents {
    std::vector<Step> steps;
    std::vector<Listed> results;
};

/// From the heads alone. Throws Error on a damaged head.
Contents list_contents(const Input& input, const Layout& layout);

LoadedResult read_values(const Input& input, const Coding& coding, const Listed& listed, const Mesh& mesh);

}  // namespace feelem::gmsh
