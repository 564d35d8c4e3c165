// SPDX-License-Identifier: Apache-2.0
// The scopes whose nodes and elements become the mesh: the model itself, each instance, the assembly.
#pragma once

#include "read/abaqus/deck_model.hpp"

#include "feelem/ids.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace feelem::abaqus {

struct FlatScope {
    std::string name;                  ///< Of the instance, as written; empty: model or assembly.
    std::string key;                   ///< The same, folded.
    std::vector<const Scope*> tables;  ///< The instance's own definitions first, then its part's.
    Placement placement;
    std::int64_t offset = 0;
    std::vector<Label> node_ids, element_ids;  ///< Ascending, unique.

    NodeId node(Label label) const { return NodeId{label + offset}; }
    ElementId element(Label label) const { return ElementId{label + offset}; }
};

/// Throws Error(TooLarge) when instances multiply the mesh beyond reason.
std::vector<FlatScope> flatten(const Deck& deck, const DeckModel& model, Diagnostics& diagnostics);

/// Makes ids unique over all scopes, reports the offsets (IdsOffset).
void offset_ids(std::vector<FlatScope>& scopes, Diagnostics& diagnostics);

/// Finds members of sets over all scopes. Work is bounded: sets may name sets, which may name sets.
class SetMembers {
public:
    SetMembers(const std::vector<FlatScope>& scopes, bool nodes) : scopes_(scopes), nodes_(nodes) {}

    /// Labels of the scope `at` are members; `use(scope, label)` for each, some more than once.
    template <class Use>
    void for_each(std::size_t at, const DeckSet& set, const Use& use) {
        std::vector<At> pending{{at, &set}};
        std::set<At> seen{pending.front()};
        while (!pending.empty() && budget_ > 0) {
            const auto [scope, one] = pending.back();
            pending.pop_back();
            for (const SetPiece& piece : one->pieces) {
                const std::size_t where = scope_of(scope, piece.instance);
                if (where >= scopes_.size()) continue;
                for (const LabelRange& range : piece.ranges) walk_range(where, range, use);
                for (const std::string& name : piece.sets) find_sets(where, name, pending, seen);
            }
        }
    }
    /// True: too many members, so that sets are incomplete from here on.
    bool exhausted() const noexcept { return budget_ == 0; }

private:
    using At = std::pair<std::size_t, const DeckSet*>;

    void find_sets(std::size_t at, const std::string& name, std::vector<At>& pending, std::set<At>& seen) {
        for (const Scope* table : scopes_[at].tables) {
            spend(1);
            const DeckSet* inner = (nodes_ ? table->node_sets : table->element_sets).find(name);
            if (inner != nullptr && budget_ > 0 && seen.insert({at, inner}).second)
                pending.push_back({at, inner});
        }
    }

    template <class Use>
    void walk_range(std::size_t at, const LabelRange& range, const Use& use) {
        const std::vector<Label>& ids = nodes_ ? scopes_[at].node_ids : scopes_[at].element_ids;
        auto id = std::ranges::lower_bound(ids, range.first);
        for (; id != ids.end() && *id <= range.last && budget_ > 0; ++id) {
            spend(1);
            if (range.step == 1 || (*id - range.first) % range.step == 0) use(at, *id);
        }
    }

    void spend(std::uint64_t amount) { budget_ -= std::min(amount, budget_); }
    std::size_t scope_of(std::size_t at, const std::string& instance) const;

    const std::vector<FlatScope>& scopes_;
    bool nodes_;
    std::uint64_t budget_ = std::uint64_t{1} << 28;
};

}  // namespace feelem::abaqus
