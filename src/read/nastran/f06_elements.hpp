// SPDX-License-Identifier: Apache-2.0
// Tables of stresses and strains in a print file: their headings, and their rows in the words of an .op2.
#pragma once

#include "read/nastran/printed_tables.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace feelem::nastran {

/// What the lines above the rows say.
struct ElementHead {
    std::string title;
    std::string element;  ///< "HEXA"
    op2::StressKind kind;
    bool has_grids = false;  ///< A column of corners.
    bool by_step = false;    ///< A row a time, a page an element.
};
/// From "STRESSES IN HEXAHEDRON SOLID ELEMENTS (HEXA)"; nothing when it is another table.
std::optional<ElementHead> element_head(const std::string& title);

/// Takes one of the lines between the title and the rows.
void read_element_columns(std::string_view line, ElementHead& head);

/// Null when Feelem does not know such rows.
const op2::ElementLayout* printed_layout(const ElementHead& head);

struct ElementLine {
    bool is_row = false;
    std::int64_t element = 0;  ///< 0: the line goes on with the element before it.
};
ElementLine element_line(std::string_view line, const ElementHead& head);

/// Elements go on from page to page.
void read_f06_elements(const Input& input, const PrintedElements& table, const EachElementRow& each);

}  // namespace feelem::nastran
