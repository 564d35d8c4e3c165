// SPDX-License-Identifier: Apache-2.0
// The .frd format, rule by rule.
#include "base/number.hpp"
#include "read/calculix/frd_fields.hpp"
#include "read/frd_text.hpp"
#include "support/memory.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace feelem {
namespace {

using test::FrdText;
using testing::ElementsAre;
using testing::HasSubstr;

struct Opened {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;

    Result load(std::string_view name, std::uint32_t nth = 0) const {
        const auto infos = model->results();
        for (std::size_t i = 0; i < infos.size(); ++i) {
            if (infos[i].name == name && nth-- == 0) return model->load(i);
        }
        ADD_FAILURE() << "no result " << name;
        return {};
    }
};

std::unique_ptr<Opened> open_text(const std::string& text) {
    auto opened = std::make_unique<Opened>();
    opened->model = open_model(std::vector<NamedBytes>{{"model.frd", text}}, {}, opened->diagnostics);
    return opened;
}

std::unique_ptr<Opened> open_shipped(const std::string& name) {
    auto opened = std::make_unique<Opened>();
    const std::vector<std::string> paths{test::project_file("tests/data/calculix/" + name)};
    opened->model = open_model(paths, {}, opened->diagnostics);
    return opened;
}

FrdText temperatures() {
    FrdText file;
    file.result("NDTEMP", {test::scalar("T")}, 4);
    for (int id = 1; id <= 4; ++id) file.record(id, {10.0 * id});
    return file.end_block();
}

TEST(FrdFields, a_million_numbers_are_rounded_as_the_general_parser_rounds_them) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> mantissa(0, 999999);
    std::uniform_int_distribution<int> exponent(-40, 40);
    std::size_t fast = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const int digits = mantissa(random);
        const std::string text = fmt::format(
            "{}{}.{:05}E{:+03}",
            digits % 2 == 0 ? '-' : ' ',
            digits / 100000,
            digits % 100000,
            exponent(random)
        );
        float single = 0;
        double twice = 0;
        if (frd::fast_real12(text.data(), single)) {
            ++fast;
            ASSERT_EQ(std::bit_cast<std::uint32_t>(single), std::bit_cast<std::uint32_t>(*parse_float(text)))
                << text;
        }
        if (frd::fast_real12(text.data(), twice)) {
            ASSERT_EQ(std::bit_cast<std::uint64_t>(twice), std::bit_cast<std::uint64_t>(*parse_double(text)))
                << text;
        }
    }
    EXPECT_GT(fast, 500'000U);
}

TEST(FrdFields, whatever_is_not_plain_is_left_to_the_general_parser) {
    float value = 0;
    EXPECT_TRUE(frd::fast_real12(" 1.00000E+10", value));
    EXPECT_EQ(value, 1e10F);
    for (const char* other : {"         NaN", " 1.0000E+010", "-1.00000E-40", "+1.00000E+00", " 1,00000E+00"})
        EXPECT_FALSE(frd::fast_real12(other, value)) << other;
}

TEST(FrdFields, integers_are_blanks_then_digits_and_nothing_else) {
    std::int64_t value = 0;
    EXPECT_TRUE(fast_integer("         7", 10, value));
    EXPECT_EQ(value, 7);
    EXPECT_TRUE(fast_integer("  12345678", 10, value));
    EXPECT_EQ(value, 12345678);
    EXPECT_TRUE(fast_integer("1234567890", 10, value));
    EXPECT_EQ(value, 1234567890);
    EXPECT_TRUE(fast_integer("00042", 5, value));
    EXPECT_EQ(value, 42);
    for (const char* bad :
         {"          ",
          "       1 2",
          "      1 23",
          "        -7",
          "       7.0",
          "  1234567 ",
          "  pppppppp",
          "    0000 0"}) {
        EXPECT_FALSE(fast_integer(bad, 10, value)) << bad;
    }
}

TEST(Frd, midside_nodes_of_brick_and_wedge_stand_between_their_corners) {
    const auto opened = open_shipped("static.frd");
    const Mesh& mesh = opened->model->mesh();
    std::size_t edges = 0;
    for (const ElementBlock& block : mesh.blocks) {
        for (const EdgeRow& edge : edges_of(block.type)) {
            const auto at = [&](std::uint8_t local) { return mesh.coordinates[raw(block.nodes[local])]; };
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(at(edge.middle)[i], (at(edge.first)[i] + at(edge.second)[i]) / 2);
            ++edges;
        }
    }
    EXPECT_EQ(edges, 12U + 9U);
}

