// SPDX-License-Identifier: Apache-2.0
// The places of largest or smallest value: peaks among their neighbours, so far apart, largest first.
#include "viewer/core/cuts.hpp"
#include "viewer/core/viewer_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace feelem::viewer {
namespace {

struct SpotQuery {
    const ViewedModel& model;
    const PresentedResult& result;
    FieldChoice field;
    FieldSpan values;
    std::vector<CutPlane> cuts;
    bool largest = true;

    /// Larger is more extreme; NaN: no value.
    double read(std::uint32_t vertex) const {
        const auto value = static_cast<double>(values.values[vertex * values.components + field.component]);
        return largest ? value : -value;
    }
};

/// Numbers from 1 on for ids: a plain list where they lie close together, as solvers number them.
class NumberedIds {
public:
    explicit NumberedIds(std::span<const std::int64_t> ids) {
        std::int64_t largest = 0, smallest = 0;
        for (const std::int64_t id : ids) {
            largest = std::max(largest, id);
            smallest = std::min(smallest, id);
        }
        const auto dense = static_cast<std::int64_t>(4 * ids.size() + 1000);
        if (smallest >= 0 && largest < dense) list_.resize(static_cast<std::size_t>(largest) + 1);
    }
    std::uint32_t number(std::int64_t id) {
        std::uint32_t& known = list_.empty() ? map_[id] : list_[static_cast<std::size_t>(id)];
        if (known == 0) known = ++count_;
        return known;
    }

private:
    std::vector<std::uint32_t> list_;
    std::unordered_map<std::int64_t, std::uint32_t> map_;
    std::uint32_t count_ = 0;
};

/// For each vertex of a part a number that all vertices of its node share: where a skin bends sharply, or
/// elements do not share values, one node has several. 0: no node.
std::vector<std::uint32_t> number_nodes(const ModelArrays& arrays, const PartSpan& part) {
    const auto ids = arrays.node_ids.subspan(part.first_vertex, part.vertices);
    NumberedIds known(ids);
    std::vector<std::uint32_t> numbers(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] != 0) numbers[i] = known.number(ids[i]);
    }
    return numbers;
}

/// Nodes that a neighbour outdoes.
std::vector<bool> find_outdone(
    const SpotQuery& query, const PartSpan& part, const std::vector<std::uint32_t>& numbers
) {
    std::vector<bool> outdone(numbers.size() + 1);
    for (const auto& triangle : query.model.arrays().triangles.subspan(part.first_triangle, part.triangles)) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
            const double va = query.read(a), vb = query.read(b);
            if (va < vb) outdone[numbers[a - part.first_vertex]] = true;
            if (vb < va) outdone[numbers[b - part.first_vertex]] = true;
        }
    }
    return outdone;
}

/// Nodes of one part that no neighbour outdoes; the solver's own values only.
void add_peaks(const SpotQuery& query, std::size_t index, std::vector<HotSpot>& spots) {
    const ModelArrays& arrays = query.model.arrays();
    const PartSpan& part = arrays.parts[index];
    const std::vector<std::uint32_t> numbers = number_nodes(arrays, part);
    const std::vector<bool> outdone = find_outdone(query, part, numbers);
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> best(numbers.size() + 1, kNone);
    for (std::uint32_t i = 0; i < part.vertices; ++i) {
        const std::uint32_t vertex = part.first_vertex + i;
        if (numbers[i] == 0 || outdone[numbers[i]] || query.values.validity[vertex] != Validity::Solver ||
            std::isnan(query.read(vertex))) {
            continue;
        }
        const auto& at = arrays.positions[vertex];
        if (is_cut_away(query.cuts, glm::dvec3(at[0], at[1], at[2]))) continue;
        std::uint32_t& known = best[numbers[i]];
        if (known == kNone || query.read(vertex) > query.read(known)) known = vertex;
    }
    for (const std::uint32_t vertex : best) {
        if (vertex == kNone) continue;
        const double value = query.largest ? query.read(vertex) : -query.read(vertex);
        spots.push_back(
            {index,
             vertex,
             arrays.node_ids[vertex],
             query.result.key,
             value,
             utilisation(value, query.result)}
        );
    }
}

double apart(const ModelArrays& arrays, std::uint32_t a, std::uint32_t b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double side =
            static_cast<double>(arrays.positions[a][k]) - static_cast<double>(arrays.positions[b][k]);
        sum += side * side;
    }
    return std::sqrt(sum);
}

