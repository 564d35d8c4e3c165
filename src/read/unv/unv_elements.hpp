// SPDX-License-Identifier: Apache-2.0
// Finite-element descriptors of universal files: what an element's number means.
#pragma once

#include "feelem/element_type.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace feelem::unv {

enum class Family : std::uint8_t {
    Line,     ///< Rods, beams, pipes, axisymmetric shells.
    Surface,  ///< Plane stress and strain, plates, membranes, axisymmetric solids, thin shells.
    Solid,
    NoSurface,  ///< Springs, masses, rigid elements, gaps.
    Unknown
};
Family family_of(std::int64_t descriptor);

/// Elements with one more line (orientation and cross sections) before their nodes.
bool has_beam_line(std::int64_t descriptor);

/// The shape: the descriptor says the family, the number of nodes the rest. Empty: none that Feelem knows.
std::optional<ElementType> type_of(std::int64_t descriptor, std::size_t node_count);

/// "lumped mass (161)": for the list of what was left out.
std::string descriptor_name(std::int64_t descriptor);

/// Place of each node of a type in a file's row, whose mid-side nodes stand between the corners; empty: in
/// order.
std::span<const std::uint8_t> file_order(ElementType type);

}  // namespace feelem::unv
