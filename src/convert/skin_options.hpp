// SPDX-License-Identifier: Apache-2.0
// A job's skin options, with the second node list read.
#pragma once

#include "feelem/convert.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace feelem {

/// Throws Error(BadOption) when the node map lacks its list, and what reading the list throws.
SkinOptions skin_options(const Job& job);

/// How the inputs of a scene name the second node list of the node map.
inline constexpr std::string_view kSurfaceNodesFormat = "surface-nodes";

/// The record of job.surface_nodes_file, for the scene's inputs; nothing when the job uses none.
std::optional<InputRecord> surface_nodes_record(const Job& job);

/// Node ids of an Ansys node list: the first number of each row that is nothing but numbers. Throws
/// Error(NoNodes) when there is none.
std::vector<NodeId> read_surface_nodes(std::string_view text, std::string_view name);

}  // namespace feelem
