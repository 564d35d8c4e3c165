// SPDX-License-Identifier: Apache-2.0
// The rows of the colour maps; made by scripts/make_colour_tables.py, default map first.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace feelem {

struct ColourTable {
    std::string_view name;
    std::span<const std::uint32_t> rows;  ///< 0xRRGGBB, equally spaced from low to high.
};
std::span<const ColourTable> colour_tables();

}  // namespace feelem
