// SPDX-License-Identifier: Apache-2.0
#include "convert/model_values.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace feelem {
namespace {

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

/// Nodes (elements) of the model without a value in any row.
std::uint64_t count_missing(const Mesh& mesh, const Result& result, std::size_t component) {
    const std::size_t width = result.component_count();
    const std::size_t rows = result.row_count();
    const bool by_node =
        result.info.location == Location::PartNodal || result.info.location == Location::ElementNodal;
    if (!by_node) {
        std::uint64_t missing = 0;
        for (std::size_t row = 0; row < rows; ++row) {
            if (std::isnan(result.values[row * width + component])) ++missing;
        }
        return missing;
    }
    std::vector<bool> known(mesh.node_count(), false);
    for (std::size_t row = 0; row < rows; ++row) {
        if (!std::isnan(result.values[row * width + component])) known[raw(result.row_node[row])] = true;
    }
    return static_cast<std::uint64_t>(std::ranges::count(known, false));
}

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

ComponentRange range_over_model(const Mesh& mesh, const Result& result, std::size_t component) {
    ComponentRange range;
    range.component = result.info.components[component];
    const std::size_t width = result.component_count();
    RowIds min_ids{}, max_ids{};
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const float value = result.values[row * width + component];
        if (std::isnan(value)) continue;
        const bool first = range.valid++ == 0;
        if (value == 0) ++range.zeros;
        if (first || value <= range.min) {
            const RowIds ids = ids_of_row(mesh, result, row);
            if (first || value < range.min || ids < min_ids) {
                min_ids = ids;
                range.min = value;
            }
        }
        if (first || value >= range.max) {
            const RowIds ids = ids_of_row(mesh, result, row);
            if (first || value > range.max || ids < max_ids) {
                max_ids = ids;
                range.max = value;
            }
        }
    }
    std::tie(range.min_id, range.min_element) = min_ids;
    std::tie(range.max_id, range.max_element) = max_ids;
    range.missing = count_missing(mesh, result, component);
    return range;
}

std::vector<ComponentRange> ranges_over_model(const Mesh& mesh, const Result& result) {
    std::vector<ComponentRange> ranges;
    for (std::size_t i = 0; i < result.component_count(); ++i) {
        ranges.push_back(range_over_model(mesh, result, i));
    }
    for (const std::string_view name : derivable_components(result.info)) {
        ranges.push_back(range_over_model(mesh, component_of(result, name), 0));
        ranges.back().component = name;
        ranges.back().derived = true;
    }
    return ranges;
}

}  // namespace feelem
