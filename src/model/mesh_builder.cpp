// SPDX-License-Identifier: Apache-2.0
#include "model/mesh_builder.hpp"

#include "base/huge_pages.hpp"
#include "model/collapse.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

namespace feelem {
namespace {

constexpr std::size_t kMostNodes = std::numeric_limits<std::uint32_t>::max() - 1;

template <class T>
void reorder(std::vector<T>& values, std::span<const std::uint32_t> order) {
    std::vector<T> sorted;
    sorted.reserve(order.size());
    for (const std::uint32_t from : order) sorted.push_back(values[from]);
    values = std::move(sorted);
}

}  // namespace

void MeshBuilder::reserve_nodes(std::size_t count) {
    reserve_big(mesh_.node_ids, count);
    reserve_big(mesh_.coordinates, count);
}

void MeshBuilder::add_node(NodeId id, const Point3& coordinates) {
    add_node(id, coordinates, {});
}

void MeshBuilder::add_node(NodeId id, const Point3& coordinates, const NodalAngles& angles) {
    assert(!lookup_ && "nodes after seal_nodes()");
    const bool rotated = angles[0] != 0 || angles[1] != 0 || angles[2] != 0;
    if (rotated && !has_angles_) {
        has_angles_ = true;
        mesh_.node_angles.resize(mesh_.node_ids.size());
    }
    if (has_angles_) mesh_.node_angles.push_back(angles);
    mesh_.node_ids.push_back(id);
    mesh_.coordinates.push_back(coordinates);
}

void MeshBuilder::add_nodes(std::span<const NodeId> ids, std::span<const Point3> coordinates) {
    assert(!lookup_ && "nodes after seal_nodes()");
    assert(ids.size() == coordinates.size());
    mesh_.node_ids.insert(mesh_.node_ids.end(), ids.begin(), ids.end());
    mesh_.coordinates.insert(mesh_.coordinates.end(), coordinates.begin(), coordinates.end());
    if (has_angles_) mesh_.node_angles.resize(mesh_.node_ids.size());
}

void MeshBuilder::add_nodes(std::vector<NodeId>&& ids, std::vector<Point3>&& coordinates) {
    if (!mesh_.node_ids.empty()) {
        add_nodes(std::span<const NodeId>(ids), coordinates);
        return;
    }
    assert(!lookup_ && "nodes after seal_nodes()");
    assert(ids.size() == coordinates.size());
    mesh_.node_ids = std::move(ids);
    mesh_.coordinates = std::move(coordinates);
}

void MeshBuilder::seal_nodes() {
    std::vector<NodeId>& ids = mesh_.node_ids;
    if (ids.size() > kMostNodes) throw Error(Code::TooLarge, "", "more than 4 294 967 294 nodes");
    const bool ascending = std::ranges::adjacent_find(ids, std::ranges::greater_equal{}) == ids.end();
    if (!ascending) {
        std::vector<std::uint32_t> order(ids.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return ids[a] < ids[b]; });
        // Of equal ids the last in file order counts.
        std::vector<std::uint32_t> kept;
        kept.reserve(order.size());
        for (const std::uint32_t at : order) {
            if (!kept.empty() && ids[kept.back()] == ids[at]) {
                diagnostics_->add(
                    Code::DuplicateNode,
                    std::string(),
                    "nodes are defined more than once; the last definition counts"
                );
                kept.back() = at;
            } else {
                kept.push_back(at);
            }
        }
        reorder(mesh_.coordinates, kept);
        if (has_angles_) reorder(mesh_.node_angles, kept);
        reorder(ids, kept);
    }
    lookup_ = std::make_unique<NodeLookup>(ids);
    block_by_type_.fill(-1);
}

PartIndex MeshBuilder::part(std::string_view name) {
    if (const auto found = part_by_name_.find(name); found != part_by_name_.end()) return found->second;
    const PartIndex index{static_cast<std::uint32_t>(mesh_.parts.size())};
    mesh_.parts.push_back({std::string(name)});
    part_by_name_.emplace(name, index);
    return index;
}

bool MeshBuilder::resolve(
    std::span<const NodeId> nodes, std::size_t corners, ElementId id, const Where& where
) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool left_out = i >= corners && nodes[i] == NodeId{0};
        resolved_[i] = left_out ? kNoNode : (*lookup_)(nodes[i]);
        if (resolved_[i] != kNoNode || left_out) continue;
        diagnostics_->add(
            Code::UnknownNode,
            [&] {
                return where() + fmt::format(
                                     " (element {} uses node {}; highest id: {})",
                                     raw(id),
                                     raw(nodes[i]),
                                     mesh_.node_ids.empty() ? 0 : raw(mesh_.node_ids.back())
                                 );
            },
            "elements use nodes that no input defines and are left out. Is a node list or an include file "
            "missing?"
        );
        return false;
    }
    return true;
}

bool MeshBuilder::resolve_plain(std::span<const NodeId> nodes, const ElementRow& row) {
    if (nodes.size() != row.node_count) return false;
    unsigned odd = 0;  // Counted: a branch each would cost more.
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        resolved_[i] = (*lookup_)(nodes[i]);
        odd += resolved_[i] == kNoNode;
    }
    // A node 0 may exist, but as a mid-side node it is one that is left out.
    for (std::size_t i = row.corner_count; i < nodes.size(); ++i) odd += nodes[i] == NodeId{0};
    return odd == 0 && (row.dimension < 2 || all_differ(std::span(resolved_).first(row.corner_count)));
}

