// SPDX-License-Identifier: Apache-2.0
// Must: add rows of elements as add_element() would, one after the other.
// Assumes: nothing about the rows.
// Algorithm: chunks of rows are looked up at once; rows without a fault are taken as they are, the others go
// through add_element(), in the order of all rows. Data: the nodes of a few chunks.
#include "base/parallel.hpp"
#include "model/collapse.hpp"
#include "model/mesh_builder.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace feelem {
namespace {

constexpr std::size_t kRowsAChunk = 4096;

/// The nodes of some rows, and the rows for which that is not enough.
struct FoundRows {
    std::vector<NodeIndex> nodes;
    std::vector<std::size_t> odd;

    void find(const NodeLookup& lookup, const ElementRow& type, std::span<const std::uint32_t> ids) {
        const std::size_t width = type.node_count;
        nodes.resize(ids.size());
        odd.clear();
        const bool all_known = lookup.find(ids, nodes.data());
        for (std::size_t row = 0; row * width < ids.size(); ++row) {
            const auto given = ids.subspan(row * width, width);
            const auto found = std::span(nodes).subspan(row * width, width);
            const auto corners = found.first(type.corner_count);
            bool whole = type.dimension < 2 || all_differ(corners);
            if (!all_known) whole = whole && lookup.find(given, found.data());
            for (const std::uint32_t id : given.subspan(type.corner_count)) whole = whole && id != 0;
            if (!whole) odd.push_back(row);
        }
    }
};

}  // namespace

void MeshBuilder::add_elements(
    ElementType type,
    PartIndex part,
    std::span<const ElementId> ids,
    std::span<const std::uint32_t> nodes,
    const WhereOf& where
) {
    assert(lookup_ && "seal_nodes() first");
    const ElementRow& row = element_row(type);
    const std::size_t width = row.node_count;
    assert(nodes.size() == ids.size() * width);
    std::vector<FoundRows> slots(ordered_slots());
    const auto first_of = [&](std::size_t chunk) { return std::min(chunk * kRowsAChunk, ids.size()); };
    const auto find = [&](std::size_t chunk, std::size_t slot) {
        const std::size_t first = first_of(chunk), last = first_of(chunk + 1);
        slots[slot].find(*lookup_, row, nodes.subspan(first * width, (last - first) * width));
    };
    const auto take = [&](std::size_t chunk, std::size_t slot) {
        const FoundRows& found = slots[slot];
        const std::size_t first = first_of(chunk), count = first_of(chunk + 1) - first;
        std::size_t done = 0;
        const auto add_whole = [&](std::size_t to) {
            if (to == done) return;
            const auto rows = std::span(found.nodes).subspan(done * width, (to - done) * width);
            add_whole_elements(type, part, ids.subspan(first + done, to - done), rows);
        };
        for (const std::size_t odd : found.odd) {
            add_whole(odd);
            std::array<NodeId, kMaxElementNodes> given{};
            for (std::size_t i = 0; i < width; ++i) given[i] = NodeId{nodes[(first + odd) * width + i]};
            add_element(ids[first + odd], type, std::span(given).first(width), part, [&] {
                return where(first + odd);
            });
            done = odd + 1;
        }
        add_whole(count);
    };
    ordered_chunks(slots.size(), (ids.size() + kRowsAChunk - 1) / kRowsAChunk, find, take);
}

}  // namespace feelem
