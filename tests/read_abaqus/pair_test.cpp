// SPDX-License-Identifier: Apache-2.0
// A deck beside the results of its job: which mesh is shown, what the deck gives to it, what is said.
#include "open_deck.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace feelem {
namespace {

using namespace tests;
using testing::ElementsAre;
using testing::HasSubstr;

std::string data_file(const std::string& name) {
    return test::project_file("tests/data/" + name);
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Opened open_files(const std::vector<std::string>& paths) {
    Opened opened;
    opened.model = open_model(paths, {}, *opened.diagnostics);
    return opened;
}

std::vector<std::string> disagreements(const Opened& opened) {
    std::vector<std::string> texts;
    for (const Diagnostic& entry : opened.diagnostics->entries())
        if (entry.code == Code::SourcesDisagree) texts.push_back(entry.text);
    return texts;
}

TEST(DeckPair, shells_that_calculix_made_solid_are_shown_solid_with_the_sets_that_fit) {
    for (const bool deck_first : {true, false}) {
        std::vector<std::string> paths{data_file("abaqus/shell.inp"), data_file("abaqus/shell.frd")};
        if (!deck_first) std::swap(paths[0], paths[1]);
        const Opened opened = open_files(paths);
        EXPECT_EQ(opened.mesh().node_count(), 12U);
        ASSERT_EQ(opened.mesh().blocks.size(), 1U);
        EXPECT_EQ(opened.mesh().blocks[0].type, ElementType::Hex8);
        // Element numbers are those of the shells, nodes are others.
        EXPECT_THAT(set_elements(opened.mesh(), "PLATE"), ElementsAre(1, 2));
        EXPECT_THAT(set_elements(opened.mesh(), "TIP"), ElementsAre(2));
        EXPECT_TRUE(set_nodes(opened.mesh(), "HELD").empty());
        EXPECT_THAT(
            disagreements(opened),
            testing::Contains(HasSubstr("sets lose 8 of 8 nodes, which are not in the mesh shown: NALL, HELD")
            )
        );
        EXPECT_THAT(disagreements(opened), testing::Contains(HasSubstr("quad4, hex8 in the mesh shown")));
        // Displacement, stress, and CalculiX' estimate of its error.
        ASSERT_EQ(opened.model->results().size(), 3U);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(opened.model->load(i).row_count(), 12U);
            for (const float value : opened.model->load(i).values) EXPECT_FALSE(std::isnan(value));
        }
    }
}

TEST(DeckPair, values_that_calculix_prints_at_nodes_of_the_shells_have_no_place_on_the_solids) {
    const Opened opened = open_files(
        {data_file("abaqus/shell.inp"), data_file("abaqus/shell.frd"), data_file("abaqus/shell.dat")}
    );
    ASSERT_EQ(opened.model->results().size(), 4U);
    const Result printed = opened.model->load(3);
    EXPECT_EQ(printed.info.name, "displacement");
    for (const float value : printed.values) EXPECT_TRUE(std::isnan(value));
    EXPECT_EQ(opened.diagnostics->count(Code::ResultWithoutNode), 6U);
    // Beside the deck alone they have theirs.
    const Opened deck = open_files({data_file("abaqus/shell.inp"), data_file("abaqus/shell.dat")});
    EXPECT_EQ(deck.model->load(0).values.at(3 * 5 + 2), -0.2640273F);
    EXPECT_TRUE(disagreements(deck).empty());
}

TEST(DeckPair, solids_of_calculix_take_the_sets_of_their_deck) {
    const Opened alone = open_files({data_file("calculix/static.frd")});
    const Opened deck = open_files({data_file("calculix/static.inp")});
    const Opened pair = open_files({data_file("calculix/static.inp"), data_file("calculix/static.frd")});
    EXPECT_TRUE(alone.mesh().node_sets.empty());
    ASSERT_FALSE(deck.mesh().node_sets.empty());
    ASSERT_EQ(pair.mesh().node_sets.size(), deck.mesh().node_sets.size());
    for (const NodeSet& set : deck.mesh().node_sets)
        EXPECT_EQ(set_nodes(pair.mesh(), set.name), set_nodes(deck.mesh(), set.name)) << set.name;
    for (const ElementSet& set : deck.mesh().element_sets)
        EXPECT_EQ(set_elements(pair.mesh(), set.name), set_elements(deck.mesh(), set.name)) << set.name;
    EXPECT_TRUE(disagreements(pair).empty());
    EXPECT_EQ(pair.model->results().size(), alone.model->results().size());
}

TEST(DeckPair, solids_that_share_no_number_with_their_shells_are_refused_with_advice) {
    // As with composite shells, whose layers CalculiX numbers anew.
    const std::string deck = "*NODE\n1,0\n2,1\n3,1,1\n4,0,1\n*ELEMENT,TYPE=S4\n77,1,2,3,4\n";
    try {
        open_decks({{"shell.inp", deck}, {"shell.frd", bytes_of(data_file("abaqus/shell.frd"))}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
        EXPECT_THAT(error.what(), HasSubstr("has 4 nodes, shell.frd has 12; 0 agree"));
        EXPECT_THAT(error.what(), HasSubstr("CalculiX makes solids of shells and beams"));
    }
}

TEST(DeckPair, results_file_beside_its_deck_has_the_sets_and_parts_of_the_deck) {
    const std::string fil = data_file("abaqus/two_bricks.fil");
    const Opened alone = open_files({fil});
    std::string nodes = "*NODE,NSET=EVERY\n", deck;
    for (std::size_t i = 0; i < alone.mesh().node_count(); ++i) {
        const Point3& at = alone.mesh().coordinates[i];
        nodes += std::to_string(raw(alone.mesh().node_ids[i]));
        for (const double x : at) nodes += "," + std::to_string(x);
        nodes += "\n";
    }
    deck = nodes + "*ELEMENT,TYPE=C3D8R,ELSET=BOTH\n";
    for (const ElementBlock& block : alone.mesh().blocks) {
        for (std::size_t e = 0; e < block.ids.size(); ++e) {
            deck += std::to_string(raw(block.ids[e]));
            for (std::size_t k = 0; k < 8; ++k)
                deck += "," + std::to_string(raw(alone.mesh().node_ids[raw(block.nodes[8 * e + k])]));
            deck += "\n";
        }
    }
    const Opened pair = open_decks({{"job.inp", deck}, {"job.fil", bytes_of(fil)}});
    EXPECT_THAT(part_of_each_element(pair.mesh()), testing::Each("BOTH"));
    EXPECT_EQ(set_nodes(pair.mesh(), "EVERY").size(), alone.mesh().node_count());
    EXPECT_TRUE(disagreements(pair).empty());
    ASSERT_EQ(pair.model->results().size(), alone.model->results().size());
    for (std::size_t i = 0; i < alone.model->results().size(); ++i) {
        const Result a = alone.model->load(i), b = pair.model->load(i);
        ASSERT_EQ(a.values.size(), b.values.size());
        for (std::size_t k = 0; k < a.values.size(); ++k)
            EXPECT_TRUE(a.values[k] == b.values[k] || (std::isnan(a.values[k]) && std::isnan(b.values[k])));
    }
}

}  // namespace
}  // namespace feelem
