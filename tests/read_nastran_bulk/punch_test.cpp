// SPDX-License-Identifier: Apache-2.0
// Punch files, in the forms of MSC and NX Nastran, by columns.
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace feelem {
namespace {

/// Lines of 72 columns and their number, as Nastran punches them.
class Punch {
public:
    Punch& line(const std::string& text) {
        text_ += fmt::format("{:<72}{:8}\n", text, ++count_);
        return *this;
    }
    Punch& head(const std::string& quantity, const std::string& form = "$REAL OUTPUT", int subcase = 1) {
        line("$TITLE   = A JOB").line("$SUBTITLE=GRAVITY").line("$LABEL   =");
        return line(quantity).line(form).line(fmt::format("$SUBCASE ID ={:12}", subcase));
    }
    Punch& row(int id, std::vector<double> values, char kind = 'G') {
        return numbers(fmt::format("{:10}       {}", id, kind), values);
    }
    /// Sorted by grid: a time or frequency first.
    Punch& row_at(double value, std::vector<double> values) {
        return numbers(fmt::format("{:16.6E} G", value), values);
    }
    const std::string& text() const { return text_; }

private:
    Punch& numbers(std::string start, const std::vector<double>& values) {
        for (std::size_t i = 0; i < values.size(); i += 3) {
            std::string out = i == 0 ? start : fmt::format("{:<18}", "-CONT-");
            for (std::size_t j = i; j < i + 3 && j < values.size(); ++j)
                out += fmt::format("{:18.6E}", values[j]);
            line(out);
        }
        return *this;
    }
    std::string text_;
    int count_ = 0;
};

struct Punched {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;

    float value(std::size_t result, int node, std::size_t component) {
        const Result loaded = model->load(result);
        const auto row = raw(find_node(model->mesh(), NodeId{node}));
        return loaded.values.at(row * loaded.component_count() + component);
    }
};
Punched open_punched(const Punch& punch, const std::string& deck = "") {
    Punched out;
    std::vector<NamedBytes> files{{"job.pch", punch.text()}};
    if (!deck.empty()) files.push_back({"job.bdf", deck});
    out.model = open_model(std::move(files), {}, out.diagnostics);
    return out;
}

TEST(NastranPunch, displacements_and_forces_of_subcases_are_matched_to_the_deck) {
    Punch punch;
    punch.head("$DISPLACEMENTS").row(1, {1e-3, 2, 3, 4, 5, 6}).row(2, {-1.234567e-5, 0, 0, 0, 0, 0});
    punch.head("$SPCF").row(2, {9, 8, 7, 6, 5, 4});
    punch.head("$DISPLACEMENTS", "$REAL OUTPUT", 2).row(1, {11, 12, 13, 14, 15, 16});
    Punched punched =
        open_punched(punch, "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\nCTRIA3,1,1,1,2,3\n");
    ASSERT_EQ(punched.model->results().size(), 6U);
    ASSERT_EQ(punched.model->steps().size(), 2U);
    EXPECT_EQ(punched.model->steps()[1].step, 2);
    EXPECT_EQ(punched.model->steps()[0].label, "GRAVITY");
    EXPECT_EQ(punched.model->results()[0].name, "displacement");
    EXPECT_EQ(punched.model->results()[2].name, "reaction_force");
    EXPECT_EQ(punched.model->results()[2].solver_name, "SPCF");
    EXPECT_EQ(punched.value(0, 2, 0), -1.234567e-5F);
    EXPECT_EQ(punched.value(1, 1, 2), 6);
    EXPECT_EQ(punched.value(2, 2, 1), 8);
    EXPECT_TRUE(std::isnan(punched.value(2, 1, 1)));
    EXPECT_EQ(punched.value(4, 1, 0), 11);
    EXPECT_EQ(punched.model->mesh().element_count(), 1U);
}

TEST(NastranPunch, modes_carry_their_number_and_frequency) {
    Punch punch;
    const double eigenvalue = std::pow(2 * std::numbers::pi * 25, 2);
    punch.line("$TITLE   = A JOB")
        .line("$SUBTITLE=")
        .line("$LABEL   =")
        .line("$EIGENVECTOR")
        .line("$REAL OUTPUT");
    punch.line("$SUBCASE ID =           1");
    punch.line(fmt::format("$EIGENVALUE = {:14.7E}  MODE ={:6}", 1.0, 1)).row(1, {1, 2, 3, 4, 5, 6});
    punch.line(fmt::format("$EIGENVALUE = {:14.7E}  MODE ={:6}", eigenvalue, 2))
        .row(1, {7, 8, 9, 10, 11, 12});
    Punched punched = open_punched(punch);
    ASSERT_EQ(punched.model->steps().size(), 2U);
    EXPECT_EQ(punched.model->steps()[1].kind, StepKind::Mode);
    EXPECT_EQ(punched.model->steps()[1].substep, 2);
    EXPECT_NEAR(punched.model->steps()[1].value, 25, 1e-5);
    EXPECT_EQ(punched.value(2, 1, 0), 7);
}

TEST(NastranPunch, complex_numbers_come_by_step_or_by_grid) {
    Punch by_step;
    by_step.head("$DISPLACEMENTS", "$REAL-IMAGINARY OUTPUT").line("$FREQUENCY =   5.0000000E+00");
    by_step.row(3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    Punched steps = open_punched(by_step);
    ASSERT_EQ(steps.model->results().size(), 4U);
    EXPECT_EQ(steps.model->steps()[0].kind, StepKind::Frequency);
    EXPECT_EQ(steps.model->results()[1].complex, Complex::Imaginary);
    EXPECT_EQ(steps.value(0, 3, 2), 3);
    EXPECT_EQ(steps.value(1, 3, 2), 9);
    EXPECT_EQ(steps.value(3, 3, 0), 10);

    Punch by_grid;
    for (const int grid : {4, 2}) {
        by_grid.head("$ACCELERATION", "$MAGNITUDE-PHASE OUTPUT");
        by_grid.line(fmt::format("$POINT ID ={:12}  IDENTIFIED BY FREQUENCY", grid));
        by_grid.row_at(5, {1. * grid, 2, 3, 4, 5, 6, 90, 8, 9, 10, 11, 12});
        by_grid.row_at(6, {10. * grid, 2, 3, 4, 5, 6, 180, 8, 9, 10, 11, 12});
    }
    Punched grids = open_punched(by_grid);
    ASSERT_EQ(grids.model->steps().size(), 2U);
    ASSERT_EQ(grids.model->results().size(), 8U);
    EXPECT_EQ(grids.value(0, 4, 0), 4);
    EXPECT_EQ(grids.value(0, 2, 0), 2);
    EXPECT_EQ(grids.model->results()[1].complex, Complex::Phase);
    EXPECT_EQ(grids.value(5, 2, 0), 180);
}

TEST(NastranPunch, scalar_points_have_one_number) {
    Punch punch;
    punch.head("$DISPLACEMENTS").row(1, {1, 2, 3, 4, 5, 6}).row(9, {5, 0, 0, 0, 0, 0}, 'S');
    Punched punched = open_punched(punch);
    EXPECT_EQ(punched.value(0, 9, 0), 5);
    EXPECT_TRUE(std::isnan(punched.value(0, 9, 1)));
    EXPECT_TRUE(std::isnan(punched.value(1, 9, 0)));
}

TEST(NastranPunch, element_tables_are_left_out_with_a_word) {
    Punch punch;
    punch.head("$ELEMENT STRESSES").line("$ELEMENT TYPE =          34  BAR").row(7, {1, 2, 3, 4});
    punch.head("$DISPLACEMENTS").row(1, {1, 2, 3, 4, 5, 6});
    const Punched punched = open_punched(punch);
    EXPECT_EQ(punched.model->results().size(), 2U);
    ASSERT_EQ(punched.diagnostics.count(Code::UnknownBlock), 1U);
    EXPECT_EQ(punched.diagnostics.entries()[0].text, "ELEMENT STRESSES are not used");
    Punch alone;
    alone.head("$ELEMENT STRESSES").row(7, {1, 2, 3, 4});
    EXPECT_THROW(open_punched(alone), Error);
}

TEST(NastranPunch, columns_that_overflowed_are_missing) {
    Punch punch;
    punch.head("$DISPLACEMENTS")
        .line(fmt::format("{:10}       G{:>18}{:>18}{:>18}", 1, "NaN", "*******", "1.5"));
    Punched punched = open_punched(punch);
    EXPECT_TRUE(std::isnan(punched.value(0, 1, 0)));
    EXPECT_EQ(punched.value(0, 1, 2), 1.5F);
    EXPECT_GT(punched.diagnostics.count(Code::NonFiniteValue), 0U);
}

TEST(NastranPunch, the_example_gives_the_same_as_its_print_file) {
    const std::string base = test::project_file("tests/data/nastran/pipe");
    Diagnostics diagnostics;
    const auto punched = open_model(std::vector<std::string>{base + ".bdf", base + ".pch"}, {}, diagnostics);
    const auto printed = open_model(std::vector<std::string>{base + ".bdf", base + ".f06"}, {}, diagnostics);
    EXPECT_EQ(punched->inputs().size(), 3U) << "with the included file";
    EXPECT_EQ(punched->mesh().parts[0].name, "Pipe wall (PSOLID 7)");
    ASSERT_EQ(punched->results().size(), 4U);
    ASSERT_EQ(printed->results().size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const Result a = punched->load(i), b = printed->load(i);
        EXPECT_EQ(a.info.name, b.info.name);
        ASSERT_EQ(a.values.size(), b.values.size());
        for (std::size_t k = 0; k < a.values.size(); ++k) {
            if (std::isnan(a.values[k]) && std::isnan(b.values[k])) continue;
            EXPECT_EQ(a.values[k], b.values[k]) << a.info.name << " " << k;
        }
    }
    // Outward everywhere: at 90 degrees along y.
    const Result moved = to_global(punched->mesh(), punched->load(0));
    const auto row = raw(find_node(punched->mesh(), NodeId{5}));
    EXPECT_NEAR(punched->mesh().coordinates[row][1], 100, 1e-12);
    EXPECT_NEAR(moved.values[row * 3], 0, 1e-9);
    EXPECT_FLOAT_EQ(moved.values[row * 3 + 1], 1.234567e-3F);
}

}  // namespace
}  // namespace feelem
