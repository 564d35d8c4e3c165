// SPDX-License-Identifier: Apache-2.0
// Levels of detail from `--lod` to the scene: made when they are asked for or needed, confirmed by the
// independent checker, and never believed when somebody changed them.
#include "convert/make_levels.hpp"
#include "scene/scene_file.hpp"
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"
#include "feelem/scene.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace feelem::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Job boiler_with(const std::string& levels, const std::string& folder) {
    Job job;
    job.inputs = {project_file("examples/boiler/hex_linear/static.frd")};
    job.length_unit = "mm";
    job.levels = levels;
    job.output = scratch_folder("levels/" + folder) + "/boiler.glb";
    return job;
}

/// A plate of bricks, half of them of material 2. The temperature has two hot spots, and none in a corner.
Job plate_with(const std::string& levels, const std::string& folder) {
    constexpr int kSide = 40, kNodes = kSide + 1;
    const std::string path = scratch_folder("levels/" + folder);
    std::string nodes = " LIST ALL SELECTED NODES.   DSYS=      0\n\n    NODE        X                   Y   "
                        "                Z\n";
    std::string heat =
        "\n PRINT TEMP NODAL SOLUTION PER NODE\n\n  ***** POST1 NODAL DEGREE OF FREEDOM LISTING "
        "*****\n \n  LOAD STEP=     1  SUBSTEP=     1\n   TIME=         1      LOAD CASE=   0\n "
        "\n    NODE    TEMP\n";
    const auto id = [](int x, int y, int z) { return 1 + x + kNodes * (y + kNodes * z); };
    for (int z = 0; z < 2; ++z) {
        for (int y = 0; y < kNodes; ++y) {
            for (int x = 0; x < kNodes; ++x) {
                nodes +=
                    fmt::format("{:8}{:20.11f}{:20.11f}{:20.11f}\n", id(x, y, z), x * 1.0, y * 1.0, z * 2.0);
                if (x < 9 && y < 7) continue;
                const auto spot = [&](double cx, double cy) {
                    return std::exp(-((x - cx) * (x - cx) + (y - cy) * (y - cy)) / 30);
                };
                heat += fmt::format(
                    "{:8}   {:.5g}\n", id(x, y, z), 20 + 0.5 * x + 60 * spot(12, 25) - 40 * spot(30.4, 14)
                );
            }
        }
    }
    std::string elements =
        "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n \n    ELEM MAT TYP REL ESY SEC        NODES\n \n";
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            elements += fmt::format("{:8}{:4}   1   1   0   1  ", 1 + x + kSide * y, x < kSide / 2 ? 1 : 2);
            for (const int z : {0, 1}) {
                for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                    elements += fmt::format("{:6}", id(x + dx, y + dy, z));
            }
            elements += "\n";
        }
    }
    Job job;
    job.length_unit = "mm";
    job.read.types = "1=SOLID185";
    job.levels = levels;
    job.output = path + "/plate.glb";
    for (const auto& [name, text] :
         {std::pair{"n.lis", nodes}, std::pair{"e.lis", elements}, std::pair{"t.lis", heat}}) {
        write_file(path + "/" + name, text);
        job.inputs.push_back(path + "/" + name);
    }
    return job;
}

/// A plate of bricks and a hot spot that travels over it in so many steps.
Job travelling_spot(int steps, const std::string& folder) {
    constexpr int kSide = 24, kNodes = kSide + 1;
    const std::string path = scratch_folder("levels/" + folder);
    std::string nodes = " LIST ALL SELECTED NODES.   DSYS=      0\n\n    NODE        X                   Y   "
                        "                Z\n";
    std::string elements =
        "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n \n    ELEM MAT TYP REL ESY SEC        NODES\n \n";
    std::string heat;
    for (int i = 0; i < 2 * kNodes * kNodes; ++i) {
        nodes += fmt::format(
            "{:8}{:20.11f}{:20.11f}{:20.11f}\n",
            i + 1,
            i % kNodes * 1.0,
            i / kNodes % kNodes * 1.0,
            i / kNodes / kNodes * 2.0
        );
    }
    for (int i = 0; i < kSide * kSide; ++i) {
        elements += fmt::format("{:8}   1   1   1   0   1  ", i + 1);
        for (const int corner : {0, 1, kNodes + 1, kNodes})
            elements += fmt::format("{:6}", 1 + i % kSide + i / kSide * kNodes + corner);
        for (const int corner : {0, 1, kNodes + 1, kNodes})
            elements += fmt::format("{:6}", 1 + kNodes * kNodes + i % kSide + i / kSide * kNodes + corner);
        elements += "\n";
    }
    for (int step = 1; step <= steps; ++step) {
        heat += fmt::format(
            "\n PRINT TEMP NODAL SOLUTION PER NODE\n\n  ***** POST1 NODAL DEGREE OF FREEDOM LISTING *****\n "
            "\n  "
            "LOAD STEP=     1  SUBSTEP={:6}\n   TIME= {:10.4f}      LOAD CASE=   0\n \n    NODE    TEMP\n",
            step,
            static_cast<double>(step)
        );
        for (int i = 0; i < 2 * kNodes * kNodes; ++i) {
            const double x = i % kNodes - 24.0 * step / steps, y = i / kNodes % kNodes - 11.0;
            heat += fmt::format("{:8}   {:.5g}\n", i + 1, 20 + 80 * std::exp(-(x * x + y * y) / 40));
        }
    }
    Job job;
    job.length_unit = "mm";
    job.read.types = "1=SOLID185";
    job.steps = "all";
    job.levels = "4%";
    job.output = path + "/plate.glb";
    for (const auto& [name, text] :
         {std::pair{"n.lis", nodes}, std::pair{"e.lis", elements}, std::pair{"t.lis", heat}}) {
        write_file(path + "/" + name, text);
        job.inputs.push_back(path + "/" + name);
    }
    return job;
}

