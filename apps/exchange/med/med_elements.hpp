// SPDX-License-Identifier: Apache-2.0
// MED's geometric types, and the mirror that its own node order is to everybody else's.
#pragma once

#include "feelem/element_type.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace feelem::exchange {

struct MedType {
    std::string_view name;  ///< "HE8": group in MAI, ending in a field's groups.
    ElementType type;
    std::uint8_t nodes;  ///< In the file; those beyond the type's own (centres) are not used.
};
/// In the order in which elements without numbers of their own are counted.
std::span<const MedType> med_types();

/// Place of each of our nodes in a mirrored row; empty for types that have no volume.
std::span<const std::uint8_t> mirrored_order(ElementType type);

}  // namespace feelem::exchange
