// SPDX-License-Identifier: Apache-2.0
// Stresses and strains out of real result files against what MAPDL and Mechanical printed from the same ones.
#include "read_ansys_rst/opened_rst.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace feelem {
namespace {

using test::load_wanted;
using test::OpenedRst;

struct PrintedRow {
    std::int64_t id = 0;
    std::vector<double> numbers;
};

/// Rows that begin with a whole number.
std::vector<PrintedRow> printed_rows_of(const std::string& path) {
    std::istringstream text(test::read_file(path));
    std::vector<PrintedRow> rows;
    for (std::string line; std::getline(text, line);) {
        std::istringstream fields(line);
        PrintedRow row;
        if (!(fields >> row.id)) continue;
        for (double number = 0; fields >> number;) row.numbers.push_back(number);
        rows.push_back(row);
    }
    EXPECT_GT(rows.size(), 0u) << path;
    return rows;
}

std::vector<PrintedRow> printed_rows(const std::string& path) {
    return printed_rows_of(*test::corpus_file("ansys/" + path));
}

/// Half of the last of `digits` digits.
double print_precision(double printed, int digits) {
    return printed == 0 ? 0 : 0.501 * std::pow(10.0, std::floor(std::log10(std::abs(printed))) - digits + 1);
}

/// Values by node of a component, averaged within the part of that name.
std::map<std::int64_t, double> by_node(
    const OpenedRst& opened, const Result& averaged, std::string_view part, std::string_view component
) {
    const Mesh& mesh = opened.model->mesh();
    const Result values = component_of(averaged, component);
    std::map<std::int64_t, double> out;
    for (std::size_t row = 0; row < values.row_count(); ++row) {
        if (mesh.parts[values.row_owner[row]].name != part) continue;
        out[raw(mesh.node_ids[raw(values.row_node[row])])] = static_cast<double>(values.values[row]);
    }
    return out;
}

// The shipped file: without the corpus, too.
TEST(RstShipped, stresses_of_a_body_equal_mechanicals_to_the_last_printed_digit) {
    const std::string folder = test::project_file("tests/data/ansys/two_cubes/");
    const OpenedRst opened = test::open_bytes(test::read_file(folder + "file.rst"));
    EXPECT_EQ(opened.model->mesh().node_count(), 45u);
    const Result stress = average(opened.model->mesh(), load_wanted(opened, {"stress"}), Averaging::Part);
    const auto ours = by_node(opened, stress, "material 1", "xx");
    const auto rows = printed_rows_of(folder + "stress_mat_1.txt");
    EXPECT_EQ(rows.size(), ours.size());
    for (const PrintedRow& row : rows) {
        const double printed = row.numbers.back();
        EXPECT_NEAR(ours.at(row.id), printed, print_precision(printed, 5) + 2e-6) << row.id;
    }
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_FLOAT_EQ(test::value_at(opened, u, 44, "x"), 0.004870886F);
}

class RstExports : public testing::Test {
protected:
    void SetUp() override {
        if (!test::corpus_file("ansys/answers.json")) GTEST_SKIP() << "the corpus is not here";
    }

    static Result averaged(const OpenedRst& opened, const test::Wanted& wanted) {
        const Result result = load_wanted(opened, wanted);
        EXPECT_EQ(result.info.location, Location::ElementNodal);
        return average(opened.model->mesh(), result, Averaging::Part);
    }

    /// A table of one part: every row has our value, and we have a value at no other node.
    static void expect_part(
        const OpenedRst& opened, const test::Wanted& wanted, std::string_view part, const std::string& path
    ) {
        SCOPED_TRACE(path);
        const auto ours = by_node(opened, averaged(opened, wanted), part, "xx");
        const auto rows = printed_rows(path);
        EXPECT_EQ(rows.size(), ours.size());
        for (const PrintedRow& row : rows) {
            ASSERT_EQ(ours.count(row.id), 1u) << row.id;
            const double printed = row.numbers.back();
            EXPECT_NEAR(ours.at(row.id), printed, print_precision(printed, 5) + 2e-7 * 10) << row.id;
        }
    }

