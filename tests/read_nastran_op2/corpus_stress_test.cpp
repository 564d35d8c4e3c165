// SPDX-License-Identifier: Apache-2.0
// Stresses and strains of real .op2 files against the printed pages of the same run, and against themselves.
#include "read_nastran_op2/op2_answers.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace feelem {
namespace {

std::unique_ptr<ModelSource> open_corpus(const std::string& path, Diagnostics& diagnostics) {
    std::vector<NamedBytes> files{{path, test::read_file(test::corpus_file("nastran/" + path).value())}};
    return open_model(std::move(files), {}, diagnostics);
}

Result load(ModelSource& model, const std::string& name, Layer layer) {
    const auto infos = model.results();
    const auto found = std::ranges::find_if(infos, [&](const ResultInfo& info) {
        return info.name == name && info.layer == layer;
    });
    if (found == infos.end()) return {};
    return model.load(static_cast<std::size_t>(found - infos.begin()));
}

/// A value at a corner of an element, or of an element (node 0); NaN when there is none.
float value_at(const Mesh& mesh, const Result& result, const std::string& component, int element, int node) {
    const int column = component_index(result.info, component);
    if (column < 0) return NAN;
    const std::size_t width = result.component_count();
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const auto owner = result.row_owner.empty() ? static_cast<std::uint32_t>(row) : result.row_owner[row];
        if (raw(element_at(mesh, ElementIndex{owner}).id()) != element) continue;
        const bool at_node = result.row_node.empty() || raw(mesh.node_ids[raw(result.row_node[row])]) == node;
        if (at_node) return result.values[row * width + static_cast<std::size_t>(column)];
    }
    return NAN;
}

struct Printed {
    const char* name;
    Layer layer;
    const char* component;
    int element, node;
    double value;
};

/// Read by eye from static_solid_shell_bar.f06.
constexpr Printed kPages[]{
    {"stress", Layer::No, "xx", 1, 2, -2.806434e+02},
    {"stress", Layer::No, "yy", 1, 2, -9.783870e+02},
    {"stress", Layer::No, "zz", 1, 2, 1.230871e+04},
    {"stress", Layer::No, "xy", 1, 2, 2.065732e+01},
    {"stress", Layer::No, "yz", 1, 2, -9.214196e+02},
    {"stress", Layer::No, "zx", 1, 2, 9.214196e+02},
    {"stress", Layer::No, "von_mises", 1, 2, 1.314756e+04},
    {"stress", Layer::No, "zx", 1, 4, -9.214196e+02},
    {"stress", Layer::No, "xy", 2, 6, -1.329118e+03},
    {"stress", Layer::No, "von_mises", 2, 8, 1.034083e+04},
    {"stress", Layer::Bottom, "von_mises", 6, 4, 9.797846e+03},
    {"stress", Layer::Top, "von_mises", 6, 4, 9.650432e+03},
    {"stress", Layer::Bottom, "major", 6, 1, 9.984315e+03},
    {"stress", Layer::Top, "minor", 6, 1, -8.298007e+02},
    {"stress", Layer::Bottom, "von_mises", 8, 3, 1.023015e+04},
    {"stress", Layer::Top, "von_mises", 8, 3, 1.046995e+04},
    {"axial_stress", Layer::No, "value", 14, 0, 2.432185e+04},
    {"axial_stress", Layer::No, "value", 15, 0, 2.438213e+04},
    {"axial_stress", Layer::No, "value", 13, 0, 1.028287e+04},
    {"bar_stress", Layer::No, "max", 12, 18, 1.342250e+04},
    {"bar_stress", Layer::No, "min", 12, 18, 7.048584e+03},
    {"bar_stress", Layer::No, "max", 12, 22, 1.310919e+04},
    {"bar_stress", Layer::No, "min", 13, 23, 1.028287e+04},
    {"strain", Layer::No, "xx", 1, 2, -1.347017e-04},
    {"strain", Layer::No, "xy", 1, 2, 1.880528e-06},
    {"strain", Layer::No, "von_mises", 1, 2, 3.989604e-04},
    {"strain", Layer::Middle, "von_mises", 6, 4, 2.731759e-04},
    {"curvature", Layer::No, "major", 6, 4, 2.760603e-05},
};

TEST(NastranOp2, stresses_and_strains_are_those_on_the_printed_page) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto model = open_corpus("models/sol_101_elements/static_solid_shell_bar.op2", diagnostics);
    for (const Printed& printed : kPages) {
        const Result result = load(*model, printed.name, printed.layer);
        const float found = value_at(model->mesh(), result, printed.component, printed.element, printed.node);
        EXPECT_NEAR(found, printed.value, 6e-7 * std::abs(printed.value))
            << printed.name << " " << printed.component << " of element " << printed.element << " at "
            << printed.node;
    }
}

