// SPDX-License-Identifier: Apache-2.0
#include "viewer/core/guidance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace feelem::viewer {
namespace {

constexpr double kSlowest = 1.5, kSpan = 8;

std::vector<float> sorted_values(
    const ViewerState& state, const ViewedModel& model, const FieldChoice& seen
) {
    const ModelArrays& arrays = model.arrays();
    const FieldSpan field = model.values(seen);
    std::vector<float> out;
    for (std::size_t part = 0; part < arrays.parts.size() && !field.values.empty(); ++part) {
        if (part < state.parts.size() && state.parts[part] == PartLook::Hidden) continue;
        const PartSpan& span = arrays.parts[part];
        for (std::size_t v = span.first_vertex; v < std::size_t{span.first_vertex} + span.vertices; ++v) {
            const float value = field.values[v * field.components + seen.component];
            if (arrays.node_ids[v] != 0 && !std::isnan(value)) out.push_back(value);
        }
    }
    std::ranges::sort(out);
    return out;
}

}  // namespace

double rank_of(std::span<const float> sorted, double value) {
    if (sorted.empty() || std::isnan(value)) return 0;
    const auto below = std::ranges::lower_bound(sorted, value, {}, [](float v) { return double{v}; });
    const auto above = std::ranges::upper_bound(sorted, value, {}, [](float v) { return double{v}; });
    if (above == sorted.end() && below != above) return 1;
    const auto sum = static_cast<double>((below - sorted.begin()) + (above - sorted.begin()));
    return sum / 2 / static_cast<double>(sorted.size());
}

double guide_rate(double rank) {
    const double q = std::clamp(rank, 0.0, 1.0);
    return kSlowest * std::pow(kSpan, q * q * q);
}

double RankList::rank(
    const ViewerState& state, const ViewedModel& model, const FieldChoice& seen, double value
) {
    if (seen_ != seen || parts_ != state.parts) {
        sorted_ = sorted_values(state, model, seen);
        seen_ = seen;
        parts_ = state.parts;
    }
    return rank_of(sorted_, value);
}

}  // namespace feelem::viewer
