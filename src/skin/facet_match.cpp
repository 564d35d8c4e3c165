// SPDX-License-Identifier: Apache-2.0
// Must: be exact, and find out why owners do not agree. Assumes: see the header.
// Algorithm: a table of the facets with their first owners; a second owner that has the same nodes the other
// way round makes the facet an inner one, any other makes it special, and these are looked at one by one. A
// facet stands in the line of memory of its smallest corner, since neighbours' facets are asked for together;
// lines that are full spill into an ordinary hash table. Data: 64 bytes a smallest corner.
#include "skin/facet_match.hpp"

#include "base/huge_pages.hpp"
#include "skin/element_checks.hpp"
#include "skin/facet_hash.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace feelem {
namespace {

/// Corners in ascending order; a triangle's fourth is kNoNode.
using FacetKey = std::array<NodeIndex, 4>;
FacetKey sorted_corners(const Outline& outline) noexcept {
    FacetKey key = outline.corners;
    std::ranges::sort(key);
    return key;
}

/// Whether facet b, of as many corners, runs through the nodes of facet a backwards, as their elements list
/// them.
template <std::size_t kCorners>
bool is_mirrored(
    const FacetRow& row_a, const NodeIndex* a, const FacetRow& row_b, const NodeIndex* b, bool quadratic
) {
    std::size_t start = 0;
    while (start < kCorners && b[row_b.nodes[start]] != a[row_a.nodes[0]]) ++start;
    if (start == kCorners) return false;
    for (std::size_t i = 1; i < kCorners; ++i) {
        if (a[row_a.nodes[i]] != b[row_b.nodes[(start + kCorners - i) % kCorners]]) return false;
    }
    if (!quadratic) return true;
    for (std::size_t i = 0; i < kCorners; ++i) {
        // Side i runs from corner start - i to the one before it.
        const std::size_t side = (start + 2 * kCorners - i - 1) % kCorners;
        if (a[row_a.nodes[kCorners + i]] != b[row_b.nodes[kCorners + side]]) return false;
    }
    return true;
}

bool is_reversed(const Outline& a, const Outline& b) {
    if (a.count != b.count) return false;
    std::size_t start = 0;
    while (start < b.count && b.corners[start] != a.corners[0]) ++start;
    for (std::size_t i = 0; i < a.count; ++i) {
        if (a.corners[i] != b.corners[(start + b.count - i) % b.count]) return false;
    }
    return true;
}

/// Whether two of the owners are different elements with the same corners.
bool has_duplicates(const Mesh& mesh, std::span<const FacetRef> owners) {
    struct Owner {
        CornerSet corners;
        FacetRef ref;
    };
    std::vector<Owner> sorted;
    sorted.reserve(owners.size());
    for (const FacetRef ref : owners)
        sorted.push_back({corner_set(mesh.blocks[ref.block], ref.position), ref});
    std::ranges::sort(sorted, [](const Owner& a, const Owner& b) {
        return std::tie(a.corners, a.ref.block, a.ref.position) <
               std::tie(b.corners, b.ref.block, b.ref.position);
    });
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const Owner &a = sorted[i - 1], &b = sorted[i];
        if (a.corners == b.corners && (a.ref.block != b.ref.block || a.ref.position != b.ref.position))
            return true;
    }
    return false;
}

/// Owners that do not cancel. Returns whether they are kept.
bool judge(const Mesh& mesh, std::span<const FacetRef> owners, OuterFacets& found) {
    if (has_duplicates(mesh, owners)) {
        found.duplicates = true;
        return false;
    }
    if (owners.size() > 2) {
        found.many_owners += owners.size();
        return false;
    }
    const Outline first = outline_of(mesh, owners[0]);
    const Outline second = outline_of(mesh, owners[1]);
    if (!same_middles(first, second)) {
        found.unmatched += 2;
        return true;
    }
    found.same_winding = true;
    return false;
}