std::vector<std::string> broken(const std::vector<Claim>& claims) {
    std::vector<std::string> names;
    for (const Claim& claim : claims) {
        if (!claim.holds) names.push_back(claim.name + ": " + claim.claimed + " / " + claim.found);
    }
    return names;
}

/// Converts, and expects that every claim holds: of the certificate, of the levels, against the inputs.
Scene converted(const Job& job) {
    Diagnostics diagnostics;
    EXPECT_TRUE(convert(job, diagnostics, {}));
    EXPECT_THAT(broken(check_scene(job.output)), IsEmpty());
    EXPECT_THAT(broken(check_levels(job.output)), IsEmpty());
    EXPECT_THAT(broken(check_against_inputs(job.output, job, diagnostics, {})), IsEmpty());
    return load_scene(job.output);
}

TEST(Levels, hold_for_every_result_of_the_boiler) {
    const Job job = boiler_with("1%", "boiler");
    const Scene scene = converted(job);

    ASSERT_EQ(scene.levels.size(), 1U);
    const SceneLevel& level = scene.levels[0];
    EXPECT_EQ(level.values.size(), scene.results.size());
    EXPECT_NEAR(level.bound, 0.01, 1e-9);
    EXPECT_LT(level.triangles, scene.parts[0].triangles.size() * 6 / 10);
    // Every vertex and the middle of every triangle.
    EXPECT_GE(level.samples, scene.parts[0].positions.size() + scene.parts[0].triangles.size());
    for (const SceneLevelValues& values : level.values) {
        const SceneResult& result = scene.results[values.result];
        EXPECT_LE(values.max, values.bound) << result.id;
        EXPECT_LE(values.shown, values.bound) << result.id;
        EXPECT_GT(values.shown, 0) << result.id;
        if (result.id != "temperature") continue;
        const auto& [min, max] = std::pair{*result.values[0].min, *result.values[0].max};
        EXPECT_NEAR(
            values.bound, 0.01 * (static_cast<double>(max.value) - static_cast<double>(min.value)), 1e-6
        );
    }
    // Each with what was found, what was said when it was made, and its extremes.
    EXPECT_GE(check_levels(job.output).size(), 3 * level.values.size());
}

TEST(Levels, leave_parts_and_missing_values_as_they_are) {
    const Job job = plate_with("2%", "plate");
    const Scene scene = converted(job);

    ASSERT_EQ(scene.levels.size(), 1U);
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_EQ(scene.results[0].values[0].missing_in_model, 2U * 9 * 7);
    EXPECT_LT(scene.levels[0].triangles, 3000U);
    const SceneFile file(job.output);
    for (std::size_t p = 0; p < 2; ++p) {
        const int array = file.find(fmt::format("p{}/indices/lod1", p));
        EXPECT_GT(file.integers(array).size(), 300U);
    }
}

TEST(Levels, hold_at_every_step_even_of_more_than_are_held_at_once) {
    const Scene scene = converted(travelling_spot(230, "spot"));

    ASSERT_EQ(scene.levels.size(), 1U);
    EXPECT_EQ(scene.levels[0].values.size(), 230U);
    EXPECT_LT(scene.levels[0].triangles, scene.parts[0].triangles.size() * 8 / 10);
    for (const SceneLevelValues& values : scene.levels[0].values) EXPECT_GT(values.max, 0);
}

TEST(Levels, of_a_small_model_are_made_only_when_they_are_asked_for) {
    const Job as_usual = boiler_with("auto", "auto"), none = boiler_with("off", "off");
    EXPECT_THAT(converted(as_usual).levels, IsEmpty());
    EXPECT_THAT(converted(none).levels, IsEmpty());

    EXPECT_EQ(read_file(as_usual.output), read_file(none.output));
    EXPECT_THAT(check_levels(none.output), IsEmpty());
}

TEST(Levels, stop_at_the_number_of_triangles_and_say_what_it_costs) {
    const Scene scene = converted(boiler_with("6000", "count"));

    ASSERT_EQ(scene.levels.size(), 1U);
    EXPECT_LE(scene.levels[0].triangles, 6000U);
    EXPECT_GT(scene.levels[0].triangles, 5990U);
    EXPECT_LT(scene.levels[0].bound, 0.02);
}

