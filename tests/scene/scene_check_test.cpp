// SPDX-License-Identifier: Apache-2.0
// A scene agrees with its certificate, and no change of it goes unnoticed.
#include "scene/sample_scenes.hpp"
#include "scene/scene_file.hpp"
#include "support/meshes.hpp"
#include "support/paths.hpp"

#include "feelem/skin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace feelem::test {
namespace {

std::vector<std::string> broken_claims(const std::string& path) {
    std::vector<std::string> names;
    for (const Claim& claim : check_scene(path)) {
        if (!claim.holds) names.push_back(claim.name + ": " + claim.claimed + " / " + claim.found);
    }
    return names;
}

/// A scene whose bytes can be changed array by array.
struct Changed {
    std::string path, bytes;

    explicit Changed(const Sample& sample, const std::string& name) {
        path = scratch_folder("broken/" + name) + "/scene.glb";
        Diagnostics diagnostics;
        write_scene(sample.contents, path, {}, diagnostics);
        bytes = read_file(path);
    }
    std::size_t place(const std::string& accessor) const {
        const SceneFile file(path);
        const SceneDocument& document = file.document();
        const ReadAccessor& read = document.accessors[static_cast<std::size_t>(file.find(accessor))];
        const ReadView& view = document.views[static_cast<std::size_t>(read.accessor.view)];
        return bytes.find("BIN", 12) + 4 + static_cast<std::size_t>(view.view.offset + read.offset);
    }
    template <class T>
    T get(const std::string& accessor, std::size_t index) const {
        T value;
        std::memcpy(&value, bytes.data() + place(accessor) + index * sizeof(T), sizeof(T));
        return value;
    }
    template <class T>
    void put(const std::string& accessor, std::size_t index, T value) {
        std::memcpy(bytes.data() + place(accessor) + index * sizeof(T), &value, sizeof(T));
        write_file(path, bytes);
    }
};

TEST(Check, every_claim_of_an_untouched_scene_holds) {
    auto sample = brick_sample(3, 2, 2);
    add_result(*sample, {"flux"}, [](std::int64_t id, std::size_t, std::size_t) {
        return id % 5 == 0 ? NAN : static_cast<float>(id) * 0.7F;
    });
    const std::string path = write_sample(*sample, "check_whole");

    EXPECT_THAT(broken_claims(path), ::testing::IsEmpty());
    EXPECT_GT(check_scene(path).size(), 40u);
}

TEST(Check, a_range_that_ends_at_minus_zero_holds) {
    auto sample = brick_sample(1, 1, 1);
    add_result(*sample, {"flux"}, [](std::int64_t, std::size_t, std::size_t) { return -0.0F; });
    EXPECT_THAT(broken_claims(write_sample(*sample, "check_minus_zero")), ::testing::IsEmpty());
}

TEST(Check, holds_for_every_element_type_that_the_skin_stage_draws) {
    for (std::size_t type = 0; type < kElementTypeCount; ++type) {
        const Mesh mesh = one_element(static_cast<ElementType>(type));
        if (element_row(static_cast<ElementType>(type)).dimension < 2) continue;
        for (const Domain domain : {Domain::Node, Domain::ElementNode}) {
            Diagnostics diagnostics;
            SkinOptions options;
            options.domain = domain;
            const Surface surface = make_skin(mesh, options, diagnostics);
            SceneContents contents;
            contents.mesh = &mesh;
            contents.surface = &surface;
            contents.steps.emplace_back();
            const std::string name(element_row(static_cast<ElementType>(type)).name);
            const std::string path =
                scratch_folder("check_" + name + (domain == Domain::Node ? "" : "_by_element")) +
                "/scene.glb";
            write_scene(contents, path, {}, diagnostics);
            EXPECT_THAT(broken_claims(path), ::testing::IsEmpty()) << name;
        }
    }
}

TEST(Check, notices_one_flipped_bit_of_a_value) {
    Changed scene(*brick_sample(2, 1, 1), "check_value");
    scene.put<std::uint32_t>("p0/_TEMPERATURE/1", 3, scene.get<std::uint32_t>("p0/_TEMPERATURE/1", 3) ^ 1u);

    EXPECT_THAT(
        broken_claims(scene.path), ::testing::Contains(::testing::HasSubstr("digest p0/_TEMPERATURE/1"))
    );
}

TEST(Check, notices_a_dropped_triangle) {
    Changed scene(*brick_sample(2, 1, 1), "check_triangle");
    for (std::size_t corner = 0; corner < 3; ++corner)
        scene.put<std::uint16_t>(
            "p0/indices", 6 + corner, scene.get<std::uint16_t>("p0/indices", 3 + corner)
        );

    const std::vector<std::string> broken = broken_claims(scene.path);
    EXPECT_THAT(broken, ::testing::Contains(::testing::HasSubstr("digest p0/indices")));
    EXPECT_THAT(broken, ::testing::Contains(::testing::HasSubstr("closed: yes / no")));
}

TEST(Check, notices_two_swapped_node_ids) {
    Changed scene(*brick_sample(2, 1, 1), "check_ids");
    const float first = scene.get<float>("p0/_NODE_ID", 0), second = scene.get<float>("p0/_NODE_ID", 1);
    ASSERT_NE(first, second);
    scene.put("p0/_NODE_ID", 0, second);
    scene.put("p0/_NODE_ID", 1, first);

    const std::vector<std::string> broken = broken_claims(scene.path);
    EXPECT_THAT(broken, ::testing::Contains(::testing::HasSubstr("digest p0/_NODE_ID")));
    EXPECT_THAT(broken, ::testing::Contains(::testing::HasSubstr("nodes at more than one place")));
}

TEST(Check, notices_two_swapped_element_ids) {
    Changed scene(*brick_sample(2, 1, 1), "check_elements");
    scene.put<std::uint32_t>("p0/elements", 0, 2);

    EXPECT_THAT(broken_claims(scene.path), ::testing::Contains(::testing::HasSubstr("digest p0/elements")));
}

TEST(Check, notices_a_change_in_any_array_of_the_scene) {
    const auto sample = brick_sample(1, 1, 1);
    Changed scene(*sample, "check_any");
    const std::string whole = scene.bytes;
    std::vector<std::string> names;
    const SceneFile file(scene.path);
    for (const auto& [name, index] : file.document().by_name) names.push_back(name);
    ASSERT_GT(names.size(), 15u);
    for (const std::string& name : names) {
        scene.bytes = whole;
        write_file(scene.path, whole);
        const std::uint8_t byte = scene.get<std::uint8_t>(name, 1);
        scene.put<std::uint8_t>(name, 1, byte ^ 0x10);
        EXPECT_THAT(broken_claims(scene.path), ::testing::Contains(::testing::HasSubstr("digest " + name)))
            << name;
    }
}

TEST(Check, notices_an_extreme_that_was_written_wrongly) {
    auto sample = brick_sample(2, 1, 1);
    Changed scene(*sample, "check_extreme");
    // The same length, so that the chunk stays whole.
    const std::string claim = "\"skin\":{\"min\":{\"value\":20.100000381469727,\"id\":1}";
    const std::size_t at = scene.bytes.find(claim);
    ASSERT_NE(at, std::string::npos);
    scene.bytes[at + claim.size() - 2] = '2';
    write_file(scene.path, scene.bytes);

    EXPECT_THAT(
        broken_claims(scene.path), ::testing::Contains(::testing::HasSubstr("minimum of temperature"))
    );
}

TEST(Check, notices_a_range_over_the_model_that_the_certificate_states_otherwise) {
    auto sample = brick_sample(2, 1, 1);
    Changed scene(*sample, "check_model_range");
    const std::string claim = R"("model":{"min":{"value":)";
    const std::size_t at = scene.bytes.find(claim);
    ASSERT_NE(at, std::string::npos);
    char& digit = scene.bytes[at + claim.size()];
    digit = digit == '1' ? '2' : '1';
    write_file(scene.path, scene.bytes);

    EXPECT_THAT(broken_claims(scene.path), ::testing::Contains(::testing::HasSubstr("range over the model")));
}

/// The sample's scene with one float of an array moved, and what no longer holds besides its digest.
std::vector<std::string> broken_by_moving(const std::string& array, std::size_t index, float by) {
    Changed scene(*brick_sample(2, 1, 1), "check_shown_" + std::to_string(index));
    scene.put<float>(array, index, scene.get<float>(array, index) + by);
    return broken_claims(scene.path);
}

TEST(Check, makes_colours_again_from_the_values) {
    EXPECT_THAT(
        broken_by_moving("p0/TEXCOORD_0", 4, 0.001F),
        ::testing::Contains(::testing::HasSubstr("colours of temperature"))
    );
}

TEST(Check, makes_the_deformed_shape_again_from_displacement_and_factor) {
    EXPECT_THAT(
        broken_by_moving("p0/deformation/1", 7, 1e-3F),
        ::testing::Contains(::testing::HasSubstr("deformed shape"))
    );
}

TEST(Check, notices_a_normal_that_looks_inwards) {
    Changed scene(*brick_sample(2, 1, 1), "check_normal");
    for (std::size_t axis = 0; axis < 3; ++axis)
        scene.put<float>("p0/NORMAL", axis, -scene.get<float>("p0/NORMAL", axis));
    EXPECT_THAT(broken_claims(scene.path), ::testing::Contains(::testing::HasSubstr("normals")));
}

TEST(Check, notices_a_factor_and_a_colour_range_that_are_not_those_of_the_presentation) {
    for (const std::string claim :
         {R"("deformation":{"result":"displacement","step":1,"factor":)",
          R"("component":"value","step":1,"range":[)"}) {
        Changed scene(*brick_sample(2, 1, 1), "check_forged");
        const std::size_t at = scene.bytes.find(claim);
        ASSERT_NE(at, std::string::npos) << claim;
        char& digit = scene.bytes[at + claim.size()];
        digit = digit == '1' ? '2' : '1';
        write_file(scene.path, scene.bytes);
        EXPECT_THAT(broken_claims(scene.path), ::testing::Not(::testing::IsEmpty())) << claim;
    }
}

}  // namespace
}  // namespace feelem::test
