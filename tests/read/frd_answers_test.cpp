// SPDX-License-Identifier: Apache-2.0
// Whole .frd files against right answers: the shipped boilers, and the corpus where it is there.
#include "read/answers.hpp"
#include "support/paths.hpp"

#include "feelem/read.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace feelem {
namespace {

struct Opened {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;
};

std::unique_ptr<Opened> open_files(const std::vector<std::string>& paths) {
    auto opened = std::make_unique<Opened>();
    opened->model = open_model(paths, {}, opened->diagnostics);
    return opened;
}

void expect_boiler(const std::string& file, const std::string& answers, const std::string& analysis) {
    SCOPED_TRACE(file);
    const auto opened = open_files({file});
    test::expect_answers(
        *opened->model, test::read_boiler_answers(answers).at(analysis), opened->diagnostics
    );
    EXPECT_TRUE(opened->diagnostics.entries().empty());
}

TEST(FrdAnswers, shipped_boiler_of_bricks_and_wedges) {
    const std::string folder = test::project_file("examples/boiler/hex_linear/");
    for (const std::string analysis : {"heat", "static", "transient"}) {
        expect_boiler(folder + analysis + ".frd", folder + "results.json", analysis);
    }
}

TEST(FrdAnswers, shipped_boiler_of_quadratic_tetrahedra) {
    const std::string folder = test::project_file("examples/boiler/small/");
    for (const std::string analysis : {"heat", "static"}) {
        expect_boiler(folder + analysis + ".frd", folder + "results.json", analysis);
    }
}

TEST(FrdAnswers, corpus_boiler_of_quadratic_bricks_as_text_and_binary) {
    const auto folder = test::corpus_file("boiler/hex_small");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    expect_boiler(*folder + "/heat.frd", *folder + "/results.json", "heat");
    expect_boiler(*folder + "/static.frd", *folder + "/results.json", "static");

    const auto text = open_files({*folder + "/static.frd"});
    const auto binary = open_files({*folder + "/static_binary.frd"});
    EXPECT_EQ(text->model->mesh().blocks[1].nodes, binary->model->mesh().blocks[1].nodes);
    ASSERT_EQ(text->model->results().size(), binary->model->results().size());
    for (std::size_t i = 0; i < text->model->results().size(); ++i) {
        const Result six_digits = text->model->load(i);
        const Result all_digits = binary->model->load(i);
        ASSERT_EQ(six_digits.values.size(), all_digits.values.size());
        // Two runs of the solver: what should be nothing is noise of its own in each.
        float largest = 0;
        for (const float value : all_digits.values) largest = std::max(largest, std::abs(value));
        for (std::size_t v = 0; v < six_digits.values.size(); ++v) {
            const double tolerance = 6e-6 * std::abs(all_digits.values[v]) + 1e-9 * largest;
            ASSERT_NEAR(six_digits.values[v], all_digits.values[v], tolerance) << six_digits.info.name;
        }
    }
}

TEST(FrdAnswers, corpus_modes_and_transient) {
    const auto folder = test::corpus_file("boiler/small");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    expect_boiler(*folder + "/modal.frd", *folder + "/results.json", "modal");
    expect_boiler(*folder + "/transient.frd", *folder + "/results.json", "transient");
}

TEST(FrdAnswers, corpus_test_suite_of_calculix) {
    const auto answers = test::corpus_file("calculix/answers.json");
    if (!answers) GTEST_SKIP() << "the corpus is not here";
    std::size_t known = 0;
    for (const auto& [name, answer] : test::read_corpus_answers(*answers)) {
        SCOPED_TRACE(name);
        const auto opened = open_files({*test::corpus_file("calculix/" + name)});
        if (!answer.known) continue;
        test::expect_answers(*opened->model, answer, opened->diagnostics);
        ++known;
    }
    EXPECT_EQ(known, 54U);
}

}  // namespace
}  // namespace feelem
