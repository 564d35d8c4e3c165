// SPDX-License-Identifier: Apache-2.0
// Stresses of small .op2 files of our own making.
#include "read_nastran_op2/op2_models.hpp"
#include "support/exercise.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace feelem {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(Op2, stresses_of_solids_stand_at_their_corners) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OES1X1");
    const Op2Ident ident{.table_code = 5, .element_type = 39, .row_words = 109, .stress_bits = 1};
    writer.block(ident, solid_element(0));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_THAT(names_of(*model), ElementsAre("stress"));
    EXPECT_THAT(model->results()[0].components, ElementsAre("xx", "yy", "zz", "xy", "yz", "zx", "von_mises"));
    const Result stress = model->load(0);
    EXPECT_EQ(stress.info.location, Location::ElementNodal);
    ASSERT_EQ(stress.row_count(), 4U);
    EXPECT_EQ(raw(stress.row_node[1]), 1U);
    const auto second = std::vector<float>(stress.values.begin() + 7, stress.values.begin() + 14);
    EXPECT_THAT(second, ElementsAre(21, 22, 23, 24, 25, 26, 27));
}

TEST(Op2, a_tensor_in_another_system_keeps_its_invariant_only) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OES1X1");
    const Op2Ident ident{.table_code = 5, .element_type = 39, .row_words = 109, .stress_bits = 1};
    writer.block(ident, solid_element(12));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    const Result stress = model->load(0);
    EXPECT_TRUE(std::isnan(stress.values[0]));
    EXPECT_EQ(stress.values[6], 17);
    EXPECT_TRUE(diagnostics.has(Code::CoordinateSystem));
}

/// A shell row: number, centre, then grid and two fibres with distance, three stresses, angle, major, minor,
/// von Mises for the centre and each corner.
Op2Words shell_element() {
    Op2Words words{whole(91), std::string("CEN/")};
    for (const std::int64_t node : {3, 1, 2, 3}) {
        words.push_back(whole(node));
        for (const double side : {0.5, -0.5}) {  // The upper fibre first.
            for (const double value : {side, 0., 0., 0., 0., side * 10, side * 20, 40 + side})
                words.emplace_back(value);
        }
    }
    return words;
}

void write_shell(Op2Writer& writer) {
    writer.begin_table("GEOM1S");
    writer.record(joined(
        {{whole(4501), whole(45), whole(1)},
         grid(1, 0, 0, 0),
         grid(2, 1, 0, 0),
         grid(3, 0, 1, 0),
         grid(4, 1, 1, 0)}
    ));
    writer.end_table();
    writer.begin_table("GEOM2S");
    writer.record(
        {whole(4801),
         whole(48),
         whole(327),
         whole(9),
         whole(3),
         whole(1),
         whole(2),
         whole(3),
         whole(0),
         whole(0),
         whole(0),
         0.,
         0.,
         0.,
         0.,
         0.,
         whole(0)}
    );
    writer.record(
        {whole(5959),
         whole(59),
         whole(282),
         whole(10),
         whole(3),
         whole(2),
         whole(4),
         whole(3),
         0.,
         0.,
         whole(0),
         whole(0),
         whole(0),
         0.,
         0.,
         0.}
    );
    writer.record({whole(3001), whole(30), whole(48), whole(11), whole(4), whole(1), whole(4)});
    writer.record({whole(5201), whole(52), whole(11), whole(11), whole(1), whole(2)});
    writer.end_table();
}

TEST(Op2, layers_of_shells_go_by_the_fibres_distance) {
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1X1");
    writer.block({.table_code = 5, .element_type = 75, .row_words = 70, .stress_bits = 1}, shell_element());
    Op2Words centre{whole(101)};
    for (const double side : {-1., 1.}) {
        for (const double value : {side, 0., 0., 0., 0., side * 3, side * 4, 7 + side})
            centre.emplace_back(value);
    }
    writer.block({.table_code = 5, .element_type = 74, .row_words = 17, .stress_bits = 1}, centre);
    writer.block(
        {.table_code = 5, .element_type = 1, .row_words = 5, .stress_bits = 1},
        {whole(111), 77., whole(1), 0., whole(1)}
    );
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_EQ(test::exercise(*model), "");
    EXPECT_EQ(model->mesh().skipped_elements.at("PLOTEL"), 1U);
    ASSERT_THAT(names_of(*model), ElementsAre("stress", "stress", "axial_stress"));
    EXPECT_EQ(model->results()[0].layer, Layer::Bottom);
    const Result bottom = model->load(0);
    // Three corners of the six-node triangle, and the other one's centre at each of its own.
    ASSERT_EQ(bottom.row_count(), 6U);
    for (std::size_t row = 0; row < 6; ++row) {
        const bool is_linear = raw(element_at(model->mesh(), ElementIndex{bottom.row_owner[row]}).id()) == 10;
        EXPECT_EQ(bottom.values[row * 3], is_linear ? 6.F : 39.5F);
        EXPECT_EQ(bottom.values[row * 3 + 1], is_linear ? -3.F : -5.F);
        EXPECT_EQ(bottom.values[row * 3 + 2], is_linear ? -4.F : -10.F);
    }
    EXPECT_EQ(model->load(1).values[0], 40.5F);
    const Result axial = model->load(2);
    EXPECT_EQ(std::ranges::count(axial.values, 77.F), 1);
}

