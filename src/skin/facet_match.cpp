// SPDX-License-Identifier: Apache-2.0
// Must: be exact, and find out why owners do not agree. Assumes: see the header.
// Algorithm: a table of the facets with their first owners; a second owner that has the same nodes the other
// way round makes the facet an inner one, any other makes it special, and these are looked at one by one. A
// facet stands in the line of memory of its smallest corner, since neighbours' facets are asked for together;
// lines that are full spill into an ordinary hash table. Data: 64 bytes a smallest corner, 1 byte an element.
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

enum class Meeting : std::uint8_t {
    OtherFacet,
    Opposite,  ///< The same nodes, the other way round.
    Unlike,    ///< The same corners.
};

/// The same nodes in opposite order, as the elements list them.
bool is_mirrored(
    const FacetRow& row_a, std::span<const NodeIndex> a, const FacetRow& row_b, std::span<const NodeIndex> b
) {
    if (row_a.type != row_b.type) return false;
    const ElementRow& shape = element_row(row_a.type);
    const std::size_t count = shape.corner_count;
    std::size_t start = 0;
    while (start < count && b[row_b.nodes[start]] != a[row_a.nodes[0]]) ++start;
    if (start == count) return false;
    for (std::size_t i = 0; i < count; ++i) {
        // Corner start - i; the side after i lies between start - i - 1 and start - i.
        const std::size_t corner = start >= i ? start - i : start + count - i;
        const std::size_t side = corner == 0 ? count - 1 : corner - 1;
        if (a[row_a.nodes[i]] != b[row_b.nodes[corner]]) return false;
        if (shape.order == 2 && a[row_a.nodes[count + i]] != b[row_b.nodes[count + side]]) return false;
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

Meeting meeting_of(const Mesh& mesh, FacetRef a, FacetRef b) {
    const FacetRow& row_a = facets_of(mesh.blocks[a.block].type)[a.facet];
    const FacetRow& row_b = facets_of(mesh.blocks[b.block].type)[b.facet];
    if (is_mirrored(row_a, element_nodes(mesh, a), row_b, element_nodes(mesh, b))) return Meeting::Opposite;
    const Outline first = outline_of(mesh, a), second = outline_of(mesh, b);
    if (sorted_corners(first) != sorted_corners(second)) return Meeting::OtherFacet;
    return is_reversed(first, second) && same_middles(first, second) ? Meeting::Opposite : Meeting::Unlike;
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
bool has_three_corners(const Mesh& mesh, FacetRef ref) {
    const auto corners = facet_corners(facets_of(mesh.blocks[ref.block].type)[ref.facet]);
    if (corners.size() == 3) return true;
    const auto nodes = element_nodes(mesh, ref);
    for (std::size_t i = 0; i < 4; ++i) {
        if (nodes[corners[i]] == nodes[corners[(i + 1) % 4]]) return true;
    }
    return false;
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

FacetTable::FacetTable(const Mesh& mesh, std::size_t buckets) : mesh_(mesh), spill_(64) {
    std::size_t elements = 0;
    for (const ElementBlock& block : mesh.blocks) {
        block_first_.push_back(elements);
        elements += block.ids.size();
    }
    outer_bits_ = big_zeros<std::uint8_t>(elements);
    buckets_ = big_zeros<Bucket>(buckets);
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
        if (visit(slot, false)) return;
    }
    for (std::size_t at = candidate.corners % spill_.size();; at = (at + 1) % spill_.size()) {
        if (visit(spill_[at], true)) return;
    }
}

/// Whether the slot is the candidate's facet; then what became of it.
bool FacetTable::meets(Slot& slot, const FacetCandidate& candidate) {
    if (slot.corners != candidate.corners) return false;
    const Meeting meeting = meeting_of(mesh_, slot.first_owner(), candidate.ref);
    if (meeting == Meeting::OtherFacet) return false;
    const bool is_second = slot.state == State::Outer;
    if (is_second) {
        flip_bit(slot.first_owner());
        --outer_;
    }
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
        flip_bit(candidate.ref);
        ++outer_;
        return true;
    });
    if (spilled_ * 2 >= spill_.size()) grow_spill();
}

std::uint64_t FacetTable::special_place(const FacetCandidate& candidate) {
    std::uint64_t place = kNotSpecial;
    visit_slots(candidate, [&](const Slot& slot, bool is_spill) {
        if (slot.state == State::Free) return true;
        if (slot.corners != candidate.corners ||
            meeting_of(mesh_, slot.first_owner(), candidate.ref) == Meeting::OtherFacet)
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
            for (const FacetRef ref : here) flip_bit(ref);
            outer_ += here.size();
        }
        i = end;
    }
}

std::uint64_t count_quads_facing_triangles(const Mesh& mesh, std::span<const FacetRef> outer) {
    const auto is_triangle = [&](FacetRef ref) { return has_three_corners(mesh, ref); };
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