std::vector<HotSpot> spots_of(
    const ViewerState& state, const ViewedModel& model, const PresentedResult& result, bool largest
) {
    const auto field = find_field(model.about(), result, state.step);
    if (!field) return {};
    const SpotQuery query{model, result, *field, model.values(*field), cuts_of(state), largest};
    if (query.values.components == 0) return {};
    std::vector<HotSpot> all;
    for (std::size_t p = 0; p < model.arrays().parts.size(); ++p) {
        if (p < state.parts.size() && state.parts[p] == PartLook::Hidden) continue;
        add_peaks(query, p, all);
    }
    std::stable_sort(all.begin(), all.end(), [&](const HotSpot& a, const HotSpot& b) {
        if (a.value != b.value) return largest ? a.value > b.value : a.value < b.value;
        return a.node < b.node;
    });
    std::vector<HotSpot> chosen;
    const double separation = state.hot.share * model.diagonal();
    for (const HotSpot& spot : all) {
        if (chosen.size() >= state.hot.count) break;
        const bool is_near = std::ranges::any_of(chosen, [&](const HotSpot& other) {
            return apart(model.arrays(), spot.vertex, other.vertex) < separation;
        });
        if (!is_near) chosen.push_back(spot);
    }
    return chosen;
}

std::vector<HotSpot> spots_of_limits(const ViewerState& state, const ViewedModel& model) {
    std::vector<HotSpot> all;
    for (const PresentedResult& result : state.presentation.results) {
        if (!result.limit) continue;
        // A limit from below is used most where the value is smallest.
        const bool largest = state.hot.largest == result.limit_is_upper;
        const std::vector<HotSpot> found = spots_of(state, model, result, largest);
        all.insert(all.end(), found.begin(), found.end());
    }
    std::stable_sort(all.begin(), all.end(), [&](const HotSpot& a, const HotSpot& b) {
        const double used_a = a.utilisation.value_or(0), used_b = b.utilisation.value_or(0);
        return state.hot.largest ? used_a > used_b : used_a < used_b;
    });
    if (all.size() > state.hot.count) all.resize(state.hot.count);
    return all;
}

}  // namespace

std::vector<HotSpot> hot_spots(const ViewerState& state, const ViewedModel& model) {
    const bool has_limit = std::ranges::any_of(state.presentation.results, [&](const PresentedResult& r) {
        return r.limit && find_component(model.about(), r);
    });
    if (state.hot.by_utilisation && has_limit) return spots_of_limits(state, model);
    const PresentedResult* seen = result_of(state.presentation, Sense::Colour);
    if (seen == nullptr) return {};
    return spots_of(state, model, *seen, state.hot.largest);
}

const std::vector<HotSpot>& HotSpotList::of(const ViewerState& state, const ViewedModel& model) {
    const HotOptions& hot = state.hot;
    const PresentedResult* seen = result_of(state.presentation, Sense::Colour);
    std::string key = fmt::format(
        "{} {} {} {} {} {}",
        state.step,
        hot.count,
        hot.share,
        hot.by_utilisation,
        hot.largest,
        seen != nullptr ? seen->key + "/" + seen->component : ""
    );
    for (const PartLook look : state.parts) key += look == PartLook::Hidden ? 'h' : '.';
    for (const CutPlane& cut : cuts_of(state)) {
        key += fmt::format(" {} {} {} {}", cut.normal.x, cut.normal.y, cut.normal.z, cut.offset);
    }
    for (const PresentedResult& result : state.presentation.results) {
        if (result.limit) key += fmt::format(" {}{}{}", result.key, *result.limit, result.limit_is_upper);
    }
    if (key != key_) {
        found_ = hot_spots(state, model);
        key_ = key;
    }
    return found_;
}

void next_hot_spot(ViewerState& state, const ViewedModel& model, int by) {
    const std::vector<HotSpot> found = hot_spots(state, model);
    if (found.empty()) {
        state.notice = "There are no hot spots: no result is seen, or it has no values.";
        return;
    }
    const auto count = static_cast<int>(found.size());
    const int before = state.hot.at ? static_cast<int>(*state.hot.at) : (by > 0 ? -1 : count);
    const int at = ((before + by) % count + count) % count;
    state.hot.at = static_cast<std::size_t>(at);
    go_to_node(state, model, found[*state.hot.at].node);
    state.notice = fmt::format("Hot spot {} of {}, node {}.", at + 1, count, found[*state.hot.at].node);
}

}  // namespace feelem::viewer