double von_mises_of(const float* s) {
    const double xy = double(s[0]) - s[1], yz = double(s[1]) - s[2], zx = double(s[2]) - s[0];
    const double shear = double(s[3]) * s[3] + double(s[4]) * s[4] + double(s[5]) * s[5];
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * shear);
}

/// Ply stresses and nothing else: opens with its deck only.
constexpr const char* kWithoutNodes = "models/unit/pcomp/pcomp_ctria3.op2";

/// Largest differences of the file's own von Mises value from that of its tensor, relative to the largest.
TEST(NastranOp2, tensors_of_solids_have_the_von_mises_stress_that_the_file_gives_them) {
    const auto answers = test::corpus_file("nastran/answers.json");
    if (!answers) GTEST_SKIP() << "the corpus is not here";
    std::size_t rows = 0;
    for (const test::Op2File& file : test::read_op2_answers(*answers)) {
        if (file.failed || file.path == kWithoutNodes) continue;
        SCOPED_TRACE(file.path);
        Diagnostics diagnostics;
        const auto model = open_corpus(file.path, diagnostics);
        for (std::size_t i = 0; i < model->results().size(); ++i) {
            const ResultInfo& info = model->results()[i];
            const bool is_tensor = info.shape == Shape::SymmetricTensor && info.name.starts_with("stress");
            if (!is_tensor || component_index(info, "von_mises") != 6) continue;
            const Result result = model->load(i);
            double largest = 0;
            for (std::size_t row = 0; row < result.row_count(); ++row)
                largest = std::fmax(largest, double(result.values[row * 7 + 6]));
            for (std::size_t row = 0; row < result.row_count(); ++row) {
                const float* values = &result.values[row * 7];
                if (std::isnan(values[0])) continue;
                ++rows;
                EXPECT_NEAR(von_mises_of(values), values[6], 2e-6 * largest);
            }
        }
    }
    EXPECT_GT(rows, 1000U);
}

TEST(NastranOp2, our_average_of_the_corners_is_what_the_solver_gives_as_grid_point_stress) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto model = open_corpus("models/solid_bending/solid_bending_ogs.op2", diagnostics);
    const Result expected = load(*model, "grid_point_stress", Layer::No);
    const Result averaged = average(model->mesh(), load(*model, "stress", Layer::No), Averaging::All);
    ASSERT_EQ(expected.row_count(), model->mesh().node_count());
    ASSERT_EQ(expected.component_count(), 8U);
    ASSERT_EQ(averaged.component_count(), 6U) << "von Mises is that of the means";
    for (std::size_t row = 0; row < expected.row_count(); ++row) {
        for (std::size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(averaged.values[row * 6 + c], expected.values[row * 8 + c], 0.02) << row;
        EXPECT_NEAR(von_mises_of(&expected.values[row * 8]), expected.values[row * 8 + 7], 0.02);
    }
}

/// The plain law of elasticity between the strain and the stress of one row, with the deck's constants.
void expect_elastic(const float* stress, const float* strain, double largest) {
    constexpr double kModulus = 2.9e7, kRatio = 0.32;
    const double shear = kModulus / (2 * (1 + kRatio));
    const double lame = kModulus * kRatio / ((1 + kRatio) * (1 - 2 * kRatio));
    const double trace = double(strain[0]) + strain[1] + strain[2];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(stress[c], lame * trace + 2 * shear * strain[c], 1e-3 * largest);
    for (int c = 3; c < 6; ++c) EXPECT_NEAR(stress[c], shear * strain[c], 1e-3 * largest);
}

TEST(NastranOp2, complex_stresses_and_strains_of_solids_obey_the_law_of_elasticity) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto model = open_corpus("models/sol_101_elements/freq_solid_shell_bar.op2", diagnostics);
    const auto infos = model->results();
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (infos[i].name != "stress" || infos[i].shape != Shape::SymmetricTensor) continue;
        for (std::size_t j = 0; j < infos.size(); ++j) {
            if (infos[j].name != "strain" || infos[j].shape != infos[i].shape ||
                infos[j].step != infos[i].step || infos[j].complex != infos[i].complex)
                continue;
            const Result stress = model->load(i), strain = model->load(j);
            ASSERT_EQ(stress.row_node, strain.row_node);
            double largest = 0;
            for (const float value : stress.values) largest = std::fmax(largest, std::abs(double(value)));
            for (std::size_t row = 0; row < stress.row_count(); ++row)
                expect_elastic(&stress.values[row * 6], &strain.values[row * 6], largest);
            ++pairs;
        }
    }
    EXPECT_EQ(pairs, 14U);  // Seven frequencies, real and imaginary.
}

