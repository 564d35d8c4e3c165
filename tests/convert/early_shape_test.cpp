// SPDX-License-Identifier: Apache-2.0
// The shape alone, offered while results are still to be read.
#include "convert/scene_for_viewing.hpp"
#include "support/paths.hpp"
#include "support/threads.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"
#include "feelem/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace feelem::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Job boiler_to(const std::string& folder) {
    Job job;
    job.inputs = {project_file("examples/boiler/hex_linear/static.frd")};
    job.length_unit = "mm";
    job.output = scratch_folder(folder) + "/boiler.glb";
    return job;
}

/// Converts with an early shape beside the output.
struct Converted {
    explicit Converted(const Job& job) : shape_path(job.output + ".shape.glb") {
        Diagnostics diagnostics;
        const auto stands = [&] {
            ++offers;
            was_first = !fs::exists(job.output);
            shape_was_there = fs::exists(shape_path);
        };
        EXPECT_TRUE(convert(job, diagnostics, {}, {shape_path, stands}));
        for (const Diagnostic& entry : diagnostics.entries()) told += entry.text + "\n";
    }
    std::string shape_path, told{};
    int offers = 0;
    bool was_first = false, shape_was_there = false;
};

TEST(EarlyShape, it_is_offered_once_and_before_the_scene) {
    const Job job = boiler_to("early/once");
    const Converted converted(job);
    EXPECT_EQ(converted.offers, 1);
    EXPECT_TRUE(converted.was_first);
    EXPECT_TRUE(converted.shape_was_there);
}

TEST(EarlyShape, scene_and_diagnostics_are_the_same_with_and_without_it) {
    const Job with = boiler_to("early/with"), without = boiler_to("early/without");
    const Converted converted(with);
    Diagnostics diagnostics;
    ASSERT_TRUE(convert(without, diagnostics, {}));
    EXPECT_TRUE(bytes_of(with.output) == bytes_of(without.output));
    std::string told;
    for (const Diagnostic& entry : diagnostics.entries()) told += entry.text + "\n";
    EXPECT_EQ(converted.told, told);
}

TEST(EarlyShape, it_has_the_shape_of_the_scene_and_no_results) {
    for (const bool compress : {false, true}) {
        Job job = boiler_to(compress ? "early/packed" : "early/plain");
        job.compress = compress;
        const Converted converted(job);
        const Scene shape = load_scene(converted.shape_path), scene = load_scene(job.output);
        EXPECT_THAT(shape.results, IsEmpty());
        EXPECT_THAT(shape.fields, IsEmpty());
        EXPECT_EQ(shape.title, scene.title);
        EXPECT_THAT(shape.steps, SizeIs(scene.steps.size()));
        ASSERT_EQ(shape.parts.size(), scene.parts.size());
        for (std::size_t i = 0; i < shape.parts.size(); ++i) {
            EXPECT_EQ(shape.parts[i].name, scene.parts[i].name);
            EXPECT_TRUE(shape.parts[i].positions == scene.parts[i].positions);
            EXPECT_TRUE(shape.parts[i].triangles == scene.parts[i].triangles);
            EXPECT_TRUE(shape.parts[i].node_ids == scene.parts[i].node_ids);
            EXPECT_TRUE(shape.parts[i].element_ids == scene.parts[i].element_ids);
        }
        EXPECT_EQ(shape.origin, scene.origin);
    }
}

TEST(EarlyShape, its_certificate_says_that_it_is_no_finished_scene) {
    const Job job = boiler_to("early/certificate");
    const Converted converted(job);
    EXPECT_TRUE(load_scene(converted.shape_path).notes.contains("preview"));
    EXPECT_FALSE(load_scene(job.output).notes.contains("preview"));
    std::vector<std::string> failing;
    for (const Claim& claim : check_scene(converted.shape_path)) {
        if (!claim.holds) failing.push_back(claim.name);
    }
    EXPECT_THAT(failing, ElementsAre("finished scene"));
    for (const Claim& claim : check_scene(job.output)) EXPECT_TRUE(claim.holds) << claim.name;
}

TEST(EarlyShape, and_scene_are_the_same_while_threads_come_and_go) {
    const Job job = boiler_to("early/changing");
    const Converted once(job);
    const std::string shape = bytes_of(once.shape_path), scene = bytes_of(job.output);
    const ThreadsComeAndGo changing;
    for (int i = 0; i < 20; ++i) {
        const Converted again(job);
        ASSERT_TRUE(bytes_of(again.shape_path) == shape) << "the shape of run " << i;
        ASSERT_TRUE(bytes_of(job.output) == scene) << "the scene of run " << i;
    }
}

TEST(EarlyShape, who_does_not_want_one_gets_none) {
    const Job job = boiler_to("early/none");
    Diagnostics diagnostics;
    ASSERT_TRUE(convert(job, diagnostics, {}));
    EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(job.output).parent_path()), {}), 1);
}

TEST(EarlyShape, what_goes_wrong_with_it_ends_the_conversion) {
    const Job job = boiler_to("early/refused");
    Diagnostics diagnostics;
    const auto refuse = [] { throw Error(Code::BadOption, "--port", "is taken"); };
    EXPECT_THROW(convert(job, diagnostics, {}, {job.output + ".shape.glb", refuse}), Error);
    EXPECT_FALSE(fs::exists(job.output));
}

TEST(EarlyShape, of_a_scene_for_viewing_it_goes_when_the_scene_is_there) {
    Job job = boiler_to("early/viewing");
    job.output.clear();
    Diagnostics diagnostics;
    std::string shape_path, scene_path;
    const SceneForViewing scene(job, diagnostics, {}, [&](const std::string& shape, const std::string& made) {
        shape_path = shape;
        scene_path = made;
        EXPECT_TRUE(fs::exists(shape));
        EXPECT_FALSE(fs::exists(made));
    });
    EXPECT_EQ(scene.path(), scene_path);
    EXPECT_TRUE(fs::exists(scene_path));
    EXPECT_FALSE(shape_path.empty() || fs::exists(shape_path));
}

}  // namespace
}  // namespace feelem::test