TEST(Frd, materials_are_parts) {
    const auto opened = open_shipped("static.frd");
    const Mesh& mesh = opened->model->mesh();
    ASSERT_EQ(mesh.parts.size(), 2U);
    EXPECT_EQ(mesh.parts[0].name, "material 1");
    EXPECT_EQ(mesh.parts[1].name, "material 2");
    EXPECT_EQ(mesh.blocks[1].type, ElementType::Wedge15);
    EXPECT_EQ(mesh.blocks[1].parts[0], PartIndex{1});
}

TEST(Frd, says_title_solver_and_version) {
    const auto opened = open_shipped("static.frd");
    EXPECT_EQ(opened->model->title(), "Brick and wedge: static");
    EXPECT_EQ(opened->model->solver().name, "CalculiX");
    EXPECT_EQ(opened->model->solver().version, "2.20");
}

TEST(Frd, results_have_common_names_components_and_averaging) {
    const auto opened = open_shipped("static.frd");
    const auto infos = opened->model->results();
    ASSERT_EQ(infos.size(), 6U);
    EXPECT_EQ(infos[0].name, "displacement");
    EXPECT_EQ(infos[0].solver_name, "DISP");
    EXPECT_THAT(infos[0].components, ElementsAre("x", "y", "z"));
    EXPECT_EQ(infos[0].averaging, Averaging::NotApplicable);
    EXPECT_EQ(infos[1].name, "stress");
    EXPECT_EQ(infos[1].shape, Shape::SymmetricTensor);
    EXPECT_THAT(infos[1].components, ElementsAre("xx", "yy", "zz", "xy", "yz", "zx"));
    EXPECT_EQ(infos[1].averaging, Averaging::Solver);
    EXPECT_EQ(infos[2].name, "strain");
    EXPECT_EQ(infos[2].shear, Shear::Tensor);
    EXPECT_EQ(infos[3].name, "reaction_force");
    EXPECT_EQ(infos[4].name, "ener");
    EXPECT_THAT(infos[4].components, ElementsAre("value"));
}

TEST(Frd, binary_holds_what_text_holds) {
    const auto text = open_shipped("static.frd");
    const auto binary = open_shipped("static_binary.frd");
    EXPECT_EQ(text->model->mesh().node_ids, binary->model->mesh().node_ids);
    EXPECT_EQ(text->model->mesh().blocks[0].nodes, binary->model->mesh().blocks[0].nodes);
    EXPECT_EQ(text->model->mesh().blocks[1].nodes, binary->model->mesh().blocks[1].nodes);
    ASSERT_EQ(text->model->results().size(), binary->model->results().size());
    for (std::size_t i = 0; i < text->model->results().size(); ++i) {
        const Result a = text->model->load(i);
        const Result b = binary->model->load(i);
        ASSERT_EQ(a.values.size(), b.values.size());
        for (std::size_t v = 0; v < a.values.size(); ++v)
            ASSERT_NEAR(a.values[v], b.values[v], 6e-6 * std::abs(b.values[v])) << a.info.name;
    }
}

TEST(Frd, either_byte_order_is_read) {
    for (const bool swapped : {false, true}) {
        const auto opened = open_text(test::binary_frd(swapped));
        EXPECT_EQ(opened->model->mesh().coordinates[3], (Point3{0, 0, 1}));
        EXPECT_EQ(opened->model->mesh().parts[0].name, "material 7");
        EXPECT_THAT(opened->load("temperature").values, ElementsAre(10, 20, 30, 40));
    }
}

TEST(Frd, a_further_block_does_not_change_the_byte_order_of_those_before_it) {
    std::string bytes = test::binary_frd(false);
    const std::size_t head = bytes.find("    2C");
    std::string nodes = bytes.substr(head, bytes.find("    3C") - head);
    const auto first_id = nodes.begin() + static_cast<std::ptrdiff_t>(nodes.find('\n') + 1);
    std::reverse(first_id, first_id + 4);
    bytes.insert(bytes.find(" 9999"), nodes);
    const auto opened = open_text(bytes);
    EXPECT_EQ(opened->model->mesh().coordinates[3], (Point3{0, 0, 1}));
    EXPECT_THAT(opened->load("temperature").values, ElementsAre(10, 20, 30, 40));
}

