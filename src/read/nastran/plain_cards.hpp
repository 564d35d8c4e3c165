// SPDX-License-Identifier: Apache-2.0
// Must: read the GRID and element cards that pre-processors write, fast, or refuse them.
// Assumes: nothing; what is refused the caller reads with BulkCard, which knows every form.
// Algorithm: fields of 8 or 16 columns lie in a register each, free fields are taken digit by digit; a card
// ends where the next line starts with a letter. Comments, tabs, names in small letters, mixed forms and
// marks that differ are refused.
// Data: none.
#pragma once

#include "read/nastran/bulk_cards.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem::nastran {

/// The GRID card at `at`. Gives where the next card starts.
std::optional<std::size_t> read_plain_grid(std::string_view text, std::size_t at, BulkGrid& grid);

/// Looks over the card at `at`, whose name has `name_length` characters: its first field, a whole number, and
/// where the next card starts.
struct PlainHead {
    std::int64_t id = 0;
    std::size_t next = 0;
};
std::optional<PlainHead> look_over_plain_card(std::string_view text, std::size_t at, std::size_t name_length);

/// First fields of a card behind its name; kBlankField where one is blank or absent.
struct PlainFields {
    static constexpr std::size_t kMost = 32;
    std::array<std::int64_t, kMost> values{};
};

/// The first `wanted` fields of the card at `at`, all of them whole numbers or blank.
bool read_plain_fields(
    std::string_view text, std::size_t at, std::size_t name_length, std::size_t wanted, PlainFields& fields
);

/// The same for card after card: one whose commas stand where those of the one before do is read without
/// waiting for the end of each field.
class FreeCards {
public:
    bool read(
        std::string_view text,
        std::size_t at,
        std::size_t name_length,
        std::size_t wanted,
        PlainFields& fields
    );

private:
    bool read_like(std::string_view text, std::size_t at, std::size_t wanted, PlainFields& fields) const;
    void remember(std::string_view text, std::size_t at, std::size_t name_length, std::size_t wanted);

    struct Field {
        std::uint16_t first = 0, last = 0;
    };
    std::string_view card_;  ///< The one before, up to the start of the next; empty: none to go by.
    std::size_t wanted_ = 0;
    std::size_t count_ = 0;  ///< Of its fields that are numbers.
    std::array<Field, PlainFields::kMost> fields_{};
    std::array<std::uint8_t, PlainFields::kMost> index_{};  ///< Which of the wanted ones they are.
};

}  // namespace feelem::nastran
