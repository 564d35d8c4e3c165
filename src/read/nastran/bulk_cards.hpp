// SPDX-License-Identifier: Apache-2.0
// What one walk over a deck finds: grids, systems, names, sets, and where the element cards are.
#pragma once

#include "read/nastran/bulk_deck.hpp"
#include "read/nastran/bulk_names.hpp"
#include "read/nastran/coordinate_systems.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace feelem::nastran {

/// A blank field whose default another card (GRDSET, BAROR) may give.
inline constexpr std::int64_t kBlankField = std::numeric_limits<std::int64_t>::min();

struct BulkGrid {
    std::int64_t id = 0;
    std::int64_t place_system = 0;  ///< CP
    std::int64_t value_system = 0;  ///< CD
    Point3 place{};
};

struct BulkElement {
    std::int64_t id = 0;
    std::uint64_t offset = 0;  ///< Of its card.
    std::uint32_t file = 0;
    std::uint16_t card = 0;  ///< Into element_cards().
    bool large = false;
    std::uint8_t shift = 0;  ///< Of its fields: a PLOTEL card may hold two elements.
};

/// SET3, or OptiStruct's SET: ids as first and last of ranges.
struct BulkSet {
    std::int64_t id = 0;
    bool of_grids = true;
    std::vector<std::pair<std::int64_t, std::int64_t>> ranges;
};

struct BulkCards {
    std::vector<BulkGrid> grids;
    std::vector<std::int64_t> scalar_points;
    std::vector<BulkElement> elements;
    CoordinateSystems systems;
    DeckNames names;
    std::vector<BulkSet> sets;
    std::map<std::string, std::uint64_t> element_cards;  ///< By card, drawn and skipped ones.
    std::map<std::string, std::uint64_t> skipped;        ///< Those without a surface.
    std::int64_t place_system = 0, value_system = 0;     ///< Of GRDSET.
    std::int64_t bar_property = kBlankField, beam_property = kBlankField;
};

/// Throws Error(BadNumber | BadStructure | TooLarge) with the card's place. `deck` must outlive the result.
BulkCards read_cards(BulkDeck& deck, Diagnostics& diagnostics);

}  // namespace feelem::nastran
