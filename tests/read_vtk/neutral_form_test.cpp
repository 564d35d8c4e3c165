// SPDX-License-Identifier: Apache-2.0
// What comes through the pipe from the helper program is as little trusted as any file; names in lists of
// files.
#include "read/exchange/family_names.hpp"
#include "read/exchange/neutral_form.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(FamilyNames, case_files_are_the_last_words_of_their_lines) {
    EXPECT_THAT(
        case_files(
            "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1 a.geo\nVARIABLE\nscalar per node: 1 T a.t**\n"
        ),
        ElementsAre("a.geo", "a.t**")
    );
}

}  // namespace
}  // namespace feelem::exchange