/// Words of one element, with that number or step in front.
Op2Words shell_row(Op2Word first, double base) {
    Op2Words words{std::move(first)};
    for (const double side : {-1., 1.}) {
        for (const double value : {side, 0., 0., 0., 0., base + 3, base + 4, base + side})
            words.emplace_back(value);
    }
    return words;
}

TEST(Op2, blocks_sorted_by_element_give_what_those_sorted_by_step_give) {
    constexpr int kTransient = 6, kSorted = 2000;
    Op2Writer by_step, by_element;
    for (Op2Writer* writer : {&by_step, &by_element}) {
        write_shell(*writer);
        writer->begin_table(writer == &by_step ? "OES1X1" : "OES2");
    }
    Op2Ident ident{
        .approach = kTransient, .table_code = 5, .element_type = 74, .row_words = 17, .stress_bits = 1};
    for (const double time : {0.5, 0.75}) {
        ident.word5 = time;
        by_step.block(ident, joined({shell_row(whole(91), 10 * time), shell_row(whole(101), 100 * time)}));
    }
    ident.table_code += kSorted;
    ident.word5 = whole(91);
    by_element.block(ident, joined({shell_row(0.5, 5), shell_row(0.75, 7.5)}));
    ident.word5 = whole(101);
    // The steps in another order, and one that the first element does not have.
    by_element.block(ident, joined({shell_row(0.75, 75), shell_row(0.5, 50), shell_row(2., 200)}));
    by_step.end_table();
    by_element.end_table();
    Diagnostics diagnostics, of_elements;
    const auto steps = open(by_step.finish(), diagnostics), elements = open(by_element.finish(), of_elements);
    EXPECT_FALSE(of_elements.has(Code::UnknownBlock));
    EXPECT_EQ(test::exercise(*elements), "");
    ASSERT_EQ(steps->results().size(), 4U);
    ASSERT_EQ(elements->results().size(), 6U);
    ASSERT_EQ(elements->steps().size(), 3U);
    for (std::size_t i = 0; i < 4; ++i) {
        const Result a = steps->load(i), b = elements->load(i);
        EXPECT_EQ(a.info.name, b.info.name);
        EXPECT_EQ(a.info.layer, b.info.layer);
        EXPECT_EQ(steps->steps()[a.info.step].value, elements->steps()[b.info.step].value);
        EXPECT_EQ(a.row_owner, b.row_owner);
        ASSERT_EQ(a.values.size(), b.values.size());
        for (std::size_t k = 0; k < a.values.size(); ++k) {
            if (std::isnan(a.values[k]) && std::isnan(b.values[k])) continue;
            EXPECT_EQ(a.values[k], b.values[k]) << i << " " << k;
        }
    }
    const Result last = elements->load(4);
    EXPECT_EQ(std::ranges::count(last.values, 199.F), 1) << "the element with that step";
    EXPECT_EQ(std::ranges::count_if(last.values, [](float value) { return !std::isnan(value); }), 3);
}

TEST(Op2, a_row_of_an_element_that_is_cut_off_is_refused) {
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES2");
    Op2Words words = shell_row(0.5, 1);
    words.emplace_back(0.75);
    writer.block(
        {.approach = 6,
         .table_code = 2005,
         .element_type = 74,
         .word5 = whole(91),
         .row_words = 17,
         .stress_bits = 1},
        words
    );
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_THROW(model->load(0), Error);
}

/// A number a word: 1, 2, 3 ... after the element's number.
Op2Words counting(std::int64_t element, int words) {
    Op2Words out{whole(element * 10 + 1)};
    for (int i = 1; i < words; ++i) out.emplace_back(static_cast<double>(i));
    return out;
}