TEST(Frd, load_factors_are_buckling_steps) {
    const auto opened = open_shipped("buckling.frd");
    const auto steps = opened->model->steps();
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[1].kind, StepKind::Buckling);
    EXPECT_EQ(steps[1].step, 2);
    EXPECT_DOUBLE_EQ(steps[1].value, 68.08753983);
}

TEST(Frd, modes_then_a_harmonic_response_with_its_complex_parts) {
    const auto opened = open_shipped("harmonic.frd");
    const auto steps = opened->model->steps();
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps[0].kind, StepKind::Mode);
    EXPECT_EQ(steps[1].label, "mode 2");
    EXPECT_EQ(steps[2].kind, StepKind::Frequency);
    EXPECT_EQ(steps[2].value, 1000);
    EXPECT_EQ(steps[2].label, "step 2, increment 0");
    const auto infos = opened->model->results();
    std::vector<std::string> found;
    for (const ResultInfo& info : infos) {
        if (info.step == 2) found.push_back(info.name + " " + std::string(word(info.complex)));
    }
    EXPECT_THAT(
        found,
        ElementsAre(
            "displacement real",
            "stress real",
            "error real",
            "displacement imaginary",
            "stress imaginary",
            "error imaginary",
            "displacement amplitude",
            "displacement phase"
        )
    );
    EXPECT_EQ(infos[0].complex, Complex::No);
}

TEST(Frd, amplitude_and_phase_belong_to_real_and_imaginary) {
    const auto opened = open_shipped("harmonic.frd");
    const Result real = opened->load("displacement", 2), imaginary = opened->load("displacement", 3);
    const Result amplitude = opened->load("displacement", 4), phase = opened->load("displacement", 5);
    const double degrees = 180 / std::acos(-1.0);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < real.values.size(); ++i) {
        const double length = std::hypot(double(real.values[i]), double(imaginary.values[i]));
        EXPECT_NEAR(amplitude.values[i], length, 1e-5 * length);
        if (length < 1e-12) continue;
        const double angle = std::atan2(double(imaginary.values[i]), double(real.values[i])) * degrees;
        EXPECT_NEAR(std::remainder(phase.values[i] - angle, 360.0), 0, 1e-2);
        ++checked;
    }
    EXPECT_GT(checked, 30U);
}

TEST(Frd, nodes_without_a_value_are_missing_not_zero) {
    const auto opened = open_shipped("harmonic.frd");
    const Result mode = opened->load("displacement");
    std::size_t missing = 0;
    for (std::size_t row = 0; row < mode.row_count(); ++row)
        missing += std::isnan(mode.values[row * 3]) ? 1U : 0U;
    EXPECT_EQ(mode.row_count(), 30U);
    EXPECT_EQ(missing, 27U);
    EXPECT_EQ(opened->diagnostics.count(Code::ResultForPartOfModel), 2U);
}

TEST(Frd, columns_that_touch_are_cut_by_position) {
    FrdText file;
    file.result("DISP", test::vector_with_all("D"), 4);
    for (int id = 1; id <= 4; ++id) file.record(id, {-1.5, -2.25, -1e-7});
    const auto opened = open_text(file.end_block().text());
    const Result result = opened->load("displacement");
    EXPECT_EQ(result.component_count(), 3U);
    EXPECT_EQ(result.values[4], -2.25F);
    EXPECT_EQ(result.values[11], -1e-7F);
}

TEST(Frd, components_beyond_six_stand_on_further_lines) {
    FrdText file;
    std::vector<std::string> components;
    for (int i = 1; i <= 8; ++i) components.push_back(test::scalar("SDV" + std::to_string(i)));
    file.result("SDV", components, 2);
    for (const int id : {2, 4}) {
        file.record(id, {1, 2, 3, 4, 5, 6.5});
        file.line(fmt::format(" -2          {:12.5E}{:12.5E}", 7.0, 10.0 * id));
    }
    const auto opened = open_text(file.end_block().text());
    const Result result = opened->load("sdv");
    EXPECT_EQ(result.info.components.back(), "sdv8");
    EXPECT_EQ(result.info.shape, Shape::Other);
    EXPECT_EQ(result.values[8 + 5], 6.5F);
    EXPECT_EQ(result.values[8 + 6], 7);
    EXPECT_EQ(result.values[24 + 7], 40);
    EXPECT_TRUE(std::isnan(result.values[0]));
}

