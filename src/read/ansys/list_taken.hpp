// SPDX-License-Identifier: Apache-2.0
// Rows read while lists are looked for: those that are printed like the one before. All others are left where
// they stand, for list_rows.hpp.
#pragma once

#include "read/ansys/list_node_rows.hpp"
#include "read/ansys/list_scan.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace feelem::ansys {

/// Elements printed like one before, of the same material and type: an id, nodes in even columns, and the
/// same characters everywhere else.
class AlikeElements {
public:
    /// The element at the start of the text; moves nothing. False: it is not like that.
    bool read(std::string_view text, std::uint32_t& id, std::uint32_t* nodes) const;
    /// An element that has to be read in another way; those behind it may be like it.
    void learn(std::string_view text, char line_end);
    /// One that read() took was not the one it was learned from.
    void found_alike() { misses_ = 0; }
    void forget() { length_ = 0; }

    std::size_t length() const { return length_; }  ///< With the ends of its lines; 0: none is known.
    std::size_t lines() const { return lines_.size(); }
    std::size_t nodes() const { return nodes_; }
    std::int64_t material() const { return material_; }
    std::int64_t type() const { return type_; }

private:
    struct Line {
        std::string_view before;  ///< What stands between the numbers before and the first node's column.
        std::size_t nodes = 0;
    };

    bool find_columns(std::string_view text, char line_end, std::vector<std::uint32_t>& nodes);
    bool add_line(std::string_view line, std::size_t first, std::vector<std::uint32_t>& nodes);

    std::vector<Line> lines_;
    std::string_view tail_;  ///< Behind the last node, with the line's end.
    std::size_t id_end_ = 0, width_ = 0, nodes_ = 0, length_ = 0;
    std::int64_t material_ = 0, type_ = 0;
    unsigned misses_ = 0;  ///< Elements that were learned since the last one that was alike.
};

/// Takes the rows of the lists of one file.
class RowTaker {
public:
    explicit RowTaker(const ListFile& file) : file_(file) {}

    /// Another list begins.
    void begin(const List& list);
    /// Rows of the list from there on, as many as are alike (and not more than a piece of the file). Where
    /// they end; `at` when there is none. `new_run`: something that is no row stands before.
    std::size_t take(List& list, std::size_t at, bool new_run);
    /// Gives the last element back to those that are still to be read: it is not like the others.
    void give_back(List& list);

private:
    std::size_t take_nodes(List& list, std::size_t at, bool new_run);
    std::size_t take_elements(List& list, std::size_t at, bool new_run);
    void add_elements(
        List& list, std::span<const std::uint32_t> ids, std::span<const std::uint32_t> nodes, std::size_t end
    );
    std::size_t rows_of_length(std::string_view text, std::size_t length) const;
    std::size_t pass_values(List& list, std::size_t at);
    static RowRun& run_for(List& list, std::size_t at, bool new_run);

    const ListFile& file_;
    std::optional<PlainNodeRows> nodes_;
    AlikeElements elements_;
    std::size_t row_length_ = 0;  ///< Of values, with the line's end.
};

}  // namespace feelem::ansys
