// SPDX-License-Identifier: Apache-2.0
#include "convert/model_values.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace feelem {
namespace {

constexpr std::size_t kRunOfRows = 1U << 14U;

/// Solver ids behind a row: (node or element, element of an unaveraged row or 0).
using RowIds = std::pair<std::int64_t, std::int64_t>;

RowIds ids_of_row(const Mesh& mesh, const Result& result, std::size_t row) {
    const auto node = [&] { return raw(mesh.node_ids[raw(result.row_node[row])]); };
    switch (result.info.location) {
    case Location::Nodal: return {raw(mesh.node_ids[row]), 0};
    case Location::PartNodal: return {node(), 0};
    case Location::Elemental:
        return {raw(element_at(mesh, ElementIndex{static_cast<std::uint32_t>(row)}).id()), 0};
    case Location::ElementNodal:
        return {node(), raw(element_at(mesh, ElementIndex{result.row_owner[row]}).id())};
    }
    return {0, 0};
}

/// Nodes (elements) of the model without a value in any row; `valid` rows have one.
std::uint64_t count_missing(
    const Mesh& mesh, const Result& result, std::size_t component, std::uint64_t valid
) {
    const std::size_t width = result.component_count();
    const std::size_t rows = result.row_count();
    const bool by_node =
        result.info.location == Location::PartNodal || result.info.location == Location::ElementNodal;
    if (!by_node) return rows - valid;
    std::vector<bool> known(mesh.node_count(), false);
    for (std::size_t row = 0; row < rows; ++row) {
        if (!std::isnan(result.values[row * width + component])) known[raw(result.row_node[row])] = true;
    }
    return static_cast<std::uint64_t>(std::ranges::count(known, false));
}

/// The extremes of a run of rows, with the solver's ids behind them.
struct RunExtremes {
    ComponentRange range;
    RowIds min_ids{}, max_ids{};

    void add(float value, const Mesh& mesh, const Result& result, std::size_t row) {
        const bool first = range.valid++ == 0;
        if (value == 0) ++range.zeros;
        if (first || value <= range.min) offer_min(value, ids_of_row(mesh, result, row), first);
        if (first || value >= range.max) offer_max(value, ids_of_row(mesh, result, row), first);
    }
    /// Of equal values the one with the smallest ids counts; of equal ids the earlier row.
    void add(const RunExtremes& later) {
        if (later.range.valid == 0) return;
        const bool first = range.valid == 0;
        range.valid += later.range.valid;
        range.zeros += later.range.zeros;
        if (first || later.range.min <= range.min) offer_min(later.range.min, later.min_ids, first);
        if (first || later.range.max >= range.max) offer_max(later.range.max, later.max_ids, first);
    }

private:
    void offer_min(float value, RowIds ids, bool first) {
        if (!first && !(value < range.min) && !(ids < min_ids)) return;
        min_ids = ids;
        range.min = value;
    }
    void offer_max(float value, RowIds ids, bool first) {
        if (!first && !(value > range.max) && !(ids < max_ids)) return;
        max_ids = ids;
        range.max = value;
    }
};

}  // namespace

ResultInfo prepared_info(const ResultInfo& info, Averaging averaging) {
    ResultInfo prepared = averaged_info(info, averaging);
    prepared.nodal_system = false;
    return prepared;
}

Result load_prepared(ModelSource& source, std::size_t index, Averaging averaging) {
    Result result = source.load(index);
    ResultInfo info = prepared_info(result.info, averaging);
    // Called only where they change something: each copies all values.
    if (result.info.nodal_system) result = to_global(source.mesh(), result);
    const bool averages = averaging == Averaging::Part || averaging == Averaging::All;
    if (result.info.location == Location::ElementNodal && averages) {
        result = average(source.mesh(), result, averaging);
    }
    result.info = std::move(info);
    return result;
}

std::vector<std::string> all_components(const ResultInfo& info) {
    std::vector<std::string> components = info.components;
    for (const std::string_view name : derivable_components(info)) components.emplace_back(name);
    return components;
}

DerivedComponents::DerivedComponents(const Result& result, std::vector<std::string_view> wanted)
    : result_(result), together_(made_of_principals(result.info, wanted)) {}

Result DerivedComponents::take(std::string_view component) {
    const auto at = std::ranges::find(together_, component);
    if (at == together_.end()) return component_of(result_, component);
    if (made_.empty()) made_ = components_of(result_, together_);
    *at = {};  // Asked for again, it is made alone.
    return std::move(made_[static_cast<std::size_t>(at - together_.begin())]);
}

ComponentRange range_over_model(const Mesh& mesh, const Result& result, std::size_t component) {
    const std::size_t width = result.component_count();
    const std::size_t rows = result.row_count();
    std::vector<RunExtremes> runs((rows + kRunOfRows - 1) / kRunOfRows);
    parallel_chunks(rows, kRunOfRows, [&](std::size_t first, std::size_t last) {
        RunExtremes run;
        for (std::size_t row = first; row < last; ++row) {
            const float value = result.values[row * width + component];
            if (!std::isnan(value)) run.add(value, mesh, result, row);
        }
        runs[first / kRunOfRows] = run;
    });
    RunExtremes all;
    for (const RunExtremes& run : runs) all.add(run);
    ComponentRange& range = all.range;
    range.component = result.info.components[component];
    std::tie(range.min_id, range.min_element) = all.min_ids;
    std::tie(range.max_id, range.max_element) = all.max_ids;
    range.missing = count_missing(mesh, result, component, range.valid);
    return range;
}

std::vector<ComponentRange> ranges_over_model(const Mesh& mesh, const Result& result) {
    std::vector<ComponentRange> ranges;
    for (std::size_t i = 0; i < result.component_count(); ++i) {
        ranges.push_back(range_over_model(mesh, result, i));
    }
    const std::vector<std::string_view> names = derivable_components(result.info);
    DerivedComponents derived(result, names);
    for (const std::string_view name : names) {
        ranges.push_back(range_over_model(mesh, derived.take(name), 0));
        ranges.back().component = name;
        ranges.back().derived = true;
    }
    return ranges;
}

}  // namespace feelem
