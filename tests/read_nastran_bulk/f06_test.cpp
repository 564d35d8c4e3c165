// SPDX-License-Identifier: Apache-2.0
// Print files: real ones against the .op2 of the same job to the printed digits, and forms we wrote
// ourselves.
#include "read/nastran/f06_pages.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace feelem {
namespace {

std::unique_ptr<ModelSource> open_files(std::vector<std::string> paths, Diagnostics& diagnostics) {
    return open_model(paths, {}, diagnostics);
}

using StepName = std::tuple<int, int, std::string, Complex>;

/// Those at grid points.
std::map<StepName, std::size_t> results_by_step(const ModelSource& model) {
    std::map<StepName, std::size_t> out;
    for (std::size_t i = 0; i < model.results().size(); ++i) {
        const ResultInfo& info = model.results()[i];
        if (info.location != Location::Nodal) continue;
        const Step& step = model.steps()[info.step];
        out.emplace(StepName{step.step, step.substep, info.name, info.complex}, i);
    }
    return out;
}

/// Seven digits are printed.
bool agrees(float printed, float binary) {
    if (std::isnan(printed) || std::isnan(binary)) return std::isnan(printed) == std::isnan(binary);
    return std::abs(printed - binary) <= 6e-7F * std::abs(binary);
}

struct Job {
    const char* name;
    const char* deck_ending;
    const char* binary_ending;
    std::vector<std::string> results;
    std::size_t steps;
};

TEST(NastranF06, every_real_file_equals_the_op2_of_its_job_to_the_printed_digits) {
    if (!test::corpus_file("nastran/models")) GTEST_SKIP() << "the corpus is not here";
    const std::vector<std::string> forces{"applied_force", "applied_moment"};
    const std::vector<std::string> moved{"displacement", "rotation"};
    const std::vector<std::string> held{"reaction_force", "reaction_moment"};
    const auto all = [](std::vector<std::vector<std::string>> lists) {
        std::vector<std::string> out;
        for (const auto& list : lists) out.insert(out.end(), list.begin(), list.end());
        return out;
    };
    const std::vector<Job> jobs{
        {"plate/plate", ".bdf", ".op2", all({moved, held}), 1},
        {"sol_101_elements/static_solid_shell_bar", ".bdf", ".op2", all({moved, held, forces}), 1},
        {"sol_101_elements/static_solid_shell_bar_xyz", ".bdf", ".op2", all({moved, held, forces}), 1},
        {"sol_101_elements/static_solid_shell_bar_global_radial_cd",
         ".bdf",
         ".op2",
         all({moved, held, forces}),
         1},
        {"sol_101_elements/mode_solid_shell_bar", ".bdf", ".op2", all({moved, held}), 3},
        {"thermal/hd15901", ".bdf", ".op2", {"temperature", "applied_heat_flow"}, 17},
    };
    for (const Job& job : jobs) {
        SCOPED_TRACE(job.name);
        const std::string base = test::corpus_file("nastran/models").value() + "/" + job.name;
        Diagnostics diagnostics, other;
        const auto printed = open_files({base + job.deck_ending, base + ".f06"}, diagnostics);
        const auto binary = open_files({base + job.deck_ending, base + job.binary_ending}, other);
        EXPECT_EQ(printed->steps().size(), job.steps);
        const auto in_binary = results_by_step(*binary);
        std::map<std::string, std::size_t> found;
        for (const auto& [name, index] : results_by_step(*printed)) {
            SCOPED_TRACE(
                fmt::format("{} of step {}.{}", std::get<2>(name), std::get<0>(name), std::get<1>(name))
            );
            ++found[std::get<2>(name)];
            const auto same = in_binary.find(name);
            ASSERT_NE(same, in_binary.end());
            const Result a = printed->load(index), b = binary->load(same->second);
            const Step& step = printed->steps()[a.info.step];
            EXPECT_NEAR(step.value, binary->steps()[b.info.step].value, 1e-6 * std::abs(step.value));
            ASSERT_EQ(a.values.size(), b.values.size());
            std::size_t compared = 0;
            for (std::size_t i = 0; i < a.values.size(); ++i) {
                // The file leaves out rows that are zero.
                if (std::isnan(a.values[i])) continue;
                ++compared;
                ASSERT_TRUE(agrees(a.values[i], b.values[i]))
                    << i << ": " << a.values[i] << " " << b.values[i];
            }
            EXPECT_GT(compared, 0U);
        }
        std::vector<std::string> names;
        for (const auto& [name, count] : found) {
            names.push_back(name);
            EXPECT_EQ(count, name == "applied_heat_flow" ? 17U : job.steps) << name;
        }
        std::vector<std::string> expected = job.results;
        std::ranges::sort(expected);
        EXPECT_EQ(names, expected);
    }
}

/// Simcenter printed this one and MSC wrote the .op2 files beside it: of its double modes each solver gives
/// other vectors, so the text itself is the answer.
TEST(NastranF06, modes_of_a_real_file_are_what_its_lines_say) {
    const auto deck = test::corpus_file("nastran/models/beam_modes/beam_modes.dat");
    if (!deck) GTEST_SKIP() << "the corpus is not here";
    const std::string file = deck->substr(0, deck->size() - 3) + "f06";
    Diagnostics diagnostics;
    const auto model = open_files({*deck, file}, diagnostics);
    ASSERT_EQ(model->steps().size(), 10U);
    EXPECT_EQ(model->steps()[0].kind, StepKind::Mode);
    EXPECT_NEAR(model->steps()[0].value, 456.6603, 1e-4);
    EXPECT_NEAR(model->steps()[9].value, 11111.59, 1e-2);
    EXPECT_EQ(model->solver().name, "Nastran");
    std::istringstream lines(test::read_file(file));
    int mode = 0, compared = 0;
    Result moved, turned;
    const auto results = results_by_step(*model);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find("E I G E N V E C T O R   N O .");
        if (at != std::string::npos) {
            mode = std::stoi(line.substr(at + 29));
            moved = model->load(results.at({1, mode, "displacement", Complex::No}));
            turned = model->load(results.at({1, mode, "rotation", Complex::No}));
        }
        std::istringstream words(line);
        int grid = 0;
        char kind = 0;
        if (mode == 0 || !(words >> grid >> kind) || kind != 'G') continue;
        const auto row = raw(find_node(model->mesh(), NodeId{grid}));
        for (std::size_t i = 0; i < 6; ++i) {
            std::string word;
            words >> word;
            EXPECT_EQ((i < 3 ? moved : turned).values[row * 3 + i % 3], std::strtof(word.c_str(), nullptr));
            ++compared;
        }
    }
    EXPECT_EQ(compared, 10 * 12 * 6);
}

