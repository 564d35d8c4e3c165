// SPDX-License-Identifier: Apache-2.0
// What one walk over a deck finds: grids, systems, names, sets, and where the element cards are.
#pragma once

#include "read/nastran/bulk_deck.hpp"
#include "read/nastran/bulk_names.hpp"
#include "read/nastran/bulk_rows.hpp"
#include "read/nastran/coordinate_systems.hpp"

#include "feelem/diagnostics.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace feelem::nastran {

/// SET3, or OptiStruct's SET: ids as first and last of ranges.
struct BulkSet {
    std::int64_t id = 0;
    bool of_grids = true;
    std::vector<std::pair<std::int64_t, std::int64_t>> ranges;
};

struct BulkCards {
    BulkGrids grids;
    std::vector<std::int64_t> scalar_points;
    BulkElements elements;
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