TEST(Op2, complex_bars_have_an_axial_number_and_four_points_at_both_ends) {
    constexpr int kFrequency = 5, kComplex = 1000, kPolar = 3;
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1X1");
    Op2Ident ident{
        .approach = kFrequency, .table_code = 5 + kComplex, .word5 = 40., .format = kPolar, .stress_bits = 1};
    ident.element_type = 1;
    ident.row_words = 5;
    writer.block(ident, counting(11, 5));
    ident.element_type = 34;
    ident.row_words = 19;
    // Points and the axial number, then their phases; of end B without the axial one.
    writer.block(ident, counting(11, 19));
    ident.element_type = 2;
    ident.row_words = 111;
    Op2Words beam{whole(111)};
    for (int station = 0; station < 11; ++station) {
        beam.push_back(whole(station == 0 ? 1 : station == 10 ? 4 : 0));
        for (int i = 1; i < 10; ++i) beam.emplace_back(100. * station + i);
    }
    writer.block(ident, beam);
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_EQ(test::exercise(*model), "");
    EXPECT_THAT(
        names_of(*model),
        ElementsAre(
            "axial_stress",
            "axial_stress",
            "bar_bending_stress",
            "bar_bending_stress",
            "bar_stress",
            "bar_stress"
        )
    );
    const auto values = [&](std::size_t i) {
        std::vector<float> out;
        for (const float value : model->load(i).values) {
            if (!std::isnan(value)) out.push_back(value);
        }
        return out;
    };
    EXPECT_EQ(model->results()[0].complex, Complex::Amplitude);
    EXPECT_EQ(model->results()[1].complex, Complex::Phase);
    EXPECT_THAT(values(0), ElementsAre(5));  // The same element in both tables: the later one counts.
    EXPECT_THAT(values(1), ElementsAre(10));
    EXPECT_THAT(model->results()[2].components, ElementsAre("c", "d", "e", "f"));
    EXPECT_THAT(values(2), ElementsAre(1, 2, 3, 4, 11, 12, 13, 14));
    EXPECT_THAT(values(3), ElementsAre(6, 7, 8, 9, 15, 16, 17, 18));
    EXPECT_THAT(values(4), ElementsAre(2, 3, 4, 5, 1002, 1003, 1004, 1005));
    EXPECT_THAT(values(5), ElementsAre(6, 7, 8, 9, 1006, 1007, 1008, 1009));
}

TEST(Op2, complex_shells_have_the_stresses_of_their_centre_in_their_own_system) {
    constexpr int kFrequency = 5, kComplex = 1000;
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1X1");
    Op2Ident ident{
        .approach = kFrequency, .table_code = 5 + kComplex, .word5 = 40., .format = 2, .stress_bits = 1};
    ident.element_type = 74;
    ident.row_words = 15;
    Op2Words centre{whole(101)};
    for (const double side : {0.5, -0.5}) {  // The upper fibre first.
        for (const double value : {side, 10 + side, 20 + side, 30 + side, 40 + side, 50 + side, 60 + side})
            centre.emplace_back(value);
    }
    writer.block(ident, centre);
    ident.element_type = 75;
    ident.row_words = 62;
    Op2Words corners{whole(91), std::string("CEN/")};
    for (const std::int64_t point : {0, 1, 2, 3}) {
        corners.push_back(whole(point == 0 ? 3 : point));
        for (const double side : {-0.5, 0.5}) {
            corners.emplace_back(side);
            for (const double value : {1., 2., 3., 4., 5. + side, 6. + side})
                corners.emplace_back(100. * static_cast<double>(point) + value);
        }
    }
    writer.block(ident, corners);
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_EQ(model->results().size(), 4U);
    EXPECT_THAT(model->results()[0].components, ElementsAre("normal_x", "normal_y", "shear_xy"));
    EXPECT_EQ(model->results()[0].location, Location::Elemental);
    const auto values = [&](std::size_t i, int element) {
        const Result result = model->load(i);
        for (std::uint32_t e = 0; e < model->mesh().element_count(); ++e) {
            if (raw(element_at(model->mesh(), ElementIndex{e}).id()) == element)
                return std::vector<float>(result.values.begin() + 3 * e, result.values.begin() + 3 * e + 3);
        }
        return std::vector<float>{};
    };
    const auto kind = [&](std::size_t i) {
        return std::pair(model->results()[i].layer, model->results()[i].complex);
    };
    EXPECT_EQ(kind(0), (std::pair{Layer::Bottom, Complex::Real}));
    EXPECT_EQ(kind(1), (std::pair{Layer::Bottom, Complex::Imaginary}));
    EXPECT_EQ(kind(2), (std::pair{Layer::Top, Complex::Real}));
    EXPECT_THAT(values(0, 10), ElementsAre(9.5, 29.5, 49.5));
    EXPECT_THAT(values(1, 10), ElementsAre(19.5, 39.5, 59.5));
    EXPECT_THAT(values(2, 10), ElementsAre(10.5, 30.5, 50.5));
    EXPECT_THAT(values(0, 9), ElementsAre(1, 3, 4.5));
    EXPECT_THAT(values(3, 9), ElementsAre(2, 4, 6.5));
}