/// Values along the cylinder's axes, turned into the basic ones, are those of the same job in basic axes: so
/// CD systems, and a deck that another reader refuses, are right.
TEST(NastranF06, values_in_nodal_systems_turn_into_those_of_the_job_in_basic_axes) {
    const auto folder = test::corpus_file("nastran/models/sol_101_elements");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    const std::string base = *folder + "/static_solid_shell_bar";
    Diagnostics diagnostics;
    const auto basic = open_files({base + ".bdf", base + ".f06"}, diagnostics);
    for (const char* variant : {"_xyz", "_global_radial_cd"}) {
        SCOPED_TRACE(variant);
        const auto model = open_files({base + variant + ".bdf", base + variant + ".f06"}, diagnostics);
        const auto results = results_by_step(*model), expected = results_by_step(*basic);
        ASSERT_EQ(results.size(), expected.size());
        ASSERT_FALSE(model->mesh().node_angles.empty());
        for (const auto& [name, index] : results) {
            SCOPED_TRACE(std::get<2>(name));
            const Result local = model->load(index);
            EXPECT_TRUE(local.info.nodal_system);
            const Result turned = to_global(model->mesh(), local);
            const Result right = basic->load(expected.at(name));
            float largest = 0;
            for (const float v : right.values)
                largest = std::isnan(v) ? largest : std::max(largest, std::abs(v));
            for (std::size_t i = 0; i < right.values.size(); ++i) {
                if (std::isnan(right.values[i]) && std::isnan(turned.values[i])) continue;
                ASSERT_NEAR(turned.values[i], right.values[i], 2e-6 * largest) << i;
            }
        }
    }
}

/// Pages as Nastran prints them: head, subtitle, label with the subcase, then the table.
std::string page(const std::string& body, int subcase = 1) {
    return "1    A JOB                                                        MARCH  12, 2013  MSC.NASTRAN "
           "11/25/11   PAGE    12\n     THE SUBTITLE\n" +
           fmt::format("0    THE LABEL{:94}SUBCASE {:<14}\n \n", "", subcase) + body;
}
const char* const kColumns = " \n      POINT ID.   TYPE          T1             T2             T3            "
                             " R1             R2             R3\n";

