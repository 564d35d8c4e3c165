// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/bulk_names.hpp"

#include "base/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace feelem::nastran {
namespace {

/// Cards that start with P and are no property of an element that is drawn.
constexpr std::array<std::string_view, 22> kOtherCards{
    "PACABS", "PACBAR", "PACINF", "PAERO1", "PARAM", "PBUSH", "PBUSH1D", "PBUSHT", "PCONV", "PCONVM", "PDAMP",
    "PDAMP5", "PDAMPT", "PELAS",  "PELAST", "PGAP",  "PHBDY", "PLY",     "PMASS",  "PSET",  "PVAL",   "PVISC",
};
static_assert(std::ranges::is_sorted(kOtherCards));

/// The text between the first two double quotes; `rest` is what follows.
std::string_view quoted(std::string_view text, std::string_view& rest) {
    const std::size_t first = text.find('"');
    if (first == std::string_view::npos) return {};
    const std::size_t last = text.find('"', first + 1);
    if (last == std::string_view::npos) return {};
    rest = text.substr(last + 1);
    return trim(text.substr(first + 1, last - first - 1));
}

/// Digits at the start of a text, after blanks.
std::optional<std::int64_t> leading_integer(std::string_view text) {
    text = trim(text);
    return parse_integer(text.substr(0, text.find_first_not_of("0123456789")));
}

std::string_view after(std::string_view text, std::string_view what) {
    const std::size_t at = text.find(what);
    return at == std::string_view::npos ? std::string_view{} : text.substr(at + what.size());
}

}  // namespace

bool is_property_card(std::string_view name) {
    return name.starts_with('P') && !name.starts_with("PLOAD") && !name.starts_with("PLOT") &&
           !std::ranges::binary_search(kOtherCards, name);
}

void DeckNames::add_comment(std::string_view comment) {
    std::string_view rest;
    if (comment.starts_with("$HMNAME PROP") || comment.starts_with("$HMNAME COMP")) {
        const std::string_view name = quoted(comment, rest);
        const auto own = leading_integer(comment.substr(12));
        const auto property = comment[8] == 'C' ? leading_integer(rest) : own;
        if (name.empty() || !own) return;
        auto& names = comment[8] == 'C' ? components_ : names_;
        names.emplace(property.value_or(*own), name);
    } else if (comment.starts_with("$HMSET ")) {
        const std::string_view name = quoted(comment, rest);
        if (const auto id = leading_integer(comment.substr(7)); id && !name.empty()) sets_.emplace(*id, name);
    } else if (comment.starts_with("$ Pset:")) {
        const std::string_view name = quoted(comment, rest);
        const std::string_view target = quoted(rest, rest);
        const auto id = leading_integer(after(target, "."));
        // Patran's own default names say no more than the card.
        if (id && !name.empty() && name != target) names_.emplace(*id, name);
    } else if (comment.starts_with("$ANSA_NAME_COMMENT;")) {
        const std::string_view fields = after(comment, ";");
        const auto id = leading_integer(fields);
        const std::string_view kind = after(fields, ";");
        const std::string_view name = after(kind, ";");
        if (id && kind.starts_with('P')) names_.emplace(*id, trim(name.substr(0, name.find(';'))));
    } else if (comment.starts_with("$ Femap")) {
        const std::string_view property = after(comment, "Property ");
        const auto id = leading_integer(property);
        const std::string_view name = trim(after(property, ":"));
        if (id && !name.empty()) names_.emplace(*id, name);
    } else if (comment.starts_with("$*")) {
        pending_ = trim(after(comment, "roperty:"));
    }
}

void DeckNames::add_card(std::string_view card, std::int64_t id) {
    kinds_.emplace(id, card);
    if (!pending_.empty()) names_.emplace(id, std::move(pending_));
    pending_.clear();
}

std::string DeckNames::set_name(std::int64_t id) const {
    const auto found = sets_.find(id);
    return found != sets_.end() ? found->second : fmt::format("set {}", id);
}

std::string DeckNames::part_name(std::int64_t id) const {
    const auto kind = kinds_.find(id);
    const std::string number = fmt::format("{} {}", kind == kinds_.end() ? "property" : kind->second, id);
    for (const auto* names : {&names_, &components_}) {
        const auto found = names->find(id);
        if (found != names->end() && !found->second.empty())
            return fmt::format("{} ({})", found->second, number);
    }
    return number;
}

}  // namespace feelem::nastran
