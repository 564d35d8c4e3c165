// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/flat_scopes.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace feelem::abaqus {
namespace {

constexpr std::int64_t kLeastOffset = 1'000'000;
constexpr std::uint64_t kMostInstanced = 20'000'000;

void sort_unique(std::vector<Label>& ids) {
    if (std::ranges::adjacent_find(ids, std::ranges::greater_equal{}) == ids.end()) return;
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void collect_ids(FlatScope& scope) {
    for (const Scope* table : scope.tables) {
        scope.node_ids.insert(scope.node_ids.end(), table->node_ids.begin(), table->node_ids.end());
        for (const ElementRun& run : table->runs)
            scope.element_ids.insert(scope.element_ids.end(), run.ids.begin(), run.ids.end());
    }
    sort_unique(scope.node_ids);
    sort_unique(scope.element_ids);
}

std::uint64_t rows_of(const Scope& scope) {
    std::uint64_t rows = scope.node_ids.size();
    for (const ElementRun& run : scope.runs) rows += run.ids.size();
    return rows;
}

bool repeats(const std::vector<FlatScope>& scopes, std::vector<Label> FlatScope::*ids) {
    std::vector<Label> all;
    for (const FlatScope& scope : scopes) all.insert(all.end(), (scope.*ids).begin(), (scope.*ids).end());
    std::ranges::sort(all);
    return std::ranges::adjacent_find(all) != all.end();
}

std::string offset_text(const std::vector<FlatScope>& scopes, std::int64_t step) {
    std::string text = fmt::format(
        "instances repeat node or element ids, so those of the second instance are moved by {0}, of the "
        "third by twice that, and so on:",
        step
    );
    constexpr std::size_t kMostNames = 20;
    for (std::size_t i = 0; i < std::min(scopes.size(), kMostNames); ++i) {
        const std::string& name = scopes[i].name;
        text +=
            fmt::format("{} {} +{}", i == 0 ? "" : ",", name.empty() ? "assembly" : name, scopes[i].offset);
    }
    if (scopes.size() > kMostNames) text += fmt::format(", and {} more", scopes.size() - kMostNames);
    return text + fmt::format(" (node {} is node 12 of {})", 12 + step, scopes[1].name);
}

}  // namespace

std::vector<FlatScope> flatten(const Deck& deck, const DeckModel& model, Diagnostics& diagnostics) {
    std::vector<FlatScope> scopes;
    if (!model.model.empty() || model.parts.empty())
        scopes.push_back({"", "", {&model.model}, {}, 0, {}, {}});
    // CalculiX does not know instances: there a part is simply there.
    for (const auto& [key, part] : model.parts) {
        if (model.instances.empty() && !part.empty()) scopes.push_back({key, key, {&part}, {}, 0, {}, {}});
    }
    std::uint64_t rows = 0;
    for (const Instance& instance : model.instances) {
        FlatScope scope{instance.name, folded(instance.name), {&instance.own}, instance.placement, 0, {}, {}};
        const auto part = model.parts.find(instance.part);
        if (part != model.parts.end()) {
            scope.tables.push_back(&part->second);
            rows += rows_of(part->second);
        } else if (instance.own.empty()) {
            diagnostics.add(
                Code::UnknownBlock,
                deck.files.front().name(),
                fmt::format("instances of part \"{}\" are empty: no *PART has that name", instance.part)
            );
        }
        if (rows > kMostInstanced) {
            throw Error(
                Code::TooLarge,
                deck.files.front().name(),
                fmt::format("instances of parts make more than {} nodes and elements", kMostInstanced)
            );
        }
        scopes.push_back(std::move(scope));
    }
    // Its sets may name nodes of instances, so it is there even without nodes of its own.
    if (!model.instances.empty()) scopes.push_back({"", "", {&model.assembly}, {}, 0, {}, {}});
    for (FlatScope& scope : scopes) collect_ids(scope);
    return scopes;
}

void offset_ids(std::vector<FlatScope>& scopes, Diagnostics& diagnostics) {
    if (scopes.size() < 2) return;
    if (!repeats(scopes, &FlatScope::node_ids) && !repeats(scopes, &FlatScope::element_ids)) return;
    std::int64_t step = kLeastOffset;
    for (const FlatScope& scope : scopes) {
        const Label last_node = scope.node_ids.empty() ? 0 : scope.node_ids.back();
        const Label last_element = scope.element_ids.empty() ? 0 : scope.element_ids.back();
        while (std::max(last_node, last_element) >= step) step *= 10;
    }
    for (std::size_t i = 0; i < scopes.size(); ++i) scopes[i].offset = static_cast<std::int64_t>(i) * step;
    diagnostics.add(Code::IdsOffset, std::string(), offset_text(scopes, step));
}

std::size_t SetMembers::scope_of(std::size_t at, const std::string& instance) const {
    if (instance.empty()) return at;
    const auto found = std::ranges::find(scopes_, instance, &FlatScope::key);
    return static_cast<std::size_t>(found - scopes_.begin());
}

}  // namespace feelem::abaqus
