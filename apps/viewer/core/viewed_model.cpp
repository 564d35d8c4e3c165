// SPDX-License-Identifier: Apache-2.0
// Facts of a model that take a look at every vertex, found once.
#include "viewer/core/model_source.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem::viewer {
namespace {

/// A source may be wrong about its lengths: nothing is read behind the end.
bool fits(const FieldSpan& field, const ModelArrays& arrays) {
    const std::size_t vertices = arrays.positions.size();
    return field.components > 0 && field.validity.size() == vertices &&
           field.values.size() == vertices * field.components;
}

}  // namespace

ViewedModel::ViewedModel(ModelSource source) : source_(std::move(source)) {}

FieldSpan ViewedModel::values(const FieldChoice& field) const {
    const auto& results = about().results;
    if (field.result >= results.size() || field.values >= results[field.result].values.size()) return {};
    try {
        const FieldSpan found = source_.values(field.result, field.values);
        return fits(found, arrays()) && field.component < found.components ? found : FieldSpan{};
    } catch (const Error& error) {
        problem_ = results[field.result].title + ": " + error.what();
        return {};
    }
}

std::optional<std::array<double, 2>> ViewedModel::skin_range(const FieldChoice& field) const {
    const std::array key{field.result, field.values, field.component};
    if (const auto known = ranges_.find(key); known != ranges_.end()) return known->second;
    const FieldSpan span = values(field);
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (std::size_t i = 0; i < span.validity.size(); ++i) {
        const auto value = static_cast<double>(span.values[i * span.components + field.component]);
        if (span.validity[i] == Validity::Missing || std::isnan(value)) continue;
        lo = std::min(lo, value);
        hi = std::max(hi, value);
    }
    std::optional<std::array<double, 2>> range;
    if (lo <= hi) range = {lo, hi};
    ranges_[key] = range;
    return range;
}

double ViewedModel::longest(const FieldChoice& field) const {
    const std::array key{field.result, field.values};
    if (const auto known = longest_.find(key); known != longest_.end()) return known->second;
    const FieldSpan span = values({field.result, field.values, 0});
    double most = 0;
    if (span.components == 3) {
        for (std::size_t i = 0; i < span.validity.size(); ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto part = static_cast<double>(span.values[3 * i + k]);
                sum += part * part;
            }
            if (sum > most) most = sum;  // false for NaN
        }
    }
    return longest_[key] = std::sqrt(most);
}

double ViewedModel::largest_side() const noexcept {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        largest =
            std::max(largest, static_cast<double>(arrays().high[k]) - static_cast<double>(arrays().low[k]));
    }
    return largest;
}

double ViewedModel::diagonal() const noexcept {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double side = static_cast<double>(arrays().high[k]) - static_cast<double>(arrays().low[k]);
        sum += side * side;
    }
    return std::sqrt(sum);
}

std::optional<std::size_t> ViewedModel::corner_of_node(std::int64_t node) const {
    if (nodes_.empty()) {
        const auto& ids = arrays().node_ids;
        std::vector<bool> used(ids.size());
        for (std::size_t corner = 0; corner < 3 * arrays().triangles.size(); ++corner) {
            const std::uint32_t vertex = vertex_at(corner);
            if (used[vertex] || ids[vertex] == 0) continue;
            used[vertex] = true;
            nodes_.emplace_back(ids[vertex], corner);
        }
        std::sort(nodes_.begin(), nodes_.end());
    }
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), std::pair{node, std::size_t{0}});
    if (node == 0 || found == nodes_.end() || found->first != node) return std::nullopt;
    return found->second;
}

std::optional<std::size_t> ViewedModel::triangle_of_element(std::int64_t element) const {
    const auto& ids = arrays().element_ids;
    const auto found = std::find(ids.begin(), ids.end(), element);
    if (found == ids.end()) return std::nullopt;
    return static_cast<std::size_t>(found - ids.begin());
}

std::size_t ViewedModel::part_of_triangle(std::size_t triangle) const {
    const auto& parts = arrays().parts;
    std::size_t part = 0;
    while (part + 1 < parts.size() && parts[part + 1].first_triangle <= triangle) ++part;
    return part;
}

std::size_t ViewedModel::part_of_vertex(std::uint32_t vertex) const {
    const auto& parts = arrays().parts;
    const auto behind =
        std::upper_bound(parts.begin(), parts.end(), vertex, [](std::uint32_t v, const PartSpan& part) {
            return v < part.first_vertex;
        });
    return behind == parts.begin() ? 0 : static_cast<std::size_t>(behind - parts.begin()) - 1;
}

}  // namespace feelem::viewer
