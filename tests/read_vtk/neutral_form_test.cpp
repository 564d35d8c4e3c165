// SPDX-License-Identifier: Apache-2.0
// What comes through the pipe from the helper program is as little trusted as any file; how often it is
// started; names in lists of files.
#include "read/exchange/asked_values.hpp"
#include "read/exchange/ensight_case.hpp"
#include "read/exchange/family_names.hpp"
#include "read/exchange/neutral_form.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

namespace feelem::exchange {
namespace {

using testing::ElementsAre;

NeutralModel sample() {
    NeutralModel model;
    model.node_ids = {5, 7, 9};
    model.coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0.5};
    model.parts = {"skin"};
    model.types = {ElementType::Tri3};
    model.element_ids = {42};
    model.element_parts = {0};
    model.element_nodes = {0, 1, 2};
    model.skipped = {{"vtkPolyhedron of 9 points", 3}};
    model.node_sets = {{"fixed", {0, 2}}};
    model.element_sets = {{"all", {0}}};
    model.steps = {{0, 1, 1, StepKind::Time, 0.25, ""}};
    model.results = {{"T", 1, Location::Nodal, 0, {"TEMP"}}};
    model.length_unit = "mm";
    return model;
}

TEST(NeutralForm, model_comes_through_whole) {
    const NeutralModel back = read_model(write_model(sample()), "x");
    EXPECT_THAT(back.node_ids, ElementsAre(5, 7, 9));
    EXPECT_EQ(back.coordinates, sample().coordinates);
    EXPECT_EQ(back.types[0], ElementType::Tri3);
    EXPECT_EQ(back.skipped[0].second, 3U);
    EXPECT_THAT(back.node_sets[0].second, ElementsAre(0, 2));
    EXPECT_EQ(back.element_sets, sample().element_sets);
    EXPECT_EQ(back.steps[0].kind, StepKind::Time);
    EXPECT_EQ(back.steps[0].value, 0.25);
    EXPECT_EQ(back.results[0].name, "T");
    EXPECT_EQ(back.results[0].component_names[0], "TEMP");
    EXPECT_EQ(back.length_unit, "mm");
}

TEST(NeutralForm, model_that_ends_anywhere_is_an_error) {
    const std::string bytes = write_model(sample());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_THROW(read_model(bytes.substr(0, length), "x"), Error) << length;
}

TEST(NeutralForm, model_with_any_byte_changed_is_a_model_or_an_error) {
    const std::string bytes = write_model(sample());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 0xFF);
        try {
            const NeutralModel model = read_model(damaged, "x");
            EXPECT_EQ(model.coordinates.size(), 3 * model.node_ids.size());
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()), "");
        }
    }
}

TEST(NeutralForm, elements_of_nodes_that_do_not_exist_are_refused) {
    NeutralModel model = sample();
    model.element_nodes[1] = 3;
    EXPECT_THROW(read_model(write_model(model), "x"), Error);
}

TEST(NeutralForm, digest_tells_meshes_apart_but_not_where_nodes_moved_to) {
    NeutralModel moved = sample(), other = sample();
    moved.coordinates[0] = 5;
    EXPECT_EQ(mesh_digest(moved), mesh_digest(sample()));
    std::swap(other.element_nodes[0], other.element_nodes[1]);
    EXPECT_NE(mesh_digest(other), mesh_digest(sample()));
}

std::string two_values() {
    NeutralWriter to(Answer::Values);
    write_values(to, 7, {1.5F, 2.5F});
    write_values(to, 8, {});
    return to.take();
}

TEST(NeutralForm, values_come_with_the_digests_of_their_meshes) {
    const std::string answer = two_values();
    const auto values = read_values(answer, 2, "x");
    ASSERT_EQ(values.size(), 2U);
    EXPECT_EQ(values[0].mesh_digest, 7U);
    EXPECT_EQ(values[0].bytes.size(), 2 * sizeof(float));
    EXPECT_EQ(values[1].mesh_digest, 8U);
    EXPECT_TRUE(values[1].bytes.empty());
}