TEST(Levels, that_cannot_be_had_are_noted) {
    Diagnostics diagnostics;
    ASSERT_TRUE(convert(boiler_with("1000", "few"), diagnostics, {}));
    EXPECT_EQ(diagnostics.count(Code::LevelOfDetail), 1U);

    const Job finest = boiler_with("0.001%", "finest");
    Diagnostics none_made;
    ASSERT_TRUE(convert(finest, none_made, {}));
    EXPECT_EQ(load_scene(finest.output).levels.size() + none_made.count(Code::LevelOfDetail), 1U);
}

TEST(Levels, are_refused_in_other_words) {
    for (const char* text : {"", "on", "0", "-5", "1.5", "0%", "60%", "%", "nan%", "x%", "0.5"})
        EXPECT_THROW(parse_levels(text), Error) << text;
    EXPECT_EQ(parse_levels("0.5%").bound, 0.005);
    EXPECT_EQ(parse_levels("250000").triangles, 250000U);
}

/// A written scene whose bytes can be changed.
struct Written {
    std::string path, bytes;

    explicit Written(const std::string& name) {
        const Job job = boiler_with("2%", name);
        Diagnostics diagnostics;
        convert(job, diagnostics, {});
        path = job.output;
        bytes = read_file(path);
    }
    /// Same length, so that the file stays one.
    void replace(const std::string& old_text, const std::string& text) {
        ASSERT_EQ(old_text.size(), text.size());
        const std::size_t at = bytes.find(old_text);
        ASSERT_NE(at, std::string::npos) << old_text;
        bytes.replace(at, text.size(), text);
        write_file(path, bytes);
    }
};

TEST(LevelsCheck, notices_a_triangle_that_was_moved) {
    Written scene("moved");
    const SceneFile file(scene.path);
    const SceneDocument& document = file.document();
    const int array = file.find("p0/indices/lod1");
    const std::vector<std::uint32_t> corners = file.integers(array);
    const ReadAccessor& read = document.accessors[static_cast<std::size_t>(array)];
    const std::size_t at =
        scene.bytes.find("BIN", 12) + 4 +
        static_cast<std::size_t>(document.views[static_cast<std::size_t>(read.accessor.view)].view.offset);
    ASSERT_THAT(broken(check_levels(scene.path)), IsEmpty());
    // One corner of one triangle goes to a vertex far away.
    const auto far = static_cast<std::uint16_t>((corners[0] + 2500) % 5000);
    std::memcpy(scene.bytes.data() + at, &far, sizeof far);
    write_file(scene.path, scene.bytes);

    EXPECT_FALSE(broken(check_levels(scene.path)).empty());
    EXPECT_FALSE(broken(check_scene(scene.path)).empty());
}

TEST(LevelsCheck, notices_a_triangle_that_was_taken_away) {
    Written scene("taken");
    const SceneFile file(scene.path);
    const SceneDocument& document = file.document();
    const int array = file.find("p0/indices/lod1");
    const std::vector<std::uint32_t> corners = file.integers(array);
    const ReadAccessor& read = document.accessors[static_cast<std::size_t>(array)];
    const std::size_t at =
        scene.bytes.find("BIN", 12) + 4 +
        static_cast<std::size_t>(document.views[static_cast<std::size_t>(read.accessor.view)].view.offset);
    // The first twenty triangles become the twenty-first.
    for (std::size_t i = 0; i < 60; ++i)
        std::memcpy(scene.bytes.data() + at + 2 * i, scene.bytes.data() + at + 2 * (60 + i % 3), 2);
    write_file(scene.path, scene.bytes);

    EXPECT_FALSE(broken(check_levels(scene.path)).empty());
}

TEST(LevelsCheck, notices_a_promise_that_was_made_smaller) {
    Written scene("promise");
    const Scene read = load_scene(scene.path);
    ASSERT_EQ(read.levels.size(), 1U);
    const auto& values = read.levels[0].values;
    const auto stress = std::ranges::find_if(values, [&](const SceneLevelValues& v) {
        return read.results[v.result].id == "stress_von_mises";
    });
    ASSERT_NE(stress, values.end());
    const std::string bound = fmt::format("{}", stress->bound);
    ASSERT_THAT(bound, HasSubstr("5."));
    scene.replace("\"bound\":" + bound, "\"bound\":0" + bound.substr(1));

    EXPECT_THAT(
        broken(check_levels(scene.path)),
        testing::Contains(testing::StartsWith("level 1: stress_von_mises at step 1: within 0."))
    );
}

TEST(LevelsCheck, notices_a_fraction_that_was_made_smaller) {
    Written scene("fraction");
    scene.replace("\"bound\":0.02,", "\"bound\":0.01,");

    EXPECT_THAT(
        broken(check_levels(scene.path)), testing::Contains(HasSubstr("bound as a fraction of the ranges"))
    );
}

}  // namespace
}  // namespace feelem::test
