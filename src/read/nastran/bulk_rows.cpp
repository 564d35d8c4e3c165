// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/bulk_rows.hpp"

#include "base/huge_pages.hpp"

#include <algorithm>

namespace feelem::nastran {
namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    if (to.capacity() - to.size() < from.size())
        reserve_big(to, std::max(2 * to.capacity(), to.size() + from.size()));
    to.insert(to.end(), from.begin(), from.end());
}

bool goes_on_with(const BulkElements::Run& a, const BulkElements::Run& b) {
    return a.card == b.card && a.whole == b.whole && a.file == b.file && a.is_unread == b.is_unread &&
           a.large == b.large && a.shift == b.shift && a.property == b.property && a.width == b.width;
}

/// The type that a card's nodes make where all of them are there, or all corners of a linear one.
std::optional<ElementType> whole_type(const PlainElement& element) {
    const ElementCard& card = *element.card;
    const ElementRow& row = element_row(card.type);
    if (element.count != row.node_count && element.count != row.corner_count) return {};
    unsigned odd = 0;
    for (std::size_t i = 0; i < element.count; ++i) odd += element.nodes[i] == 0;
    // Corners alone stand in front only where the card lists them first.
    for (std::size_t i = 0; i < row.corner_count; ++i) odd += card.order[i] >= element.count;
    if (odd != 0) return {};
    return element.count == row.node_count ? card.type : row.linear;
}

}  // namespace

BulkGrid BulkGrids::at(std::size_t i) const {
    const Systems of = i < systems.size() ? systems[i] : Systems{};
    return {raw(ids[i]), of.place, of.value, places[i]};
}

void BulkGrids::add(const BulkGrid& grid) {
    if (grid.place_system != kBlankField || grid.value_system != kBlankField) {
        systems.resize(ids.size());
        systems.push_back({grid.place_system, grid.value_system});
    }
    ids.push_back(NodeId{grid.id});
    places.push_back(grid.place);
}

void BulkGrids::add(const BulkGrids& further) {
    if (!further.systems.empty()) {
        systems.resize(ids.size());
        append(systems, further.systems);
    }
    append(ids, further.ids);
    append(places, further.places);
}

void BulkGrids::clear() {
    ids.clear();
    places.clear();
    systems.clear();
}

const BulkElements::Run& BulkElements::run_of(std::size_t i) const {
    return *(std::ranges::upper_bound(runs, i, {}, &Run::first) - 1);
}

void BulkElements::add(const PlainElement& element, std::uint32_t file, std::uint64_t offset) {
    Run run;
    run.card = element.card;
    run.whole = whole_type(element);
    run.file = file;
    run.property = element.property;
    run.first = ids.size();
    run.first_node = nodes.size();
    run.width = run.whole ? element.count : element.card->node_count();
    if (runs.empty() || !goes_on_with(runs.back(), run)) runs.push_back(run);
    ids.push_back(ElementId{element.id});
    offsets.push_back(offset);
    if (!run.whole) {
        nodes.insert(nodes.end(), element.nodes.begin(), element.nodes.begin() + element.count);
        nodes.resize(nodes.size() + run.width - element.count);
        return;
    }
    const std::size_t first = nodes.size();
    nodes.resize(first + run.width);
    for (std::size_t i = 0; i < run.width; ++i) nodes[first + i] = element.nodes[element.card->order[i]];
}

void BulkElements::add(const UnreadElement& element, std::uint32_t file, std::uint64_t offset) {
    Run run;
    run.card = element.card;
    run.file = file;
    run.is_unread = true;
    run.large = element.large;
    run.shift = element.shift;
    run.first = ids.size();
    run.first_node = nodes.size();
    if (runs.empty() || !goes_on_with(runs.back(), run)) runs.push_back(run);
    ids.push_back(ElementId{element.id});
    offsets.push_back(offset);
}

void BulkElements::add(const BulkElements& further) {
    for (Run run : further.runs) {
        run.first += ids.size();
        run.first_node += nodes.size();
        if (runs.empty() || !goes_on_with(runs.back(), run)) runs.push_back(run);
    }
    append(ids, further.ids);
    append(offsets, further.offsets);
    append(nodes, further.nodes);
}

void BulkElements::clear() {
    runs.clear();
    ids.clear();
    offsets.clear();
    nodes.clear();
}

}  // namespace feelem::nastran
