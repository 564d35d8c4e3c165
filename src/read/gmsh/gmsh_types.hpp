// SPDX-License-Identifier: Apache-2.0
// gmsh's element types and node orders.
#pragma once

#include "feelem/element_type.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace feelem::gmsh {

struct TypeRow {
    int number = 0;
    std::string_view name;   ///< As gmsh calls it.
    std::uint8_t nodes = 0;  ///< In the file.
    bool known = false;      ///< False: of higher order; read over and counted.
    ElementType type = ElementType::Point1;
    std::span<const std::uint8_t> order;  ///< Place of each of our nodes in the file's row; empty: in order.
};

/// Null: a number that gmsh does not have, so that not even its length is known.
const TypeRow* find_type(std::int64_t number);

/// Place of each node of a type in a file's row; empty: in order.
std::span<const std::uint8_t> file_order(ElementType type);

}  // namespace feelem::gmsh
