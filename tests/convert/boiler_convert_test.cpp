// SPDX-License-Identifier: Apache-2.0
// The shipped boiler through the whole pipeline.
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"
#include "feelem/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace feelem::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string boiler(const std::string& file) {
    return project_file("examples/boiler/hex_linear/" + file);
}

Job boiler_job(std::initializer_list<const char*> files) {
    Job job;
    for (const char* file : files) job.inputs.push_back(boiler(file));
    job.length_unit = "mm";
    return job;
}

ModelReport report_of(const Job& job) {
    Diagnostics diagnostics;
    return report_model(job, diagnostics, {}).value();
}

const ComponentRange& range_of(
    const ModelReport& report, const std::string& name, const std::string& component
) {
    for (const ResultReport& result : report.results) {
        if (result.info.name != name) continue;
        for (const ComponentRange& range : result.ranges) {
            if (range.component == component) return range;
        }
    }
    throw std::runtime_error("no " + name + "." + component);
}

Scene convert_and_load(Job job, const std::string& folder) {
    job.output = scratch_folder(folder) + "/boiler.glb";
    Diagnostics diagnostics;
    EXPECT_TRUE(convert(job, diagnostics, {}));
    return load_scene(job.output);
}

// results.json and the boiler's README: what CalculiX computed, by an independent script.
TEST(BoilerReport, extremes_and_ids_are_the_solvers) {
    const ModelReport report = report_of(boiler_job({"heat.frd", "static.frd"}));

    const ComponentRange& temperature = range_of(report, "temperature", "value");
    EXPECT_EQ(temperature.min, 124.052F);
    EXPECT_EQ(temperature.min_id, 1337);
    EXPECT_EQ(temperature.max, 227.511F);
    EXPECT_EQ(temperature.max_id, 67);
    EXPECT_EQ(temperature.missing, 0U);
    const ComponentRange& moved = range_of(report, "displacement", "magnitude");
    EXPECT_NEAR(moved.max, 4.246207, 1e-6);
    EXPECT_EQ(moved.max_id, 212);
    EXPECT_TRUE(moved.derived);
    EXPECT_NEAR(range_of(report, "stress", "von_mises").max, 283.7, 0.05);
}

TEST(BoilerReport, elements_and_skin_are_counted) {
    const ModelReport report = report_of(boiler_job({"static.frd"}));

    EXPECT_EQ(report.nodes, 2546U);
    EXPECT_EQ(report.elements, 1272U);
    EXPECT_EQ(report.skin->solid_quad_kept + report.skin->solid_tri_kept, 2568U);
    EXPECT_EQ(report.skin->triangles, 10128U);
    EXPECT_EQ(report.skin->vertices, 2546U);
    EXPECT_TRUE(report.skin->closed);
}

TEST(BoilerReport, lists_and_frd_have_the_same_skin) {
    const ModelReport frd = report_of(boiler_job({"static.frd"}));
    const ModelReport lists = report_of(boiler_job(
        {"NLIST_all.lis", "ELIST.lis", "ETLIST.lis", "PRNSOL_U.lis", "PRNSOL_TEMP.lis", "PRNSOL_S.lis"}
    ));

    EXPECT_EQ(lists.skin->solid_facets_in, 7608U);
    EXPECT_EQ(lists.skin->solid_facets_kept, 2568U);
    EXPECT_EQ(lists.skin->triangles, frd.skin->triangles);
    EXPECT_EQ(lists.skin->vertices, frd.skin->vertices);
    EXPECT_EQ(range_of(lists, "temperature", "value").min_id, 1231)
        << "the smallest of those printed as 124.05";
}

TEST(BoilerReport, node_map_removes_nothing_from_a_thin_boiler) {
    Job job = boiler_job({"NLIST_all.lis", "ELIST.lis", "ETLIST.lis"});
    job.skin.method = SkinMethod::NodeList;
    job.surface_nodes_file = boiler("NLIST_surface.lis");
    EXPECT_EQ(report_of(job).skin->solid_facets_kept, 7608U);

    for (std::string& input : job.inputs)
        input = project_file("examples/boiler/small/" + input.substr(input.rfind('/') + 1));
    job.surface_nodes_file = project_file("examples/boiler/small/NLIST_surface.lis");
    EXPECT_EQ(report_of(job).skin->solid_facets_kept, 15152U);
    job.skin.method = SkinMethod::Exact;
    EXPECT_EQ(report_of(job).skin->solid_facets_kept, 2576U);
}

