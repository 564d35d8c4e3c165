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
#include <functional>
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

/// Fields that the simplifier holds at once: that many at most, and at least these, in so many bytes.
constexpr std::size_t kMostFields = 200, kLeastFields = 24;
constexpr std::size_t kFieldBytes = std::size_t{1} << 30;
/// Of a field: its values, their scaled copy, and that of the middles, a triangle.
constexpr std::size_t kBytesOfField = 8;
/// Steps of each result that the search begins with when not all can be held, and how often it takes more.
constexpr std::size_t kFirstSteps = 8;
constexpr int kRounds = 5;

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
    const SceneOptions& scene;
    std::vector<Served> served{};
    std::vector<std::size_t>
        held{};  ///< Of `served`: the simplifier holds these; the others are measured afterwards.
    LodOptions options{};

    std::size_t width(std::size_t i) const { return results[served[i].result].components.size(); }
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

ComponentValues values_of(const Making& making, std::size_t i) {
    const Served& served = making.served[i];
    SurfaceField field = making.store.field(served.result, served.values);
    round_as_written(making.results[served.result], making.scene, field);
    return components_of(field);
}

std::vector<LodField> fields_of(const Making& making, std::size_t i, const ComponentValues& values) {
    std::vector<LodField> fields;
    for (const std::vector<float>& component : values)
        fields.push_back({component, making.served[i].component_bound});
    return fields;
}

/// What was found of one level.
struct JudgedLevel {
    LevelJudgement judgement;  ///< By the checker.
    std::vector<double> max;   ///< By the lists of the simplifier, per served.
};

JudgedLevel judge(const Making& making, const LodLevel& level) {
    JudgedLevel judged;
    judged.judgement = judge_level(
        making.surface,
        level.triangles,
        level.certificate.distance_bound,
        making.served.size(),
        [&](std::size_t i) {
            ComponentValues values = values_of(making, i);
            std::vector<double> found;
            for (const LodFieldError& error :
                 measure_level(making.surface, fields_of(making, i, values), level))
                found.push_back(error.max);
            judged.max.push_back(error_of_value(making.results[making.served[i].result].shape, found));
            report_progress(making.work.progress, "levels", fraction_of(i, making.served.size()));
            return values;
        }
    );
    return judged;
}

/// The largest difference as a share of what is allowed; an extreme that is lost is worse than any.
double share_used(const Making& making, const JudgedLevel& judged, std::size_t i) {
    if (!judged.judgement.values[i].keeps_extremes) return std::numeric_limits<double>::infinity();
    const Shape shape = making.results[making.served[i].result].shape;
    const double shown = error_of_value(shape, judged.judgement.values[i].shown);
    return std::max(shown, judged.max[i]) / making.served[i].bound;
}

/// Empty when the level keeps its promise, else what it does not keep; `broken`: of which results and steps.
std::string complaint(const Making& making, const JudgedLevel& judged, std::vector<std::size_t>& broken) {
    const LevelJudgement& judgement = judged.judgement;
    if (!std::isfinite(judgement.max_distance)) return "a triangle of it is where none was";
    for (std::size_t i = 0; i < making.served.size(); ++i) {
        if (!(share_used(making, judged, i) <= 1)) broken.push_back(i);
    }
    if (judgement.without_place + judgement.invented + judgement.lost > 0)
        return fmt::format(
            "{} vertices have no place on it, {} gain and {} lose a value",
            judgement.without_place,
            judgement.invented,
            judgement.lost
        );
    if (broken.empty()) return "";
    std::ranges::stable_sort(broken, std::greater<>{}, [&](std::size_t i) {
        return share_used(making, judged, i);
    });
    const Served& worst = making.served[broken.front()];
    return fmt::format(
        "{} is shown {:.3g} times as far off as it may be",
        making.results[worst.result].id,
        share_used(making, judged, broken.front())
    );
}

/// To nine decimals, so that people read 0.005 and not the last bit of a quotient.
double rounded_up(double fraction) {
    return std::ceil((fraction - 1e-12) * 1e9) / 1e9;
}

