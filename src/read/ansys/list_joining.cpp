// SPDX-License-Identifier: Apache-2.0
// Results that several listings print in turn: PRNSOL,S and PRNSOL,S,PRIN are one.
#include "read/ansys/list_results.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace feelem::ansys {
namespace {

using MomentKey = std::tuple<std::string, Layer, int, int, StepKind, double, std::string>;
MomentKey moment_of(const ListedResults& out, const ListedResult& result) {
    const Step& step = out.steps[result.info.step];
    return {result.info.name, result.info.layer, step.step, step.substep, step.kind, step.value, step.label};
}

/// Whether a result is nothing but derived components of another one.
bool belongs_to(const ListedResult& derived, const ListedResult& base) {
    const ResultInfo& a = derived.info;
    const ResultInfo& b = base.info;
    return a.location == Location::Nodal && a.unit == b.unit && a.averaging == b.averaging &&
           std::ranges::all_of(a.components, [&](const std::string& component) {
               return is_derived_component(component) && component_index(b, component) < 0;
           });
}

void join(ListedResults& out) {
    std::map<MomentKey, std::size_t> bases;
    for (std::size_t i = 0; i < out.results.size(); ++i) {
        const ResultInfo& info = out.results[i].info;
        const bool is_whole = info.shape == Shape::SymmetricTensor || info.shape == Shape::Vector;
        if (is_whole && info.location == Location::Nodal) bases.emplace(moment_of(out, out.results[i]), i);
    }
    std::vector<bool> joined(out.results.size());
    for (std::size_t i = 0; i < out.results.size(); ++i) {
        const auto found = bases.find(moment_of(out, out.results[i]));
        if (found == bases.end() || found->second == i) continue;
        ListedResult& base = out.results[found->second];
        if (!belongs_to(out.results[i], base)) continue;
        std::vector<std::string>& components = base.info.components;
        for (const std::string& component : out.results[i].info.components) components.push_back(component);
        base.info.corner_only = base.info.corner_only && out.results[i].info.corner_only;
        base.further.push_back(std::move(out.results[i]));
        joined[i] = true;
    }
    std::vector<ListedResult> kept;
    for (std::size_t i = 0; i < joined.size(); ++i) {
        if (!joined[i]) kept.push_back(std::move(out.results[i]));
    }
    out.results = std::move(kept);
}

void drop_unused_steps(ListedResults& out) {
    std::vector<std::uint32_t> new_index(out.steps.size());
    std::vector<bool> used(out.steps.size());
    for (const ListedResult& result : out.results) used[result.info.step] = true;
    std::vector<Step> kept;
    for (std::size_t i = 0; i < used.size(); ++i) {
        new_index[i] = static_cast<std::uint32_t>(kept.size());
        if (used[i]) kept.push_back(out.steps[i]);
    }
    for (ListedResult& result : out.results) result.info.step = new_index[result.info.step];
    out.steps = std::move(kept);
}

}  // namespace

void join_derived(ListedResults& out) {
    join(out);
    drop_unused_steps(out);
}

}  // namespace feelem::ansys