TEST(BoilerReport, a_result_that_two_inputs_repeat_is_listed_once) {
    const ModelReport report = report_of(boiler_job({"heat.frd", "static.frd"}));

    const auto is_temperature = [](const ResultReport& result) { return result.info.name == "temperature"; };
    EXPECT_EQ(std::ranges::count_if(report.results, is_temperature), 1);
    EXPECT_EQ(report.steps.size(), 2U) << "both analyses still have results of their own";
}

TEST(BoilerReport, results_that_differ_stay_apart_and_are_named_by_their_file) {
    Job job = boiler_job({"heat.frd", "transient.frd"});
    job.results = "temperature@transient.frd";

    const ModelReport report = report_of(job);

    EXPECT_EQ(report.results.size(), 8U);
    for (const ResultReport& result : report.results) {
        EXPECT_EQ(report.steps[result.info.step].input, 1U);
    }
}

TEST(BoilerReport, units_are_declared_and_stay_with_their_result) {
    Job job = boiler_job({"static.frd"});
    job.units = {{"stress", "MPa"}};

    const ModelReport report = report_of(job);

    for (const ResultReport& result : report.results) {
        EXPECT_EQ(result.info.unit, result.info.name == "stress" ? "MPa" : "") << result.info.name;
    }
    EXPECT_EQ(report.length_unit->name, "mm");
}

TEST(BoilerReport, units_of_unknown_results_are_refused_with_the_nearest_name) {
    Job job = boiler_job({"static.frd"});
    job.units = {{"stres", "MPa"}};

    try {
        report_of(job);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnknownName);
        EXPECT_THAT(error.what(), HasSubstr("Did you mean \"stress\"?"));
    }
}

TEST(BoilerScene, holds_every_value_of_the_skin_bit_for_bit) {
    const Job job = boiler_job({"heat.frd", "static.frd"});
    const Scene scene = convert_and_load(job, "convert_boiler");
    Diagnostics diagnostics;
    const auto source = open_job(job, diagnostics, {});
    const Mesh& mesh = source->mesh();

    std::size_t compared = 0;
    for (std::size_t i = 0; i < source->results().size(); ++i) {
        const Result result = source->load(i);
        for (const SceneField& field : scene.fields) {
            const SceneResult& shown = scene.results[field.result];
            if (shown.quantity != result.info.name || shown.derived) continue;
            ASSERT_EQ(shown.components, result.info.components);
            const ScenePart& part = scene.parts[field.part];
            const std::size_t width = shown.components.size();
            for (std::size_t v = 0; v < part.node_ids.size(); ++v) {
                if (part.node_ids[v] == 0) continue;
                const std::size_t row = raw(find_node(mesh, NodeId{part.node_ids[v]}));
                for (std::size_t c = 0; c < width; ++c, ++compared) {
                    ASSERT_EQ(field.values[v * width + c], result.values[row * width + c]);
                }
            }
        }
    }
    EXPECT_GT(compared, 2546U * 12);
}

TEST(BoilerScene, analyses_of_one_state_are_one_step) {
    const Scene scene = convert_and_load(boiler_job({"heat.frd", "static.frd"}), "convert_one_state");

    ASSERT_EQ(scene.steps.size(), 1U);
    std::vector<std::string> ids;
    for (const SceneResult& result : scene.results) ids.push_back(result.id);
    EXPECT_THAT(
        ids,
        ElementsAre(
            "temperature",
            "heat_flux",
            "heat_flux_magnitude",
            "displacement",
            "displacement_magnitude",
            "stress",
            "stress_von_mises",
            "stress_tresca",
            "stress_principal_1",
            "stress_principal_2",
            "stress_principal_3",
            "error"
        )
    );
}

