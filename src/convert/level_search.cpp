// SPDX-License-Identifier: Apache-2.0
#include "convert/level_search.hpp"

#include "convert/judge_level.hpp"
#include "convert/stage.hpp"
#include "scene/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace feelem {
namespace {

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

ComponentValues values_of(const LevelSearch& search, std::size_t i) {
    const ServedValues& served = search.served[i];
    SurfaceField field = search.store.field(served.result, served.values);
    round_as_written(search.results[served.result], search.scene, field);
    return components_of(field);
}

std::vector<LodField> fields_of(const LevelSearch& search, std::size_t i, const ComponentValues& values) {
    std::vector<LodField> fields;
    for (const std::vector<float>& component : values)
        fields.push_back({component, search.served[i].component_bound});
    return fields;
}

/// What was found of one level.
struct JudgedLevel {
    LevelJudgement judgement;  ///< By the checker.
    std::vector<double> max;   ///< By the lists of the simplifier, per served.
};

JudgedLevel judge(const LevelSearch& search, const LodLevel& level) {
    JudgedLevel judged;
    judged.judgement = judge_level(
        search.surface,
        level.triangles,
        level.certificate.distance_bound,
        search.served.size(),
        [&](std::size_t i) {
            ComponentValues values = values_of(search, i);
            std::vector<double> found;
            for (const LodFieldError& error :
                 measure_level(search.surface, fields_of(search, i, values), level))
                found.push_back(error.max);
            judged.max.push_back(error_of_value(search.results[search.served[i].result].shape, found));
            report_progress(search.work.progress, "levels", fraction_of(i, search.served.size()));
            return values;
        }
    );
    return judged;
}

/// The largest difference as a share of what is allowed; an extreme that is lost is worse than any.
double share_used(const LevelSearch& search, const JudgedLevel& judged, std::size_t i) {
    if (!judged.judgement.values[i].keeps_extremes) return std::numeric_limits<double>::infinity();
    const Shape shape = search.results[search.served[i].result].shape;
    const double shown = error_of_value(shape, judged.judgement.values[i].shown);
    return std::max(shown, judged.max[i]) / search.served[i].bound;
}

/// Empty when the level keeps its promise, else what it does not keep; `broken`: of which results and steps.
std::string complaint(
    const LevelSearch& search, const JudgedLevel& judged, std::vector<std::size_t>& broken
) {
    const LevelJudgement& judgement = judged.judgement;
    if (!std::isfinite(judgement.max_distance)) return "a triangle of it is where none was";
    for (std::size_t i = 0; i < search.served.size(); ++i) {
        if (!(share_used(search, judged, i) <= 1)) broken.push_back(i);
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
        return share_used(search, judged, i);
    });
    const ServedValues& worst = search.served[broken.front()];
    return fmt::format(
        "{} is shown {:.3g} times as far off as it may be",
        search.results[worst.result].id,
        share_used(search, judged, broken.front())
    );
}

/// To nine decimals, so that people read 0.005 and not the last bit of a quotient.
double rounded_up(double fraction) {
    return std::ceil((fraction - 1e-12) * 1e9) / 1e9;
}

SceneLevel described(const LevelSearch& search, const LodLevel& level, const JudgedLevel& judged) {
    const LodCertificate& certificate = level.certificate;
    SceneLevel out;
    out.triangles = level.triangles.size();
    out.max_distance =
        std::max({certificate.max_distance, certificate.max_border_distance, judged.judgement.max_distance});
    out.distance_bound = std::max(certificate.distance_bound, out.max_distance);
    out.samples = certificate.samples;
    for (std::size_t i = 0; i < search.served.size(); ++i) {
        const ServedValues& served = search.served[i];
        SceneLevelValues values{served.result, served.values};
        values.max = judged.max[i];
        values.shown = error_of_value(search.results[served.result].shape, judged.judgement.values[i].shown);
        // What was found may be a little more than what was needed for the count.
        values.bound = std::max({certificate.bound * served.bound, values.max, values.shown});
        if (served.range > 0) out.bound = std::max(out.bound, rounded_up(values.bound / served.range));
        out.values.push_back(values);
    }
    return out;
}

