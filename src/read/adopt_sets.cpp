// SPDX-License-Identifier: Apache-2.0
#include "read/adopt_sets.hpp"

#include "base/letter_case.hpp"
#include "read/element_lookup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem {
namespace {

/// What did not go over whole, of the sets of one kind.
struct SetLosses {
    std::uint64_t members = 0, of_members = 0;  ///< Of the sets that lost some.
    std::vector<std::string> cut;               ///< Sets that lost members.
    std::vector<std::string> other;             ///< Sets that hold other members in the mesh shown.
};

/// The members of a set as indexes of the mesh shown, ascending, once each.
template <class Index>
std::vector<Index> members_shown(
    const std::vector<Index>& members, const std::vector<Index>* map, Index none, std::uint64_t& lost
) {
    std::vector<Index> out;
    out.reserve(members.size());
    for (const Index member : members) {
        const Index there = map == nullptr ? member : raw(member) < map->size() ? (*map)[raw(member)] : none;
        if (there == none)
            ++lost;
        else
            out.push_back(there);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

template <class Index>
bool holds_same(std::vector<Index> members, const std::vector<Index>& sorted) {
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members == sorted;
}

/// The map of elements, and with it solids that a solver made of shells and beams: they keep the numbers.
std::vector<ElementIndex> elements_shown(const Mesh& other, const MeshMap& map, const Mesh& shown) {
    std::vector<ElementIndex> places = map.elements;
    if (map.thickened == 0 || other.element_sets.empty()) return places;
    const ElementLookup lookup(shown);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        if (places[i] == kNoElement) places[i] = lookup(element_at(other, ElementIndex{i}).id());
    }
    return places;
}

/// `members_of`: the member of a set that holds its nodes or elements.
template <class Set, class Index>
SetLosses adopt_kind(
    const std::vector<Set>& sets,
    const std::vector<Index>* map,
    Index none,
    std::vector<Index> Set::*members_of,
    std::vector<Set>& shown
) {
    SetLosses losses;
    std::map<std::string, std::size_t> by_name;
    for (std::size_t i = 0; i < shown.size(); ++i) by_name.emplace(lower_case(shown[i].name), i);
    for (const Set& set : sets) {
        std::uint64_t lost = 0;
        std::vector<Index> members = members_shown(set.*members_of, map, none, lost);
        if (lost > 0) {
            losses.members += lost;
            losses.of_members += (set.*members_of).size();
            losses.cut.push_back(set.name);
        }
        const auto known = by_name.find(lower_case(set.name));
        if (known != by_name.end()) {
            if (!holds_same(shown[known->second].*members_of, members)) losses.other.push_back(set.name);
            continue;
        }
        if (members.empty() && lost > 0) continue;
        by_name.emplace(lower_case(set.name), shown.size());
        shown.push_back({set.name, std::move(members)});
    }
    return losses;
}

void tell_losses(
    const SetLosses& losses, std::string_view what, const std::string& name, Diagnostics& diagnostics
) {
    constexpr std::size_t kMostSetsNamed = 5;
    const auto names = [&](const std::vector<std::string>& sets) {
        const std::size_t shown = std::min(sets.size(), kMostSetsNamed);
        return fmt::format(
            "{}{}",
            fmt::join(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
            shown < sets.size() ? " ..." : ""
        );
    };
    if (!losses.cut.empty()) {
        diagnostics.add(
            Code::SourcesDisagree,
            name,
            fmt::format(
                "sets lose {} of {} {}, which are not in the mesh shown: {}",
                losses.members,
                losses.of_members,
                what,
                names(losses.cut)
            ),
            losses.cut.size()
        );
    }
    if (!losses.other.empty()) {
        diagnostics.add(
            Code::SourcesDisagree,
            name,
            fmt::format(
                "sets hold other {} than those of the same name in the mesh shown, which stay: {}",
                what,
                names(losses.other)
            ),
            losses.other.size()
        );
    }
}

}  // namespace

void adopt_sets(
    const Mesh& other, const MeshMap* map, const std::string& name, Mesh& shown, Diagnostics& diagnostics
) {
    const SetLosses nodes = adopt_kind(
        other.node_sets, map == nullptr ? nullptr : &map->nodes, kNoNode, &NodeSet::nodes, shown.node_sets
    );
    const std::vector<ElementIndex> places =
        map == nullptr ? std::vector<ElementIndex>{} : elements_shown(other, *map, shown);
    const SetLosses elements = adopt_kind(
        other.element_sets,
        map == nullptr ? nullptr : &places,
        kNoElement,
        &ElementSet::elements,
        shown.element_sets
    );
    tell_losses(nodes, "nodes", name, diagnostics);
    tell_losses(elements, "elements", name, diagnostics);
}

bool share_sets(const Mesh& own, Mesh& shared) {
    std::vector<NodeSet> nodes = shared.node_sets;
    std::vector<ElementSet> elements = shared.element_sets;
    const std::vector<NodeIndex>* same_nodes = nullptr;
    const std::vector<ElementIndex>* same_elements = nullptr;
    const SetLosses of_nodes = adopt_kind(own.node_sets, same_nodes, kNoNode, &NodeSet::nodes, nodes);
    const SetLosses of_elements =
        adopt_kind(own.element_sets, same_elements, kNoElement, &ElementSet::elements, elements);
    if (!of_nodes.other.empty() || !of_elements.other.empty()) return false;
    shared.node_sets = std::move(nodes);
    shared.element_sets = std::move(elements);
    return true;
}

}  // namespace feelem
