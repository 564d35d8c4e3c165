// SPDX-License-Identifier: Apache-2.0
// Node sets and side sets of Exodus files, read straight from netCDF.
#pragma once

#include "read/exchange/neutral_form.hpp"

#include <string>

namespace feelem::exchange {

/// Adds both as sets of nodes: of a side set all nodes of its sides, when `model` has the elements by the
/// file's ids. It must have the nodes by them.
void add_exodus_sets(const std::string& path, bool has_element_ids, NeutralModel& model);

}  // namespace feelem::exchange
