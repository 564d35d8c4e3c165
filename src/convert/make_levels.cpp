// SPDX-License-Identifier: Apache-2.0
#include "convert/make_levels.hpp"

#include "base/number.hpp"
#include "convert/judge_level.hpp"
#include "convert/stage.hpp"
#include "scene/steps.hpp"

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
constexpr std::uint64_t kFewTriangles = 125'000;
/// Fraction of a result's range over the model and the steps.
constexpr double kUsualBound = 0.005;
constexpr double kWidestBound = 0.05;
/// Of the diagonal: half of what element edges are drawn off the surface, so that they stay in sight.
constexpr double kDistance = 2.5e-4;
/// Of the largest number: below it float32 has few digits left.
constexpr double kLeastBound = 1e-6;
/// A level must save at least this share of the triangles of the one before.
constexpr double kWorthwhile = 0.2;

/// One result at one step.
struct Served {
    std::size_t result = 0, values = 0;
    double range = 0;  ///< Of the whole result.
    double bound = 0;  ///< Of the whole value, in the result's unit.
    double component_bound = 0;
};

struct Making {
    const Work& work;
    const LodSurface& surface;
    SceneValueStore& store;
    const std::vector<SceneResult>& results;
    std::vector<Served> served{};
    LodOptions options{};
};

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
std::vector<Served> everything_shown(
    const std::vector<SceneResult>& results, const SceneValueStore& store, double share
) {
    std::vector<Served> served;
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

/// A vertex has all components of a value, or none.
ComponentValues components_of(const SurfaceField& field) {
    const std::size_t width = field.component_count;
    const std::size_t vertices = width == 0 ? 0 : field.values.size() / width;
    ComponentValues out(width, std::vector<float>(vertices));
    for (std::size_t v = 0; v < vertices; ++v) {
        bool is_whole = true;
        for (std::size_t c = 0; c < width; ++c)
            is_whole = is_whole && std::isfinite(field.values[v * width + c]);
        for (std::size_t c = 0; c < width; ++c)
            out[c][v] = is_whole ? field.values[v * width + c] : std::numeric_limits<float>::quiet_NaN();
    }
    return out;
}

/// A level is about what the scene holds: the values that a compressed one has rounded.
void round_as_written(const SceneResult& result, const SceneOptions& options, SurfaceField& field) {
    if (!options.compress || !result.range) return;
    if (const auto steps = gltf::steps_within(*result.range, options.bound))
        gltf::round_to_steps(*steps, field.values);
}

/// Empty when the level keeps its promise, else what it does not keep.
std::string complaint(const Making& making, const LevelJudgement& judgement) {
    if (judgement.without_place + judgement.invented + judgement.lost > 0)
        return fmt::format(
            "{} vertices have no place on it, {} gain and {} lose a value",
            judgement.without_place,
            judgement.invented,
            judgement.lost
        );
    if (!std::isfinite(judgement.max_distance)) return "a triangle of it is where none was";
    for (std::size_t i = 0; i < making.served.size(); ++i) {
        const Served& served = making.served[i];
        const SceneResult& result = making.results[served.result];
        const double shown = error_of_value(result.shape, judgement.values[i].shown);
        if (shown > served.bound)
            return fmt::format("{} is shown {:.4g} off, not within {:.4g}", result.id, shown, served.bound);
        if (!judgement.values[i].keeps_extremes) return fmt::format("an extreme of {} is lost", result.id);
    }
    return "";
}

/// To nine decimals, so that people read 0.005 and not the last bit of a quotient.
double rounded_up(double fraction) {
    return std::ceil((fraction - 1e-12) * 1e9) / 1e9;
}

SceneLevel described(const Making& making, const LodLevel& level, const LevelJudgement& judgement) {
    const LodCertificate& certificate = level.certificate;
    SceneLevel out;
    out.triangles = level.triangles.size();
    out.max_distance =
        std::max({certificate.max_distance, certificate.max_border_distance, judgement.max_distance});
    out.distance_bound = std::max(certificate.distance_bound, out.max_distance);
    out.samples = certificate.samples;
    std::size_t k = 0;
    for (std::size_t i = 0; i < making.served.size(); ++i) {
        const Served& served = making.served[i];
        const SceneResult& result = making.results[served.result];
        std::vector<double> found;
        for (std::size_t c = 0; c < result.components.size(); ++c)
            found.push_back(certificate.fields[k++].max);
        SceneLevelValues values{served.result, served.values};
        values.max = error_of_value(result.shape, found);
        values.shown = error_of_value(result.shape, judgement.values[i].shown);
        // What the checker found may be a little more than what was needed for the count.
        values.bound = std::max(certificate.bound * served.bound, values.shown);
        if (served.range > 0) out.bound = std::max(out.bound, rounded_up(values.bound / served.range));
        out.values.push_back(values);
    }
    return out;
}

/// Levels with this slip; empty with `why` when one of them does not hold.
std::vector<std::pair<SceneLevel, LodLevel>> attempt(
    const Making& making, const std::vector<ComponentValues>& values, std::string& why
) {
    std::vector<LodField> fields;
    for (std::size_t i = 0; i < making.served.size(); ++i) {
        for (const std::vector<float>& component : values[i])
            fields.push_back({component, making.served[i].component_bound});
    }
    LodResult made = simplify(making.surface, fields, making.options);
    std::vector<std::pair<SceneLevel, LodLevel>> levels;
    std::size_t before = making.surface.triangles.size();
    for (LodLevel& level : made.levels) {
        report_progress(making.work.progress, "levels", 0.5);
        const auto most = (1 - kWorthwhile) * static_cast<double>(before);
        if (static_cast<double>(level.triangles.size()) > most || level.triangles.empty()) continue;
        before = level.triangles.size();
        const LevelJudgement judgement = judge_level(
            making.surface,
            level.triangles,
            level.certificate.distance_bound,
            values.size(),
            [&](std::size_t i) { return values[i]; }
        );
        why = complaint(making, judgement);
        if (!why.empty()) return {};
        levels.emplace_back(described(making, level, judgement), std::move(level));
    }
    return levels;
}

void note(const Work& work, const std::string& text) {
    work.diagnostics.add(Code::LevelOfDetail, "", text);
}

std::vector<LodTarget> targets_of(const LevelWish& wish) {
    if (wish.kind == LevelWish::Kind::Triangles) return {{wish.triangles, 1}};
    if (wish.kind == LevelWish::Kind::Bound) return {{0, 1}};
    return {{kHeadsetTriangles, 1}, {kFewTriangles, 1}};
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
    Making making{work, drawn, store, contents.results};
    making.served = everything_shown(contents.results, store, share_of(wish));
    making.options.targets = targets_of(wish);
    making.options.distance = kDistance * diagonal_of(positions);
    std::vector<ComponentValues> values;
    for (const Served& served : making.served) {
        SurfaceField field = store.field(served.result, served.values);
        round_as_written(contents.results[served.result], options, field);
        values.push_back(components_of(field));
    }
    std::string why;
    std::vector<std::pair<SceneLevel, LodLevel>> levels;
    for (making.options.slip = 0.5; making.options.slip > 0.1 && levels.empty(); making.options.slip /= 2) {
        levels = attempt(making, values, why);
        if (why.empty()) break;
    }
    if (!why.empty()) return note(work, "no level of detail: " + why);
    if (levels.empty())
        return note(
            work, fmt::format("no level of detail: a bound of {}% saves no triangles", 100 * share_of(wish))
        );
    const std::uint64_t wanted = making.options.targets.front().triangles;
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