struct Printed {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;
};
Printed open_text(const std::string& text) {
    Printed printed;
    printed.model = open_model(std::vector<NamedBytes>{{"job.f06", text}}, {}, printed.diagnostics);
    return printed;
}

float value_at(const ModelSource& model, const Result& result, int node, std::size_t component = 0) {
    const auto row = raw(find_node(model.mesh(), NodeId{node}));
    return result.values.at(row * result.component_count() + component);
}

TEST(NastranF06, a_table_goes_on_over_pages_and_ends_where_the_next_begins) {
    const std::string title = "                     D I S P L A C E M E N T   V E C T O R\n";
    const std::string row2 = "             2      G      2.000000E+00   0.0            0.0            0.0    "
                             "        0.0            0.0\n";
    const Printed printed = open_text(
        page(
            title + kColumns +
            "             1      G      1.000000E+00  -2.500000E-03   3.000000-101   4.0            5.0      "
            "      "
            "6.000000E+00\n"
        ) +
        page(title + kColumns + row2) + page("", 2) + page(title + kColumns + row2, 2)
    );
    ASSERT_EQ(printed.model->steps().size(), 2U);
    EXPECT_EQ(printed.model->steps()[1].step, 2);
    EXPECT_EQ(printed.model->steps()[0].label, "THE SUBTITLE, THE LABEL");
    EXPECT_EQ(printed.model->title(), "A JOB");
    EXPECT_EQ(printed.model->solver().name, "MSC Nastran");
    ASSERT_EQ(printed.model->results().size(), 4U);
    const Result moved = printed.model->load(0), turned = printed.model->load(1);
    EXPECT_EQ(moved.info.name, "displacement");
    EXPECT_EQ(value_at(*printed.model, moved, 1, 1), -0.0025F);
    EXPECT_EQ(value_at(*printed.model, turned, 1, 2), 6);
    EXPECT_EQ(value_at(*printed.model, moved, 2), 2);
    EXPECT_TRUE(std::isnan(value_at(*printed.model, printed.model->load(2), 1)));
}

TEST(NastranF06, complex_rows_are_two_lines_by_step_and_by_grid) {
    const std::string rows = "0            1      G      1.000000E+00   2.000000E+00   3.000000E+00   0.0    "
                             "        0.0            0.0\n"
                             "                           1.500000E+00   2.500000E+00   3.500000E+00   0.0    "
                             "        0.0            0.0\n"
                             "0          101      S      7.000000E+00\n"
                             "                           8.000000E+00\n";
    const Printed by_step = open_text(page(
        "      FREQUENCY =  1.000000E+01\n               C O M P L E X   D I S P L A C E M E N T   V E C T O "
        "R\n"
        "                                   (REAL/IMAGINARY)\n" +
        std::string(kColumns) + rows
    ));
    ASSERT_EQ(by_step.model->results().size(), 4U);
    EXPECT_EQ(by_step.model->steps()[0].kind, StepKind::Frequency);
    EXPECT_EQ(by_step.model->steps()[0].value, 10);
    const Result real = by_step.model->load(0), imaginary = by_step.model->load(1);
    EXPECT_EQ(real.info.complex, Complex::Real);
    EXPECT_EQ(imaginary.info.complex, Complex::Imaginary);
    EXPECT_EQ(value_at(*by_step.model, real, 1, 2), 3);
    EXPECT_EQ(value_at(*by_step.model, imaginary, 1, 2), 3.5F);
    EXPECT_EQ(value_at(*by_step.model, real, 101), 7);
    EXPECT_EQ(value_at(*by_step.model, imaginary, 101), 8);
    EXPECT_TRUE(std::isnan(value_at(*by_step.model, real, 101, 1)));

    const Printed by_grid = open_text(
        page("      POINT-ID =         5\n               C O M P L E X   V E L O C I T Y   V E C T O R\n"
             "                                   (MAGNITUDE/PHASE)\n"
             "\n      FREQUENCY   TYPE          T1             T2             T3             R1             "
             "R2             R3\n"
             "0   1.000000E+01     G      1.000000E+00   2.000000E+00   3.000000E+00   0.0            0.0    "
             "        0.0\n"
             "                           9.000000E+01   0.0            0.0            0.0            0.0     "
             "       0.0\n"
             "0   2.000000E+01     G      4.000000E+00   2.000000E+00   3.000000E+00   0.0            0.0    "
             "        0.0\n"
             "                           1.800000E+02   0.0            0.0            0.0            0.0     "
             "       0.0\n")
    );
    ASSERT_EQ(by_grid.model->steps().size(), 2U);
    ASSERT_EQ(by_grid.model->results().size(), 8U);
    EXPECT_EQ(by_grid.model->steps()[1].value, 20);
    const auto results = results_by_step(*by_grid.model);
    EXPECT_EQ(
        value_at(*by_grid.model, by_grid.model->load(results.at({1, 2, "velocity", Complex::Phase})), 5), 180
    );
    EXPECT_EQ(
        value_at(*by_grid.model, by_grid.model->load(results.at({1, 1, "velocity", Complex::Amplitude})), 5),
        1
    );
}

