// SPDX-License-Identifier: Apache-2.0
// What stands where in an archive of commands: blocks by their places, everything smaller by value.
#pragma once

#include "base/input.hpp"
#include "read/ansys/cdb_format.hpp"
#include "read/ansys/list_types.hpp"
#include "read/include_files.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::ansys::cdb {

/// Rows of a block in one of the deck's inputs.
struct BlockRows {
    std::size_t input = 0;
    std::size_t begin = 0, end = 0;
    RowFormat format;
    std::int64_t announced = 0;  ///< A hint, never trusted.
    char line_end = '\n';
    bool ended = false;             ///< By a row of its kind, not by the end of the file.
    std::size_t rows = 0;           ///< Lines at which a row seems to begin: never fewer than there are rows.
    std::vector<std::size_t> cuts;  ///< Beginnings of rows, as it seems, about a megabyte apart.
    bool assumed = false;  ///< By the announced number alone: who reads a line says whether it starts_row().
};

/// What readers of rows throw when a block is not what was assumed of it.
struct NotAsAssumed {};

/// Blanks and digits where the first column ends: other lines end a block.
inline bool starts_row(std::string_view line, std::size_t id_width) {
    if (line.size() < id_width || id_width < 2) return false;
    const auto blank_or_digit = [](char c) { return c == ' ' || (c >= '0' && c <= '9'); };
    const char last = line[id_width - 1];
    return blank_or_digit(line[0]) && blank_or_digit(line[id_width - 2]) && last >= '0' && last <= '9';
}

enum class ElementForm {
    Solid,   ///< EBLOCK,19,SOLID: eleven attributes, then nodes.
    Plain,   ///< EBLOCK,10: number, type, real constant, material, system, then nodes.
    Compact  ///< EBLOCK,11,COMPACT: number, then nodes; the rest as the commands before set it.
};

struct ElementRows {
    BlockRows rows;
    ElementForm form = ElementForm::Solid;
    std::int64_t type = 1;  ///< Current ones, where a row gives none.
    std::int64_t material = 1;
    std::string body;
};

/// N: a node by command.
struct CommandNode {
    std::int64_t id = 0;  ///< 0: the next after the highest.
    Point3 position{};
    NodalAngles angles{};
};

/// E and EN: an element by command.
struct CommandElement {
    std::int64_t id = 0;  ///< 0: the next after the highest.
    std::int64_t type = 1;
    std::int64_t material = 1;
    std::size_t first = 0, count = 0;  ///< In Deck::command_nodes.
    std::size_t input = 0, offset = 0;
};

struct ComponentRows {
    std::string name;
    bool of_nodes = true;
    BlockRows rows;
};

struct Deck {
    std::vector<Input> inputs;  ///< The deck itself, then what it reads by /INPUT and CDREAD.
    std::vector<BlockRows> node_blocks;
    std::vector<CommandNode> nodes;
    std::vector<ElementRows> element_blocks;
    std::vector<CommandElement> elements;
    std::vector<std::int64_t> element_nodes;  ///< Of the elements by command.
    std::vector<ComponentRows> components;
    TypeTable types;
    std::optional<LengthUnit> unit;
    std::string title;
    std::string version;  ///< Of the release that wrote it.
};

/// One pass over the lines. Blocks are skipped, not read. Throws Error on a block without a format.
/// `by_counts`: a block whose announced number of rows, each as long as the first, leads to its end is not
/// looked at at all; throws NotAsAssumed when the deck includes others.
Deck scan_deck(const Input& input, IncludeFiles* includes, Diagnostics& diagnostics, bool by_counts = false);

}  // namespace feelem::ansys::cdb
