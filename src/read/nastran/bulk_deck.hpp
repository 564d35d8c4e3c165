// SPDX-License-Identifier: Apache-2.0
// A deck as the solver reads it: bulk data after BEGIN BULK up to ENDDATA, with what it INCLUDEs in place.
#pragma once

#include "base/input.hpp"
#include "read/include_files.hpp"
#include "read/nastran/bulk_card.hpp"

#include "feelem/diagnostics.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::nastran {

/// INCLUDE 'name' (the name may go on over several lines); `next` is where the deck goes on.
struct Include {
    std::string name;
    std::size_t next = 0;
};
/// Empty when the line at `offset` is no INCLUDE.
std::optional<Include> include_at(std::string_view text, std::size_t offset);

/// Whether a line that starts with BEGIN BULK stands in the text.
bool has_begin_bulk(std::string_view text);

/// Walks the cards of decks that are one model: usually one deck, or several pieces without BEGIN BULK.
class BulkDeck {
public:
    BulkDeck(std::vector<Input> roots, IncludeFiles* includes, Diagnostics& diagnostics);

    /// The next card of the bulk data; false at the end.
    bool next(CardHead& head);
    /// Where the next line starts, when it is bulk data; whoever reads cards there by himself says so.
    struct Ahead {
        std::string_view text;  ///< Of the file.
        std::size_t offset = 0;
    };
    std::optional<Ahead> ahead() const;
    void go_on_at(std::size_t offset, std::uint64_t cards_read);
    /// Where the last card is.
    std::uint32_t file() const noexcept { return frames_.back().file; }
    const Input& input(std::uint32_t file) const { return files_[file]; }
    std::string where(std::uint32_t file, std::size_t offset) const {
        return files_[file].where_line(offset);
    }
    /// Comments with names since the last take, in order.
    std::vector<std::string_view> take_names();
    /// Words of the title lines of case control.
    const std::string& title() const noexcept { return title_; }
    /// Of all kinds, ENDDATA included.
    std::uint64_t card_count() const noexcept { return card_count_; }
    bool missed_include() const noexcept { return missed_include_; }

private:
    struct Frame {
        std::uint32_t file = 0;
        BulkLines lines;
    };
    void open_root();
    void push(Input input);
    void follow(const Include& include);
    bool read_control(std::string_view line);
    void skip_section(std::string_view line);

    std::vector<Input> roots_;
    std::size_t next_root_ = 0;
    IncludeFiles* includes_;
    Diagnostics& diagnostics_;
    std::vector<Input> files_;  ///< Each once, in order of first use.
    std::vector<Frame> frames_;
    std::vector<std::string_view> names_;
    std::string title_;
    std::uint64_t card_count_ = 0;
    bool in_bulk_ = false;
    bool skips_ = false;  ///< Within the section of a superelement.
    bool missed_include_ = false;
};

}  // namespace feelem::nastran
