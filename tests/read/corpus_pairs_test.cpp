// SPDX-License-Identifier: Apache-2.0
// Real files of one model, written by different programs or at different moments, through one door; and files
// of different models, which are refused with numbers.
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace feelem {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

struct Pair {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;

    std::vector<std::string> disagreements() const {
        std::vector<std::string> texts;
        for (const Diagnostic& entry : diagnostics->entries()) {
            if (entry.code == Code::SourcesDisagree) texts.push_back(entry.text);
        }
        return texts;
    }
    const ElementSet* element_set(std::string_view name) const {
        const auto found = std::ranges::find(model->mesh().element_sets, name, &ElementSet::name);
        return found == model->mesh().element_sets.end() ? nullptr : &*found;
    }
    const NodeSet* node_set(std::string_view name) const {
        const auto found = std::ranges::find(model->mesh().node_sets, name, &NodeSet::name);
        return found == model->mesh().node_sets.end() ? nullptr : &*found;
    }
};

/// Empty when the corpus is not here.
std::optional<std::vector<std::string>> corpus_paths(const std::vector<std::string>& names) {
    std::vector<std::string> paths;
    for (const std::string& name : names) {
        const auto file = test::corpus_file(name);
        if (!file) return std::nullopt;
        paths.push_back(*file);
    }
    return paths;
}

Pair open_pair(const std::vector<std::string>& paths) {
    Pair pair;
    pair.model = open_model(paths, {}, *pair.diagnostics);
    return pair;
}

/// Members of a set by id, ascending.
std::vector<std::int64_t> ids_of(const Mesh& mesh, const NodeSet& set) {
    std::vector<std::int64_t> ids;
    for (const NodeIndex node : set.nodes) ids.push_back(raw(mesh.node_ids[raw(node)]));
    std::ranges::sort(ids);
    return ids;
}
std::vector<std::int64_t> ids_of(const Mesh& mesh, const ElementSet& set) {
    std::vector<std::int64_t> ids;
    for (const ElementIndex element : set.elements) ids.push_back(raw(element_at(mesh, element).id()));
    std::ranges::sort(ids);
    return ids;
}

TEST(CorpusPairs, components_of_a_deck_go_to_the_mesh_of_the_results_by_id) {
    const auto paths = corpus_paths({"ansys/cdb/HexBeam.cdb", "ansys/rst/hexbeam_v150/file.rst"});
    if (!paths) GTEST_SKIP() << "the corpus is not here";
    const Pair deck = open_pair({paths->front()});
    const Pair results = open_pair({paths->back()});
    ASSERT_EQ(deck.model->mesh().node_sets.size() + deck.model->mesh().element_sets.size(), 4U);

    const Pair both = open_pair(*paths);

    EXPECT_EQ(both.model->results().size(), results.model->results().size());
    EXPECT_THAT(both.disagreements(), IsEmpty());
    for (const NodeSet& set : deck.model->mesh().node_sets) {
        const NodeSet* found = both.node_set(set.name);
        ASSERT_NE(found, nullptr) << set.name;
        EXPECT_EQ(ids_of(both.model->mesh(), *found), ids_of(deck.model->mesh(), set)) << set.name;
    }
    for (const ElementSet& set : deck.model->mesh().element_sets) {
        const ElementSet* found = both.element_set(set.name);
        ASSERT_NE(found, nullptr) << set.name;
        EXPECT_EQ(ids_of(both.model->mesh(), *found), ids_of(deck.model->mesh(), set)) << set.name;
    }
}

TEST(CorpusPairs, workbench_input_and_its_results_agree_in_mesh_and_parts) {
    const auto paths =
        corpus_paths({"ansys/cdb/engineeringData_ds.dat", "ansys/rst/engineeringData_v212.rst"});
    if (!paths) GTEST_SKIP() << "the corpus is not here";
    const Pair both = open_pair(*paths);
    EXPECT_EQ(both.model->mesh().node_count(), 2720U);
    EXPECT_EQ(both.model->mesh().element_count(), 450U);
    EXPECT_THAT(both.disagreements(), IsEmpty());
}

TEST(CorpusPairs, a_printed_list_beside_its_binary_results_gives_the_same_values) {
    const auto paths =
        corpus_paths({"ansys/rst/hexbeam_v150/file.rst", "ansys/rst/hexbeam_v150/prnsol_u.txt"});
    if (!paths) GTEST_SKIP() << "the corpus is not here";
    const Pair both = open_pair(*paths);
    std::optional<Result> printed, stored;
    for (std::size_t i = 0; i < both.model->results().size(); ++i) {
        const ResultInfo& info = both.model->results()[i];
        if (info.name != "displacement") continue;
        const Step& step = both.model->steps()[info.step];
        if (step.input == 1) printed = both.model->load(i);
        if (step.input == 0 && step.substep == 1) stored = both.model->load(i);
    }
    ASSERT_TRUE(printed && stored);
    const std::size_t width = printed->component_count();
    ASSERT_GE(width, 3U);
    for (std::size_t row = 0; row < 321; ++row) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double right = static_cast<double>(stored->values[3 * row + c]);
            EXPECT_NEAR(
                static_cast<double>(printed->values[width * row + c]), right, 1e-6 * std::abs(right) + 1e-6
            );
        }
    }
}