SceneLevel described(const Making& making, const LodLevel& level, const JudgedLevel& judged) {
    const LodCertificate& certificate = level.certificate;
    SceneLevel out;
    out.triangles = level.triangles.size();
    out.max_distance =
        std::max({certificate.max_distance, certificate.max_border_distance, judged.judgement.max_distance});
    out.distance_bound = std::max(certificate.distance_bound, out.max_distance);
    out.samples = certificate.samples;
    for (std::size_t i = 0; i < making.served.size(); ++i) {
        const Served& served = making.served[i];
        SceneLevelValues values{served.result, served.values};
        values.max = judged.max[i];
        values.shown = error_of_value(making.results[served.result].shape, judged.judgement.values[i].shown);
        // What was found may be a little more than what was needed for the count.
        values.bound = std::max({certificate.bound * served.bound, values.max, values.shown});
        if (served.range > 0) out.bound = std::max(out.bound, rounded_up(values.bound / served.range));
        out.values.push_back(values);
    }
    return out;
}

using MadeLevels = std::vector<std::pair<SceneLevel, LodLevel>>;

/// Levels for what is held; empty with `why` when one of them does not hold, and `broken`: for what.
MadeLevels attempt(const Making& making, std::string& why, std::vector<std::size_t>& broken) {
    LodResult made;
    {
        std::vector<ComponentValues> values;
        std::vector<LodField> fields;
        for (const std::size_t i : making.held) values.push_back(values_of(making, i));
        for (std::size_t h = 0; h < making.held.size(); ++h) {
            const auto own = fields_of(making, making.held[h], values[h]);
            fields.insert(fields.end(), own.begin(), own.end());
        }
        made = simplify(making.surface, fields, making.options);
    }
    MadeLevels levels;
    std::size_t before = making.surface.triangles.size();
    for (LodLevel& level : made.levels) {
        const auto most = (1 - kWorthwhile) * static_cast<double>(before);
        if (static_cast<double>(level.triangles.size()) > most || level.triangles.empty()) continue;
        before = level.triangles.size();
        const JudgedLevel judged = judge(making, level);
        why = complaint(making, judged, broken);
        if (!why.empty()) return {};
        levels.emplace_back(described(making, level, judged), std::move(level));
    }
    return levels;
}

/// How many fields the simplifier may hold.
std::size_t room_for_fields(const Making& making) {
    const std::size_t fitting = kFieldBytes / (kBytesOfField * making.surface.triangles.size());
    return std::clamp(fitting, kLeastFields, kMostFields);
}

/// True when it was not held before and there is room.
bool hold(Making& making, std::size_t i, std::size_t& room) {
    if (making.width(i) > room || std::ranges::find(making.held, i) != making.held.end()) return false;
    room -= making.width(i);
    making.held.push_back(i);
    return true;
}

/// Everything, or of each result some steps, evenly: then extremes of all steps are kept by name.
void choose_held(Making& making, std::size_t& room) {
    std::size_t all = 0;
    for (std::size_t i = 0; i < making.served.size(); ++i) all += making.width(i);
    if (all <= room) {
        for (std::size_t i = 0; i < making.served.size(); ++i) hold(making, i, room);
        return;
    }
    std::size_t half = room / 2;
    const std::size_t kept_back = room - half;
    for (std::size_t k = 0; k < kFirstSteps; ++k) {
        for (std::size_t i = 0; i < making.served.size(); ++i) {
            const std::size_t steps = making.results[making.served[i].result].values.size();
            if (making.served[i].values == k * (steps - 1) / (kFirstSteps - 1)) hold(making, i, half);
        }
    }
    room = half + kept_back;
    std::vector<bool> is_kept(making.surface.positions.size(), false);
    for (std::size_t i = 0; i < making.served.size(); ++i) {
        const ComponentValues values = values_of(making, i);
        for (const VertexIndex v : lasting_extremes(making.surface, fields_of(making, i, values)))
            is_kept[raw(v)] = true;
    }
    for (std::uint32_t v = 0; v < is_kept.size(); ++v) {
        if (is_kept[v]) making.options.keep.push_back(VertexIndex{v});
    }
}

/// Holds more of what was broken, the worst first; then leaves values less freedom.
MadeLevels search(Making& making, std::string& why) {
    std::size_t room = room_for_fields(making);
    choose_held(making, room);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::size_t> broken;
        why.clear();
        MadeLevels levels = attempt(making, why, broken);
        if (why.empty()) return levels;
        std::size_t more = 0;
        for (const std::size_t i : broken) {
            if (more < making.held.size() && hold(making, i, room)) ++more;
        }
        if (more == 0) making.options.slip /= 2;
    }
    return {};
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
    Making making{work, drawn, store, contents.results, options};
    making.served = everything_shown(contents.results, store, share_of(wish));
    making.options.targets = targets_of(wish);
    making.options.distance = kDistance * diagonal_of(positions);
    std::string why;
    MadeLevels levels = search(making, why);
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