TEST(BoilerScene, of_lists_shows_several_files_as_one_step_and_marks_mid_side_means) {
    Job job;
    job.length_unit = "mm";
    for (const char* file : {"NLIST_all", "ELIST", "ETLIST", "PRNSOL_U", "PRNSOL_TEMP", "PRNSOL_S"}) {
        job.inputs.push_back(project_file(std::string("examples/boiler/small/") + file + ".lis"));
    }

    const Scene scene = convert_and_load(job, "convert_lists");

    ASSERT_EQ(scene.steps.size(), 1U);
    std::size_t solver = 0, interpolated = 0;
    for (const SceneField& field : scene.fields) {
        if (scene.results[field.result].id != "stress_von_mises") continue;
        const ScenePart& part = scene.parts[field.part];
        for (std::size_t v = 0; v < field.validity.size(); ++v) {
            if (part.node_ids[v] == 0) continue;
            EXPECT_NE(field.validity[v], Validity::Missing);
            (field.validity[v] == Validity::Solver ? solver : interpolated) += 1;
        }
    }
    EXPECT_GT(solver, 1000U) << "corners";
    EXPECT_GT(interpolated, 3000U) << "mid-side nodes, which PRNSOL,S does not list";
}

TEST(BoilerScene, states_that_differ_stay_separate_steps) {
    const Scene scene = convert_and_load(boiler_job({"static.frd", "transient.frd"}), "convert_two_states");

    EXPECT_EQ(scene.steps.size(), 9U);
    for (const SceneResult& result : scene.results) {
        EXPECT_EQ(result.values.size(), result.id == "temperature" ? 9U : 1U) << result.id;
    }
}

TEST(BoilerScene, extremes_are_those_of_the_whole_model) {
    const Scene scene = convert_and_load(boiler_job({"heat.frd"}), "convert_extremes");

    const SceneValues& values = scene.results.front().values.front();
    ASSERT_EQ(scene.results.front().id, "temperature");
    EXPECT_EQ(values.min->value, 124.052F);
    EXPECT_EQ(values.min->id, 1337);
    EXPECT_EQ(values.max->value, 227.511F);
    EXPECT_EQ(values.max->id, 67);
    EXPECT_EQ(values.missing_in_model, 0U);
}

TEST(BoilerScene, only_the_results_asked_for_are_there) {
    Job job = boiler_job({"static.frd"});
    job.results = "displacement";

    const Scene scene = convert_and_load(job, "convert_results");

    ASSERT_EQ(scene.results.size(), 2U);
    EXPECT_EQ(scene.results[0].id, "displacement");
    EXPECT_EQ(scene.results[1].id, "displacement_magnitude");
}

TEST(BoilerScene, same_input_gives_the_same_bytes) {
    Job job = boiler_job({"heat.frd", "static.frd"});
    const std::string folder = scratch_folder("convert_same_bytes");
    Diagnostics diagnostics;
    for (const char* name : {"a", "b"}) {
        std::filesystem::create_directory(folder + "/" + name);
        job.output = folder + "/" + name + "/boiler.glb";
        ASSERT_TRUE(convert(job, diagnostics, {}));
    }

    EXPECT_TRUE(read_file(folder + "/a/boiler.glb") == read_file(folder + "/b/boiler.glb"));
}

TEST(Convert, cancelled_work_writes_nothing) {
    for (const std::string stop : {"read", "skin", "results", "write"}) {
        Job job = boiler_job({"static.frd"});
        const std::string folder = scratch_folder("convert_cancel");
        job.output = folder + "/boiler.glb";
        Diagnostics diagnostics;

        const bool done =
            convert(job, diagnostics, [&](std::string_view stage, double) { return stage != stop; });

        EXPECT_FALSE(done) << stop;
        EXPECT_TRUE(std::filesystem::is_empty(folder)) << stop;
    }
}

TEST(Convert, presentation_that_asks_for_what_is_not_there_names_what_is) {
    Job job = boiler_job({"heat.frd"});
    const std::string folder = scratch_folder("convert_presentation");
    job.output = folder + "/boiler.glb";
    job.presentation_file = project_file("examples/boiler/boiler.presentation.json");
    Diagnostics diagnostics;

    try {
        convert(job, diagnostics, {});
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadPresentation);
        EXPECT_THAT(error.what(), HasSubstr("temperature.value"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace feelem::test
