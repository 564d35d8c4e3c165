// SPDX-License-Identifier: Apache-2.0
#include "convert/judge_level.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem {
namespace {

/// The checker tells that many fields' missing values apart at once.
constexpr std::size_t kFieldsAtOnce = 64;

struct Ends {
    float low = std::numeric_limits<float>::infinity(), high = -std::numeric_limits<float>::infinity();

    void take(float value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool operator==(const Ends&) const = default;
};

/// Vertices of triangles that have an area: what can be seen.
std::vector<VertexIndex> seen_vertices(
    const LodSurface& surface, std::span<const std::array<VertexIndex, 3>> triangles
) {
    std::vector<bool> is_seen(surface.positions.size(), false);
    for (const auto& t : triangles) {
        const Point3 &a = surface.positions[raw(t[0])], &b = surface.positions[raw(t[1])],
                     &c = surface.positions[raw(t[2])];
        bool has_area = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            has_area = has_area || (b[i] - a[i]) * (c[j] - a[j]) != (b[j] - a[j]) * (c[i] - a[i]);
        }
        for (const VertexIndex v : t) is_seen[raw(v)] = is_seen[raw(v)] || has_area;
    }
    std::vector<VertexIndex> seen;
    for (std::uint32_t v = 0; v < is_seen.size(); ++v) {
        if (is_seen[v]) seen.push_back(VertexIndex{v});
    }
    return seen;
}

Ends ends_at(std::span<const VertexIndex> vertices, std::span<const float> values) {
    Ends ends;
    for (const VertexIndex v : vertices) ends.take(values[raw(v)]);
    return ends;
}

struct UnderCheck {
    const LodSurface& surface;
    std::span<const std::array<VertexIndex, 3>> level;
    double distance;
    std::vector<VertexIndex> seen_before, seen;
};

/// Results and steps that are looked at together.
struct Batch {
    std::vector<ComponentValues> values;
    std::size_t first = 0, fields = 0;
};

void judge_batch(const UnderCheck& under, const Batch& batch, LevelJudgement& out) {
    std::vector<LodField> fields;
    for (const ComponentValues& components : batch.values) {
        for (const std::vector<float>& values : components) fields.push_back({values, 1});
    }
    const LodCheck check = check_level(under.surface, fields, under.level, under.distance);
    out.max_distance = std::max(out.max_distance, check.max_distance);
    out.without_place = std::max(out.without_place, check.without_place);
    out.invented += check.invented;
    out.lost += check.lost;
    std::size_t k = 0;
    for (std::size_t i = 0; i < batch.values.size(); ++i) {
        LevelJudgement::Value& value = out.values[batch.first + i];
        for (const std::vector<float>& values : batch.values[i]) {
            value.shown.push_back(check.fields[k++].max);
            value.keeps_extremes =
                value.keeps_extremes && ends_at(under.seen_before, values) == ends_at(under.seen, values);
        }
    }
}

/// From the middles of the level's triangles to the original ones: nothing may be drawn where nothing was.
/// The same checker, with the two changed over.
double distance_of_middles(const UnderCheck& under) {
    std::vector<Point3> positions(under.surface.positions.begin(), under.surface.positions.end());
    std::vector<std::array<VertexIndex, 3>> thirds;
    LodSurface middles;
    middles.parts = under.surface.parts;
    for (const auto& t : under.level) {
        const VertexIndex middle{static_cast<std::uint32_t>(positions.size())};
        Point3 sum{};
        for (const VertexIndex v : t) {
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += positions[raw(v)][axis] / 3;
        }
        positions.push_back(sum);
        if (!middles.parts.empty()) middles.parts.push_back(std::uint32_t{middles.parts[raw(t[0])]});
        for (std::size_t k = 0; k < 3; ++k) thirds.push_back({t[k], t[(k + 1) % 3], middle});
    }
    middles.positions = positions;
    middles.triangles = thirds;
    const LodCheck check = check_level(middles, {}, under.surface.triangles, under.distance);
    return check.without_place > 0 ? std::numeric_limits<double>::infinity() : check.max_distance;
}

}  // namespace

LevelJudgement judge_level(
    const LodSurface& surface,
    std::span<const std::array<VertexIndex, 3>> level,
    double distance,
    std::size_t count,
    const std::function<ComponentValues(std::size_t)>& load
) {
    LevelJudgement judgement;
    judgement.values.resize(count);
    const UnderCheck under{
        surface, level, distance, seen_vertices(surface, surface.triangles), seen_vertices(surface, level)};
    judgement.max_distance = distance_of_middles(under);
    Batch batch;
    for (std::size_t i = 0; i < count; ++i) {
        ComponentValues values = load(i);
        if (!batch.values.empty() && batch.fields + values.size() > kFieldsAtOnce) {
            judge_batch(under, std::exchange(batch, {{}, i, 0}), judgement);
        }
        batch.fields += values.size();
        batch.values.push_back(std::move(values));
    }
    judge_batch(under, batch, judgement);
    return judgement;
}

double error_of_value(Shape shape, std::span<const double> components) {
    double most = 0, squares = 0;
    for (const double error : components) {
        most = std::max(most, error);
        squares += error * error;
    }
    return shape == Shape::Vector ? std::sqrt(squares) : most;
}

}  // namespace feelem