TEST(NeutralForm, values_that_end_anywhere_are_an_error) {
    const std::string answer = two_values();
    EXPECT_THROW(read_values(answer, 3, "x"), Error);
    for (std::size_t length = 0; length < answer.size(); ++length)
        EXPECT_THROW(read_values(answer.substr(0, length), 2, "x"), Error) << length;
    std::string huge = answer;
    huge[16] = '\xFF';
    EXPECT_THROW(read_values(huge, 2, "x"), Error);
}

/// A helper that answers with the first character of the result's name, and fails on "bad".
struct ToyHelper {
    std::vector<std::size_t> asked;
    std::string operator()(const std::vector<std::string>& requests) {
        asked.push_back(requests.size());
        NeutralWriter to(Answer::Values);
        for (const std::string& request : requests) {
            const std::string name = read_request(request).name;
            if (name == "bad") throw Error(Code::BadStructure, "x", "as asked for");
            write_values(to, 1, std::vector<float>(3, static_cast<float>(name[0])));
        }
        return to.take();
    }
};

float first_value(const NeutralValues& values) {
    float value = 0;
    std::memcpy(&value, values.bytes.data(), sizeof value);
    return value;
}

TEST(AskedValues, helper_is_started_once_for_many_small_results) {
    ToyHelper helper;
    AskedValues values(std::ref(helper), "x");
    values.list({{"a", 1}, {"b", 1}, {"c", 1}}, 3, 3);
    EXPECT_EQ(first_value(values.get(0)), 'a');
    EXPECT_EQ(first_value(values.get(2)), 'c');
    EXPECT_EQ(first_value(values.get(1)), 'b');
    EXPECT_EQ(first_value(values.get(0)), 'a');
    EXPECT_THAT(helper.asked, ElementsAre(3U));
}

TEST(AskedValues, damaged_result_takes_no_other_with_it) {
    ToyHelper helper;
    AskedValues values(std::ref(helper), "x");
    values.list({{"a", 1}, {"bad", 1}, {"c", 1}}, 3, 3);
    EXPECT_EQ(first_value(values.get(0)), 'a');
    EXPECT_THROW(values.get(1), Error);
    EXPECT_EQ(first_value(values.get(2)), 'c');
    EXPECT_THAT(helper.asked, ElementsAre(3U, 1U, 1U, 1U));
}

TEST(AskedValues, large_results_are_asked_for_alone) {
    ToyHelper helper;
    AskedValues values(std::ref(helper), "x");
    constexpr std::size_t kManyNodes = 12u << 20;
    values.list({{"a", 1}, {"b", 1}, {"c", 1}}, kManyNodes, 3);
    EXPECT_EQ(first_value(values.get(0)), 'a');
    EXPECT_EQ(first_value(values.get(1)), 'b');
    EXPECT_THAT(helper.asked, ElementsAre(1U, 1U));
}

TEST(NeutralForm, request_comes_back) {
    const NeutralResult request{"a:b \"c\"", 6, Location::Elemental, 17, {}};
    const NeutralResult back = read_request(write_request(request));
    EXPECT_EQ(back.name, request.name);
    EXPECT_EQ(back.components, 6U);
    EXPECT_EQ(back.location, Location::Elemental);
    EXPECT_EQ(back.step, 17U);
}

TEST(FamilyNames, pvd_entries_have_times_and_files) {
    const auto entries = read_pvd(
        "<VTKFile type=\"Collection\"><Collection>\n<DataSet timestep=\"0.5\" part='0' file='a &amp; "
        "b.vtu'/>\n"
        "<DataSet file = \"c.vtu\" timestep=\"1e1\"></DataSet></Collection></VTKFile>",
        "x"
    );
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].file, "a & b.vtu");
    EXPECT_EQ(entries[0].time, 0.5);
    EXPECT_EQ(entries[1].file, "c.vtu");
    EXPECT_EQ(entries[1].time, 10);
}

TEST(FamilyNames, attributes_are_found_in_their_own_tags_only) {
    const char* const text =
        "<Pieces Source='no'/><Piece XSource='no' Source='a.vtu'/><Piece Source=\"b.vtu\"";
    EXPECT_THAT(attribute_values(text, "Piece", "Source"), ElementsAre("a.vtu"));
}