// CalculiX writes the mesh that it solved on: shells and beams are bricks there.
TEST(CorpusPairs, decks_of_calculix_and_their_results_are_one_model_or_say_in_numbers_why_not) {
    const auto folder = test::corpus_file("calculix/test");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    std::size_t equal = 0, told = 0;
    for (const char* name : {"achtel29", "beam8pjc", "ball", "anipla2", "b31", "boxprofile"}) {
        SCOPED_TRACE(name);
        const std::string base = *folder + "/" + name;
        const Pair results = open_pair({base + ".frd.ref"});
        const Pair both = open_pair({base + ".inp", base + ".frd.ref"});
        EXPECT_EQ(both.model->results().size(), results.model->results().size());
        EXPECT_EQ(both.model->mesh().node_count(), results.model->mesh().node_count()) << "results are shown";
        ++(both.disagreements().empty() ? equal : told);
        for (std::size_t i = 0; i < both.model->results().size(); ++i) {
            const Result mine = both.model->load(i), alone = results.model->load(i);
            ASSERT_EQ(mine.values.size(), alone.values.size());
            for (std::size_t k = 0; k < mine.values.size(); ++k) {
                const bool both_missing = std::isnan(mine.values[k]) && std::isnan(alone.values[k]);
                ASSERT_TRUE(both_missing || mine.values[k] == alone.values[k]) << k;
            }
        }
    }
    std::cout << equal << " pairs agree, " << told << " say in what they do not\n";
    EXPECT_GE(equal, 3U);
    EXPECT_GE(told, 1U);
}

TEST(CorpusPairs, op2_files_are_refused_beside_decks_of_other_models) {
    const auto models = test::corpus_file("nastran/models");
    if (!models) GTEST_SKIP() << "the corpus is not here";
    const std::vector<std::string> names{
        "plate/plate",
        "solid_bending/solid_bending",
        "sol_101_elements/static_solid_shell_bar",
        "thermal/hd15901",
        "elements/static_elements"};
    for (const std::string& deck : names) {
        for (const std::string& results : names) {
            SCOPED_TRACE(deck + ".bdf with " + results + ".op2");
            const std::vector<std::string> paths{
                *models + "/" + deck + ".bdf", *models + "/" + results + ".op2"};
            Diagnostics diagnostics;
            if (deck == results) {
                EXPECT_NO_THROW(open_model(paths, {}, diagnostics));
                continue;
            }
            try {
                open_model(paths, {}, diagnostics);
                ADD_FAILURE() << "was read";
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), Code::MeshesDiffer) << error.what();
                EXPECT_THAT(error.what(), testing::ContainsRegex("[0-9]")) << "numbers";
            }
        }
    }
}

TEST(CorpusPairs, results_of_ansys_are_refused_beside_decks_of_other_models) {
    const auto paths = corpus_paths(
        {"ansys/cdb/global.cdb",
         "ansys/cdb/sector.cdb",
         "ansys/cdb/class40.cdb",
         "ansys/rst/hexbeam_v150/file.rst"}
    );
    if (!paths) GTEST_SKIP() << "the corpus is not here";
    for (std::size_t i = 0; i + 1 < paths->size(); ++i) {
        SCOPED_TRACE((*paths)[i]);
        Diagnostics diagnostics;
        const std::vector<std::string> two{(*paths)[i], paths->back()};
        try {
            open_model(two, {}, diagnostics);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Code::MeshesDiffer) << error.what();
            EXPECT_THAT(error.what(), HasSubstr("agree in number and place"));
        }
    }
}

}  // namespace
}  // namespace feelem
