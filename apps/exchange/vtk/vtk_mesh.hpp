// SPDX-License-Identifier: Apache-2.0
// The leaves of a data set as one mesh: which point and which cell is which node and which element.
#pragma once

#include "read/exchange/neutral_form.hpp"
#include "vtk/vtk_readers.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace feelem::exchange {

inline constexpr std::uint32_t kNowhere = 0xFFFFFFFF;

/// Per leaf, per point and per cell.
struct Merged {
    std::vector<std::vector<std::uint32_t>> node_of;     ///< Index of the node.
    std::vector<std::vector<std::uint32_t>> element_of;  ///< Index of the element; kNowhere: left out.
    std::size_t nodes = 0, elements = 0;
    bool has_node_ids = false, has_element_ids = false;  ///< The file's own.
};

/// Names of arrays that hold ids, and are no results.
bool is_id_array(std::string_view name);

/// `own_format`: see VtkReader. Points with the same id, in files whose points have ids, are one node; others
/// are a node each. Ids that different places share, and ids of cells that occur twice, are not used.
Merged merge(const std::vector<Leaf>& leaves, bool own_format, NeutralModel& model);

}  // namespace feelem::exchange
