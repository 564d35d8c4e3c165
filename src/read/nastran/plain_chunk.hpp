// SPDX-License-Identifier: Apache-2.0
// Plain cards that follow each other, read off a stretch of a deck.
#pragma once

#include "read/nastran/bulk_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace feelem::nastran {

struct PlainCards {
    BulkGrids grids;
    BulkElements elements;
    std::uint64_t cards = 0;
    std::size_t end = 0;  ///< Where the deck goes on.

    /// The grids and elements that begin in [from, stop), up to the first card that is not as plain; gives
    /// where it came to. What was here before is gone.
    std::size_t read(std::string_view text, std::uint32_t file, std::size_t from, std::size_t stop);

    struct Read {
        std::size_t end = 0;
        std::uint64_t cards = 0;
    };
    /// The same, behind what is there.
    static Read read(
        std::string_view text,
        std::uint32_t file,
        std::size_t from,
        std::size_t stop,
        BulkGrids& grids,
        BulkElements& elements
    );

    /// Where the first line at or behind `at` starts that looks like a card's first; the text's end when none
    /// does.
    static std::size_t start_of_card(std::string_view text, std::size_t at);
};

}  // namespace feelem::nastran