/// Of an outer facet.
bool has_three_corners(const Mesh& mesh, FacetRef ref, bool may_repeat) {
    const FacetRow& row = facets_of(mesh.blocks[ref.block].type)[ref.facet];
    if (row.type == ElementType::Tri3 || row.type == ElementType::Tri6) return true;
    return may_repeat && outline_of(mesh, ref).count == 3;
}

/// Corners of outer triangles, to be asked for.
class TriangleSet {
public:
    explicit TriangleSet(std::vector<FacetKey> keys) : keys_(std::move(keys)) { std::ranges::sort(keys_); }
    bool has(NodeIndex a, NodeIndex b, NodeIndex c) const {
        FacetKey key{a, b, c, kNoNode};
        std::ranges::sort(key);
        return std::ranges::binary_search(keys_, key);
    }

private:
    std::vector<FacetKey> keys_;
};

}  // namespace

FacetTable::FacetTable(const Mesh& mesh, std::size_t buckets, std::span<std::uint8_t> outer_bits)
    : mesh_(mesh), buckets_(buckets), spill_(64), outer_bits_(outer_bits) {
    std::size_t elements = 0;
    for (const ElementBlock& block : mesh.blocks) {
        blocks_.push_back(
            {elements, block.nodes.data(), element_row(block.type).node_count, facets_of(block.type)}
        );
        elements += block.ids.size();
    }
}

FacetTable::Meeting FacetTable::meeting_of(FacetRef a, FacetRef b) const {
    const Block &block_a = blocks_[a.block], &block_b = blocks_[b.block];
    const FacetRow &row_a = block_a.facets[a.facet], &row_b = block_b.facets[b.facet];
    const NodeIndex* nodes_a = block_a.nodes + a.position * block_a.width;
    const NodeIndex* nodes_b = block_b.nodes + b.position * block_b.width;
    if (row_a.type == row_b.type) {
        const bool is_triangle = row_a.type == ElementType::Tri3 || row_a.type == ElementType::Tri6;
        const bool is_quadratic = row_a.type != ElementType::Tri3 && row_a.type != ElementType::Quad4;
        if (is_triangle ? is_mirrored<3>(row_a, nodes_a, row_b, nodes_b, is_quadratic)
                        : is_mirrored<4>(row_a, nodes_a, row_b, nodes_b, is_quadratic))
            return Meeting::Opposite;
    }
    const Outline first = outline_of(mesh_, a), second = outline_of(mesh_, b);
    if (sorted_corners(first) != sorted_corners(second)) return Meeting::OtherFacet;
    return is_reversed(first, second) && same_middles(first, second) ? Meeting::Opposite : Meeting::Unlike;
}

void FacetTable::grow_spill() {
    std::vector<Slot> old(spill_.size() * 2);
    old.swap(spill_);
    for (const Slot& slot : old) {
        if (slot.state == State::Free) continue;
        std::size_t at = slot.corners % spill_.size();
        while (spill_[at].state != State::Free) at = (at + 1) % spill_.size();
        spill_[at] = slot;
    }
}

/// Calls visit for the slots in which the facet may be, until it says true.
template <class Visit>
void FacetTable::visit_slots(const FacetCandidate& candidate, Visit visit) {
    for (Slot& slot : buckets_[candidate.bucket].slots) {
        ++probes_;
        if (visit(slot, false)) return;
    }
    for (std::size_t at = candidate.corners % spill_.size();; at = (at + 1) % spill_.size()) {
        ++probes_;
        if (visit(spill_[at], true)) return;
    }
}

/// Whether the slot is the candidate's facet; then what became of it.
bool FacetTable::meets(Slot& slot, const FacetCandidate& candidate) {
    if (slot.corners != candidate.corners) return false;
    const Meeting meeting = meeting_of(slot.first_owner(), candidate.ref);
    if (meeting == Meeting::OtherFacet) return false;
    const bool is_second = slot.state == State::Outer;
    if (is_second) set_bit(slot.first_owner(), false);
    set_bit(candidate.ref, false);
    if (slot.state != State::Special) {
        slot.state = is_second && meeting == Meeting::Opposite ? State::Inner : State::Special;
        specials_ += slot.state == State::Special ? 1U : 0U;
    }
    return true;
}

