// SPDX-License-Identifier: Apache-2.0
// Must: read the element cards that pre-processors write, one after the other, fast, or refuse them.
// Assumes: nothing; what is refused the caller reads with BulkCard, which knows every form.
// Algorithm: commas and line ends of free cards are found 64 characters at a time; a fixed card is read by
// the columns of the one before, between which the same characters must stand. All whole numbers of a card
// are made at once where the processor can. What is not that plain is read field by field (plain_cards.hpp).
// Data: what the card before looks like.
#pragma once

#include "base/text_fields.hpp"
#include "read/nastran/bulk_rows.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem::nastran {

class PlainElements {
public:
    explicit PlainElements(std::string_view text) : text_(text) {}

    /// The element's card at `at`. Gives where the next card starts.
    std::optional<std::size_t> read(std::size_t at, PlainElement& element);

private:
    static constexpr std::size_t kMostFields = 2 + kMaxElementNodes;
    bool find_card(std::size_t at);
    std::optional<std::size_t> read_free(std::size_t at, PlainElement& element);
    std::optional<std::size_t> read_like(std::size_t at, PlainElement& element);
    std::optional<std::size_t> read_any(std::size_t at, PlainElement& element);
    const char* find_free_fields(const char* first, std::size_t& count);
    bool read_numbers(std::size_t count);
    void put(std::size_t count, bool has_property, PlainElement& element) const;
    void remember(std::string_view card, const PlainElement& element);

    /// A stretch of the card before.
    struct Stretch {
        std::uint16_t first = 0, last = 0;
    };

    std::string_view text_;
    std::array<TextField, kMostFields> fields_{};
    std::array<std::uint32_t, kMostFields> numbers_of_{};
    const ElementCard* card_ = nullptr;  ///< Of the name before.
    FieldEnds ends_{nullptr, nullptr};
    std::size_t ends_at_ = std::string_view::npos;  ///< Where a card starts that ends_ stands at.

    std::string_view like_;  ///< The fixed card before, to the start of the next; empty: none to go by.
    const ElementCard* like_card_ = nullptr;
    std::size_t like_count_ = 0;  ///< Of its numbers: the first is the element's, the second its property.
    bool like_has_property_ = false;
    std::array<Stretch, kMostFields> numbers_{};
    std::size_t same_count_ = 0;
    std::array<Stretch, 2 * kMostFields> same_{};  ///< What stands between numbers.
};

}  // namespace feelem::nastran