ElementBlock& MeshBuilder::block_of(ElementType type) {
    int& index = block_by_type_[static_cast<std::size_t>(type)];
    if (index < 0) {
        std::size_t expected = expected_elements_;
        for (const ElementBlock& block : mesh_.blocks) expected -= std::min(expected, block.ids.size());
        index = static_cast<int>(mesh_.blocks.size());
        ElementBlock& block = mesh_.blocks.emplace_back();
        block.type = type;
        reserve_big(block.ids, expected);
        reserve_big(block.parts, expected);
        reserve_big(block.nodes, expected * element_row(type).node_count);
    }
    return mesh_.blocks[static_cast<std::size_t>(index)];
}

void MeshBuilder::add_element(
    ElementId id, ElementType type, std::span<const NodeId> nodes, PartIndex part, const Where& where
) {
    assert(lookup_ && "seal_nodes() first");
    const ElementRow* row = &element_row(type);
    assert(nodes.size() >= row->corner_count && nodes.size() <= row->node_count);
    if (resolve_plain(nodes, *row)) {
        ElementBlock& block = block_of(type);
        block.ids.push_back(id);
        block.parts.push_back(part);
        const auto first = resolved_.begin();
        block.nodes.insert(block.nodes.end(), first, first + row->node_count);
        return;
    }
    resolved_.fill(kNoNode);
    if (!resolve(nodes, row->corner_count, id, where)) return;

    std::span<const NodeIndex> found = std::span(resolved_).first(row->node_count);
    const auto collapsed = collapse(type, found);
    if (collapsed) {
        type = collapsed->type;
        row = &element_row(type);
        std::ranges::copy(collapsed->nodes, resolved_.begin());
        found = std::span(resolved_).first(row->node_count);
        diagnostics_->add(
            Code::DegenerateElement,
            where,
            fmt::format("elements that repeat nodes were read as {}", row->name)
        );
    }
    if (row->order == 2) {
        const auto middles = found.subspan(row->corner_count);
        const auto missing = std::ranges::count(middles, kNoNode);
        if (missing == std::ssize(middles)) {
            type = row->linear;
            row = &element_row(type);
            found = found.first(row->node_count);
        } else if (missing > 0) {
            diagnostics_->add(
                Code::MissingMidside,
                where,
                "mid-side nodes are left out; these edges are straight",
                static_cast<std::uint64_t>(missing)
            );
        }
    }
    ElementBlock& block = block_of(type);
    block.ids.push_back(id);
    block.parts.push_back(part);
    block.nodes.insert(block.nodes.end(), found.begin(), found.end());
}

void MeshBuilder::add_whole_elements(
    ElementType type, PartIndex part, std::span<const ElementId> ids, std::span<const NodeIndex> found
) {
    assert(lookup_ && "seal_nodes() first");
    assert(found.size() == ids.size() * element_row(type).node_count);
    ElementBlock& block = block_of(type);
    block.ids.insert(block.ids.end(), ids.begin(), ids.end());
    block.parts.insert(block.parts.end(), ids.size(), part);
    block.nodes.insert(block.nodes.end(), found.begin(), found.end());
}

void MeshBuilder::add_whole_elements(
    ElementType type,
    std::vector<PartIndex>&& parts,
    std::vector<ElementId>&& ids,
    std::vector<NodeIndex>&& found
) {
    assert(lookup_ && "seal_nodes() first");
    assert(found.size() == ids.size() * element_row(type).node_count && parts.size() == ids.size());
    int& index = block_by_type_[static_cast<std::size_t>(type)];
    if (index < 0) {
        index = static_cast<int>(mesh_.blocks.size());
        mesh_.blocks.push_back({type, std::move(ids), std::move(parts), std::move(found)});
        return;
    }
    ElementBlock& block = mesh_.blocks[static_cast<std::size_t>(index)];
    block.ids.insert(block.ids.end(), ids.begin(), ids.end());
    block.parts.insert(block.parts.end(), parts.begin(), parts.end());
    block.nodes.insert(block.nodes.end(), found.begin(), found.end());
}

void MeshBuilder::skip_element(std::string_view type_name, std::uint64_t count) {
    mesh_.skipped_elements[std::string(type_name)] += count;
}

void MeshBuilder::add_node_set(std::string name, std::span<const NodeId> nodes) {
    NodeSet set{std::move(name), {}};
    for (const NodeId id : nodes) {
        if (const NodeIndex index = (*lookup_)(id); index != kNoNode) set.nodes.push_back(index);
    }
    mesh_.node_sets.push_back(std::move(set));
}

Mesh MeshBuilder::finish() {
    if (!lookup_) seal_nodes();
    for (const auto& [name, count] : mesh_.skipped_elements) {
        diagnostics_->add(
            Code::SkippedElement,
            std::string(),
            fmt::format("{} elements are left out: they have no surface of their own", name),
            count
        );
    }
    lookup_.reset();
    part_by_name_.clear();
    has_angles_ = false;
    expected_elements_ = 0;
    return std::exchange(mesh_, {});
}

}  // namespace feelem
