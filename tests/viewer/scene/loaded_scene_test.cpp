// SPDX-License-Identifier: Apache-2.0
// The viewer's arrays are the scene's, bit for bit.
#include "support/paths.hpp"
#include "viewer/scene/loaded_scene.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>

namespace feelem::viewer {
namespace {

/// CTest runs each test in a process of its own.
std::string folder() {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    return test::scratch_folder("viewer_scene_" + test);
}

const std::string& boiler_scene() {
    static const std::string path = [] {
        Job job;
        job.inputs = {test::project_file("examples/boiler/boiler.frd")};
        job.output = folder() + "/boiler.glb";
        job.length_unit = "mm";
        job.presentation_file = test::project_file("examples/boiler/boiler.presentation.json");
        job.levels = "8000";
        Diagnostics diagnostics;
        convert(job, diagnostics, {});
        return job.output;
    }();
    return path;
}

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

TEST(LoadedScene, joined_parts_are_those_of_the_scene) {
    const LoadedScene loaded(boiler_scene());
    const Scene scene = load_scene(boiler_scene());
    const Geometry& geometry = loaded.geometry();
    ASSERT_EQ(geometry.parts.size(), scene.parts.size());
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const PartRange& range = geometry.parts[p];
        const ScenePart& part = scene.parts[p];
        ASSERT_EQ(range.vertices, part.positions.size());
        ASSERT_EQ(range.triangles, part.triangles.size());
        for (std::uint32_t v = 0; v < range.vertices; ++v) {
            EXPECT_EQ(geometry.positions[range.first_vertex + v], part.positions[v]);
            EXPECT_EQ(geometry.node_ids[range.first_vertex + v], part.node_ids[v]);
        }
        for (std::uint32_t t = 0; t < range.triangles; ++t) {
            EXPECT_EQ(geometry.element_ids[range.first_triangle + t], part.element_ids[t]);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(
                    geometry.triangles[range.first_triangle + t][k], part.triangles[t][k] + range.first_vertex
                );
        }
    }
    EXPECT_EQ(loaded.about().title, scene.title);
    EXPECT_EQ(loaded.about().presentation.results.size(), 3U);
}

TEST(LoadedScene, values_are_bit_equal_to_the_scenes_and_read_once) {
    LoadedScene loaded(boiler_scene());
    const Scene scene = load_scene(boiler_scene());
    for (const SceneField& field : scene.fields) {
        const FieldValues& values = loaded.values(field.result, 0);
        const std::size_t first = loaded.geometry().parts[field.part].first_vertex;
        ASSERT_EQ(values.components, scene.results[field.result].components.size());
        for (std::size_t i = 0; i < field.values.size(); ++i)
            ASSERT_TRUE(same_bits(values.values[first * values.components + i], field.values[i]));
        EXPECT_EQ(values.validity[first], field.validity[0]);
        EXPECT_EQ(&loaded.values(field.result, 0), &values);
    }
}

TEST(LoadedScene, an_edge_moves_with_the_vertex_that_it_lies_on) {
    const LoadedScene loaded(boiler_scene());
    const Geometry& geometry = loaded.geometry();
    ASSERT_GT(geometry.edges.size(), 1000U);
    ASSERT_EQ(geometry.edge_vertices.size(), geometry.edge_positions.size());
    double diagonal = 0;
    for (std::size_t k = 0; k < 3; ++k) diagonal += std::pow(geometry.high[k] - geometry.low[k], 2);
    for (std::size_t i = 0; i < geometry.edge_positions.size(); ++i) {
        const auto& vertex = geometry.positions[geometry.edge_vertices[i]];
        double gap = 0;
        for (std::size_t k = 0; k < 3; ++k) gap += std::pow(geometry.edge_positions[i][k] - vertex[k], 2);
        EXPECT_LT(std::sqrt(gap), 0.001 * std::sqrt(diagonal)) << "edge place " << i;
    }
    for (const auto& [from, to] : geometry.edges)
        EXPECT_LT(std::max(from, to), geometry.edge_positions.size());
}

TEST(LoadedScene, millimetres_with_z_up_become_metres_with_y_up) {
    const LoadedScene loaded(boiler_scene());
    const glm::vec4 metres = loaded.to_metres() * glm::vec4(1000, 2000, 3000, 1);
    EXPECT_FLOAT_EQ(metres.x, 1);
    EXPECT_FLOAT_EQ(metres.y, 3);
    EXPECT_FLOAT_EQ(metres.z, -2);
}

TEST(LoadedScene, a_reduced_level_has_fewer_triangles_over_the_same_vertices) {
    LoadedScene loaded(boiler_scene());
    ASSERT_FALSE(loaded.about().levels.empty());
    const auto& level = loaded.level(0);
    EXPECT_EQ(level.size(), loaded.about().levels[0].triangles);
    EXPECT_LT(level.size(), loaded.geometry().triangles.size());
    for (const auto& triangle : level)
        for (const std::uint32_t corner : triangle) ASSERT_LT(corner, loaded.geometry().positions.size());
}

TEST(LoadedScene, a_presentation_finds_its_component) {
    const LoadedScene loaded(boiler_scene());
    const Scene& about = loaded.about();
    const auto found = loaded.find(about.presentation.results[2], 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(about.results[found->result].components[found->component], "von_mises");
    PresentedResult other = about.presentation.results[2];
    other.component = "no_such";
    EXPECT_FALSE(loaded.find(other, 0));
    EXPECT_FALSE(loaded.find(about.presentation.results[2], 7));
}

TEST(LoadedScene, another_presentation_takes_the_place_of_the_scenes_own) {
    const std::string& scene = boiler_scene();
    const std::string other = scene + ".presentation.json";
    test::write_file(other, R"({"format": "feelem-presentation", "version": 1, "results": [
        {"key": "V", "name": "stress", "component": "von_mises", "location": "nodal"}],
        "effects": [{"result": "V", "sense": "visual", "type": "colour", "map": "viridis"}]})");
    const LoadedScene loaded(scene, other);
    ASSERT_EQ(loaded.about().presentation.results.size(), 1U);
    EXPECT_EQ(loaded.about().presentation.results[0].key, "V");
    EXPECT_TRUE(loaded.find(loaded.about().presentation.results[0], 0));
}

TEST(LoadedScene, what_is_not_a_scene_says_so) {
    const std::string path = folder() + "/not_a_scene.bin";
    test::write_file(path, "glTF but no more");
    EXPECT_THROW(LoadedScene{path}, Error);
}

}  // namespace
}  // namespace feelem::viewer
