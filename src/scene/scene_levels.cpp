// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_levels.hpp"

#include "scene/scene_fields.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace feelem {
namespace {

using LevelTriangles = std::vector<std::array<VertexIndex, 3>>;

std::string level_indices(const ScenePartBuild& part, std::size_t level) {
    return fmt::format("{}indices/lod{}", part.prefix, level + 1);
}

/// The triangles of one part: they stand together.
std::span<const std::array<VertexIndex, 3>> triangles_of(
    const LevelTriangles& triangles, const SurfacePart& part
) {
    const auto is_inside = [&](const std::array<VertexIndex, 3>& t) {
        return raw(t[0]) >= part.first_vertex && raw(t[0]) - part.first_vertex < part.vertex_count;
    };
    const auto first = std::ranges::find_if(triangles, is_inside);
    const auto last = std::find_if_not(first, triangles.end(), is_inside);
    return {first, last};
}

}  // namespace

void write_level_triangles(SceneBuild& build) {
    for (std::size_t level = 0; level < build.contents.levels.size(); ++level) {
        std::uint64_t written = 0;
        for (const ScenePartBuild& part : build.parts) {
            const SurfacePart& range = *part.range;
            const auto triangles = triangles_of(build.contents.level_triangles[level], range);
            written += triangles.size();
            // glTF has no empty arrays.
            if (triangles.empty()) continue;
            const ArraySpec spec{level_indices(part, level), 1, 3 * triangles.size(), gltf::kIndexTarget};
            build.arrays.indices(spec, range.vertex_count, [&](std::size_t i) {
                return raw(triangles[i / 3][i % 3]) - range.first_vertex;
            });
        }
        if (written != build.contents.levels[level].triangles)
            throw Error(Code::BadStructure, "", "triangles of a level do not follow the parts");
    }
}

void write_levels(JsonText& json, const SceneBuild& build) {
    if (build.contents.levels.empty()) return;
    json.key("levels").begin_array();
    for (std::size_t i = 0; i < build.contents.levels.size(); ++i) {
        const SceneLevel& level = build.contents.levels[i];
        json.begin_object().member("triangles", level.triangles).key("indices").begin_array();
        for (const ScenePartBuild& part : build.parts) {
            const bool none = triangles_of(build.contents.level_triangles[i], *part.range).empty();
            json.text_or_null(none ? std::string() : level_indices(part, i));
        }
        json.end_array().member("bound", level.bound).key("distance").begin_object();
        json.member("bound", level.distance_bound).member("max", level.max_distance).end_object();
        json.member("samples", level.samples).key("values").begin_array();
        for (const SceneLevelValues& values : level.values) {
            const SceneResult& result = build.contents.results[values.result];
            json.begin_object().member("result", result.id);
            json.member("step", step_id(result.values[values.values])).member("bound", values.bound);
            json.member("max", values.max).member("shown", values.shown).end_object();
        }
        json.end_array().end_object();
    }
    json.end_array();
}

void write_level_claims(JsonText& json, const SceneBuild& build) {
    if (build.contents.levels.empty()) return;
    json.key("levels").begin_array();
    for (const SceneLevel& level : build.contents.levels) {
        double worst = 0;
        for (const SceneLevelValues& values : level.values) {
            if (values.bound > 0) worst = std::max(worst, std::max(values.max, values.shown) / values.bound);
        }
        json.begin_object().member("triangles", level.triangles).member("bound", level.bound);
        json.member("worstOfBound", worst).end_object();
    }
    json.end_array();
}

std::vector<std::vector<std::array<std::uint32_t, 3>>> read_level_triangles(
    const SceneFile& file, std::size_t level, std::span<const ScenePart> parts
) {
    const std::vector<std::string>& names = file.document().level_indices[level];
    std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (names[p].empty()) continue;
        const std::vector<std::uint32_t> corners = file.integers(file.find(names[p]));
        const bool fits =
            std::ranges::all_of(corners, [&](std::uint32_t c) { return c < parts[p].positions.size(); });
        if (!fits || corners.size() % 3 != 0)
            throw Error(
                Code::BadScene, file.path(), fmt::format("'{}' has a triangle without vertices", names[p])
            );
        for (std::size_t i = 0; i < corners.size(); i += 3)
            triangles[p].push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
    return triangles;
}

}  // namespace feelem
