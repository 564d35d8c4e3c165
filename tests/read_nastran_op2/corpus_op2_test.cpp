// SPDX-License-Identifier: Apache-2.0
// Real .op2 files of several solvers against the answers of another reader.
#include "read_nastran_op2/op2_answers.hpp"
#include "support/exercise.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace feelem {
namespace {

std::unique_ptr<ModelSource> open_alone(const std::string& path, Diagnostics& diagnostics) {
    const std::string file = test::corpus_file("nastran/" + path).value();
    std::vector<NamedBytes> files{{path, test::read_file(file)}};
    return open_model(std::move(files), {}, diagnostics);
}

constexpr std::string_view kNoGeometry[]{
    "models/plate/plate_formatted.op2",  // Text: refused.
    "models/msc/single_element-3d/static.op2",
    "models/plate_py/plate_py.op2",
    "models/unit/pcomp/pcomp_cquad4.op2",
    "models/unit/pcomp/pcomp_ctria3.op2",
};

/// OUGV1 stands in this file twice, byte for byte.
constexpr const char* kWritesTablesTwice = "models/sol_101_elements/transient_solid_shell_bar.op2";

/// With the deck beside it, which must be of the same mesh; null when there is none.
std::unique_ptr<ModelSource> open_with_deck(const std::string& path, Diagnostics& diagnostics) {
    const auto deck = test::corpus_file("nastran/" + path.substr(0, path.size() - 3) + "bdf");
    if (!deck) return nullptr;
    const std::vector<std::string> files{*deck, test::corpus_file("nastran/" + path).value()};
    return open_model(files, {}, diagnostics);
}

using Open = std::unique_ptr<ModelSource> (*)(const std::string& path, Diagnostics& diagnostics);

/// How many answers were compared.
std::size_t compare_answers(Open open) {
    std::size_t compared = 0;
    for (const test::Op2File& file :
         test::read_op2_answers(test::corpus_file("nastran/answers.json").value())) {
        SCOPED_TRACE(file.path);
        if (file.answers.empty()) continue;
        Diagnostics diagnostics;
        const auto model = open(file.path, diagnostics);
        if (!model) continue;
        EXPECT_EQ(test::exercise(*model), "");
        for (test::Op2Answer answer : file.answers) {
            // The other reader counts both copies.
            if (file.path == kWritesTablesTwice) answer.step_count /= 2;
            SCOPED_TRACE(answer.result + " of subcase " + std::to_string(answer.subcase));
            test::expect_answer(*model, answer);
            ++compared;
        }
    }
    return compared;
}

TEST(NastranOp2, every_answer_of_the_corpus_agrees) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    EXPECT_EQ(compare_answers(open_alone), 130U);
}

TEST(NastranOp2, every_answer_agrees_with_the_deck_beside_the_results) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    EXPECT_EQ(compare_answers(open_with_deck), 126U);
}

/// Scalar points of coupled fluids stand in the deck alone.
std::vector<NodeId> placed_nodes(const Mesh& mesh) {
    std::vector<NodeId> ids;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        if (!std::isnan(mesh.coordinates[i][0])) ids.push_back(mesh.node_ids[i]);
    }
    return ids;
}

/// Tables by step renamed, so that those by node are all there is.
std::unique_ptr<ModelSource> open_sorted_by_node(const std::string& path, Diagnostics& diagnostics) {
    std::string bytes = test::read_file(test::corpus_file("nastran/" + path).value());
    if (bytes.find("OUGV2   ") == std::string::npos) return nullptr;
    for (std::size_t at = 0; (at = bytes.find("OUGV1   ", at)) != std::string::npos;) bytes[at] = 'X';
    std::vector<NamedBytes> files{{path, std::move(bytes)}};
    return open_model(std::move(files), {}, diagnostics);
}

TEST(NastranOp2, answers_agree_with_tables_that_are_sorted_by_node) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    EXPECT_EQ(compare_answers(open_sorted_by_node), 8U);
}

TEST(NastranOp2, geometry_of_the_results_agrees_with_the_deck) {
    const auto answers = test::corpus_file("nastran/answers.json");
    if (!answers) GTEST_SKIP() << "the corpus is not here";
    std::size_t compared = 0, same = 0;
    for (const test::Op2File& file : test::read_op2_answers(*answers)) {
        SCOPED_TRACE(file.path);
        if (std::ranges::find(kNoGeometry, file.path) != std::end(kNoGeometry)) continue;
        Diagnostics diagnostics;
        const auto both = open_with_deck(file.path, diagnostics);
        if (!both) continue;
        const auto alone = open_alone(file.path, diagnostics);
        const Mesh& own = alone->mesh();
        const bool same_nodes = placed_nodes(own) == placed_nodes(both->mesh());
        if (same_nodes && own.element_count() == both->mesh().element_count()) ++same;
        ++compared;
    }
    // The other decks were extended after the run; what both hold was compared when they were opened.
    EXPECT_EQ(compared, 45U);
    EXPECT_EQ(same, 37U);
}

