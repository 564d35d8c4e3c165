// SPDX-License-Identifier: Apache-2.0
// Unaveraged results to one value a node: decision 0009.
#include "feelem/derive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace feelem {
namespace {

std::vector<std::uint32_t> part_of_elements(const Mesh& mesh) {
    std::vector<std::uint32_t> parts;
    parts.reserve(mesh.element_count());
    for (const ElementBlock& block : mesh.blocks) {
        for (const PartIndex part : block.parts) parts.push_back(raw(part));
    }
    return parts;
}

/// `rows` in ascending order of key(row) < count, rows with equal keys in their order.
template <class Key>
std::vector<std::uint32_t> sorted_by(std::span<const std::uint32_t> rows, std::size_t count, Key key) {
    std::vector<std::uint32_t> next(count + 1);
    for (const std::uint32_t row : rows) ++next[key(row) + 1];
    for (std::size_t i = 1; i <= count; ++i) next[i] += next[i - 1];
    std::vector<std::uint32_t> out(rows.size());
    for (const std::uint32_t row : rows) out[next[key(row)]++] = row;
    return out;
}

/// The mean of some rows of some columns; NaN does not count.
void add_mean(
    const Result& result,
    std::span<const std::size_t> columns,
    std::span<const std::uint32_t> rows,
    float* out
) {
    const std::size_t width = result.component_count();
    for (std::size_t k = 0; k < columns.size(); ++k) {
        double sum = 0;
        std::size_t count = 0;
        for (const std::uint32_t row : rows) {
            const float value = result.values[row * width + columns[k]];
            if (std::isnan(value)) continue;
            sum += static_cast<double>(value);
            ++count;
        }
        out[k] = count == 0 ? std::numeric_limits<float>::quiet_NaN()
                            : static_cast<float>(sum / static_cast<double>(count));
    }
}

bool is_averaged(const ResultInfo& info, Averaging averaging) {
    return info.location == Location::ElementNodal && info.averaging == Averaging::None &&
           (averaging == Averaging::Part || averaging == Averaging::All);
}

}  // namespace

ResultInfo averaged_info(const ResultInfo& info, Averaging averaging) {
    if (!is_averaged(info, averaging)) return info;
    ResultInfo out = info;
    out.averaging = averaging;
    out.location = averaging == Averaging::Part ? Location::PartNodal : Location::Nodal;
    for (const Derivation& derivation : derivations()) {
        if (derivation.applies(info)) std::erase(out.components, derivation.name);
    }
    return out;
}

Result average(const Mesh& mesh, const Result& result, Averaging averaging) {
    if (!is_averaged(result.info, averaging)) return result;
    const bool by_part = averaging == Averaging::Part;
    const std::vector<std::uint32_t> part_of = part_of_elements(mesh);
    const std::size_t row_count =
        std::min({result.row_count(), result.row_owner.size(), result.row_node.size()});
    std::vector<std::uint32_t> rows;
    rows.reserve(row_count);
    for (std::uint32_t row = 0; row < row_count; ++row) {
        const bool is_known =
            result.row_owner[row] < part_of.size() && raw(result.row_node[row]) < mesh.node_count();
        if (is_known) rows.push_back(row);
    }
    rows = sorted_by(rows, mesh.node_count(), [&](std::uint32_t row) { return raw(result.row_node[row]); });
    const auto part = [&](std::uint32_t row) { return by_part ? part_of[result.row_owner[row]] : 0; };
    if (by_part) rows = sorted_by(rows, mesh.parts.size(), part);

    Result out;
    out.info = averaged_info(result.info, averaging);
    std::vector<std::size_t> columns;
    for (const std::string& name : out.info.components)
        columns.push_back(static_cast<std::size_t>(component_index(result.info, name)));
    const std::size_t width = columns.size();
    if (!by_part) out.values.assign(mesh.node_count() * width, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t first = 0; first < rows.size();) {
        const NodeIndex node = result.row_node[rows[first]];
        const std::uint32_t owner = part(rows[first]);
        std::size_t last = first + 1;
        while (last < rows.size() && result.row_node[rows[last]] == node && part(rows[last]) == owner) ++last;
        std::size_t place = std::size_t{raw(node)} * width;
        if (by_part) {
            place = out.values.size();
            out.values.resize(place + width);
            out.row_owner.push_back(owner);
            out.row_node.push_back(node);
        }
        add_mean(result, columns, std::span(rows).subspan(first, last - first), out.values.data() + place);
        first = last;
    }
    return out;
}

}  // namespace feelem
