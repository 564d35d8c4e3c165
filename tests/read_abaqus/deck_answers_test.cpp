// SPDX-License-Identifier: Apache-2.0
// Whole decks against right answers: the shipped boilers, and the corpus where it is there.
#include "read/answers.hpp"
#include "read/merged_model.hpp"
#include "support/paths.hpp"

#include "feelem/read.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace feelem {
namespace {

namespace fs = std::filesystem;

struct Opened {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;
    const Mesh& mesh() const { return model->mesh(); }
};

std::unique_ptr<Opened> open_files(const std::vector<std::string>& paths) {
    auto opened = std::make_unique<Opened>();
    opened->model = open_model(paths, {}, opened->diagnostics);
    return opened;
}

Surface skin_of(const Mesh& mesh) {
    Diagnostics diagnostics;
    return make_skin(mesh, {}, diagnostics);
}

void expect_boiler(const std::string& deck, std::uint64_t facets, const std::string& frd) {
    SCOPED_TRACE(deck);
    const auto opened = open_files({deck});
    const auto results = open_files({frd});
    const SkinReport report = skin_of(opened->mesh()).report;
    EXPECT_EQ(report.solid_facets_kept, facets);
    EXPECT_TRUE(report.closed);
    const SkinReport expected = skin_of(results->mesh()).report;
    EXPECT_NEAR(report.area, expected.area, 1e-5 * expected.area);
    EXPECT_NEAR(report.volume, expected.volume, 1e-5 * expected.volume);
}

TEST(DeckAnswers, decks_of_boilers_have_the_mesh_of_their_results) {
    const auto corpus = test::corpus_file("boiler");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    const std::string folder = *corpus + "/";
    for (const char* boiler : {"hex_linear/", "small/"}) {
        const auto deck = open_files({folder + boiler + "static.inp"});
        const auto results = open_files({folder + boiler + "static.frd"});
        EXPECT_NO_THROW(check_same_mesh(results->mesh(), deck->mesh(), boiler));
        EXPECT_EQ(deck->mesh().parts.at(0).name, "EALL");
    }
}

TEST(DeckAnswers, decks_of_one_folder_and_their_results_are_one_model) {
    const auto corpus = test::corpus_file("boiler/hex_linear");
    if (!corpus) GTEST_SKIP() << "the corpus is not here";
    const auto opened = open_files({*corpus});
    EXPECT_EQ(opened->mesh().element_count(), 1272U);
    EXPECT_EQ(opened->model->steps().size(), 10U) << "heat, static and eight of transient";
    EXPECT_FALSE(opened->diagnostics.has(Code::DuplicateNode));
}

TEST(DeckAnswers, converted_boilers_have_the_true_facets) {
    const auto folder = test::corpus_file("converted");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    const std::string boilers = test::project_file("examples/boiler/");
    expect_boiler(*folder + "/boiler_linear.inp", 2568, boilers + "hex_linear/static.frd");
    expect_boiler(*folder + "/boiler_tet10.inp", 2576, boilers + "small/static.frd");
}

/// What CalculiX does with elements before it writes them, so that its answer is not the deck's.
struct Expanded {
    const char* why;
    std::set<std::string> decks;
};
const std::vector<Expanded> kExpanded{
    {"shells, beams, trusses, plane elements and membranes are written as the solids made of them",
     {"b31",
      "boxprofile",
      "membrane1",
      "membrane3",
      "oneeltruss",
      "planestress4",
      "shell1",
      "shell3",
      "shell5",
      "truss",
      "uprofile",
      "crackIIint",
      "induction",
      "ball"}},
    {"the mesh is refined, or a sector repeated, while solving", {"circ10p", "circ11p", "greencyc1"}},
    {"pre-tension sections split the nodes they cut", {"pret1", "pret4"}},
    {"the job takes up the mesh of an earlier one", {"beamread3"}},
    {"elements are switched off (*MODEL CHANGE)", {"modelchel"}},
    {"network elements (D) have no surface and are counted instead", {"beamhtfcnu"}},
    {"the answers' plain reader failed", {"leifer1"}},
};

bool is_expanded(const std::string& deck) {
    return std::ranges::any_of(kExpanded, [&](const Expanded& one) { return one.decks.contains(deck); });
}

const std::map<std::string, ElementType> kAnswerTypes{
    {"1", ElementType::Hex8},
    {"4", ElementType::Hex20},
    {"6", ElementType::Tet10},
    {"7", ElementType::Tri3},
    {"10", ElementType::Quad8},
    {"11", ElementType::Line2},
    {"12", ElementType::Line3},
};

TEST(DeckAnswers, decks_of_calculix_have_the_elements_of_its_results) {
    const auto folder = test::corpus_file("calculix");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    std::size_t compared = 0;
    for (const auto& [file, answer] : test::read_corpus_answers(*folder + "/answers.json")) {
        const std::string name = fs::path(file).stem().stem().string();
        if (is_expanded(name)) continue;
        SCOPED_TRACE(name);
        const auto deck = open_files({*folder + "/test/" + name + ".inp"});
        std::map<ElementType, std::uint64_t> expected, found;
        for (const auto& [type, count] : answer.elements_by_frd_type) expected[kAnswerTypes.at(type)] = count;
        for (const ElementBlock& block : deck->mesh().blocks) found[block.type] = block.ids.size();
        EXPECT_EQ(found, expected);
        // The same elements with the same nodes at the same places; nodes of no element are not in the
        // results.
        const auto results = open_files({*folder + "/" + file});
        for (std::size_t i = 0; i < results->mesh().blocks.size(); ++i) {
            const ElementBlock& theirs = results->mesh().blocks[i];
            const auto ours = std::ranges::find(deck->mesh().blocks, theirs.type, &ElementBlock::type);
            ASSERT_NE(ours, deck->mesh().blocks.end());
            std::map<ElementId, std::vector<std::int64_t>> rows;
            const std::size_t width = element_row(theirs.type).node_count;
            for (std::size_t e = 0; e < ours->ids.size(); ++e) {
                for (std::size_t n = 0; n < width; ++n)
                    rows[ours->ids[e]].push_back(raw(deck->mesh().node_ids[raw(ours->nodes[e * width + n])]));
            }
            for (std::size_t e = 0; e < theirs.ids.size(); ++e) {
                std::vector<std::int64_t> row;
                for (std::size_t n = 0; n < width; ++n)
                    row.push_back(raw(results->mesh().node_ids[raw(theirs.nodes[e * width + n])]));
                EXPECT_EQ(rows[theirs.ids[e]], row) << raw(theirs.ids[e]);
            }
        }
        ++compared;
    }
    EXPECT_EQ(compared, 32U);
}

TEST(DeckAnswers, decks_beside_universal_files_have_their_counts) {
    const auto folder = test::corpus_file("unv");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    const auto answers = nlohmann::json::parse(test::read_file(*folder + "/answers.json"));
    std::size_t compared = 0;
    for (const auto& [file, answer] : answers.items()) {
        SCOPED_TRACE(file);
        const std::string deck = *folder + "/" + fs::path(file).stem().string() + ".inp";
        ASSERT_TRUE(fs::exists(deck));
        const auto opened = open_files({deck});
        EXPECT_EQ(opened->mesh().node_count(), answer["nodes"].get<std::size_t>());
        EXPECT_EQ(opened->mesh().element_count(), answer["elements"].get<std::size_t>());
        ++compared;
    }
    EXPECT_GT(compared, 5U);
}

TEST(DeckAnswers, decks_of_other_programs_are_read) {
    const auto folder = test::corpus_file("abaqus/test");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    struct Case {
        const char* file;
        std::size_t nodes, elements, facets;
        double volume;
        std::vector<std::string> parts;
    };
    // Counted in the files; volumes are those of the bodies that their authors describe.
    const std::vector<Case> cases{
        {"test_parse_mesh/cube_tet4.inp", 10, 17, 12, 1000, {"CUBE"}},
        {"test_parse_model/cube_tet4.inp", 10, 17, 12, 1000, {"CUBE"}},
        {"test_parse_model_mixed_case/cube_tet4_mixed_case.inp", 10, 17, 12, 1000, {"Cube"}},
        {"test_parse_mesh/beam.inp", 298, 120, 114, 10000, {"Body1"}},
        {"test_parse_mesh/tet4.inp", 116, 264, 212, 1, {"UPPER", "LOWER"}},
        {"test_parse_mesh/hypermesh_model.inp", 2, 0, 0, 0, {}},
        {"test_parse_mesh/nx_export_problem.inp", 3, 0, 0, 0, {}},
        {"test_comprehensive/plate_with_hole.inp", 13, 8, 0, 0, {"OUTER_ELEMENTS", "INNER_ELEMENTS"}},
        {"test_comprehensive/cantilever_beam.inp", 26, 3, 16, 20, {"BEAM", "REFINED_TIP"}},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.file);
        const auto opened = open_files({*folder + "/" + one.file});
        EXPECT_EQ(opened->mesh().node_count(), one.nodes);
        EXPECT_EQ(opened->mesh().element_count(), one.elements);
        std::vector<std::string> parts;
        for (const Part& part : opened->mesh().parts) parts.push_back(part.name);
        EXPECT_EQ(parts, one.parts);
        if (one.elements == 0) continue;
        const SkinReport report = skin_of(opened->mesh()).report;
        EXPECT_EQ(report.solid_facets_kept, one.facets);
        EXPECT_NEAR(report.volume, one.volume, 1e-5 * one.volume + 1e-9);
    }
}

}  // namespace
}  // namespace feelem
