// SPDX-License-Identifier: Apache-2.0
// Groups of nodes and elements in universal files.
#pragma once

#include "base/input.hpp"
#include "read/unv/unv_datasets.hpp"

#include "feelem/ids.hpp"

#include <string>
#include <vector>

namespace feelem::unv {

struct Group {
    std::string name;
    std::vector<NodeId> nodes;
    std::vector<ElementId> elements;
};

/// Those of a dataset behind those that are there. Throws Error on a damaged record.
void read_groups(const Input& input, const Dataset& dataset, std::vector<Group>& groups);

}  // namespace feelem::unv