TEST(Op2, tables_of_optistruct_say_by_their_name_that_they_are_strains) {
    Op2Writer writer;
    writer.head("OS2022.2");
    write_shell(writer);
    for (const char* table : {"OES1X", "OSTR1X"}) {
        writer.begin_table(table);
        writer.block({.table_code = 5, .element_type = 74, .row_words = 17}, shell_row(whole(101), 10));
        writer.end_table();
    }
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_THAT(names_of(*model), ElementsAre("stress", "stress", "strain", "strain"));
    for (const ResultInfo& info : model->results()) EXPECT_EQ(info.components[0], "von_mises");
}

TEST(Op2, plies_are_a_result_each) {
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1C");
    const auto ply_row = [](std::int64_t element, std::int64_t ply) {
        Op2Words words{whole(element * 10 + 1), whole(ply)};
        for (int i = 1; i <= 9; ++i) words.emplace_back(100. * static_cast<double>(ply) + i);
        return words;
    };
    for (const int subcase : {1, 2}) {
        writer.block(
            {.table_code = 5, .element_type = 97, .subcase = subcase, .row_words = 11, .stress_bits = 5},
            joined({ply_row(10, 1), ply_row(10, 3), ply_row(9, 3)})
        );
    }
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_EQ(test::exercise(*model), "");
    EXPECT_THAT(
        names_of(*model), ElementsAre("ply_stress_1", "ply_stress_3", "ply_stress_1", "ply_stress_3")
    );
    EXPECT_THAT(
        model->results()[0].components,
        ElementsAre("normal_1", "normal_2", "shear_12", "shear_1z", "shear_2z", "von_mises", "major", "minor")
    );
    EXPECT_EQ(model->results()[0].location, Location::Elemental);
    const Result third = model->load(3);
    for (std::uint32_t e = 0; e < model->mesh().element_count(); ++e) {
        const auto id = raw(element_at(model->mesh(), ElementIndex{e}).id());
        const std::vector<float> row(third.values.begin() + 8 * e, third.values.begin() + 8 * e + 8);
        if (id == 9 || id == 10) {
            EXPECT_THAT(row, ElementsAre(301, 302, 303, 304, 305, 309, 307, 308));
        } else {
            EXPECT_TRUE(std::isnan(row[0]));
        }
    }
    const Result first = model->load(0);
    EXPECT_EQ(std::ranges::count_if(first.values, [](float v) { return !std::isnan(v); }), 8);
}

TEST(Op2, hostile_plies_are_bounded) {
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1C");
    Op2Words words;
    for (std::int64_t ply = -5; ply < 3000; ++ply) {
        words.push_back(whole(101));
        words.push_back(whole(ply));
        for (int i = 0; i < 9; ++i) words.emplace_back(1.);
    }
    writer.block({.table_code = 5, .element_type = 97, .row_words = 11}, words);
    writer.end_table();
    Diagnostics diagnostics;
    EXPECT_EQ(open(writer.finish(), diagnostics)->results().size(), 1000U);
}

TEST(Op2, what_is_not_used_is_named_once_a_kind_with_its_elements) {
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1C");
    for (const int subcase : {1, 2, 3}) {
        for (const int type : {97, 95}) {
            writer.block(
                {.table_code = 5, .element_type = type, .subcase = subcase, .row_words = 12}, {whole(101), 1.}
            );
        }
    }
    writer.end_table();
    writer.begin_table("OEF1X");
    writer.block({.table_code = 1004, .element_type = 34, .row_words = 17}, {whole(101), 1.});
    writer.block({.table_code = 4, .element_type = 777, .row_words = 17}, {whole(101), 1.});
    writer.end_table();
    writer.begin_table("OGPFB1");
    writer.block({.table_code = 19, .element_type = 0, .row_words = 10}, {whole(101), 1.});
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    std::vector<std::string> texts;
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.code == Code::UnknownBlock)
            texts.push_back(entry.text + " x" + std::to_string(entry.count));
    }
    EXPECT_THAT(
        texts,
        ElementsAre(
            "OEF1X: forces of elements are not used: elements of type 777 x1",
            "OEF1X: forces of elements, complex, are not used: CBAR (type 34) x1",
            "OES1C: stresses of elements are not used: composite CQUAD4 (type 95), composite CTRIA3 (type "
            "97) x6",
            "OGPFB1: balances of forces at grid points are not used x1"
        )
    );
}

}  // namespace
}  // namespace feelem
