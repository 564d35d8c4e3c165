// SPDX-License-Identifier: Apache-2.0
// Tables of stresses and strains in a punch file: the words of an .op2, three to a line.
#pragma once

#include "base/input.hpp"
#include "read/nastran/printed_tables.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem::nastran {

inline constexpr std::size_t kPunchField = 18;
inline constexpr std::size_t kPunchData = 72;  ///< Columns behind number the lines.

/// What stands under $ELEMENT STRESSES or $ELEMENT STRAINS.
struct PunchedElements {
    bool strain = false;
    std::int64_t type = 0;
    std::string_view words;  ///< "QUAD4     VONM   FIBER"
};
/// From "$ELEMENT TYPE =          33  QUAD4     VONM   FIBER".
void read_element_type(std::string_view line, PunchedElements& elements);

/// What the columns hold; nothing for strains of shells when the file does not say it.
std::optional<op2::StressKind> punched_kind(
    const PunchedElements& elements, const op2::ElementLayout& layout
);

/// From the number of lines that the row at `at` has; null when Feelem does not know such rows.
const op2::ElementLayout* punched_layout(
    std::string_view text, std::size_t at, std::size_t last, std::int64_t type
);

void read_punch_elements(const Input& input, const PrintedElements& table, const EachElementRow& each);

}  // namespace feelem::nastran
