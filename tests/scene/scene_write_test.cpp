// SPDX-License-Identifier: Apache-2.0
// What stands in a scene, read back.
#include "scene/sample_scenes.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <set>

namespace feelem::test {
namespace {

using ::testing::HasSubstr;

const SceneField& field_of(const Scene& scene, const std::string& id, std::size_t step = 0) {
    for (const SceneField& field : scene.fields) {
        if (scene.results[field.result].id == id && field.step == step) return field;
    }
    throw std::runtime_error("no field of " + id);
}

TEST(Scene, every_value_comes_back_bit_for_bit_at_the_vertices_of_its_node) {
    const auto sample = brick_sample(2, 2, 1);
    const Scene scene = load_scene(write_sample(*sample, "scene_values"));

    ASSERT_EQ(scene.parts.size(), 1u);
    const std::vector<std::int64_t>& ids = scene.parts[0].node_ids;
    for (std::size_t r = 0; r < sample->fields.size(); ++r) {
        const SurfaceField& wanted = sample->fields[r][0];
        const SceneField& found = field_of(scene, sample->contents.results[r].id);
        ASSERT_EQ(found.values.size(), wanted.values.size());
        for (std::size_t i = 0; i < wanted.values.size(); ++i)
            ASSERT_EQ(
                std::bit_cast<std::uint32_t>(found.values[i]), std::bit_cast<std::uint32_t>(wanted.values[i])
            );
    }
    for (std::size_t v = 0; v < ids.size(); ++v) {
        const NodeIndex node = sample->surface.vertex_node[v];
        ASSERT_EQ(ids[v], node == kNoNode ? 0 : raw(sample->mesh.node_ids[raw(node)]));
    }
}

TEST(Scene, triangles_name_their_elements) {
    const auto sample = brick_sample(3, 1, 1);
    const Scene scene = load_scene(write_sample(*sample, "scene_elements"));

    ASSERT_EQ(scene.parts[0].triangles.size(), 14u * 4);
    const std::set<std::int64_t> elements(
        scene.parts[0].element_ids.begin(), scene.parts[0].element_ids.end()
    );
    EXPECT_EQ(elements, (std::set<std::int64_t>{1, 2, 3}));
}

TEST(Scene, missing_values_come_back_missing_and_never_as_zero) {
    auto sample = brick_sample(2, 1, 1);
    add_result(*sample, {"flux"}, [](std::int64_t id, std::size_t, std::size_t) {
        return id == 5 ? NAN : static_cast<float>(id) + 0.1F;
    });
    const Scene scene = load_scene(write_sample(*sample, "scene_missing"));

    const SceneField& field = field_of(scene, "flux");
    std::size_t missing = 0;
    for (std::size_t v = 0; v < field.values.size(); ++v) {
        if (scene.parts[0].node_ids[v] != 5) continue;
        ++missing;
        EXPECT_TRUE(std::isnan(field.values[v]));
        EXPECT_EQ(field.validity[v], Validity::Missing);
    }
    EXPECT_EQ(missing, 2u);
    EXPECT_EQ(scene.results.back().values[0].missing_in_model, 1u);
}

TEST(Scene, a_part_without_any_value_of_a_result_has_no_accessor_for_it) {
    auto sample = brick_sample(1, 1, 1);
    add_result(*sample, {"nothing"}, [](std::int64_t, std::size_t, std::size_t) { return NAN; });
    const std::string path = write_sample(*sample, "scene_nothing");

    EXPECT_THAT(load_scene(path).extras_json, HasSubstr("\"accessors\":[null]"));
}

TEST(Scene, node_ids_beyond_float32_are_split_and_joined) {
    auto sample = brick_sample(1, 1, 1);
    for (NodeId& id : sample->mesh.node_ids) id = NodeId{raw(id) + 16777216LL * 1000 + 12345};
    const Scene scene = load_scene(write_sample(*sample, "scene_large_ids"));

    std::set<std::int64_t> ids(scene.parts[0].node_ids.begin(), scene.parts[0].node_ids.end());
    ids.erase(0);
    std::set<std::int64_t> wanted;
    for (const NodeId id : sample->mesh.node_ids) wanted.insert(raw(id));
    EXPECT_EQ(ids, wanted);
}

TEST(Scene, each_field_is_asked_for_once) {
    auto sample = brick_sample(1, 1, 1);
    write_sample(*sample, "scene_asked");

    EXPECT_EQ(sample->asked, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Scene, same_contents_give_the_same_bytes) {
    const auto sample = brick_sample(2, 2, 2);
    const std::string first = read_file(write_sample(*sample, "scene_same_1"));

    EXPECT_EQ(first, read_file(write_sample(*sample, "scene_same_2")));
}

TEST(Scene, coordinates_far_away_are_shifted_and_reported) {
    auto sample = brick_sample(1, 1, 1);
    for (Point3& position : sample->surface.positions) position[0] += 5'000'000.25;
    Diagnostics diagnostics;
    const std::string path = scratch_folder("scene_far") + "/scene.glb";
    write_scene(sample->contents, path, {}, diagnostics);

    EXPECT_TRUE(diagnostics.has(Code::LargeRounding));
    const Scene scene = load_scene(path);
    EXPECT_EQ(scene.origin[0], 5'000'001);
    for (std::size_t v = 0; v < scene.parts[0].positions.size(); ++v)
        EXPECT_EQ(scene.parts[0].positions[v][0] + scene.origin[0], sample->surface.positions[v][0]);
}

TEST(Scene, other_steps_stand_in_side_files_when_they_are_large) {
    auto sample = brick_sample(2, 1, 1);
    sample->contents.steps.push_back({0, 2, 1, StepKind::Time, 2.5, ""});
    add_result(*sample, {"power"}, [](std::int64_t id, std::size_t step, std::size_t) {
        return static_cast<float>(id) * 0.1F + static_cast<float>(step);
    });
    const std::string path = write_sample(*sample, "scene_steps", {.embed_limit = 0});

    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(path).replace_extension(".d") / "power.2.bin"));
    const Scene scene = load_scene(path);
    EXPECT_EQ(field_of(scene, "power", 1).values, sample->fields.back()[1].values);
    EXPECT_EQ(scene.steps[1].kind, StepKind::Time);
    EXPECT_EQ(scene.steps[1].value, 2.5);
}

TEST(Scene, gltf_has_its_buffers_beside_it) {
    const auto sample = brick_sample(1, 1, 1);
    const std::string path = write_sample(*sample, "scene_gltf", {}, "scene.gltf");

    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(path).replace_extension(".d") / "scene.bin"));
    EXPECT_EQ(load_scene(path).fields.size(), 3u);
}

