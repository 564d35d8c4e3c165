// SPDX-License-Identifier: Apache-2.0
// "Did you mean ...?": the known name nearest to one that is not known.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace feelem {

/// Nearest by edit distance (insert, delete, replace, swap of neighbours), the earlier one on a tie; empty
/// when none is near enough to be meant.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> known);

/// " Did you mean \"temperature\"?" or "".
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

}  // namespace feelem
