// SPDX-License-Identifier: Apache-2.0
// Levels of a real model with real results: the boiler of examples/, its skin cut finely.
#include "lod_surfaces.hpp"
#include "support/opened_model.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace feelem {
namespace {

struct Boiler {
    Surface surface;
    std::vector<SurfaceField> values;  ///< Temperature, von Mises, length of the displacement.
};

Boiler boiler(unsigned subdivide) {
    const auto opened = test::open_path(test::project_file("examples/boiler/boiler.frd"));
    const Mesh& mesh = opened->model->mesh();
    SkinOptions options;
    options.subdivide = subdivide;
    Boiler out;
    out.surface = make_skin(mesh, options, opened->diagnostics);
    for (std::size_t i = 0; i < opened->model->results().size(); ++i) {
        const std::string name = opened->model->results()[i].name;
        const std::string component = name == "temperature"    ? "value"
                                      : name == "stress"       ? "von_mises"
                                      : name == "displacement" ? "magnitude"
                                                               : "";
        if (component.empty()) continue;
        out.values.push_back(carry(mesh, out.surface, component_of(opened->model->load(i), component)));
    }
    return out;
}

std::vector<LodField> fields_of(const Boiler& model, double share) {
    std::vector<LodField> fields;
    for (const SurfaceField& field : model.values) {
        const auto [low, high] = std::ranges::minmax_element(field.values);
        fields.push_back({field.values, share * (static_cast<double>(*high) - static_cast<double>(*low))});
    }
    return fields;
}

TEST(LodBoiler, one_chain_serves_temperature_stress_and_displacement) {
    const Boiler model = boiler(2);
    ASSERT_EQ(model.values.size(), 3U);
    const LodSurface surface = lod_surface(model.surface);
    const auto fields = fields_of(model, 0.02);
    LodOptions options;
    options.targets = {{0, 0.25}, {0, 1}};

    const LodResult result = simplify(surface, fields, options);

    test::expect_sound(surface, fields, result, options);
    EXPECT_EQ(result.report.non_manifold, 0U);
    EXPECT_LT(result.levels[1].triangles.size(), model.surface.triangles.size() / 3);
}

TEST(LodBoiler, extremes_of_stress_stay_bit_by_bit) {
    const Boiler model = boiler(1);
    const LodSurface surface = lod_surface(model.surface);
    const auto fields = fields_of(model, 0.01);

    const LodLevel level = simplify(surface, fields, {}).levels[0];

    // By place, so that a summit is one across a crease.
    std::vector<std::array<VertexIndex, 3>> welded;
    for (const auto& t : model.surface.triangles)
        welded.push_back(
            {VertexIndex{surface.places[raw(t[0])]},
             VertexIndex{surface.places[raw(t[1])]},
             VertexIndex{surface.places[raw(t[2])]}}
        );
    std::vector<bool> stays(model.surface.positions.size(), false);
    for (const VertexIndex v : level.vertices) stays[surface.places[raw(v)]] = true;
    std::size_t extremes = 0;
    for (const LodField& field : fields) {
        for (const float sign : {1.0F, -1.0F}) {
            for (const std::uint32_t v :
                 test::lasting_extremes(field.values, welded, 2 * field.bound, sign)) {
                EXPECT_TRUE(stays[v]) << "vertex " << v;
                ++extremes;
            }
        }
    }
    EXPECT_GT(extremes, 10U);
}

TEST(LodBoiler, vertices_of_a_node_are_one_point_and_others_are_not) {
    const Boiler model = boiler(2);
    const LodSurface surface = lod_surface(model.surface);

    const test::EdgeUse use = test::edge_use(surface, surface.triangles);
    EXPECT_EQ(use.borders, 0U);
    EXPECT_EQ(use.non_manifold, 0U);
    for (std::uint32_t v = 0; v < surface.places.size(); ++v)
        EXPECT_EQ(model.surface.vertex_node[v], model.surface.vertex_node[surface.places[v]]);
}

}  // namespace
}  // namespace feelem
