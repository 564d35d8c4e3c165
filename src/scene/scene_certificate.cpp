// SPDX-License-Identifier: Apache-2.0
// The conversion certificate: what was in the files, what was kept and why, what the scene holds.
#include "scene/json_text.hpp"
#include "scene/scene_extras.hpp"
#include "scene/scene_fields.hpp"
#include "scene/scene_levels.hpp"

namespace feelem {
namespace {

void write_skin(JsonText& json, const SkinReport& skin, std::uint64_t elements) {
    json.key("skin").begin_object().member("elements", elements);
    json.key("facets")
        .begin_object()
        .member("in", skin.solid_facets_in)
        .member("kept", skin.solid_facets_kept);
    json.member("keptTriangles", skin.solid_tri_kept).member("keptQuads", skin.solid_quad_kept);
    json.key("dropped").begin_object().member("inner", skin.facets_inner);
    json.member("manyOwners", skin.facets_many_owners).member("collapsed", skin.facets_collapsed);
    json.member("ofDuplicates", skin.facets_of_duplicates).end_object();
    json.member("unmatched", skin.unmatched_facets);
    json.member("shellTriangles", skin.shell_tri).member("shellQuads", skin.shell_quad).end_object();
    json.member("duplicateElements", skin.duplicate_elements)
        .member("invertedElements", skin.inverted_elements);
    json.member("vertices", skin.vertices).member("triangles", skin.triangles).key("closed");
    if (skin.has_solids)
        json.value(skin.closed);
    else
        json.null();
    json.member("area", skin.area).member("volume", skin.volume).end_object();
}

void write_scene_counts(JsonText& json, const SceneBuild& build) {
    std::uint64_t vertices = 0, triangles = 0;
    for (const ScenePartBuild& part : build.parts) {
        vertices += part.range->vertex_count;
        triangles += part.range->triangle_count;
    }
    json.key("scene").begin_object().member("vertices", vertices).member("triangles", triangles);
    json.member("edges", build.edges).member("area", build.area).member("volume", build.volume).end_object();
}

void write_extreme(JsonText& json, std::string_view key, const std::optional<Extreme>& extreme) {
    json.key(key);
    if (!extreme) {
        json.null();
        return;
    }
    json.begin_object()
        .member("value", static_cast<double>(extreme->value))
        .member("id", extreme->id)
        .end_object();
}

void write_results(JsonText& json, const SceneBuild& build) {
    json.key("results").begin_array();
    for (std::size_t r = 0; r < build.contents.results.size(); ++r) {
        const SceneResult& result = build.contents.results[r];
        for (std::size_t v = 0; v < result.values.size(); ++v) {
            const WrittenField& field = build.written[r][v];
            json.begin_object().member("result", result.id).member("step", step_id(result.values[v]));
            json.key("model").begin_object();
            write_extreme(json, "min", result.values[v].min);
            write_extreme(json, "max", result.values[v].max);
            json.member("missing", result.values[v].missing_in_model).end_object();
            json.key("skin").begin_object();
            write_extreme(json, "min", field.min);
            write_extreme(json, "max", field.max);
            json.member("missing", field.missing).member("interpolated", field.interpolated).end_object();
            json.end_object();
        }
    }
    json.end_array();
}

}  // namespace

std::string certificate_text(const SceneBuild& build) {
    JsonText json;
    json.begin_object().member("version", 1);
    const Mesh& mesh = *build.contents.mesh;
    json.key("model")
        .begin_object()
        .member("nodes", mesh.node_count())
        .member("elements", mesh.element_count());
    json.key("skippedElements").begin_object();
    for (const auto& [type, count] : mesh.skipped_elements) json.member(type, count);
    json.end_object().end_object();
    write_skin(json, build.contents.surface->report, mesh.element_count());
    write_scene_counts(json, build);
    json.member("largestCoordinateRounding", build.largest_rounding);
    write_results(json, build);
    write_level_claims(json, build);
    json.key("notes").begin_object();
    for (const auto& [name, text] : build.contents.notes) json.member(name, text);
    json.end_object().key("digests").begin_object();
    for (const Digest& digest : build.digests) json.member(digest.accessor, digest.sha256);
    json.end_object().end_object();
    return json.text();
}

}  // namespace feelem
