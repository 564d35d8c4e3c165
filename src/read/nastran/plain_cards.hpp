// SPDX-License-Identifier: Apache-2.0
// Must: read the element cards that pre-processors write, or refuse them.
// Assumes: nothing; what is refused the caller reads with BulkCard, which knows every form.
// Algorithm: fields of 8 or 16 columns lie in a register each, free fields are taken digit by digit; a card
// ends where the next line starts with a letter. Comments, tabs, names in small letters, mixed forms and
// marks that differ are refused.
// Data: none.
#pragma once

#include "read/nastran/bulk_rows.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem::nastran {

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

}  // namespace feelem::nastran