void FacetTable::add(const FacetCandidate& candidate) {
    visit_slots(candidate, [&](Slot& slot, bool is_spill) {
        if (slot.state != State::Free) return meets(slot, candidate);
        slot = {
            candidate.corners,
            candidate.ref.position,
            candidate.ref.block,
            candidate.ref.facet,
            State::Outer};
        spilled_ += is_spill ? 1U : 0U;
        set_bit(candidate.ref, true);
        return true;
    });
    if (spilled_ * 2 >= spill_.size()) grow_spill();
}

std::uint64_t FacetTable::special_place(const FacetCandidate& candidate) {
    std::uint64_t place = kNotSpecial;
    visit_slots(candidate, [&](const Slot& slot, bool is_spill) {
        if (slot.state == State::Free) return true;
        if (slot.corners != candidate.corners ||
            meeting_of(slot.first_owner(), candidate.ref) == Meeting::OtherFacet)
            return false;
        if (slot.state == State::Special) {
            place = is_spill ? buckets_.size() * 4 + static_cast<std::size_t>(&slot - spill_.data())
                             : std::size_t{candidate.bucket} * 4 +
                                   static_cast<std::size_t>(&slot - buckets_[candidate.bucket].slots.data());
        }
        return true;
    });
    return place;
}

void FacetTable::judge_specials(std::vector<SpecialOwner> owners, OuterFacets& found) {
    std::ranges::stable_sort(owners, {}, &SpecialOwner::place);
    std::vector<FacetRef> here;
    for (std::size_t i = 0; i < owners.size() && !found.duplicates;) {
        here.clear();
        std::size_t end = i;
        for (; end < owners.size() && owners[end].place == owners[i].place; ++end)
            here.push_back(owners[end].ref);
        if (judge(mesh_, here, found)) {
            for (const FacetRef ref : here) set_bit(ref, true);
        }
        i = end;
    }
}

std::uint64_t count_quads_facing_triangles(
    const Mesh& mesh, std::span<const FacetRef> outer, bool may_repeat
) {
    const bool has_triangles =
        may_repeat || std::ranges::any_of(mesh.blocks, [](const ElementBlock& block) {
            return element_row(block.type).dimension == 3 && block.type != ElementType::Hex8 &&
                   block.type != ElementType::Hex20 && block.type != ElementType::Hex27;
        });
    if (!has_triangles) return 0;
    const auto is_triangle = [&](FacetRef ref) { return has_three_corners(mesh, ref, may_repeat); };
    const auto triangle_count = static_cast<std::size_t>(std::ranges::count_if(outer, is_triangle));
    if (triangle_count == 0 || triangle_count == outer.size()) return 0;
    std::vector<FacetKey> triangles;
    triangles.reserve(triangle_count);
    std::vector<bool> at_triangles(mesh.node_count());
    for (const FacetRef ref : outer) {
        if (!is_triangle(ref)) continue;
        const Outline outline = outline_of(mesh, ref);
        for (const NodeIndex corner : std::span(outline.corners).first(3)) at_triangles[raw(corner)] = true;
        triangles.push_back(sorted_corners(outline));
    }
    const TriangleSet set(std::move(triangles));
    std::uint64_t count = 0;
    for (const FacetRef ref : outer) {
        if (is_triangle(ref)) continue;
        const Outline outline = outline_of(mesh, ref);
        const auto& [a, b, c, d] = outline.corners;
        if (!at_triangles[raw(a)] || !at_triangles[raw(b)] || !at_triangles[raw(c)] || !at_triangles[raw(d)])
            continue;
        if ((set.has(a, b, c) && set.has(a, c, d)) || (set.has(a, b, d) && set.has(b, c, d))) ++count;
    }
    return count;
}

}  // namespace feelem
