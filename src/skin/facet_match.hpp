// SPDX-License-Identifier: Apache-2.0
// The exact half of the search for outer facets: candidates matched by their corners.
#pragma once

#include "base/huge_pages.hpp"
#include "skin/facet_cancellation.hpp"
#include "skin/outline.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

struct FacetCandidate {
    std::uint64_t corners = 0;  ///< FacetHash::corners.
    std::uint32_t bucket = 0;   ///< Rank of the smallest corner.
    FacetRef ref;
};

/// Facets by their corners, with what is known of their owners. Add all owners of a facet, or none.
class FacetTable {
public:
    /// `outer_bits`: per element of all blocks, bit i for facet i: what the table says of the facets that it
    /// is given, whatever was there before.
    FacetTable(const Mesh& mesh, std::size_t buckets, std::span<std::uint8_t> outer_bits);

    void add(const FacetCandidate& candidate);
    std::uint64_t special_count() const { return specials_; }
    std::uint64_t probes() const { return probes_; }

    /// Asks memory for what add() will need.
    void fetch(const FacetCandidate& candidate) const { __builtin_prefetch(&buckets_[candidate.bucket]); }

    /// The place of a facet whose owners do not cancel (three, two the same way round, unequal middles), else
    /// kNotSpecial. When all were added.
    static constexpr std::uint64_t kNotSpecial = ~std::uint64_t{0};
    std::uint64_t special_place(const FacetCandidate& candidate);
    /// All owners of such a facet.
    struct SpecialOwner {
        std::uint64_t place = 0;
        FacetRef ref;
    };
    void judge_specials(std::vector<SpecialOwner> owners, OuterFacets& found);

private:
    enum class State : std::uint8_t {
        Free,
        Outer,
        Inner,
        Special
    };
    enum class Meeting : std::uint8_t {
        OtherFacet,
        Opposite,  ///< The same nodes, the other way round.
        Unlike,    ///< The same corners.
    };
    /// All zero: free.
    struct Slot {
        std::uint64_t corners = 0;
        std::uint32_t position = 0;  ///< Of the first owner.
        std::uint8_t block = 0;
        std::uint8_t facet = 0;
        State state = State::Free;

        FacetRef first_owner() const { return {position, block, facet}; }
    };
    /// A line of the cache; what does not fit in goes to spill_.
    struct alignas(64) Bucket {
        std::array<Slot, 4> slots;
    };

    /// What is asked of a block again and again.
    struct Block {
        std::size_t first_element;
        const NodeIndex* nodes;
        std::size_t width;
        std::span<const FacetRow> facets;
    };

    void set_bit(FacetRef ref, bool is_outer) {
        std::uint8_t& bits = outer_bits_[blocks_[ref.block].first_element + ref.position];
        const unsigned bit = 1U << ref.facet;
        bits = static_cast<std::uint8_t>((bits & ~bit) | (is_outer ? bit : 0U));
    }
    Meeting meeting_of(FacetRef a, FacetRef b) const;
    bool meets(Slot& slot, const FacetCandidate& candidate);
    void grow_spill();
    template <class Visit>
    void visit_slots(const FacetCandidate& candidate, Visit visit);

    const Mesh& mesh_;
    std::vector<Block> blocks_;
    ZeroedArray<Bucket> buckets_;
    std::vector<Slot> spill_;
    std::size_t spilled_ = 0;
    std::span<std::uint8_t> outer_bits_;
    std::uint64_t specials_ = 0, probes_ = 0;
};

/// Quads that two outer triangles with the same corners lie against. `may_repeat`: corners of elements may
/// repeat, so that a quad may be a triangle.
std::uint64_t count_quads_facing_triangles(
    const Mesh& mesh, std::span<const FacetRef> outer, bool may_repeat
);

}  // namespace feelem