TEST(Scene, a_failing_field_leaves_the_old_scene_as_it_was) {
    auto sample = brick_sample(1, 1, 1);
    sample->contents.steps.push_back({0, 2, 1, StepKind::Static, 2, ""});
    add_result(*sample, {"power"}, [](std::int64_t id, std::size_t, std::size_t) { return float(id); });
    const std::string path = write_sample(*sample, "scene_old", {.embed_limit = 0});
    const std::string folder = std::filesystem::path(path).replace_extension(".d").string();
    const std::string scene = read_file(path), side = read_file(folder + "/power.2.bin");

    sample->contents.load = [](std::size_t, std::size_t) -> SurfaceField {
        throw Error(Code::BadNumber, "x:1", "no");
    };
    Diagnostics diagnostics;
    EXPECT_THROW(write_scene(sample->contents, path, {.embed_limit = 0}, diagnostics), Error);

    EXPECT_EQ(read_file(path), scene);
    EXPECT_EQ(read_file(folder + "/power.2.bin"), side);
    const auto beside = std::filesystem::directory_iterator(std::filesystem::path(path).parent_path());
    EXPECT_EQ(std::distance(begin(beside), end(beside)), 2);
}

TEST(Scene, a_folder_that_is_not_a_scenes_is_never_replaced) {
    auto sample = brick_sample(1, 1, 1);
    const std::string folder = scratch_folder("scene_foreign");
    std::filesystem::create_directories(folder + "/scene.d");
    write_file(folder + "/scene.d/thesis.txt", "precious");
    Diagnostics diagnostics;

    EXPECT_THROW(write_scene(sample->contents, folder + "/scene.glb", {}, diagnostics), Error);
    EXPECT_EQ(read_file(folder + "/scene.d/thesis.txt"), "precious");
}

TEST(Scene, result_names_cannot_collide) {
    auto sample = brick_sample(1, 1, 1);
    for (const char* id : {"stress_normal", "batchid", "node_id", "temperature_valid"})
        add_result(*sample, {id}, [](std::int64_t node, std::size_t, std::size_t) { return float(node); });
    const Scene scene = load_scene(write_sample(*sample, "scene_names"));

    EXPECT_EQ(scene.fields.size(), 7u);
}

TEST(Scene, a_cut_scene_is_refused_at_every_length) {
    const auto sample = brick_sample(1, 1, 1);
    const std::string bytes = read_file(write_sample(*sample, "scene_whole"));
    const std::string path = scratch_folder("broken/scene_cut") + "/scene.glb";
    for (std::size_t length = 0; length < bytes.size(); length += 997) {
        write_file(path, bytes.substr(0, length));
        EXPECT_THROW(load_scene(path), Error) << length;
    }
}

}  // namespace
}  // namespace feelem::test