TEST(Frd, a_block_of_no_nodes_is_noted_and_the_next_one_read) {
    FrdText file;
    file.result("ENER", {test::scalar("ENER")}, 0).end_block();
    file.result("NDTEMP", {test::scalar("T")}, 1).record(3, {5}).end_block();
    const auto opened = open_text(file.text());
    EXPECT_EQ(opened->diagnostics.count(Code::EmptyResult), 1U);
    ASSERT_EQ(opened->model->results().size(), 1U);
    EXPECT_EQ(opened->load("temperature").values[2], 5);
}

TEST(Frd, equal_frequencies_are_two_steps) {
    FrdText file;
    for (const int step : {1, 2}) {
        file.line(fmt::format("    1PMODE{:14}{:12}", "", step));
        file.result("DISP", test::vector_with_all("D"), 1, step, 76.66, 2)
            .record(1, {1.0 * step, 0, 0})
            .end_block();
    }
    const auto opened = open_text(file.text());
    const auto steps = opened->model->steps();
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[0].value, steps[1].value);
    EXPECT_EQ(steps[1].label, "mode 2");
    EXPECT_EQ(opened->load("displacement", 1).values[0], 2);
}

TEST(Frd, lines_that_end_in_cr_lf_make_no_difference) {
    std::string text = temperatures().text();
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
        text.insert(at, "\r");
    const auto opened = open_text(text);
    EXPECT_THAT(opened->load("temperature").values, ElementsAre(10, 20, 30, 40));
    EXPECT_TRUE(opened->diagnostics.entries().empty());
}

TEST(Frd, not_a_number_is_missing_and_counted_once) {
    FrdText file;
    file.result("DISP", test::vector_with_all("D"), 2);
    file.line(" -1         1         NaN 1.00000E+00         Inf").record(2, {4, 5, 6}).end_block();
    const auto opened = open_text(file.text());
    const Result result = opened->load("displacement");
    opened->load("displacement");
    EXPECT_TRUE(std::isnan(result.values[0]));
    EXPECT_TRUE(std::isnan(result.values[2]));
    EXPECT_EQ(result.values[1], 1);
    EXPECT_EQ(result.values[5], 6);
    EXPECT_EQ(opened->diagnostics.count(Code::NonFiniteValue), 2U);
}

TEST(Frd, exponents_of_three_digits_push_columns_along_and_are_still_read) {
    FrdText file;
    file.result("DISP", test::vector_with_all("D"), 2);
    file.line(" -1         1-1.00000E-100 2.00000E+00-3.00000E+00").record(2, {4, 5, 6}).end_block();
    const Result result = open_text(file.text())->load("displacement");
    EXPECT_EQ(result.values[1], 2);
    EXPECT_EQ(result.values[2], -3);
    EXPECT_EQ(result.values[3], 4);
}

TEST(Frd, values_at_unknown_nodes_are_counted) {
    FrdText file;
    file.result("NDTEMP", {test::scalar("T")}, 5);
    for (int id = 1; id <= 5; ++id) file.record(id, {10.0 * id});
    const auto opened = open_text(file.end_block().text());
    EXPECT_THAT(opened->load("temperature").values, ElementsAre(10, 20, 30, 40));
    EXPECT_EQ(opened->diagnostics.count(Code::ResultWithoutNode), 1U);
}

TEST(Frd, a_file_cut_in_its_last_block_keeps_what_came_before) {
    const std::string whole = temperatures()
                                  .result("FLUX", test::vector_with_all("F"), 4, 2)
                                  .record(1, {1, 2, 3})
                                  .record(2, {1, 2, 3})
                                  .text();
    const auto opened = open_text(whole.substr(0, whole.size() - 20));
    EXPECT_TRUE(opened->diagnostics.has(Code::TruncatedInput));
    ASSERT_EQ(opened->model->results().size(), 1U);
    EXPECT_THAT(opened->load("temperature").values, ElementsAre(10, 20, 30, 40));
}

TEST(Frd, a_damaged_record_is_an_error_with_its_line) {
    std::string text = temperatures().text();
    text.replace(text.find("3.00000E+01"), 11, "3.0oo00E+01");
    const auto opened = open_text(text);
    try {
        opened->model->load(0);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadNumber);
        EXPECT_EQ(error.where(), "model.frd:20");
        EXPECT_THAT(error.what(), HasSubstr("3.0oo00E+01"));
    }
}

TEST(Frd, a_file_cut_within_its_mesh_is_an_error) {
    const std::string text = temperatures().text();
    try {
        open_text(text.substr(0, text.find(" -1         3")));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::Truncated);
    }
}

