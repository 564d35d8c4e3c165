// SPDX-License-Identifier: Apache-2.0
// Rows of NBLOCK, EBLOCK and CMBLOCK: fixed columns, whose last ones may be left out.
#pragma once

#include "read/ansys/cdb_deck.hpp"
#include "read/ansys/list_rows.hpp"
#include "read/ansys/list_text.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace feelem::ansys::cdb {

/// A place in a deck, for messages.
class RowPlace {
public:
    RowPlace(const Input& input, std::string_view block) : input_(input), block_(block) {}
    void at(std::size_t offset) { offset_ = offset; }
    std::size_t offset() const { return offset_; }
    std::string where() const { return input_.where_line(offset_); }
    /// Bytes of zero are what a broken copy leaves behind.
    [[noreturn]] void bad_row(std::string_view line) const;

private:
    const Input& input_;
    std::string_view block_;
    std::size_t offset_ = 0;
};

/// An integer of a row; 0 for a blank or absent field.
std::int64_t integer_field(
    std::string_view line, std::size_t first, std::size_t width, const RowPlace& place
);
double real_field(
    std::string_view line, std::size_t first, std::size_t width, std::size_t decimals, const RowPlace& place
);

/// The rows of a block that begin in [first, stop) of its input.
struct RowRange {
    std::size_t first = 0, stop = 0;
};

/// A position among the lines of a block.
struct BlockCursor {
    std::string_view text;
    std::size_t at = 0, end = 0;
    std::size_t stop = 0;  ///< No row begins here or behind; the last one may go on to `end`.
    char line_end = '\n';
    std::size_t checked_width = 0;  ///< Of the first column, where lines are to be looked at; 0: they were.

    BlockCursor(const Deck& deck, const BlockRows& rows, RowRange range)
        : text(deck.inputs[rows.input].text()), at(range.first), end(rows.end), stop(range.stop),
          line_end(rows.line_end), checked_width(rows.assumed ? rows.format.id_width : 0) {}
    /// The next line, without its end and a carriage return; nothing at the end. Throws NotAsAssumed.
    std::optional<std::string_view> next();
    bool at_end() const { return at >= end; }
    /// False when the file ends without a line end: its last line may have been cut.
    bool was_ended() const { return text[at - 1] == line_end; }
};

/// Rows of an NBLOCK.
class NodeRows {
public:
    NodeRows(const Deck& deck, const BlockRows& rows, RowRange range);
    bool next();
    std::size_t at() const { return lines_.at; }  ///< Where the next row begins.
    const CommandNode& node() const { return node_; }
    const RowPlace& place() const { return place_; }
    bool cut() const { return cut_; }  ///< The file ends in the middle of the last row, which is not given.
    std::int64_t count() const { return count_; }

private:
    bool read_fast();
    void read(std::string_view line);

    const BlockRows& rows_;
    BlockCursor lines_;
    RowPlace place_;
    CommandNode node_;
    std::int64_t count_ = 0;
    bool cut_ = false;
    // Of the row before, which the next one is like: its length with what ends it, and its reals.
    std::size_t length_ = 0;  ///< 0: no such row.
    std::size_t reals_ = 0;
};

/// Rows of an EBLOCK; those of several lines are put together.
class ElementRowsReader {
public:
    /// How many nodes elements of a type have at most: the plain forms do not say how many a row has.
    using NodesOfType = std::function<std::size_t(std::int64_t type)>;

    ElementRowsReader(const Deck& deck, const ElementRows& block, RowRange range, NodesOfType nodes_of_type);
    bool next();
    std::size_t at() const { return lines_.at; }  ///< Where the next row begins.
    /// Its nodes, where it was read as columns: row() has them too then, but for a price.
    std::span<const std::uint32_t> plain_nodes() const {
        return is_plain_ ? std::span(columns_).first(node_count_) : std::span<const std::uint32_t>{};
    }
    std::int64_t id() const { return row_.id; }
    std::int64_t type() const { return row_.type; }
    std::int64_t material() const { return row_.material; }
    std::size_t offset() const { return row_.offset; }
    std::size_t node_count() const { return is_plain_ ? node_count_ : row_.nodes.size(); }
    const ElementRowIds& row();
    const RowPlace& place() const { return place_; }
    bool cut() const { return cut_; }
    std::int64_t count() const { return count_; }

private:
    static constexpr std::size_t kMostNodes = 64;
    static constexpr std::size_t kSolidAttributes = 11;
    static constexpr std::size_t kPlainAttributes = 5;
    static constexpr std::size_t kAlike = 9;  ///< First attributes, the number of nodes with them.

    bool read_fast();
    void read_solid(std::string_view line);
    void read_plain(std::string_view line);
    void add_nodes(
        std::string_view line, std::size_t first_field, std::size_t last_field, std::size_t wanted
    );
    void add_lines(std::size_t wanted);
    void remember(std::size_t first);

    const ElementRows& block_;
    NodesOfType nodes_of_type_;
    BlockCursor lines_;
    RowPlace place_;
    ElementRowIds row_;
    std::array<std::int64_t, kMostNodes> nodes_{};
    std::array<std::uint32_t, kMostNodes> columns_{};  ///< Nodes of a row that was read as columns.
    bool is_plain_ = false;                            ///< This row was.
    std::size_t node_count_ = 0;                       ///< Of the row; those beyond the array are not kept.
    std::int64_t count_ = 0;
    bool short_ = false;  ///< The row has fewer nodes than it says.
    bool cut_ = false;
    std::string_view alike_;         ///< First attributes of the row before; empty: no fast way.
    std::size_t line_end_size_ = 0;  ///< One or two characters.
};

}  // namespace feelem::ansys::cdb
