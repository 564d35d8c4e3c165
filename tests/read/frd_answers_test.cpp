// SPDX-License-Identifier: Apache-2.0
// Whole .frd files against right answers: the shipped boilers, and the corpus where it is there.
#include "read/answers.hpp"
#include "support/paths.hpp"

#include "feelem/read.hpp"

#include <gtest/gtest.h>

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