TEST(Frd, an_element_type_beyond_twelve_is_left_out_and_counted) {
    std::string text = temperatures().text();
    text.replace(text.find(" -1         1    3"), 18, " -1         1   13");
    const auto opened = open_text(text);
    EXPECT_EQ(opened->model->mesh().skipped_elements.at("type 13"), 1U);
    EXPECT_EQ(opened->diagnostics.count(Code::UnknownElementType), 1U);
}

/// A column of nodes whose temperature is their number: long enough for several threads.
std::string long_file(bool shuffled) {
    constexpr int kNodes = 70'000;
    FrdText file;
    for (int id = 1; id <= kNodes; ++id) file.node(id, id, 0, 0);
    file.result("NDTEMP", {test::scalar("T")}, kNodes);
    for (int i = 1; i <= kNodes; ++i) {
        // The first record and one far behind change places.
        const int id = !shuffled ? i : i == 1 ? kNodes - 9 : i == kNodes - 9 ? 1 : i;
        file.record(id, {static_cast<double>(id)});
    }
    return file.end_block().text();
}

TEST(Frd, records_in_any_order_go_to_their_nodes) {
    for (const bool shuffled : {false, true}) {
        const auto opened = open_text(long_file(shuffled));
        const Result result = opened->load("temperature");
        for (std::size_t row = 0; row < result.row_count(); ++row)
            ASSERT_EQ(result.values[row], static_cast<float>(row + 1)) << "shuffled: " << shuffled;
    }
}

TEST(Frd, a_large_file_is_let_go_behind_the_reader) {
    if (test::kSanitized) GTEST_SKIP() << "sanitizers hold memory of their own";
    constexpr int kNodes = 300'000;
    std::size_t file_bytes = 0;
    const std::string path = test::scratch_folder("frd_memory") + "/large.frd";
    {
        FrdText file;
        for (int id = 1; id <= kNodes; ++id) file.node(id, id, 0, 0);
        file.result("SDV", std::vector<std::string>(6, test::scalar("S")), kNodes);
        for (int id = 1; id <= kNodes; ++id) file.record(id, {1, 2, 3, 4, 5, 6});
        const std::string text = file.end_block().text();
        file_bytes = text.size();
        test::write_file(path, text);
    }
    malloc_trim(0);
    test::reset_peak_memory();
    const std::uint64_t before = test::peak_memory();

    Diagnostics diagnostics;
    const auto model = open_model(std::vector<std::string>{path}, {}, diagnostics);
    const Result result = model->load(0);

    const std::uint64_t used = test::peak_memory() - before;
    const std::uint64_t held = kNodes * (sizeof(NodeId) + sizeof(Point3) + 6 * sizeof(float));
    EXPECT_EQ(result.values.back(), 6);
    EXPECT_GT(file_bytes, 2 * held);
    EXPECT_LT(used, held + (16u << 20));
}

TEST(Frd, shell_surfaces_are_layers_of_one_stress) {
    FrdText file;
    std::vector<std::string> tensor;
    int i = 1, j = 1;
    for (const char* name : {"SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"})
        tensor.push_back(fmt::format("{:8}{:5}{:5}{:5}{:5}", name, 1, 4, i, j));
    for (const char* name : {"STRNEG", "STRMID", "STRPOS"})
        file.result(name, tensor, 1).record(1, {1, 2, 3, 4, 5, 6}).end_block();
    const auto opened = open_text(file.text());
    const auto infos = opened->model->results();
    ASSERT_EQ(infos.size(), 3U);
    EXPECT_EQ(infos[0].name, "stress");
    EXPECT_EQ(infos[0].layer, Layer::Bottom);
    EXPECT_EQ(infos[1].layer, Layer::Middle);
    EXPECT_EQ(infos[2].layer, Layer::Top);
    EXPECT_EQ(infos[2].name, "stress");
}

TEST(Frd, a_second_result_of_one_name_keeps_the_solvers_name) {
    FrdText file;
    for (const char* name : {"TOSTRAIN", "MESTRAIN", "MESTRAIN"})
        file.result(name, {test::scalar("E")}, 1).record(1, {1}).end_block();
    const auto opened = open_text(file.text());
    const auto infos = opened->model->results();
    EXPECT_EQ(infos[0].name, "strain");
    EXPECT_EQ(infos[1].name, "mestrain");
    EXPECT_EQ(infos[2].name, "strain_2");
}

}  // namespace
}  // namespace feelem
