// SPDX-License-Identifier: Apache-2.0
// Nastran's element cards: which shape each is, where its nodes stand, and which cards have no surface.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace feelem::nastran {

/// A card that becomes an element of the mesh. Fields are counted from 0 = the card's name, so that the
/// element's number is field 1.
struct ElementCard {
    std::string_view name;                   ///< "CHEXA"
    ElementType type = ElementType::Point1;  ///< With all its mid-side nodes.
    std::uint8_t first_node = 3;             ///< Field of G1.
    std::uint8_t property = 2;               ///< Field of the property id; 0: the card has none.
    /// Feelem's node i is the card's node order[i].
    std::array<std::uint8_t, kMaxElementNodes> order{};

    std::size_t node_count() const noexcept { return element_row(type).node_count; }
};

/// All of them, in alphabetical order.
std::span<const ElementCard> element_cards();
/// Null when the card is none of them. The name in upper case, without a star.
const ElementCard* find_element_card(std::string_view name);

/// Whether it is an element that has no surface of its own: springs, dampers, masses, rigid bodies, contact,
/// surfaces of convection. The reader counts them by name.
bool is_element_without_surface(std::string_view name);

/// The nodes of a card in Feelem's order and the type they make. `nodes` is in the card's order and as long
/// as its node_count() or shorter; 0 is a blank field. Without any mid-side node the type is the linear one.
/// Empty when a corner is missing.
struct ElementNodes {
    ElementType type = ElementType::Point1;
    std::array<NodeId, kMaxElementNodes> nodes{};
    std::size_t count = 0;
};
std::optional<ElementNodes> arrange_nodes(const ElementCard& card, std::span<const std::int64_t> nodes);

}  // namespace feelem::nastran
