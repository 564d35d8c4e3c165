// SPDX-License-Identifier: Apache-2.0
// Must: take the rows of *NODE and *ELEMENT that programs write off a text, fast, or refuse them.
// Assumes: nothing; what is refused the caller reads field by field.
// Algorithm: commas and line ends are found 64 characters at a time; the whole numbers of a row, and its
// coordinates, are made at once where the processor can. Comments, signs of labels, labels of more than eight
// digits, fields left out but the last coordinates, and more fields than a row has, are refused.
// Data: the rows.
#pragma once

#include "read/abaqus/deck_model.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace feelem::abaqus {

/// "id, x, y, z" a line; coordinates that are left out at its end are 0.
struct PlainNodes {
    std::vector<Label> ids;
    std::vector<Point3> places;

    std::size_t size() const noexcept { return ids.size(); }
    void begin_like(const PlainNodes& other);  ///< Without rows.
    void add(const PlainNodes& further);
    /// The rows of `text` that begin in [from, stop), up to the first that is not plain, behind those that
    /// are here; gives where it came to.
    std::size_t read(std::string_view text, std::size_t from, std::size_t stop);
};

/// "id, node, node ..." over line ends behind commas, as many nodes as the type has.
struct PlainElementRows {
    const DeckType* type = nullptr;
    std::vector<Label> ids;
    std::vector<Label> nodes;  ///< In Feelem's order.

    std::size_t size() const noexcept { return ids.size(); }
    void begin_like(const PlainElementRows& other);
    void add(const PlainElementRows& further);
    std::size_t read(std::string_view text, std::size_t from, std::size_t stop);
    /// One more, its nodes as the file has them.
    void add(Label id, std::span<const Label> nodes_of_file);
};

/// Where the first line at or behind `at` starts that no line before it goes on in.
std::size_t start_of_row(std::string_view text, std::size_t at);

}  // namespace feelem::abaqus