    /// A table of several parts: a node stands once a part, in any order of the parts.
    static void expect_combined(
        const OpenedRst& opened, const test::Wanted& wanted, const std::string& path
    ) {
        SCOPED_TRACE(path);
        const Result values = averaged(opened, wanted);
        std::multimap<std::int64_t, double> ours;
        for (const char* part : {"material 1", "material 2"}) {
            for (const auto& [node, value] : by_node(opened, values, part, "xx")) ours.emplace(node, value);
        }
        const auto rows = printed_rows(path);
        EXPECT_EQ(rows.size(), ours.size());
        for (const PrintedRow& row : rows) {
            const double printed = row.numbers.back();
            auto [it, last] = ours.equal_range(row.id);
            while (it != last && std::abs(it->second - printed) > print_precision(printed, 5) + 2e-6) ++it;
            ASSERT_NE(it, last) << row.id << " " << printed;
            ours.erase(it);
        }
        EXPECT_TRUE(ours.empty());
    }
};

// PRNSOL,S with ten digits: the corner nodes alone.
TEST_F(RstExports, averaged_stresses_equal_prnsol_to_seven_digits) {
    const OpenedRst opened = test::open_corpus({"rst/hexbeam_v150/file.rst"});
    const Result stress = averaged(opened, {"stress"});
    EXPECT_TRUE(stress.info.corner_only);
    const auto rows = printed_rows("rst/hexbeam_v150/prnsol_s.txt");
    EXPECT_EQ(rows.size(), 99u);
    constexpr std::array kComponents{"xx", "yy", "zz", "xy", "yz", "zx"};
    for (std::size_t c = 0; c < kComponents.size(); ++c) {
        const auto ours = by_node(opened, stress, "material 1", kComponents[c]);
        EXPECT_EQ(ours.size(), rows.size());
        // Stresses reach 6e6; the sums are of single-precision numbers.
        for (const PrintedRow& row : rows)
            EXPECT_NEAR(ours.at(row.id), row.numbers[c], 1e-7 * std::abs(row.numbers[c]) + 1e-3)
                << row.id << kComponents[c];
    }
}

TEST_F(RstExports, invariants_of_averaged_stresses_equal_prnsol) {
    const OpenedRst opened = test::open_corpus({"rst/hexbeam_v150/file.rst"});
    const Result stress = averaged(opened, {"stress"});
    const auto rows = printed_rows("rst/hexbeam_v150/prnsol_s_prin.txt");
    constexpr std::array kComponents{"principal_1", "principal_2", "principal_3", "tresca", "von_mises"};
    for (std::size_t c = 0; c < kComponents.size(); ++c) {
        const auto ours = by_node(opened, stress, "material 1", kComponents[c]);
        for (const PrintedRow& row : rows)
            EXPECT_NEAR(ours.at(row.id), row.numbers[c], 1e-6 * std::abs(row.numbers[c]) + 0.5)
                << row.id << kComponents[c];
    }
}

TEST_F(RstExports, displacements_equal_prnsol) {
    const OpenedRst opened = test::open_corpus({"rst/hexbeam_v150/file.rst"});
    const Result u = load_wanted(opened, {"displacement"});
    constexpr std::array kComponents{"x", "y", "z"};
    for (const PrintedRow& row : printed_rows("rst/hexbeam_v150/prnsol_u.txt")) {
        for (std::size_t c = 0; c < kComponents.size(); ++c) {
            const auto ours = static_cast<double>(test::value_at(opened, u, row.id, kComponents[c]));
            EXPECT_NEAR(ours, row.numbers[c], 1e-7 * std::abs(row.numbers[c]) + 1e-7) << row.id;
        }
    }
}

TEST_F(RstExports, stresses_and_strains_of_each_body_equal_mechanicals) {
    const std::string folder = "workbench/two_cubes/";
    const OpenedRst opened = test::open_corpus({folder + "file.rst"});
    expect_part(opened, {"stress"}, "material 1", folder + "stress_mat_1.txt");
    expect_part(opened, {"stress"}, "material 2", folder + "stress_mat_2.txt");
    expect_combined(opened, {"stress"}, folder + "stress_combined.txt");
    EXPECT_EQ(load_wanted(opened, {"stress"}).info.unit, "MPa");
    EXPECT_EQ(load_wanted(opened, {"elastic_strain"}).info.shear, Shear::Engineering);
    const Result strain = averaged(opened, {"elastic_strain"});
    for (const char* part : {"1", "2"}) {
        const auto ours = by_node(opened, strain, std::string("material ") + part, "xx");
        const auto rows = printed_rows(folder + "elastic_strain_mat_" + part + ".txt");
        EXPECT_EQ(rows.size(), ours.size());
        for (const PrintedRow& row : rows) {
            const double printed = row.numbers.back();
            EXPECT_NEAR(ours.at(row.id), printed, print_precision(printed, 5) + 2e-12) << row.id;
        }
    }
}

TEST_F(RstExports, top_and_bottom_of_shells_equal_mechanicals) {
    const std::string folder = "workbench/extract_shell_layer/";
    const OpenedRst opened = test::open_corpus({folder + "mixed_shell_solid.rst"});
    const test::Wanted top{"stress", 0, Complex::No, Layer::Top};
    const test::Wanted bottom{"stress", 0, Complex::No, Layer::Bottom};
    expect_part(opened, top, "material 2", folder + "stress_top_nodal_mat_2.txt");
    expect_part(opened, bottom, "material 2", folder + "stress_bot_nodal_mat_2.txt");
    // Solids stand in each layer.
    expect_part(opened, top, "material 1", folder + "stress_top_nodal_mat_1.txt");
    expect_part(opened, bottom, "material 1", folder + "stress_bot_nodal_mat_1.txt");
    expect_combined(opened, top, folder + "stress_top_nodal_combined.txt");
    expect_combined(opened, bottom, folder + "stress_bot_nodal_combined.txt");
}

TEST_F(RstExports, means_of_elements_equal_mechanicals) {
    const std::string folder = "workbench/extract_shell_layer/";
    const OpenedRst opened = test::open_corpus({folder + "mixed_shell_solid.rst"});
    for (const auto& [layer, file] :
         {std::pair{Layer::Top, "stress_top_elemental_combined.txt"},
          std::pair{Layer::Bottom, "stress_bot_elemental_combined.txt"}}) {
        const Result stress = load_wanted(opened, {"stress", 0, Complex::No, layer});
        std::map<std::int64_t, std::pair<double, int>> sums;
        for (std::size_t row = 0; row < stress.row_count(); ++row) {
            auto& sum = sums[raw(element_at(opened.model->mesh(), ElementIndex{stress.row_owner[row]}).id())];
            sum.first += static_cast<double>(stress.values[6 * row]);
            ++sum.second;
        }
        for (const PrintedRow& row : printed_rows(folder + file)) {
            ASSERT_EQ(sums.count(row.id), 1u) << row.id;
            const double printed = row.numbers.back();
            EXPECT_NEAR(sums[row.id].first / sums[row.id].second, printed, print_precision(printed, 5) + 2e-6)
                << file << " " << row.id;
        }
    }
}

// OUTRES,NAR: two ways to the same numbers, out of different records.
TEST_F(RstExports, averages_that_ansys_stored_equal_ours_over_all_elements) {
    const OpenedRst opened = test::open_corpus({"rst/nodal_averaged_v251.rst"});
    for (const char* name : {"stress", "elastic_strain", "plastic_strain"}) {
        const std::string stored_name = std::string("averaged_") + name;
        for (const std::uint32_t step : {0U, 4U}) {
            const Result stored = load_wanted(opened, {stored_name, step});
            EXPECT_EQ(stored.info.averaging, Averaging::Solver);
            EXPECT_EQ(stored.info.location, Location::Nodal);
            const Result ours =
                average(opened.model->mesh(), load_wanted(opened, {name, step}), Averaging::All);
            ASSERT_EQ(stored.values.size(), ours.values.size());
            float largest = 0;
            for (const float value : ours.values) largest = std::fmax(largest, std::abs(value));
            std::size_t missing = 0;
            for (std::size_t i = 0; i < ours.values.size(); ++i) {
                EXPECT_EQ(std::isnan(stored.values[i]), std::isnan(ours.values[i]));
                missing += std::isnan(ours.values[i]) ? 1U : 0U;
                if (!std::isnan(ours.values[i])) {
                    EXPECT_NEAR(stored.values[i], ours.values[i], 1e-6F * largest) << name << i;
                }
            }
            EXPECT_EQ(missing, 138u * 6);  // Mid-side nodes.
        }
    }
}

}  // namespace
}  // namespace feelem
