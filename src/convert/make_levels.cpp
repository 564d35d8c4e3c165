// SPDX-License-Identifier: Apache-2.0
#include "convert/make_levels.hpp"

#include "base/number.hpp"
#include "convert/level_search.hpp"
#include "convert/stage.hpp"

#include "feelem/error.hpp"
#include "feelem/lod.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace feelem {
namespace {

/// What a headset draws without dropping frames, and what a weak machine does.
constexpr std::uint64_t kHeadsetTriangles = 500'000;
constexpr std::uint64_t kWeakTriangles = 125'000;
/// Fraction of a result's range over the model and the steps.
constexpr double kUsualBound = 0.005;
constexpr double kWidestBound = 0.05;
/// Of the diagonal: half of what element edges are drawn off the surface, so that they stay in sight.
constexpr double kDistance = 2.5e-4;
/// Of the largest number: below it float32 has few digits left.
constexpr double kLeastBound = 1e-6;

double diagonal_of(std::span<const Point3> positions) {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::ranges::minmax_element(positions, {}, [axis](const Point3& p) { return p[axis]; });
        square += ((*high)[axis] - (*low)[axis]) * ((*high)[axis] - (*low)[axis]);
    }
    return std::sqrt(square);
}

/// Every result at every step, each with its share of the range over all of them.
std::vector<ServedValues> everything_shown(
    const std::vector<SceneResult>& results, const SceneValueStore& store, double share
) {
    std::vector<ServedValues> served;
    for (std::size_t r = 0; r < results.size(); ++r) {
        const SceneResult& result = results[r];
        double range = 0, largest = 0;
        for (std::size_t c = 0; c < result.components.size(); ++c) {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (std::size_t v = 0; v < result.values.size(); ++v) {
                const ComponentRange& at = store.ranges(r, v)[c];
                if (at.valid == 0) continue;
                low = std::min(low, static_cast<double>(at.min));
                high = std::max(high, static_cast<double>(at.max));
            }
            if (low > high) continue;
            range = std::max(range, high - low);
            largest = std::max({largest, std::abs(low), std::abs(high)});
        }
        const double bound =
            std::max({share * range, kLeastBound * largest, double{std::numeric_limits<float>::min()}});
        const double component = result.shape == Shape::Vector ? bound / std::numbers::sqrt3 : bound;
        for (std::size_t v = 0; v < result.values.size(); ++v)
            served.push_back({r, v, range, bound, component});
    }
    return served;
}

void note(const Work& work, const std::string& text) {
    work.diagnostics.add(Code::LevelOfDetail, "", text);
}

std::vector<LodTarget> targets_of(const LevelWish& wish) {
    if (wish.kind == LevelWish::Kind::Triangles) return {{wish.triangles, 1}};
    if (wish.kind == LevelWish::Kind::Bound) return {{0, 1}};
    return {{kHeadsetTriangles, 1}, {kWeakTriangles, 1}};
}

double share_of(const LevelWish& wish) {
    if (wish.kind == LevelWish::Kind::Triangles) return kWidestBound;
    return wish.kind == LevelWish::Kind::Bound ? wish.bound : kUsualBound;
}

}  // namespace

LevelWish parse_levels(std::string_view text) {
    using enum LevelWish::Kind;
    if (text == "auto") return {Auto, 0, 0};
    if (text == "off") return {Off, 0, 0};
    if (text.ends_with('%')) {
        const auto percent = parse_double(text.substr(0, text.size() - 1));
        if (percent && *percent >= 0.001 && *percent <= 50) return {Bound, 0, *percent / 100};
    } else if (const auto count = parse_integer(text); count && *count > 0) {
        return {Triangles, static_cast<std::uint64_t>(*count), 0};
    }
    throw Error(
        Code::BadOption,
        "--lod",
        fmt::format(
            "\"{}\": expected auto, off, a number of triangles like 200000, or a bound from 0.001% to 50% "
            "like "
            "0.5%",
            text
        )
    );
}

void make_levels(
    const Work& work,
    const Surface& surface,
    SceneValueStore& store,
    const SceneOptions& options,
    SceneContents& contents
) {
    const LevelWish wish = parse_levels(work.job.levels);
    const std::uint64_t triangles = surface.triangles.size();
    if (wish.kind == LevelWish::Kind::Off || triangles == 0) return;
    if (wish.kind == LevelWish::Kind::Auto && triangles <= kHeadsetTriangles) return;
    if (wish.kind == LevelWish::Kind::Triangles && triangles <= wish.triangles) return;
    if (surface.domain == Domain::ElementNode)
        return note(
            work,
            "no level of detail: with values of elements or unaveraged ones every element has vertices of "
            "its own"
        );
    report_progress(work.progress, "levels", 0);
    const std::vector<Point3> positions = scene_positions(surface, options);
    LodSurface drawn = lod_surface(surface);
    drawn.positions = positions;
    LevelSearch search{work, drawn, store, contents.results, options};
    search.served = everything_shown(contents.results, store, share_of(wish));
    search.options.targets = targets_of(wish);
    search.options.distance = kDistance * diagonal_of(positions);
    std::string why;
    MadeLevels levels = search_levels(search, why);
    if (!why.empty()) return note(work, "no level of detail: " + why);
    if (levels.empty())
        return note(
            work, fmt::format("no level of detail: a bound of {}% saves no triangles", 100 * share_of(wish))
        );
    const std::uint64_t wanted = search.options.targets.front().triangles;
    if (wanted > 0 && levels.front().first.triangles > wanted)
        note(
            work,
            fmt::format(
                "the level of detail has {} triangles, not {}: fewer would show a value more than {}% of its "
                "range off",
                levels.front().first.triangles,
                wanted,
                100 * share_of(wish)
            )
        );
    for (auto& [level, made] : levels) {
        contents.levels.push_back(std::move(level));
        contents.level_triangles.push_back(std::move(made.triangles));
    }
}

}  // namespace feelem