/// Levels for what is held; empty with `why` when one of them does not hold, and `broken`: for what.
MadeLevels attempt(const LevelSearch& search, std::string& why, std::vector<std::size_t>& broken) {
    LodResult made;
    {
        std::vector<ComponentValues> values;
        std::vector<LodField> fields;
        for (const std::size_t i : search.held) values.push_back(values_of(search, i));
        for (std::size_t h = 0; h < search.held.size(); ++h) {
            const auto own = fields_of(search, search.held[h], values[h]);
            fields.insert(fields.end(), own.begin(), own.end());
        }
        made = simplify(search.surface, fields, search.options);
    }
    MadeLevels levels;
    std::size_t before = search.surface.triangles.size();
    for (LodLevel& level : made.levels) {
        const auto most = (1 - kWorthwhile) * static_cast<double>(before);
        if (static_cast<double>(level.triangles.size()) > most || level.triangles.empty()) continue;
        before = level.triangles.size();
        const JudgedLevel judged = judge(search, level);
        why = complaint(search, judged, broken);
        if (!why.empty()) return {};
        levels.emplace_back(described(search, level, judged), std::move(level));
    }
    return levels;
}

/// How many fields the simplifier may hold.
std::size_t room_for_fields(const LevelSearch& search) {
    const std::size_t fitting = kFieldBytes / (kBytesOfField * search.surface.triangles.size());
    return std::clamp(fitting, kLeastFields, kMostFields);
}

/// True when it was not held before and there is room.
bool hold(LevelSearch& search, std::size_t i, std::size_t& room) {
    if (search.width(i) > room || std::ranges::find(search.held, i) != search.held.end()) return false;
    room -= search.width(i);
    search.held.push_back(i);
    return true;
}

/// Everything, or of each result some steps, evenly: then extremes of all steps are kept by name.
void choose_held(LevelSearch& search, std::size_t& room) {
    std::size_t all = 0;
    for (std::size_t i = 0; i < search.served.size(); ++i) all += search.width(i);
    if (all <= room) {
        for (std::size_t i = 0; i < search.served.size(); ++i) hold(search, i, room);
        return;
    }
    std::size_t half = room / 2;
    const std::size_t kept_back = room - half;
    for (std::size_t k = 0; k < kFirstSteps; ++k) {
        for (std::size_t i = 0; i < search.served.size(); ++i) {
            const std::size_t steps = search.results[search.served[i].result].values.size();
            if (search.served[i].values == k * (steps - 1) / (kFirstSteps - 1)) hold(search, i, half);
        }
    }
    room = half + kept_back;
    std::vector<bool> is_kept(search.surface.positions.size(), false);
    for (std::size_t i = 0; i < search.served.size(); ++i) {
        const ComponentValues values = values_of(search, i);
        for (const VertexIndex v : lasting_extremes(search.surface, fields_of(search, i, values)))
            is_kept[raw(v)] = true;
    }
    for (std::uint32_t v = 0; v < is_kept.size(); ++v) {
        if (is_kept[v]) search.options.keep.push_back(VertexIndex{v});
    }
}

}  // namespace

/// Holds more of what was broken, the worst first; then leaves values less freedom.
MadeLevels search_levels(LevelSearch& search, std::string& why) {
    std::size_t room = room_for_fields(search);
    choose_held(search, room);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::size_t> broken;
        why.clear();
        MadeLevels levels = attempt(search, why, broken);
        if (why.empty()) return levels;
        std::size_t more = 0;
        for (const std::size_t i : broken) {
            if (more < search.held.size() && hold(search, i, room)) ++more;
        }
        if (more == 0) search.options.slip /= 2;
    }
    return {};
}

}  // namespace feelem