TEST(NastranOp2, a_table_that_is_written_twice_is_listed_once) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto model = open_alone(kWritesTablesTwice, diagnostics);
    const auto is_displacement = [](const ResultInfo& info) { return info.name.starts_with("displacement"); };
    EXPECT_EQ(std::ranges::count_if(model->results(), is_displacement), 21);
}

std::size_t displacement_of(const ModelSource& model) {
    const auto infos = model.results();
    const auto found = std::ranges::find(infos, "displacement", &ResultInfo::name);
    return static_cast<std::size_t>(found - infos.begin());
}

Result global_displacement(ModelSource& model) {
    return to_global(model.mesh(), model.load(displacement_of(model)));
}

TEST(NastranOp2, displacements_in_radial_systems_turn_into_those_of_the_same_model_in_global_ones) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const std::string folder = "models/sol_101_elements/static_solid_shell_bar";
    const auto radial = open_alone(folder + "_global_radial_cd.op2", diagnostics);
    const auto plain = open_alone(folder + "_xyz.op2", diagnostics);
    EXPECT_TRUE(std::ranges::any_of(radial->results(), &ResultInfo::nodal_system));
    EXPECT_FALSE(radial->mesh().node_angles.empty());
    const Result turned = global_displacement(*radial);
    const Result expected = global_displacement(*plain);
    ASSERT_EQ(turned.values.size(), expected.values.size());
    EXPECT_NE(turned.values, radial->load(displacement_of(*radial)).values);
    for (std::size_t i = 0; i < turned.values.size(); ++i)
        EXPECT_NEAR(turned.values[i], expected.values[i], 1e-8) << i;
}

using ResultKey = std::tuple<std::int32_t, std::int32_t, std::string>;

std::map<ResultKey, std::size_t> results_by_key(const ModelSource& model) {
    std::map<ResultKey, std::size_t> out;
    for (std::size_t i = 0; i < model.results().size(); ++i) {
        const ResultInfo& info = model.results()[i];
        const Step& step = model.steps()[info.step];
        if (info.location == Location::Nodal) out.try_emplace({step.step, step.substep, info.name}, i);
    }
    return out;
}

/// Largest difference, where both have a value, relative to the largest value.
double difference(const Result& a, const Result& b) {
    double largest = 0, most = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        if (std::isnan(a.values[i]) || std::isnan(b.values[i])) continue;
        largest = std::fmax(largest, std::abs(double(a.values[i])));
        most = std::fmax(most, std::abs(double(a.values[i]) - b.values[i]));
    }
    return largest == 0 ? most : most / largest;
}

TEST(NastranOp2, every_number_at_a_node_is_the_one_on_the_printed_pages) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    std::size_t compared = 0;
    for (const char* name :
         {"sol_101_elements/static_solid_shell_bar",
          "sol_101_elements/static_solid_shell_bar_global_radial_cd",
          "sol_101_elements/static_solid_shell_bar_xyz",
          "sol_101_elements/mode_solid_shell_bar",
          "plate/plate",
          "thermal/hd15901"}) {
        SCOPED_TRACE(name);
        const std::string base = test::corpus_file("nastran/models").value() + "/" + name;
        Diagnostics diagnostics;
        const std::vector<std::string> binary{base + ".bdf", base + ".op2"};
        const std::vector<std::string> printed{base + ".bdf", base + ".f06"};
        const auto ours = open_model(binary, {}, diagnostics);
        const auto pages = open_model(printed, {}, diagnostics);
        const auto on_pages = results_by_key(*pages);
        for (const auto& [key, index] : results_by_key(*ours)) {
            const auto found = on_pages.find(key);
            if (found == on_pages.end()) continue;
            SCOPED_TRACE(std::get<std::string>(key));
            const Result mine = ours->load(index);
            const Result other = pages->load(found->second);
            ASSERT_EQ(mine.values.size(), other.values.size());
            EXPECT_LT(difference(mine, other), 1e-6);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 68U);
}

TEST(NastranOp2, text_op2_is_refused_with_a_hint) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    try {
        open_alone("models/plate/plate_formatted.op2", diagnostics);
        FAIL() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadStructure);
        EXPECT_NE(std::string(error.what()).find("UNFORM"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace feelem
