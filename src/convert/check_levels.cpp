// SPDX-License-Identifier: Apache-2.0
// check_levels: what a scene promises of its levels of detail, found again from its full triangles and
// values.
#include "convert/judge_level.hpp"
#include "scene/scene_levels.hpp"
#include "scene/scene_read.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace feelem {
namespace {

using Triangles = std::vector<std::array<VertexIndex, 3>>;

/// All parts with their vertices one after the other.
struct WholeScene {
    const SceneFile& file;
    std::vector<ScenePart> parts{};
    std::vector<std::uint32_t> first{};  ///< Vertex of each part.
    std::vector<Point3> positions{};
    Triangles triangles{};
    LodSurface surface{};
};

Triangles joined(
    const WholeScene& scene, std::size_t part, std::span<const std::array<std::uint32_t, 3>> triangles
) {
    Triangles out;
    const std::uint32_t first = scene.first[part];
    for (const auto& t : triangles)
        out.push_back({VertexIndex{first + t[0]}, VertexIndex{first + t[1]}, VertexIndex{first + t[2]}});
    return out;
}

void join_parts(WholeScene& scene) {
    scene.parts = read_parts(scene.file);
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        scene.first.push_back(static_cast<std::uint32_t>(scene.positions.size()));
        for (const auto& at : scene.parts[p].positions) {
            scene.positions.push_back({at[0], at[1], at[2]});
            scene.surface.parts.push_back(static_cast<std::uint32_t>(p));
        }
        const Triangles own = joined(scene, p, scene.parts[p].triangles);
        scene.triangles.insert(scene.triangles.end(), own.begin(), own.end());
    }
    scene.surface.positions = scene.positions;
    scene.surface.triangles = scene.triangles;
}

/// Of one result at one step over all parts; missing where a part has none.
ComponentValues values_of(const WholeScene& scene, const SceneLevelValues& wanted) {
    const std::size_t width = scene.file.document().scene.results[wanted.result].components.size();
    ComponentValues out(
        width, std::vector<float>(scene.positions.size(), std::numeric_limits<float>::quiet_NaN())
    );
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const auto field = read_field(scene.file, scene.parts, {wanted.result, wanted.values, p});
        if (!field) continue;
        for (std::size_t v = 0; v < scene.parts[p].positions.size(); ++v) {
            for (std::size_t c = 0; c < width; ++c) out[c][scene.first[p] + v] = field->values[v * width + c];
        }
    }
    return out;
}

void claim_at_most(std::vector<Claim>& claims, const std::string& name, double bound, double found) {
    claims.push_back(
        {name,
         fmt::format("within {}", bound),
         fmt::format("{}", found),
         found <= bound && std::isfinite(bound)}
    );
}
void claim_equal(
    std::vector<Claim>& claims, const std::string& name, std::uint64_t said, std::uint64_t found
) {
    claims.push_back({name, fmt::format("{}", said), fmt::format("{}", found), said == found});
}

/// The fraction that people read must not be smaller than any of the bounds.
void claim_fraction(
    std::vector<Claim>& claims, const Scene& scene, const SceneLevel& level, const std::string& name
) {
    double worst = 0;
    for (const SceneLevelValues& values : level.values) {
        const SceneResult& result = scene.results[values.result];
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const SceneValues& at : result.values) {
            if (at.min) low = std::min(low, static_cast<double>(at.min->value));
            if (at.max) high = std::max(high, static_cast<double>(at.max->value));
        }
        if (high > low) worst = std::max(worst, values.bound / (high - low));
    }
    // Both are rounded quotients.
    claim_at_most(claims, name + ": bound as a fraction of the ranges", level.bound * (1 + 1e-9), worst);
}

void check_one(const WholeScene& scene, std::size_t index, std::vector<Claim>& claims) {
    const Scene& said = scene.file.document().scene;
    const SceneLevel& level = said.levels[index];
    const std::string name = fmt::format("level {}", index + 1);
    Triangles triangles;
    const auto by_part = read_level_triangles(scene.file, index, scene.parts);
    for (std::size_t p = 0; p < by_part.size(); ++p) {
        const Triangles own = joined(scene, p, by_part[p]);
        triangles.insert(triangles.end(), own.begin(), own.end());
    }
    claim_equal(claims, name + ": triangles", level.triangles, triangles.size());
    std::uint64_t shown = 0;
    for (const SceneResult& result : said.results) shown += result.values.size();
    claim_equal(claims, name + ": results and steps with a bound", shown, level.values.size());
    claim_fraction(claims, said, level, name);
    const LevelJudgement found =
        judge_level(scene.surface, triangles, level.distance_bound, level.values.size(), [&](std::size_t i) {
            return values_of(scene, level.values[i]);
        });
    claim_at_most(claims, name + ": distance", level.distance_bound, found.max_distance);
    claim_equal(claims, name + ": vertices without a place", 0, found.without_place);
    claim_equal(claims, name + ": values gained or lost", 0, found.invented + found.lost);
    for (std::size_t i = 0; i < level.values.size(); ++i) {
        const SceneLevelValues& values = level.values[i];
        const SceneResult& result = said.results[values.result];
        const std::string what =
            fmt::format("{}: {} at step {}", name, result.id, result.values[values.values].step + 1);
        claim_at_most(claims, what, values.bound, error_of_value(result.shape, found.values[i].shown));
        claim_at_most(claims, what + " as made", values.bound, std::max(values.max, values.shown));
        claims.push_back(
            {what + ", extremes",
             "drawn as they are",
             found.values[i].keeps_extremes ? "drawn as they are" : "lost",
             found.values[i].keeps_extremes}
        );
    }
}

}  // namespace

std::vector<Claim> check_levels(const std::string& scene_path) {
    const SceneFile file(scene_path);
    std::vector<Claim> claims;
    if (file.document().scene.levels.empty()) return claims;
    WholeScene scene{file};
    try {
        join_parts(scene);
        for (std::size_t i = 0; i < file.document().scene.levels.size(); ++i) check_one(scene, i, claims);
    } catch (const Error& error) {
        claims.push_back({"levels fit the scene", "yes", error.what(), false});
    }
    return claims;
}

}  // namespace feelem
