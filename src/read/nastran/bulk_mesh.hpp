// SPDX-License-Identifier: Apache-2.0
// The mesh of a deck: grids placed through their coordinate systems, elements by card, parts by property.
#pragma once

#include "base/input.hpp"
#include "read/include_files.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace feelem::nastran {

struct BulkModel {
    Mesh mesh;
    std::string title;
    /// What the deck holds, for comparison with other readers.
    std::uint64_t cards = 0;
    std::uint64_t grids = 0;
    std::uint64_t systems = 0;                           ///< Without the basic one.
    std::map<std::string, std::uint64_t> element_cards;  ///< By card, drawn and skipped ones.
};

/// `decks`: one deck, or pieces without BEGIN BULK that are one model. Throws Error.
BulkModel read_bulk(std::vector<Input> decks, IncludeFiles* includes, Diagnostics& diagnostics);

}  // namespace feelem::nastran
