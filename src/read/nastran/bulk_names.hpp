// SPDX-License-Identifier: Apache-2.0
// What people call properties and sets: pre-processors keep the names in comments, the cards know numbers
// only.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace feelem::nastran {

class DeckNames {
public:
    /// A comment of HyperMesh ($HMNAME), ANSA, Femap or Patran ($ Pset); or Simcenter's "$*  Property: name",
    /// which is meant for the property card that follows.
    void add_comment(std::string_view comment);
    /// A property card: the kind by which the part is named when nothing better is known.
    void add_card(std::string_view card, std::int64_t id);

    /// "wing skin (PSHELL 4)", "PSHELL 4", or "property 4" when the deck has no such card.
    std::string part_name(std::int64_t id) const;
    /// HyperMesh's name of a set, or "set 5".
    std::string set_name(std::int64_t id) const;

private:
    std::map<std::int64_t, std::string> kinds_;
    std::map<std::int64_t, std::string> names_;
    std::map<std::int64_t, std::string> components_;  ///< HyperMesh's components, by property.
    std::map<std::int64_t, std::string> sets_;
    std::string pending_;
};

/// Whether a card defines the property of elements that are drawn.
bool is_property_card(std::string_view name);

}  // namespace feelem::nastran
