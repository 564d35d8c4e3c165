// SPDX-License-Identifier: Apache-2.0
// Must: be exact, and find out why owners do not agree. Assumes: see the header.
// Algorithm: a hash table (node_buckets.hpp) of the first candidate of each facet, with the number and sum of
// its owners; one owner is outer, two that add up to 0 are inner, all others are looked at one by one. Then
// quads whose place is taken by two triangles. Data: 12 bytes a candidate and the table.
#include "skin/facet_match.hpp"

#include "skin/element_checks.hpp"
#include "skin/facet_hash.hpp"
#include "skin/node_buckets.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace feelem {
namespace {

std::uint32_t hash_of(const FacetKey& key) noexcept {
    using namespace facet_hash;
    return static_cast<std::uint32_t>(
        fold(pair(raw(key[1]), raw(key[2])) ^ kPair, raw(key[3]) ^ kTriangle) >> 32U
    );
}

struct CandidateSlot {
    std::uint32_t entry = 0;  ///< Candidate + 1.
};

/// What the candidates with the same corners have in common, kept at the first of them.
struct Group {
    std::uint32_t owners = 0;
    std::uint64_t sum = 0;

    bool is_outer() const { return owners == 1; }
    bool is_inner() const { return owners == 2 && sum == 0; }
};

struct Groups {
    std::vector<std::uint32_t> first;  ///< Per candidate: the first one with its corners.
    std::vector<Group> at;             ///< Per candidate; filled at the first ones.
};

Groups group(std::span<const FacetCandidate> candidates) {
    Groups groups;
    groups.first.resize(candidates.size());
    groups.at.resize(candidates.size());
    NodeIndex last{0};
    for (const FacetCandidate& candidate : candidates) last = std::max(last, candidate.key[0]);
    NodeRanks ranks(std::size_t{raw(last)} + 1);
    for (const FacetCandidate& candidate : candidates) ranks.mark(candidate.key[0]);
    ranks.seal();
    NodeBuckets<CandidateSlot> buckets(ranks.count());
    for (const FacetCandidate& candidate : candidates) buckets.count(ranks(candidate.key[0]));
    buckets.seal();
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
        const FacetKey& key = candidates[i].key;
        CandidateSlot& slot = buckets.slot(ranks(key[0]), hash_of(key), [&](const CandidateSlot& there) {
            return candidates[there.entry - 1].key == key;
        });
        if (slot.entry == 0) slot.entry = i + 1;
        groups.first[i] = slot.entry - 1;
        Group& mine = groups.at[groups.first[i]];
        ++mine.owners;
        mine.sum += candidates[i].hash;
    }
    return groups;
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
    if (facet_hash::of(first).value + facet_hash::of(second).value != 0) found.same_winding = true;
    return false;
}

/// Decides on the groups that are neither outer nor inner: flags, per candidate, those that are kept.
std::vector<bool> judge_all(
    const Mesh& mesh, std::span<const FacetCandidate> candidates, const Groups& groups, OuterFacets& found
) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> special;  // (first, candidate)
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
        const Group& mine = groups.at[groups.first[i]];
        if (!mine.is_outer() && !mine.is_inner()) special.emplace_back(groups.first[i], i);
    }
    std::vector<bool> kept;
    if (special.empty()) return kept;
    kept.resize(candidates.size());
    std::ranges::sort(special);
    std::vector<FacetRef> owners;
    for (std::size_t i = 0; i < special.size() && !found.duplicates;) {
        owners.clear();
        std::size_t end = i;
        for (; end < special.size() && special[end].first == special[i].first; ++end)
            owners.push_back(candidates[special[end].second].ref);
        if (judge(mesh, owners, found)) {
            for (std::size_t k = i; k < end; ++k) kept[special[k].second] = true;
        }
        i = end;
    }
    return kept;
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

/// Quads that two outer triangles with the same corners lie against.
std::uint64_t count_quads_facing_triangles(const Mesh& mesh, const OuterFacets& found) {
    std::vector<FacetKey> triangles;
    bool has_quads = false;
    for (const FacetRef ref : found.outer) {
        const Outline outline = outline_of(mesh, ref);
        if (outline.count == 3) triangles.push_back(sorted_corners(outline));
        has_quads = has_quads || outline.count == 4;
    }
    if (triangles.empty() || !has_quads) return 0;
    const TriangleSet set(std::move(triangles));
    std::uint64_t count = 0;
    for (const FacetRef ref : found.outer) {
        const Outline outline = outline_of(mesh, ref);
        if (outline.count != 4) continue;
        const auto& [a, b, c, d] = outline.corners;
        if ((set.has(a, b, c) && set.has(a, c, d)) || (set.has(a, b, d) && set.has(b, c, d))) ++count;
    }
    return count;
}

}  // namespace

FacetKey sorted_corners(const Outline& outline) noexcept {
    FacetKey key = outline.corners;
    std::ranges::sort(key);
    return key;
}

void match_facets(const Mesh& mesh, std::span<const FacetCandidate> candidates, OuterFacets& found) {
    const Groups groups = group(candidates);
    const std::vector<bool> kept = judge_all(mesh, candidates, groups, found);
    if (found.duplicates) return;
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
        if (groups.at[groups.first[i]].is_outer() || (!kept.empty() && kept[i]))
            found.outer.push_back(candidates[i].ref);
    }
    // A quad and the two triangles before it are three facets.
    found.unmatched += 3 * count_quads_facing_triangles(mesh, found);
}

}  // namespace feelem
