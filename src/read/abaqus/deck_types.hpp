// SPDX-License-Identifier: Apache-2.0
// Abaqus' and CalculiX' names of element types -> shapes. Letters behind the number of nodes (R, I, H, T, P,
// M ...) say how an element computes, not what it looks like.
#pragma once

#include "feelem/element_type.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace feelem::abaqus {

enum class Use : std::uint8_t {
    Shape,  ///< Has a shape of ours.
    Skip,   ///< Known, but without a surface of its own: spring, mass, gasket, cohesive, infinite ...
    Unknown,
};

struct DeckType {
    Use use = Use::Unknown;
    ElementType shape = ElementType::Point1;
    std::uint8_t most_nodes = 0;   ///< Of a row; further ones (a beam's direction node) do not count.
    std::uint8_t least_nodes = 0;  ///< Of a row that ends early.
    /// Feelem's node i is the row's node order[i]; empty: the same order.
    std::span<const std::uint8_t> order;
};

/// `name` in upper case.
DeckType deck_type(std::string_view name);

}  // namespace feelem::abaqus