/// The principal values and the equivalent one follow from the other columns, so all are in their places.
TEST(NastranOp2, plies_have_the_principal_values_of_their_stresses_and_strains) {
    const auto answers = test::corpus_file("nastran/answers.json");
    if (!answers) GTEST_SKIP() << "the corpus is not here";
    std::size_t rows = 0, files = 0, results = 0;
    for (const test::Op2File& file : test::read_op2_answers(*answers)) {
        if (file.failed || file.path == kWithoutNodes) continue;
        SCOPED_TRACE(file.path);
        Diagnostics diagnostics;
        const auto model = open_corpus(file.path, diagnostics);
        const std::size_t before = results;
        for (std::size_t i = 0; i < model->results().size(); ++i) {
            const ResultInfo& info = model->results()[i];
            if (!info.name.starts_with("ply_")) continue;
            ++results;
            SCOPED_TRACE(info.name);
            const bool strain = info.name.starts_with("ply_strain_");
            const bool von_mises = info.components[5] == "von_mises";
            const Result result = model->load(i);
            ASSERT_EQ(result.row_count(), model->mesh().element_count());
            for (std::size_t row = 0; row < result.row_count(); ++row) {
                const float* v = &result.values[row * 8];
                if (std::isnan(v[0])) continue;
                ++rows;
                const double middle = (double(v[0]) + v[1]) / 2, half = (double(v[0]) - v[1]) / 2;
                const double radius = std::hypot(half, strain ? v[2] / 2.0 : double(v[2]));
                const double near = 3e-6 * (std::abs(middle) + radius) + 1e-30;
                EXPECT_NEAR(v[6], middle + radius, near);
                EXPECT_NEAR(v[7], middle - radius, near);
                const double shear = strain ? 2 * radius : radius;
                const double mises = (strain ? 2. / 3 : 1) * std::sqrt(middle * middle + 3 * radius * radius);
                EXPECT_NEAR(v[5], von_mises ? mises : shear, near);
            }
        }
        if (results > before) ++files;
    }
    EXPECT_EQ(files, 17U);
    EXPECT_EQ(results, 338U);
    EXPECT_EQ(rows, 2678U);
}

/// Words of loadstep_elements.op2, unpacked by a script of its own.
TEST(NastranOp2, nonlinear_elements_give_their_equivalent_stress_at_corners_and_fibres) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto model = open_corpus("models/elements/loadstep_elements.op2", diagnostics);
    const Result solid = load(*model, "nonlinear_state", Layer::No);
    EXPECT_THAT(
        solid.info.components, testing::ElementsAre("equivalent_stress", "plastic_strain", "creep_strain")
    );
    EXPECT_EQ(value_at(model->mesh(), solid, "equivalent_stress", 1, 2), 3569.9636F);
    EXPECT_EQ(value_at(model->mesh(), solid, "equivalent_stress", 1, 3), 2354.4182F);
    EXPECT_EQ(value_at(model->mesh(), solid, "plastic_strain", 1, 2), 0);
    const Result bottom = load(*model, "nonlinear_state", Layer::Bottom);
    EXPECT_EQ(bottom.info.location, Location::Elemental);
    EXPECT_EQ(value_at(model->mesh(), bottom, "equivalent_stress", 6, 0), 2715.9421F);
    const Result top = load(*model, "nonlinear_state", Layer::Top);
    EXPECT_EQ(value_at(model->mesh(), top, "equivalent_stress", 6, 0), 1952.9111F);
    EXPECT_EQ(value_at(model->mesh(), top, "creep_strain", 6, 0), 0);
}

/// A complex result of one step, by its name, layer and part; empty when the file has none.
Result load_complex(
    ModelSource& model,
    std::uint32_t step,
    const std::string& name,
    Layer layer,
    Complex part,
    std::size_t width
) {
    for (std::size_t i = 0; i < model.results().size(); ++i) {
        const ResultInfo& info = model.results()[i];
        if (info.step == step && info.name == name && info.layer == layer && info.complex == part &&
            info.components.size() == width)
            return model.load(i);
    }
    return {};
}

/// One part of a result as complex numbers: amplitudes and phases are put together first.
std::vector<std::complex<double>> numbers_of(
    ModelSource& model,
    bool polar,
    std::uint32_t step,
    const std::string& name,
    Layer layer,
    std::size_t width
) {
    const Result a =
        load_complex(model, step, name, layer, polar ? Complex::Amplitude : Complex::Real, width);
    const Result b =
        load_complex(model, step, name, layer, polar ? Complex::Phase : Complex::Imaginary, width);
    EXPECT_EQ(a.values.size(), b.values.size());
    std::vector<std::complex<double>> out;
    for (std::size_t i = 0; i < std::min(a.values.size(), b.values.size()); ++i) {
        out.push_back(
            polar ? std::polar<double>(a.values[i], b.values[i] * std::numbers::pi / 180)
                  : std::complex<double>(a.values[i], b.values[i])
        );
    }
    return out;
}

