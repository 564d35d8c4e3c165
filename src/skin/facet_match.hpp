// SPDX-License-Identifier: Apache-2.0
// The exact half of the search for outer facets: candidates matched by their corners.
#pragma once

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
    FacetTable(const Mesh& mesh, std::size_t buckets);

    void add(const FacetCandidate& candidate);
    std::uint64_t outer_count() const { return outer_; }
    std::uint64_t special_count() const { return specials_; }

    /// Per element of all blocks, which facets are outer: bit i for facet i.
    std::span<const std::uint8_t> outer_facets() const { return outer_bits_; }

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

    std::size_t index_of(FacetRef ref) const { return block_first_[ref.block] + ref.position; }
    void flip_bit(FacetRef ref) { outer_bits_[index_of(ref)] ^= static_cast<std::uint8_t>(1U << ref.facet); }
    bool meets(Slot& slot, const FacetCandidate& candidate);
    void grow_spill();
    template <class Visit>
    void visit_slots(const FacetCandidate& candidate, Visit visit);

    const Mesh& mesh_;
    std::vector<std::size_t> block_first_;
    std::vector<Bucket> buckets_;
    std::vector<Slot> spill_;
    std::size_t spilled_ = 0;
    std::vector<std::uint8_t> outer_bits_;
    std::uint64_t outer_ = 0, specials_ = 0;
};

/// Quads that two outer triangles with the same corners lie against.
std::uint64_t count_quads_facing_triangles(const Mesh& mesh, std::span<const FacetRef> outer);

}  // namespace feelem