TEST(FamilyNames, pvd_without_its_end_is_an_error) {
    const std::string text =
        "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" file=\"a.vtu\"/>";
    EXPECT_THROW(read_pvd(text, "x"), Error);
    EXPECT_EQ(read_pvd(text + "</Collection></VTKFile>", "x").size(), 1U);
}

constexpr const char* kCase = R"(FORMAT
type: ensight gold
GEOMETRY
model: 1 1 a.geo**** change_coords_only
VARIABLE
scalar per node: 2 T a.t**
vector per element: U fixed.u
complex scalar per node: 1 P p.re p.im 50.0
constant per case: c 1.5
scalar per measured node: M m.m
TIME
time set: 1
number of steps: 2
filename start number: 7
filename increment: 3
time values: 0.5 1.5
time set: 2
number of steps: 3
filename numbers: 1 5
 12
time values: 0 1
 2e0
)";

TEST(EnsightCase, files_of_all_steps_are_named) {
    EXPECT_THAT(
        files_of(read_ensight_case(kCase)),
        ElementsAre("a.geo0007", "a.geo0010", "a.t01", "a.t05", "a.t12", "fixed.u", "p.re", "p.im", "m.m")
    );
}

TEST(EnsightCase, blanks_of_every_kind_end) {
    const EnsightCase all = read_ensight_case("type: \vensight\f gold \f\nmodel: \v 1\tbox.geo \v\n");
    EXPECT_EQ(files_of(all).size(), 1U);
}

TEST(EnsightCase, more_files_than_any_real_case_has_are_refused) {
    std::string text = "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1 box.geo\nVARIABLE\n";
    for (int i = 0; i < 100; ++i) text += fmt::format("scalar per node: 1 v{0} v{0}.****\n", i);
    text += "TIME\ntime set: 1\nnumber of steps: 5000\nfilename start number: 0\nfilename increment: 1\n";
    EXPECT_THROW(files_of(read_ensight_case(text)), Error);
}

TEST(EnsightCase, file_of_a_time_is_the_last_that_is_not_later) {
    const EnsightCase all = read_ensight_case(kCase);
    ASSERT_EQ(all.variables.size(), 5U);
    EXPECT_EQ(file_at(all, all.variables[0].file, 1.9), "a.t05");
    EXPECT_EQ(file_at(all, all.variables[0].file, 2), "a.t12");
    EXPECT_EQ(file_at(all, all.geometry, 1.9), "a.geo0010");
    EXPECT_EQ(file_at(all, all.variables[1].file, 1.9), "fixed.u");
    EXPECT_FALSE(all.variables[1].nodal);
    EXPECT_TRUE(all.variables[4].measured);
}

TEST(EnsightCase, values_are_counted_without_parts_and_undefined_ones) {
    EXPECT_EQ(count_ensight_values("T\npart\n 1\ncoordinates\n 1.0\n-2e5\n"), 2);
    EXPECT_EQ(count_ensight_values("T\npart\n 1\ncoordinates undef\n -9.9\n 1.0\npart\n2\nhexa8\nnan\n"), 2);
    EXPECT_EQ(count_ensight_values("T\npart\n 1\ncoordinates partial\n 1\n 1\n 1.0\n"), -1);
}

TEST(EnsightCase, geometry_that_ends_early_is_noticed) {
    const std::string text = "a\nb\nnode id assign\nelement id given\npart\n 1\nbody\ncoordinates\n 1\n "
                             "0.0\n 0.0\n 0.0\npoint\n 1\n "
                             "9\n 1\n";
    EXPECT_EQ(trouble_of_ensight_geometry(text), "");
    EXPECT_EQ(trouble_of_ensight_end(text), "");
    EXPECT_NE(trouble_of_ensight_geometry(text.substr(0, text.size() - 3)), "");
    EXPECT_NE(trouble_of_ensight_end("T\n 1.00000e+00\n 2.0"), "");
}

}  // namespace
}  // namespace feelem::exchange