double largest_of(const std::vector<std::complex<double>>& values) {
    double largest = 0;
    for (const auto& value : values) largest = std::fmax(largest, std::abs(value));
    return largest;
}

/// Plates: the fibres lie half the thickness from the middle, on the side that Nastran's curvature says.
TEST(NastranOp2, complex_stresses_and_strains_of_shells_obey_the_law_of_elasticity) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    constexpr double kModulus = 2.9e7, kRatio = 0.32, kHalfThickness = 0.125;
    constexpr double kStiff = kModulus / (1 - kRatio * kRatio), kShear = kModulus / (2 * (1 + kRatio));
    struct ComplexFile {
        const char* path;
        bool polar;
        std::size_t shells, moving;  ///< Over all steps; and those that are not all zero.
    };
    for (const auto& [path, polar, expected, expected_moving] : {
             ComplexFile{"models/sol_101_elements/freq_solid_shell_bar.op2", false, 42, 6},
             ComplexFile{"models/elements/modes_complex_elements.op2", false, 32, 8},
             ComplexFile{"models/elements/freq_random_elements.op2", false, 40, 8},
             ComplexFile{"models/elements/freq_elements2.op2", true, 40, 8},
         }) {
        SCOPED_TRACE(path);
        Diagnostics diagnostics;
        const auto model = open_corpus(path, diagnostics);
        std::size_t shells = 0, moving = 0;
        for (std::uint32_t step = 0; step < model->steps().size(); ++step) {
            const auto bottom = numbers_of(*model, polar, step, "stress", Layer::Bottom, 3);
            const auto top = numbers_of(*model, polar, step, "stress", Layer::Top, 3);
            const auto middle = numbers_of(*model, polar, step, "strain", Layer::Middle, 3);
            const auto curvature = numbers_of(*model, polar, step, "curvature", Layer::No, 3);
            ASSERT_EQ(bottom.size(), middle.size());
            const double most = 1e-5 * largest_of(bottom);
            for (std::size_t i = 0; i + 2 < bottom.size(); i += 3) {
                const ElementIndex element{static_cast<std::uint32_t>(i / 3)};
                const PartIndex part = element_at(model->mesh(), element).part();
                // The others are composites.
                if (model->mesh().parts[raw(part)].name != "property 4" || std::isnan(bottom[i].real()))
                    continue;
                ++shells;
                if (std::abs(bottom[i]) > 0) ++moving;
                for (const double z : {-kHalfThickness, kHalfThickness}) {
                    const auto& fibre = z < 0 ? bottom : top;
                    std::array<std::complex<double>, 3> e;
                    for (std::size_t c = 0; c < 3; ++c) e[c] = middle[i + c] - z * curvature[i + c];
                    EXPECT_LE(std::abs(fibre[i] - kStiff * (e[0] + kRatio * e[1])), most) << i;
                    EXPECT_LE(std::abs(fibre[i + 1] - kStiff * (e[1] + kRatio * e[0])), most) << i;
                    EXPECT_LE(std::abs(fibre[i + 2] - kShear * e[2]), most) << i;
                }
            }
        }
        EXPECT_EQ(shells, expected);
        EXPECT_EQ(moving, expected_moving);
    }
}

/// One job written twice: with real and imaginary parts, and with amplitudes, phases and von Mises values.
TEST(NastranOp2, amplitudes_and_phases_are_the_real_and_imaginary_parts_of_the_same_job) {
    if (!test::corpus_file("nastran/answers.json")) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto parts = open_corpus("models/elements/freq_random_elements.op2", diagnostics);
    const auto polar = open_corpus("models/elements/freq_elements2.op2", diagnostics);
    constexpr std::uint32_t kResonance = 4;  // Nothing moves at the other frequencies.
    ASSERT_EQ(parts->steps()[kResonance].value, 40);
    ASSERT_EQ(polar->steps()[kResonance].value, 40);
    for (const auto& [name, layer, width] :
         {std::tuple{"stress", Layer::Bottom, 3U},
          {"stress", Layer::Top, 3U},
          {"strain", Layer::Middle, 3U},
          {"curvature", Layer::No, 3U},
          {"stress", Layer::No, 6U}}) {
        SCOPED_TRACE(name);
        const auto a = numbers_of(*parts, false, kResonance, name, layer, width);
        const auto b = numbers_of(*polar, true, kResonance, name, layer, width);
        ASSERT_EQ(a.size(), b.size());
        std::size_t compared = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            // The second file has no CQUADR and CTRIAR: they are composites there.
            if (std::isnan(a[i].real()) || std::isnan(b[i].real())) continue;
            ++compared;
            EXPECT_LE(std::abs(a[i] - b[i]), 1e-6 * largest_of(a)) << i;
        }
        EXPECT_GE(compared, 24U);
        EXPECT_GT(largest_of(a), 0);
    }
}

}  // namespace
}  // namespace feelem