TEST(NastranF06, temperatures_stand_six_in_a_row) {
    const Printed printed = open_text(page(
        "               T E M P E R A T U R E   V E C T O R\n\n"
        "      POINT ID.   TYPE      ID   VALUE     ID+1 VALUE     ID+2 VALUE     ID+3 VALUE     ID+4 VALUE  "
        "   ID+5 "
        "VALUE\n"
        "             1      S      1.000000E+01   2.000000E+01   3.000000E+01   4.000000E+01   5.000000E+01 "
        "  "
        "6.000000E+01\n"
        "             7      S      7.000000E+01\n            11      S      1.100000E+02   1.200000E+02\n"
    ));
    ASSERT_EQ(printed.model->results().size(), 1U);
    const Result temperature = printed.model->load(0);
    EXPECT_EQ(temperature.info.name, "temperature");
    EXPECT_EQ(temperature.info.shape, Shape::Scalar);
    EXPECT_EQ(temperature.values, (std::vector<float>{10, 20, 30, 40, 50, 60, 70, 110, 120}));
    EXPECT_EQ(raw(printed.model->mesh().node_ids.back()), 12);
}

TEST(NastranF06, forces_of_equal_eigenvalues_are_told_apart_by_their_grids) {
    const std::string head = "      EIGENVALUE =  4.000000E+02\n         F O R C E S   O F   S I N G L E - P "
                             "O I N T   C O N S T R A I N T\n";
    const auto row = [](int grid, const char* value) {
        return fmt::format(
            "{:14}      G      {}   0.0            0.0            0.0            0.0            0.0\n",
            grid,
            value
        );
    };
    const Printed printed = open_text(
        page("                 R E A L   E I G E N V A L U E S\n   MODE    EXTRACTION      EIGENVALUE        "
             "    RADIANS\n"
             "    NO.       ORDER\n        1         1        1.000000E+02        1.000000E+01        "
             "1.591549E+00\n"
             "        2         2        4.000000E+02        2.000000E+01        3.183099E+00\n"
             "        3         3        4.000000E+02        2.000000E+01        3.183099E+00\n") +
        page(head + kColumns + row(1, "1.000000E+00")) + page(head + kColumns + row(2, "2.000000E+00")) +
        page(head + kColumns + row(1, "3.000000E+00") + row(2, "4.000000E+00"))
    );
    ASSERT_EQ(printed.model->steps().size(), 2U);
    EXPECT_EQ(printed.model->steps()[0].substep, 2);
    EXPECT_EQ(printed.model->steps()[1].substep, 3);
    EXPECT_NEAR(printed.model->steps()[0].value, 20 / (2 * std::numbers::pi), 1e-12);
    EXPECT_EQ(value_at(*printed.model, printed.model->load(0), 2), 2);
    EXPECT_EQ(value_at(*printed.model, printed.model->load(2), 2), 4);
}

TEST(NastranF06, rows_under_a_heading_that_is_not_known_are_nobodys) {
    const std::string row = "             1      G      1.000000E+00   0.0            0.0            0.0     "
                            "       0.0            0.0\n";
    const std::string title = "                     D I S P L A C E M E N T   V E C T O R\n";
    const Printed printed = open_text(
        page(title + kColumns + "   S T R E S S E S   I N   S O M E T H I N G\n" + row) +
        page(title + kColumns + row)
    );
    EXPECT_EQ(printed.model->results().size(), 2U);
    EXPECT_EQ(printed.diagnostics.count(Code::UnknownBlock), 1U);
}

TEST(NastranF06, a_file_without_results_at_grids_says_what_to_ask_for) {
    try {
        open_text(page("  *** USER FATAL MESSAGE 9050 (SEKRRS)\n"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("DISPLACEMENT(PRINT,PUNCH) = ALL"), std::string::npos);
    }
}

}  // namespace
}  // namespace feelem
