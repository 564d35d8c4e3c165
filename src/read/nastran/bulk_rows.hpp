// SPDX-License-Identifier: Apache-2.0
// Grids and elements as their cards have them, many together, in the order of the deck.
#pragma once

#include "read/nastran/nastran_elements.hpp"

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
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

struct BulkGrids {
    struct Systems {
        std::int64_t place = kBlankField, value = kBlankField;
    };
    std::vector<NodeId> ids;
    std::vector<Point3> places;
    std::vector<Systems> systems;  ///< One a grid; fewer: the fields of the others are blank.

    std::size_t size() const noexcept { return ids.size(); }
    BulkGrid at(std::size_t i) const;
    void add(const BulkGrid& grid);
    void add(const BulkGrids& further);
    void clear();
};

/// An element's card whose fields are plain numbers.
struct PlainElement {
    const ElementCard* card = nullptr;
    std::int64_t id = 0;
    std::int64_t property = kBlankField;
    std::size_t count = 0;                  ///< Of nodes; the others are blank.
    std::array<std::uint32_t, 32> nodes{};  ///< In the card's order; 0: blank.
};

/// Where an element's card stands that must be read again.
struct UnreadElement {
    const ElementCard* card = nullptr;
    std::int64_t id = 0;
    bool large = false;
    std::uint8_t shift = 0;  ///< Of its fields: a PLOTEL card may hold two elements.
};

struct BulkElements {
    /// Elements that follow each other with as many nodes of one card and property.
    struct Run {
        const ElementCard* card = nullptr;
        /// Whole: every node is there, in Feelem's order. None: in the card's order, 0 where one is blank.
        std::optional<ElementType> whole;
        std::uint32_t file = 0;
        bool is_unread = false;
        bool large = false;
        std::uint8_t shift = 0;
        std::int64_t property = kBlankField;
        std::size_t first = 0;       ///< Into ids and offsets, up to the first of the next run.
        std::size_t first_node = 0;  ///< Into nodes.
        std::size_t width = 0;       ///< Nodes an element.
    };
    std::vector<Run> runs;
    std::vector<ElementId> ids;
    std::vector<std::uint64_t> offsets;  ///< Of their cards.
    std::vector<std::uint32_t> nodes;

    std::size_t size() const noexcept { return ids.size(); }
    std::size_t end_of(std::size_t run) const {
        return run + 1 < runs.size() ? runs[run + 1].first : ids.size();
    }
    /// The run that element i belongs to.
    const Run& run_of(std::size_t i) const;
    std::span<const std::uint32_t> nodes_of(const Run& run, std::size_t i) const {
        return std::span(nodes).subspan(run.first_node + (i - run.first) * run.width, run.width);
    }
    void add(const PlainElement& element, std::uint32_t file, std::uint64_t offset);
    void add(const UnreadElement& element, std::uint32_t file, std::uint64_t offset);
    void add(const BulkElements& further);
    void clear();
};

}  // namespace feelem::nastran
