// SPDX-License-Identifier: Apache-2.0
// Punch files, in the forms of MSC and NX Nastran, by columns.
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
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
    /// Words of eighteen columns.
    Punch& words(int id, const std::vector<std::string>& fields) {
        for (std::size_t i = 0; i < fields.size(); i += 3) {
            std::string out = i == 0 ? fmt::format("{:10}{:8}", id, "") : fmt::format("{:<18}", "-CONT-");
            for (std::size_t j = i; j < i + 3 && j < fields.size(); ++j) out += fields[j];
            line(out);
        }
        return *this;
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

const char* const kElementDeck = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\n"
                                 "CQUAD4,7,1,1,2,3,4\nCTETRA,8,2,1,2,3,4\nCROD,9,3,1,2\n";

TEST(NastranPunch, shells_give_two_layers_at_their_corners) {
    // Words as MSC punches them for CQUADR: the number, "CEN/", how many corners, then the points.
    Punch punch;
    punch.head("$ELEMENT STRESSES").line("$ELEMENT TYPE =         144  QUAD4C    VONM");
    std::vector<std::string> words{"CEN/              ", "   4              "};
    for (const int grid : {0, 1, 2, 3, 4}) {
        if (grid > 0) words.push_back(fmt::format("{:>4}{:14}", grid, ""));
        for (const double side : {-0.5, 0.5}) {
            for (const double value :
                 {side, 1., 2., 3., 45., grid + 10 + side, grid + 20 + side, grid + 30 + side})
                words.push_back(fmt::format("{:18.6E}", value));
        }
    }
    punch.words(7, words);
    Punched punched = open_punched(punch, kElementDeck);
    ASSERT_EQ(punched.model->results().size(), 2U);
    const Result bottom = punched.model->load(0), top = punched.model->load(1);
    EXPECT_EQ(bottom.info.layer, Layer::Bottom);
    EXPECT_EQ(bottom.info.name, "stress");
    EXPECT_EQ(bottom.info.solver_name, "ELEMENT STRESSES");
    EXPECT_EQ(bottom.info.components, (std::vector<std::string>{"von_mises", "major", "minor"}));
    ASSERT_EQ(bottom.row_count(), 4U);
    EXPECT_EQ(bottom.values[0], 30.5F);
    EXPECT_EQ(bottom.values[11], 23.5F);
    EXPECT_EQ(top.values[3], 32.5F);
}

TEST(NastranPunch, solids_and_rods_are_read_by_the_words_of_their_type) {
    Punch punch;
    punch.head("$ELEMENT STRAINS").line("$ELEMENT TYPE =          39  TETRA     VONM");
    std::vector<std::string> words{"   0              ", "GRID              ", "   4              "};
    for (const int grid : {0, 1, 2, 3, 4}) {
        words.push_back(fmt::format("{:>4}{:14}", grid, ""));
        for (int i = 1; i <= 20; ++i) words.push_back(fmt::format("{:18.6E}", 100. * grid + i));
    }
    punch.words(8, words);
    punch.head("$ELEMENT STRESSES").line("$ELEMENT TYPE =           1   (ROD)").row(9, {7, 1, 2, 1}, ' ');
    Punched punched = open_punched(punch, kElementDeck);
    ASSERT_EQ(punched.model->results().size(), 2U);
    const Result strain = punched.model->load(0), axial = punched.model->load(1);
    EXPECT_EQ(strain.info.name, "strain");
    EXPECT_EQ(strain.info.shear, Shear::Engineering);
    ASSERT_EQ(strain.row_count(), 4U);
    EXPECT_EQ(
        std::vector<float>(strain.values.begin() + 7, strain.values.begin() + 14),
        (std::vector<float>{201, 209, 215, 202, 210, 216, 208})
    );
    EXPECT_EQ(axial.info.name, "axial_stress");
    EXPECT_EQ(std::ranges::count(axial.values, 7.F), 1);
}

/// A row of a shell's centre.
std::vector<double> fibres() {
    return {-1, 1, 2, 3, 4, 5, 6, 7, 1, 1, 2, 3, 4, 5, 6, 7};
}

TEST(NastranPunch, strains_of_shells_are_used_where_the_file_says_what_they_are) {
    Punch punch;
    for (const char* words : {"QUAD4     VONM   FIBER", "QUAD4     VONM   CURV", "QUAD4     VONM"})
        punch.head("$ELEMENT STRAINS")
            .line(fmt::format("$ELEMENT TYPE =          33  {}", words))
            .row(7, fibres(), ' ');
    punch.head("$ELEMENT STRESSES").line("$ELEMENT TYPE =          33").row(7, fibres(), ' ');
    Punched punched = open_punched(punch, kElementDeck);
    std::vector<std::string> names;
    for (const ResultInfo& info : punched.model->results())
        names.push_back(info.name + " " + std::string(word(info.layer)) + " " + info.components[0]);
    EXPECT_EQ(
        names,
        (std::vector<std::string>{
            "strain bottom von_mises",
            "strain top von_mises",
            "strain middle von_mises",
            "curvature  von_mises",
            "stress bottom equivalent",
            "stress top equivalent"})
    );
    ASSERT_EQ(punched.diagnostics.count(Code::UnknownBlock), 1U);
}

TEST(NastranPunch, a_row_of_an_element_with_lines_too_few_is_refused) {
    Punch punch;
    punch.head("$ELEMENT STRESSES")
        .line("$ELEMENT TYPE =          33  QUAD4     VONM")
        .row(7, fibres(), ' ')
        .row(7, {1, 2}, ' ');
    Punched punched = open_punched(punch, kElementDeck);
    EXPECT_THROW(punched.model->load(0), Error);
}

TEST(NastranPunch, element_tables_that_are_not_read_are_left_out_with_a_word) {
    Punch punch;
    punch.head("$ELEMENT STRESSES").line("$ELEMENT TYPE =          95  QUAD4LC").row(7, {1, 2, 3, 4}, ' ');
    punch.head("$ELEMENT FORCES").line("$ELEMENT TYPE =          34  BAR").row(7, {1, 2, 3, 4}, ' ');
    punch.line("$EIGENVALUE =  1.0000000E+00  MODE =     1").row(7, {1, 2, 3, 4}, ' ');
    punch.head("$ELEMENT STRESSES", "$REAL-IMAGINARY OUTPUT")
        .line("$ELEMENT TYPE =           1  ROD")
        .row(7, {1, 2, 3}, ' ');
    punch.head("$DISPLACEMENTS").row(1, {1, 2, 3, 4, 5, 6});
    const Punched punched = open_punched(punch);
    EXPECT_EQ(punched.model->results().size(), 2U);
    std::vector<std::string> texts;
    for (const Diagnostic& entry : punched.diagnostics.entries()) {
        if (entry.code == Code::UnknownBlock) texts.push_back(entry.text);
    }
    EXPECT_EQ(
        texts,
        (std::vector<std::string>{
            "ELEMENT STRESSES of composite CQUAD4 (type 95) are not used",
            "ELEMENT FORCES are not used",
            "ELEMENT STRESSES of CROD (type 1), complex, are not used"})
    );
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
    ASSERT_EQ(punched->results().size(), 5U);
    ASSERT_EQ(printed->results().size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const Result a = punched->load(i), b = printed->load(i);
        EXPECT_EQ(a.info.name, b.info.name);
        EXPECT_EQ(a.info.components, b.info.components);
        EXPECT_EQ(a.row_owner, b.row_owner);
        EXPECT_EQ(a.row_node, b.row_node);
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
    // The hoop stress of a thick pipe is largest at its inner face, the radial one is the pressure there.
    const Result stress = to_cylindrical(punched->mesh(), punched->load(4), CylindricalSystem{});
    const auto radial = static_cast<std::size_t>(component_index(stress.info, "radial"));
    const auto hoop = static_cast<std::size_t>(component_index(stress.info, "hoop"));
    ASSERT_EQ(stress.row_count(), 16U);
    for (std::size_t i = 0; i < stress.row_count(); ++i) {
        const bool is_inner = raw(punched->mesh().node_ids[raw(stress.row_node[i])]) % 2 != 0;
        const float* values = &stress.values[i * stress.component_count()];
        EXPECT_NEAR(values[radial], is_inner ? -5 : 0, 1e-4);
        EXPECT_NEAR(values[hoop], is_inner ? 27.72727 : 22.72727, 1e-4);
    }
}

}  // namespace
}  // namespace feelem
