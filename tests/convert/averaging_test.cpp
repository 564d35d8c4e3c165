// SPDX-License-Identifier: Apache-2.0
// Element results of two bricks of different materials: averaged within a part, over all, or not at all.
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/probe.hpp"
#include "feelem/scene.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace feelem::test {
namespace {

using testing::ElementsAre;

/// Bricks 1 (material 1) and 2 (material 2) side by side along x; they share the nodes 2, 5, 8 and 11. SX is
/// 10 in brick 1 and 30 in brick 2, everywhere; the other components are zero.
Job two_bricks(const std::string& folder) {
    const std::string path = scratch_folder(folder);
    std::string nodes = " LIST ALL SELECTED NODES.   DSYS=      0\n\n    NODE        X                   Y   "
                        "                Z\n";
    for (int i = 0; i < 12; ++i) {
        nodes += fmt::format(
            "{:8}{:20.11f}{:20.11f}{:20.11f}\n", i + 1, i % 3 * 1.0, i / 3 % 2 * 1.0, i / 6 * 1.0
        );
    }
    const std::array<std::string, 2> corners{
        "     1     2     5     4     7     8    11    10",
        "     2     3     6     5     8     9    12    11"};
    std::string elements =
        "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n \n    ELEM MAT TYP REL ESY SEC        NODES\n \n";
    std::string stress =
        "\n PRINT S    ELEMENT SOLUTION PER ELEMENT\n\n  ***** POST1 ELEMENT NODAL STRESS LISTING *****\n \n"
        "  LOAD STEP=     1  SUBSTEP=     1\n   TIME=    1.0000      LOAD CASE=   0\n \n"
        "  THE FOLLOWING X,Y,Z VALUES ARE IN GLOBAL COORDINATES\n \n";
    for (int e = 0; e < 2; ++e) {
        elements +=
            fmt::format("{:8}{:4}   1   1   0   1  {}\n", e + 1, e + 1, corners[static_cast<std::size_t>(e)]);
        stress += fmt::format(
            "  ELEMENT={:8}        SOLID185\n    NODE    SX          SY          SZ          SXY         SYZ "
            "        SXZ     \n",
            e + 1
        );
        std::string_view rest = corners[static_cast<std::size_t>(e)];
        for (; !rest.empty(); rest.remove_prefix(6)) {
            stress += fmt::format("{:>8}{:12.5g}", rest.substr(0, 6), e == 0 ? 10.0 : 30.0);
            for (int c = 0; c < 5; ++c) stress += "   0.0000    ";
            stress += "\n";
        }
    }
    Job job;
    job.length_unit = "mm";
    job.read.types = "1=SOLID185";
    job.output = path + "/bricks.glb";
    for (const auto& [name, text] :
         std::map<std::string, std::string>{{"n.lis", nodes}, {"e.lis", elements}, {"s.lis", stress}}) {
        write_file(path + "/" + name, text);
        job.inputs.push_back(path + "/" + name);
    }
    return job;
}

ComponentRange range_of_xx(const Job& job) {
    Diagnostics diagnostics;
    const ModelReport report = report_model(job, diagnostics, {}).value();
    const auto stress =
        std::ranges::find(report.results, "stress", [](const auto& r) { return r.info.name; });
    EXPECT_NE(stress, report.results.end());
    return stress->ranges.front();
}

/// The values of stress xx that the scene holds at node 2, which both bricks have.
std::vector<float> xx_at_shared_node(const Scene& scene) {
    std::vector<float> values;
    for (const SceneField& field : scene.fields) {
        if (scene.results[field.result].id != "stress") continue;
        const ScenePart& part = scene.parts[field.part];
        for (std::size_t v = 0; v < part.node_ids.size(); ++v) {
            if (part.node_ids[v] == 2) values.push_back(field.values[6 * v]);
        }
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

Scene converted(const Job& job) {
    Diagnostics diagnostics;
    EXPECT_TRUE(convert(job, diagnostics, {}));
    for (const Claim& claim : check_scene(job.output)) EXPECT_TRUE(claim.holds) << claim.name;
    return load_scene(job.output);
}

TEST(AveragePart, keeps_a_value_for_each_material_at_a_shared_node) {
    const Job job = two_bricks("average_part");

    const Scene scene = converted(job);

    EXPECT_THAT(xx_at_shared_node(scene), ElementsAre(10, 30));
    for (const ScenePart& part : scene.parts) EXPECT_EQ(part.domain, "node");
    EXPECT_EQ(range_of_xx(job).min_element, 0);
}

TEST(AverageAll, mixes_materials_to_one_value) {
    Job job = two_bricks("average_all");
    job.averages = {Averaging::All};

    const Scene scene = converted(job);

    EXPECT_THAT(xx_at_shared_node(scene), ElementsAre(20));
    const ComponentRange range = range_of_xx(job);
    EXPECT_EQ(range.min, 10);
    EXPECT_EQ(range.min_id, 1);
    EXPECT_EQ(range.max_id, 3);
}

TEST(AverageNone, gives_each_element_its_own_vertices_and_names_it_in_ranges) {
    Job job = two_bricks("average_none");
    job.averages = {Averaging::None};

    const Scene scene = converted(job);

    EXPECT_THAT(xx_at_shared_node(scene), ElementsAre(10, 30));
    for (const ScenePart& part : scene.parts) EXPECT_EQ(part.domain, "element-node");
    const ComponentRange range = range_of_xx(job);
    EXPECT_EQ(range.max, 30);
    EXPECT_EQ(range.max_id, 2);
    EXPECT_EQ(range.max_element, 2);
    EXPECT_EQ(range.min_element, 1);
}

TEST(AverageNone, has_no_level_of_detail_and_says_so) {
    Job job = two_bricks("average_none_levels");
    job.averages = {Averaging::None};
    job.levels = "10%";
    Diagnostics diagnostics;

    ASSERT_TRUE(convert(job, diagnostics, {}));

    EXPECT_EQ(diagnostics.count(Code::LevelOfDetail), 1U);
    EXPECT_TRUE(load_scene(job.output).levels.empty());
}

TEST(AverageSeveral, are_results_of_their_own_and_every_claim_of_the_scene_holds) {
    Job job = two_bricks("average_several");
    job.averages = {Averaging::Part, Averaging::All, Averaging::None};

    const Scene scene = converted(job);

    Diagnostics diagnostics;
    for (const Claim& claim : check_against_inputs(job.output, job, diagnostics, {}))
        EXPECT_TRUE(claim.holds) << claim.name << ": " << claim.found;
    std::map<std::string, Averaging> found;
    for (const SceneResult& result : scene.results) {
        if (result.components.front() == "xx") found[result.id] = result.averaging;
    }
    const std::map<std::string, Averaging> expected{
        {"stress", Averaging::Part},
        {"stress_across_parts", Averaging::All},
        {"stress_unaveraged", Averaging::None}};
    EXPECT_EQ(found, expected);
    for (const SceneResult& result : scene.results) {
        if (result.id == "stress_von_mises_unaveraged") {
            EXPECT_EQ(result.title, "von Mises stress, unaveraged");
        }
    }
}

TEST(Probe, node_of_two_parts_has_the_values_of_both) {
    const Scene scene = converted(two_bricks("probe_two_parts"));

    const auto places = probe(scene, {2, {}, {}});

    ASSERT_EQ(places.size(), 2U);
    std::vector<float> found;
    for (const ProbedPlace& place : places) {
        for (const ProbedValue& value : place.results) {
            if (value.component == "xx") found.push_back(value.node_value.value());
        }
    }
    EXPECT_THAT(found, ElementsAre(10, 30));
}

TEST(Probe, ray_meets_the_first_facet_and_reads_between_its_nodes) {
    const Scene scene = converted(two_bricks("probe_ray"));

    const auto places = probe(scene, {{}, {}, std::array{1.75, 0.25, 9.0, 0.0, 0.0, -2.0}});

    ASSERT_EQ(places.size(), 1U);
    const ProbedPlace& place = places.front();
    EXPECT_EQ(place.element_id, 2);
    EXPECT_EQ(place.node_id, 9);
    EXPECT_DOUBLE_EQ(place.distance, 8);
    EXPECT_NEAR(place.point[0], 1.75, 1e-12);
    EXPECT_NEAR(place.point[2], 1, 1e-12);
    for (const ProbedValue& value : place.results) {
        if (value.component == "xx") {
            EXPECT_NEAR(value.value.value(), 30, 1e-5);
            EXPECT_EQ(value.state, "solver");
        }
    }
}

TEST(Probe, ray_that_misses_finds_nothing_and_a_point_finds_the_nearest_place) {
    const Scene scene = converted(two_bricks("probe_point"));

    EXPECT_TRUE(probe(scene, {{}, {}, std::array{5.0, 5.0, 9.0, 0.0, 0.0, -1.0}}).empty());
    const auto places = probe(scene, {{}, Point3{-3, 0.1, 0.2}, {}});
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places.front().element_id, 1);
    EXPECT_DOUBLE_EQ(places.front().distance, 3);
}

}  // namespace
}  // namespace feelem::test
