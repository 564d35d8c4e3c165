// SPDX-License-Identifier: Apache-2.0
// Whether a deck and the geometry beside the results contradict each other.
#include "read/nastran/op2_mesh.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace feelem::op2 {
namespace {

/// Element ids in ascending order with where each stands.
std::vector<std::pair<ElementId, ElementIndex>> by_id(const Mesh& mesh) {
    std::vector<std::pair<ElementId, ElementIndex>> out;
    std::uint32_t index = 0;
    for (const ElementBlock& block : mesh.blocks) {
        for (const ElementId id : block.ids) out.emplace_back(id, ElementIndex{index++});
    }
    std::ranges::sort(out);
    return out;
}

void check_same_places(const Mesh& deck, const Mesh& own, const Input& input) {
    double largest = 0;
    for (const Point3& place : deck.coordinates) {
        for (const double x : place) largest = std::isfinite(x) ? std::max(largest, std::abs(x)) : largest;
    }
    const double tolerance = 1e-5 * largest;
    for (std::size_t i = 0; i < own.node_count(); ++i) {
        const NodeIndex other = find_node(deck, own.node_ids[i]);
        if (other == kNoNode) continue;
        const Point3& a = own.coordinates[i];
        const Point3& b = deck.coordinates[raw(other)];
        for (std::size_t c = 0; c < 3; ++c) {
            if (!(std::abs(a[c] - b[c]) > tolerance)) continue;
            throw Error(
                Code::MeshesDiffer,
                input.name(),
                fmt::format(
                    "grid {} is at ({:g}, {:g}, {:g}), in the inputs before it at ({:g}, {:g}, {:g}). Are "
                    "the "
                    "files of one model?",
                    raw(own.node_ids[i]),
                    a[0],
                    a[1],
                    a[2],
                    b[0],
                    b[1],
                    b[2]
                )
            );
        }
    }
}

}  // namespace

void check_same_ids(const Mesh& deck, const Mesh& own, const Input& input) {
    check_most_are_known(deck, own.node_ids, input);
    check_same_places(deck, own, input);
    const auto theirs = by_id(deck);
    const auto same_node = [&](NodeIndex a, NodeIndex b) {
        return a == kNoNode || b == kNoNode ? a == b : own.node_ids[raw(a)] == deck.node_ids[raw(b)];
    };
    for (const auto& [id, index] : by_id(own)) {
        const auto mine = element_at(own, index).nodes();
        auto other = std::ranges::lower_bound(theirs, id, {}, &std::pair<ElementId, ElementIndex>::first);
        bool same = other == theirs.end() || other->first != id;
        for (; !same && other != theirs.end() && other->first == id; ++other)
            same = std::ranges::equal(mine, element_at(deck, other->second).nodes(), same_node);
        if (same) continue;
        throw Error(
            Code::MeshesDiffer,
            input.name(),
            fmt::format(
                "element {} has other nodes than in the inputs before it. Are the files of one model?",
                raw(id)
            )
        );
    }
}

void check_most_are_known(const Mesh& deck, std::span<const NodeId> ids, const Input& input) {
    const auto known = static_cast<std::size_t>(std::ranges::count_if(ids, [&](NodeId id) {
        return find_node(deck, id) != kNoNode;
    }));
    if (2 * known >= ids.size()) return;
    throw Error(
        Code::MeshesDiffer,
        input.name(),
        fmt::format(
            "of its {} grids the inputs before it, with {} grids, have {}. Are the files of one model?",
            ids.size(),
            deck.node_count(),
            known
        )
    );
}

}  // namespace feelem::op2
