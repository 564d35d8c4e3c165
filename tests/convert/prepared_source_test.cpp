// SPDX-License-Identifier: Apache-2.0
// Averagings, systems and envelopes as results of their own: listed, loaded, in a scene and checked.
#include "convert/prepared_source.hpp"
#include "made_up_source.hpp"
#include "support/paths.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"
#include "feelem/probe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace feelem::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Temperatures at eight nodes, a step each.
class Steps : public MadeUpSource {
public:
    std::vector<std::vector<float>> values;

    void add_values(std::vector<float> at_nodes) {
        add(0, 1, static_cast<int>(values.size()) + 1);
        at_nodes.resize(8, std::numeric_limits<float>::quiet_NaN());
        values.push_back(std::move(at_nodes));
    }
    Result load(std::size_t index) override { return {made_results[index], values[index], {}, {}}; }
};

std::vector<std::size_t> all_of(const ModelSource& source) {
    std::vector<std::size_t> all(source.results().size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

std::vector<float> loaded(PreparedSource& source, const std::string& name) {
    for (std::size_t i = 0; i < source.results().size(); ++i) {
        if (source.results()[i].name == name) return source.load(i).values;
    }
    ADD_FAILURE() << "no result " << name;
    return std::vector<float>(8);
}

TEST(Envelope, is_the_extreme_of_each_node_and_says_at_which_step) {
    Steps source;
    source.add_values({1, -5, 2});
    source.add_values({3, 4, 2});
    source.add_values({2, 1, std::numeric_limits<float>::quiet_NaN(), 7});
    Preparing preparing;
    preparing.envelopes = parse_envelopes("max,min, absmax");

    PreparedSource shown(source, all_of(source), preparing);

    const std::vector<float> max = loaded(shown, "temperature_max");
    EXPECT_THAT(std::vector<float>(max.begin(), max.begin() + 4), ElementsAre(3, 4, 2, 7));
    EXPECT_TRUE(std::isnan(max[4])) << "no step has a value there";
    const std::vector<float> at = loaded(shown, "temperature_max_step");
    EXPECT_THAT(std::vector<float>(at.begin(), at.begin() + 4), ElementsAre(2, 2, 1, 3))
        << "the first on a tie";
    EXPECT_EQ(loaded(shown, "temperature_min")[1], -5);
    EXPECT_EQ(loaded(shown, "temperature_absmax")[1], -5) << "the sign stays";
    EXPECT_EQ(loaded(shown, "temperature_absmax_step")[1], 1);
    const Step& step = shown.steps()[shown.results()[3].step];
    EXPECT_TRUE(is_envelope(step));
    EXPECT_EQ(step.label, "maximum over 3 steps");
}

/// Stresses of elements, each step with rows of its own.
class ElementSteps : public MadeUpSource {
public:
    std::vector<Result> made;

    void add_rows(
        std::vector<std::uint32_t> owners, std::vector<std::uint32_t> nodes, std::vector<float> values
    ) {
        add_step(0, 1, static_cast<int>(made.size()) + 1);
        ResultInfo& info = add_result("stress", {"value"}, Shape::Scalar);
        info.location = Location::ElementNodal;
        info.averaging = Averaging::None;
        Result result{info, std::move(values), std::move(owners), {}};
        for (const std::uint32_t node : nodes) result.row_node.push_back(NodeIndex{node});
        made.push_back(std::move(result));
    }
    Result load(std::size_t index) override { return made[index]; }
};

Result load_named(PreparedSource& source, const std::string& name) {
    for (std::size_t i = 0; i < source.results().size(); ++i) {
        if (source.results()[i].name == name) return source.load(i);
    }
    ADD_FAILURE() << "no result " << name;
    return {};
}

TEST(Envelope, elements_that_have_values_at_some_steps_have_the_extreme_of_these) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    ElementSteps source;
    source.add_rows({0, 0, 1, 1}, {2, 0, 1, 3}, {5, 1, 2, 3});
    source.add_rows({1, 1, 2}, {3, 1, 0}, {7, 1, 9});
    source.add_rows({0, 0, 1, 1, 2}, {0, 2, 1, 3, 0}, {4, 4, nan, 8, 6});
    Preparing preparing;
    preparing.envelopes = parse_envelopes("max");
    preparing.averages = {Averaging::None};

    PreparedSource shown(source, all_of(source), preparing);
    const Result max = load_named(shown, "stress_max"), at = load_named(shown, "stress_max_step");

    EXPECT_THAT(max.row_owner, ElementsAre(0, 0, 1, 1, 2));
    EXPECT_THAT(
        max.row_node, ElementsAre(NodeIndex{0}, NodeIndex{2}, NodeIndex{1}, NodeIndex{3}, NodeIndex{0})
    );
    EXPECT_THAT(max.values, ElementsAre(4, 5, 2, 8, 9));
    EXPECT_EQ(at.row_owner, max.row_owner);
    EXPECT_THAT(at.values, ElementsAre(3, 1, 1, 3, 2));
}

TEST(Envelope, the_second_row_of_a_node_in_an_element_stays_the_second) {
    ElementSteps source;
    source.add_rows({0, 0}, {1, 1}, {1, 20});
    source.add_rows({0, 0, 1}, {1, 1, 1}, {2, 10, 5});
    Preparing preparing;
    preparing.envelopes = parse_envelopes("max");
    preparing.averages = {Averaging::None};

    PreparedSource shown(source, all_of(source), preparing);

    EXPECT_THAT(load_named(shown, "stress_max").values, ElementsAre(2, 20, 5));
}

TEST(Envelope, modes_have_none_and_one_step_is_too_few) {
    Steps source;
    source.add_values({1});
    Preparing preparing;
    preparing.envelopes = parse_envelopes("max");
    EXPECT_THROW(PreparedSource(source, all_of(source), preparing), Error);
    source.add_values({2});
    for (Step& step : source.made_steps) step.kind = StepKind::Mode;
    EXPECT_THROW(PreparedSource(source, all_of(source), preparing), Error);
    EXPECT_THROW(parse_envelopes("max,most"), Error);
}

TEST(ResultSystems, are_named_by_their_numbers_and_refused_when_they_are_none) {
    EXPECT_EQ(parse_result_system("cylindrical:1.0, 2,3e0,0,0,4").name, "cylindrical:1,2,3,0,0,4");
    EXPECT_EQ(parse_result_system("cylindrical:1,2,3,0,0,4").system.axis, (Point3{0, 0, 1}));
    for (const char* text :
         {"",
          "polar:0,0,0,0,0,1",
          "cylindrical:0,0,0,0,0,0",
          "cylindrical:0,0,0,0,1",
          "cylindrical:0,0,0,0,0,1,2",
          "cylindrical:0,0,0,0,0,nan"})
        EXPECT_THROW(parse_result_system(text), Error) << text;
}

Job boiler_job(const std::string& file, const std::string& folder) {
    Job job;
    job.inputs = {project_file("examples/boiler/hex_linear/" + file)};
    job.length_unit = "mm";
    job.output = scratch_folder(folder) + "/a.glb";
    return job;
}

/// Converts, and expects that every claim holds, alone and against the inputs.
Scene checked_scene(const Job& job) {
    Diagnostics diagnostics;
    EXPECT_TRUE(convert(job, diagnostics, {}));
    for (const Claim& claim : check_scene(job.output))
        EXPECT_TRUE(claim.holds) << claim.name << ": " << claim.found;
    for (const Claim& claim : check_against_inputs(job.output, job, diagnostics, {}))
        EXPECT_TRUE(claim.holds) << claim.name << ": " << claim.found;
    return load_scene(job.output);
}

const SceneResult& result_called(const Scene& scene, const std::string& id) {
    const auto found = std::ranges::find(scene.results, id, &SceneResult::id);
    EXPECT_NE(found, scene.results.end()) << id;
    return found == scene.results.end() ? scene.results.front() : *found;
}

TEST(Envelope, of_the_transient_boiler_holds_in_a_scene) {
    Job job = boiler_job("transient.frd", "envelope_scene");
    job.results = "temperature";
    job.envelopes = "max,min";

    const Scene scene = checked_scene(job);

    EXPECT_EQ(scene.notes.at("envelopes"), "max,min");
    ASSERT_EQ(scene.steps.size(), 10U);
    const SceneResult& hottest = result_called(scene, "temperature_max");
    ASSERT_EQ(hottest.values.size(), 1U);
    float most = 0;
    for (const SceneValues& values : result_called(scene, "temperature").values)
        most = std::max(most, values.max->value);
    EXPECT_EQ(hottest.values[0].max->value, most);
    EXPECT_EQ(result_called(scene, "temperature_max_step").values[0].max->value, 8);
    ASSERT_TRUE(scene.presentation.step);
    EXPECT_EQ((*scene.presentation.step)[1], 8) << "the last step is shown first, not the envelope";
}

TEST(ResultSystems, give_the_boiler_hoop_and_axial_stress_in_a_scene) {
    Job job = boiler_job("static.frd", "hoop_scene");
    job.results = "stress,displacement";
    job.result_systems = {"cylindrical:0,0,0,0,0,1"};

    const Scene scene = checked_scene(job);

    const SceneResult& hoop = result_called(scene, "stress_hoop");
    EXPECT_EQ(hoop.title, "Hoop stress");
    EXPECT_EQ(hoop.system, "cylindrical:0,0,0,0,0,1");
    EXPECT_EQ(result_called(scene, "displacement_radial").title, "Radial displacement");
    EXPECT_TRUE(result_called(scene, "stress").system.empty());
    const auto places = probe(scene, {scene.parts[0].node_ids[0], {}, {}});
    std::vector<std::string> components;
    for (const ProbedValue& value : places.at(0).results)
        components.push_back(value.name + " " + value.component);
    EXPECT_THAT(
        components,
        testing::IsSupersetOf({"stress hoop", "stress axial", "stress radial", "displacement radial"})
    );
}

TEST(Reactions, are_summed_over_all_nodes) {
    Job job;
    job.inputs = {project_file("tests/data/calculix/static.frd")};
    Diagnostics diagnostics;

    const ModelReport report = report_model(job, diagnostics, {}).value();

    ASSERT_EQ(report.reactions.size(), 1U);
    const ReactionSum& sum = report.reactions[0];
    EXPECT_EQ(sum.info.name, "reaction_force");
    EXPECT_THAT(sum.info.components, ElementsAre("x", "y", "z"));
    // The file's FORC block, added up apart.
    const auto model = open_model(job.inputs, {}, diagnostics);
    std::vector<double> expected(3, 0.0);
    for (std::size_t i = 0; i < model->results().size(); ++i) {
        if (model->results()[i].name != "reaction_force") continue;
        const Result result = model->load(i);
        for (std::size_t v = 0; v < result.values.size(); ++v) {
            const std::size_t component = v % result.component_count();
            if (component < 3) expected[component] += static_cast<double>(result.values[v]);
        }
    }
    EXPECT_EQ(sum.sum, expected);
    EXPECT_GT(std::abs(sum.sum[0]) + std::abs(sum.sum[1]) + std::abs(sum.sum[2]), 0);
    EXPECT_EQ(sum.nodes, model->mesh().node_count());
    EXPECT_THAT(info_json(report, diagnostics), HasSubstr("\"reactions\""));
}

TEST(Reactions, of_heat_are_one_number) {
    // The energy of the file, named as CalculiX names the heat that flows in at held temperatures.
    std::string text = read_file(project_file("tests/data/calculix/static.frd"));
    for (const std::string name : {" -4  ENER", " -5  ENER"}) {
        const std::size_t at = text.find(name);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, name.size(), name.substr(0, 5) + "RFL ");
    }
    Job job;
    job.inputs = {scratch_folder("heat_reactions") + "/heat.frd"};
    write_file(job.inputs[0], text);
    Diagnostics diagnostics;

    const ModelReport report = report_model(job, diagnostics, {}).value();

    ASSERT_EQ(report.reactions.size(), 2U);
    const ReactionSum& sum = report.reactions[1];
    EXPECT_EQ(sum.info.name, "reaction_heat_flow");
    double expected = 0;
    const auto model = open_model(job.inputs, {}, diagnostics);
    for (std::size_t i = 0; i < model->results().size(); ++i) {
        if (model->results()[i].solver_name != "RFL") continue;
        for (const float value : model->load(i).values) expected += static_cast<double>(value);
    }
    EXPECT_EQ(sum.sum, std::vector<double>{expected});
    EXPECT_GT(expected, 0);
}

}  // namespace
}  // namespace feelem::test
