// SPDX-License-Identifier: Apache-2.0
// How element cards stand in the records of GEOM2.
#pragma once

#include "read/nastran/op2_records.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace feelem::op2 {

/// One kind of record, known by the first two words of its head. Words of an entry: number, property (most),
/// nodes, the rest.
struct CardRecord {
    std::int64_t key = 0;
    std::int64_t second_key = 0;
    std::string_view name;                ///< As in the bulk data; empty: no element.
    std::array<std::uint8_t, 3> words{};  ///< Of an entry: several lengths have been written over time.
    std::uint8_t first_node = 2;
    std::uint8_t node_words = 0;  ///< 0: it has no surface.
};

/// Null when the record is of no known kind.
const CardRecord* find_card_record(std::int64_t key, std::int64_t second_key);

/// Words of an entry such that numbers ascend and nodes are positive; 0 when no known length fits.
std::size_t entry_words(const CardRecord& card, const Words& entries);

}  // namespace feelem::op2
