// SPDX-License-Identifier: Apache-2.0
// Numbers of a model's own type table -> element types: listed, given by the user, or concluded.
#pragma once

#include "read/ansys/ansys_elements.hpp"
#include "read/ansys/list_rows.hpp"

#include "feelem/diagnostics.hpp"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace feelem::ansys {

/// What is known of the rows of one type number.
struct TypeShape {
    std::string name;                    ///< As listed or given; empty: neither.
    std::optional<ElementName> element;  ///< Known to Feelem.
    int keyopt1 = 0;
    std::optional<ElementType> guessed;  ///< Concluded from rows and geometry.
};
using TypeTable = std::map<int, TypeShape>;

/// ETLIST listings of all files, then `option` ("1=SOLID92,2=SHELL63" or the path of an ETLIST listing).
/// Throws Error(BadOption).
TypeTable read_types(std::span<const ListFile> files, const std::string& option, Diagnostics& diagnostics);

/// Where a node is; empty when no input says so.
using FindPosition = std::function<std::optional<Point3>(std::int64_t id)>;

/// Adds shapes for the types of element rows that have no name, from the number of their nodes and, where
/// that is not enough, from the places of these (GuessedElementType).
void guess_types(
    std::span<const ListFile> files, const FindPosition& position, TypeTable& types, Diagnostics& diagnostics
);

/// The shape of a row of that type, if it is drawn.
std::optional<RowShape> shape_of(const TypeShape& type, std::size_t count);

}  // namespace feelem::ansys
