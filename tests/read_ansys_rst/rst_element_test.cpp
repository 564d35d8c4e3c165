// SPDX-License-Identifier: Apache-2.0
// Element results of small SYNTHETIC files: rows, layers, axes; and shells of real files against their
// curvature.
#include "model/rotation.hpp"
#include "model/vector.hpp"
#include "read_ansys_rst/opened_rst.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace feelem {
namespace {

using test::load_wanted;
using test::open_written;
using test::OpenedRst;
using test::WrittenElementRecord;
using test::WrittenModel;
using test::WrittenSet;
using testing::ElementsAre;

constexpr std::size_t kStress = 3, kElasticStrain = 6, kThermalStrain = 9, kEuler = 10, kFlux = 11;

/// Row r, column c holds base + 10 r + c.
std::vector<double> rows(std::size_t count, std::size_t width, double base) {
    std::vector<double> values;
    for (std::size_t r = 0; r < count; ++r) {
        for (std::size_t c = 0; c < width; ++c)
            values.push_back(base + 10 * static_cast<double>(r) + static_cast<double>(c));
    }
    return values;
}

WrittenModel bricks_with(std::vector<WrittenElementRecord> records) {
    WrittenModel model = test::two_bricks();
    WrittenSet set;
    set.element_records = std::move(records);
    model.sets.push_back(set);
    return model;
}

/// One square shell, nodes 10, 20, 50, 40 of the bricks.
WrittenModel shell_with(
    std::int32_t routine, std::int32_t keyopt8, std::vector<WrittenElementRecord> records
) {
    WrittenModel model = bricks_with(std::move(records));
    model.types = {{routine, 4, 0, keyopt8}};
    model.elements = {{1, 1, 1, {10, 20, 50, 40}}};
    return model;
}

/// Values of a row: those of an element at a node.
std::vector<float> row_at(
    const OpenedRst& opened, const Result& result, std::uint32_t element, std::int64_t node
) {
    const std::size_t width = result.component_count();
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const NodeIndex index = result.row_node[row];
        if (result.row_owner[row] == element && raw(opened.model->mesh().node_ids[raw(index)]) == node)
            return {
                result.values.begin() + static_cast<std::ptrdiff_t>(row * width),
                result.values.begin() + static_cast<std::ptrdiff_t>((row + 1) * width)};
    }
    ADD_FAILURE() << "no row of element " << element << " at node " << node;
    return {};
}

TEST(RstElement, corners_have_a_row_each_and_are_averaged_by_material) {
    const OpenedRst opened =
        open_written(bricks_with({{0, kStress, rows(8, 6, 1), 0}, {1, kStress, rows(8, 6, 1001), 0}}));
    const Result stress = load_wanted(opened, {"stress"});
    EXPECT_EQ(stress.info.location, Location::ElementNodal);
    EXPECT_EQ(stress.info.averaging, Averaging::None);
    EXPECT_EQ(stress.info.solver_name, "S");
    EXPECT_FALSE(stress.info.corner_only);
    EXPECT_THAT(stress.info.components, ElementsAre("xx", "yy", "zz", "xy", "yz", "zx"));
    EXPECT_EQ(stress.row_count(), 16u);
    EXPECT_THAT(row_at(opened, stress, 0, 20), ElementsAre(11, 12, 13, 14, 15, 16));
    EXPECT_THAT(row_at(opened, stress, 1, 20), ElementsAre(1001, 1002, 1003, 1004, 1005, 1006));
    const Result all = average(opened.model->mesh(), stress, Averaging::All);
    EXPECT_EQ(test::value_at(opened, all, 20, "xx"), (11.0F + 1001.0F) / 2);
    const Result parts = average(opened.model->mesh(), stress, Averaging::Part);
    EXPECT_EQ(parts.row_count(), 16u);
}

TEST(RstElement, element_without_a_record_has_no_row_and_a_negative_pointer_means_zeros) {
    const OpenedRst opened = open_written(bricks_with({{1, kThermalStrain, {}, 64}}));
    const Result strain = load_wanted(opened, {"thermal_strain"});
    EXPECT_EQ(strain.row_count(), 8u);
    EXPECT_THAT(row_at(opened, strain, 1, 120), ElementsAre(0, 0, 0, 0, 0, 0));
}

TEST(RstElement, invariants_of_old_files_are_components_of_elements_and_are_derived_anew_of_averages) {
    WrittenModel model = bricks_with({{0, kStress, rows(8, 11, 1), 0}, {0, kEuler, {90, 0, 0}, 0}});
    model.has_principal = true;
    const OpenedRst opened = open_written(model);
    const Result stress = load_wanted(opened, {"stress"});
    EXPECT_THAT(
        stress.info.components,
        ElementsAre(
            "xx",
            "yy",
            "zz",
            "xy",
            "yz",
            "zx",
            "principal_1",
            "principal_2",
            "principal_3",
            "tresca",
            "von_mises"
        )
    );
    // Turned about z; what does not depend on axes stays.
    EXPECT_THAT(row_at(opened, stress, 0, 50), ElementsAre(22, 21, 23, -24, 26, -25, 27, 28, 29, 30, 31));
    const Result parts = average(opened.model->mesh(), stress, Averaging::Part);
    EXPECT_EQ(parts.info.components.size(), 6u);
    EXPECT_EQ(parts.values.size(), 6 * parts.row_count());
}

TEST(RstElement, values_along_the_elements_axes_are_turned_into_the_global_ones) {
    std::vector<double> strain;
    for (int k = 0; k < 8; ++k) strain.insert(strain.end(), {1, 2, 3, 8, 0, 0, 99});
    const OpenedRst opened =
        open_written(bricks_with({{0, kElasticStrain, strain, 0}, {0, kEuler, {90, 0, 0}, 0}}));
    const Result turned = load_wanted(opened, {"elastic_strain"});
    EXPECT_EQ(turned.info.shear, Shear::Engineering);
    EXPECT_THAT(row_at(opened, turned, 0, 10), ElementsAre(2, 1, 3, -8, 0, 0));
}

TEST(RstElement, angles_may_be_of_each_corner_and_of_each_layer) {
    std::vector<double> stress(48);
    for (std::size_t k = 0; k < 8; ++k) stress[6 * k] = 4;  // Pull along x of the layer.
    std::vector<double> angles(25);
    angles[3] = 90;  // The second corner lies along y.
    angles[24] = 45;
    const OpenedRst opened = open_written(bricks_with({{0, kStress, stress, 0}, {0, kEuler, angles, 0}}));
    const Result turned = load_wanted(opened, {"stress"});
    const std::vector<float> first = row_at(opened, turned, 0, 10), second = row_at(opened, turned, 0, 20);
    EXPECT_NEAR(first[0], 2, 1e-6F);
    EXPECT_NEAR(first[3], 2, 1e-6F);
    EXPECT_NEAR(second[0], 2, 1e-6F);
    EXPECT_NEAR(second[3], -2, 1e-6F);
}

TEST(RstElement, layered_bricks_show_the_outer_surfaces_of_their_outer_layers) {
    // Three layers of eight rows each.
    const OpenedRst opened = open_written(bricks_with({{0, kStress, rows(24, 6, 0), 0}}));
    const Result stress = load_wanted(opened, {"stress"});
    EXPECT_EQ(row_at(opened, stress, 0, 10)[0], 0);    // Row 0: the bottom of the first layer.
    EXPECT_EQ(row_at(opened, stress, 0, 70)[0], 200);  // Row 20: the top of the third.
    EXPECT_EQ(row_at(opened, stress, 0, 100)[0], 230);
}

TEST(RstElement, shells_have_three_surfaces_when_keyopt_8_says_so) {
    const OpenedRst opened = open_written(shell_with(181, 2, {{0, kStress, rows(12, 6, 0), 0}}));
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Bottom}), 0, 20)[0], 10);
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Top}), 0, 20)[0], 50);
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Middle}), 0, 20)[0], 90);
    EXPECT_FALSE(test::has_wanted(opened, {"stress"}));
}

TEST(RstElement, shells_with_two_surfaces_have_no_middle) {
    const OpenedRst opened = open_written(shell_with(181, 0, {{0, kStress, rows(8, 6, 0), 0}}));
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Bottom}), 0, 20)[0], 10);
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Top}), 0, 20)[0], 50);
    EXPECT_FALSE(test::has_wanted(opened, {"stress", 0, Complex::No, Layer::Middle}));
}

TEST(RstElement, composite_shells_show_their_outer_surfaces_along_their_own_layers) {
    // Two layers of bottom, top, middle; the upper one lies at 90 degrees.
    const std::vector<double> angles{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 90};
    const OpenedRst opened =
        open_written(shell_with(181, 2, {{0, kStress, rows(24, 6, 0), 0}, {0, kEuler, angles, 0}}));
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Bottom}), 0, 10)[0], 0);
    const Result top = load_wanted(opened, {"stress", 0, Complex::No, Layer::Top});
    EXPECT_THAT(row_at(opened, top, 0, 10), ElementsAre(161, 160, 162, -163, 165, -164));
    EXPECT_EQ(load_wanted(opened, {"stress", 0, Complex::No, Layer::Middle}).row_count(), 0u);
}

TEST(RstElement, composites_that_store_outer_surfaces_alone_have_the_angles_of_all_layers) {
    const std::vector<double> angles{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 45, 90};
    const OpenedRst opened =
        open_written(shell_with(181, 0, {{0, kStress, rows(8, 6, 0), 0}, {0, kEuler, angles, 0}}));
    const Result bottom = load_wanted(opened, {"stress", 0, Complex::No, Layer::Bottom});
    EXPECT_THAT(row_at(opened, bottom, 0, 10), ElementsAre(0, 1, 2, 3, 4, 5));
    const Result top = load_wanted(opened, {"stress", 0, Complex::No, Layer::Top});
    EXPECT_THAT(row_at(opened, top, 0, 10), ElementsAre(41, 40, 42, -43, 45, -44));
}

TEST(RstElement, shell63_begins_with_its_top) {
    const OpenedRst opened = open_written(shell_with(63, 0, {{0, kStress, rows(8, 6, 0), 0}}));
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Top}), 0, 20)[0], 10);
    EXPECT_EQ(row_at(opened, load_wanted(opened, {"stress", 0, Complex::No, Layer::Bottom}), 0, 20)[0], 50);
}

TEST(RstElement, shells_whose_order_of_layers_is_not_known_are_left_out_and_counted) {
    const OpenedRst opened = open_written(shell_with(43, 0, {{0, kStress, rows(8, 6, 0), 0}}));
    EXPECT_EQ(load_wanted(opened, {"stress", 0, Complex::No, Layer::Top}).row_count(), 0u);
    EXPECT_TRUE(opened.diagnostics->has(Code::ResultForPartOfModel));
}

TEST(RstElement, degenerate_bricks_have_one_row_a_node) {
    WrittenModel model = bricks_with({{0, kStress, rows(8, 6, 0), 0}});
    model.elements[0].nodes = {10, 20, 50, 50, 70, 80, 110, 110};
    const OpenedRst opened = open_written(model);
    EXPECT_EQ(opened.model->mesh().blocks[0].type, ElementType::Wedge6);
    const Result stress = load_wanted(opened, {"stress"});
    EXPECT_EQ(stress.row_count(), 6u);
    EXPECT_EQ(row_at(opened, stress, 0, 110)[0], 60);
}

TEST(RstElement, flux_is_heat_when_temperature_is_the_only_field) {
    WrittenModel model = bricks_with({{0, kFlux, rows(8, 3, 0), 0}});
    model.dofs = {20};
    model.units = 5;
    const OpenedRst heat = open_written(model);
    const Result flux = load_wanted(heat, {"heat_flux"});
    EXPECT_EQ(flux.info.unit, "W/m^2");
    EXPECT_THAT(row_at(heat, flux, 0, 20), ElementsAre(10, 11, 12));
    model.dofs = {1, 2, 3, 21};
    EXPECT_TRUE(test::has_wanted(open_written(model), {"electric_flux_density"}));
    model.dofs = {20, 21};  // Of two fields one record holds both.
    EXPECT_FALSE(test::has_wanted(open_written(model), {"heat_flux"}));
    EXPECT_FALSE(test::has_wanted(open_written(model), {"electric_flux_density"}));
}

TEST(RstElement, records_shared_by_all_elements_cannot_cost_time) {
    // A thousand elements point to one long packed record.
    WrittenModel model = test::two_bricks();
    const WrittenModel one = bricks_with({{0, kStress, rows(8, 6, 0), 0}, {1, kStress, rows(7, 6, 0), 0}});
    const OpenedRst opened = open_written(one);
    EXPECT_EQ(load_wanted(opened, {"stress"}).row_count(), 8u);
    EXPECT_EQ(opened.diagnostics->count(Code::ResultForPartOfModel), 1u);
}

/// Stretch of the top against the bottom along a diagonal, as the rotations of its two ends would make it in
/// a shell of thickness one; and as the strains say.
struct Bending {
    double by_rotation = 0, by_strain = 0;
};

/// Along both diagonals of every quad: rotation carries the normal's end forwards or backwards.
std::vector<Bending> bending_of(const OpenedRst& opened, Complex complex) {
    const Mesh& mesh = opened.model->mesh();
    const Result rotation = load_wanted(opened, {"rotation", 0, complex});
    const Result top = load_wanted(opened, {"elastic_strain", 0, complex, Layer::Top});
    const Result bottom = load_wanted(opened, {"elastic_strain", 0, complex, Layer::Bottom});
    std::vector<Bending> all;
    std::uint32_t first = 0;
    for (const ElementBlock& block : mesh.blocks) {
        const ElementRow& type = element_row(block.type);
        const bool quad = type.dimension == 2 && type.corner_count == 4;
        for (std::size_t e = 0; quad && e < block.ids.size(); ++e) {
            const NodeIndex* nodes = block.nodes.data() + type.node_count * e;
            const auto place = [&](std::size_t k) { return mesh.coordinates[raw(nodes[k])]; };
            Point3 normal = cross(minus(place(2), place(0)), minus(place(3), place(1)));
            const double length = std::sqrt(dot(normal, normal));
            for (double& x : normal) x /= length;
            std::array<double, 6> difference{};
            for (std::size_t k = 0; k < 4; ++k) {
                const std::int64_t id = raw(mesh.node_ids[raw(nodes[k])]);
                const auto element = static_cast<std::uint32_t>(first + e);
                const auto up = row_at(opened, top, element, id), down = row_at(opened, bottom, element, id);
                for (std::size_t c = 0; c < 6; ++c)
                    difference[c] += static_cast<double>(up[c] - down[c]) / 4 / (c < 3 ? 1 : 2);
            }
            for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
                Point3 along = minus(place(k + 2), place(k));
                const double size = std::sqrt(dot(along, along));
                for (double& x : along) x /= size;
                const auto carried = [&](std::size_t corner) {
                    Point3 turn{};
                    for (std::size_t c = 0; c < 3; ++c)
                        turn[c] = static_cast<double>(rotation.values[3 * raw(nodes[corner]) + c]);
                    return dot(cross(turn, normal), along);
                };
                const auto& d = difference;
                const double stretch =
                    along[0] * along[0] * d[0] + along[1] * along[1] * d[1] + along[2] * along[2] * d[2] +
                    2 * (along[0] * along[1] * d[3] + along[1] * along[2] * d[4] + along[2] * along[0] * d[5]
                        );
                all.push_back({(carried(k + 2) - carried(k)) / size, stretch});
            }
        }
        first += static_cast<std::uint32_t>(block.ids.size());
    }
    return all;
}

// A surface that a shell bends away from is stretched: this tells the top from the bottom, and right axes
// from wrong ones, in files of which no listing is to be had.
TEST(RstShells, top_and_bottom_of_real_shells_follow_the_rotations_of_their_nodes) {
    struct Case {
        const char* path;
        std::vector<double> thicknesses;  // Of any of its elements.
        double tolerance;
        Complex complex = Complex::No;
    };
    for (const Case& one :
         {Case{"rst/shell63_beam4_v191.rst", {0.3}, 1e-6},
          Case{"rst/shell181_v172.rst", {5}, 1e-6},
          Case{"workbench/extract_shell_layer/mixed_shell_solid.rst", {1}, 1e-4},
          // Composites: layers at 45 and -45 degrees.
          Case{"rst/shell181_v211.rst", {1.9}, 1e-6},
          Case{"rst/shell281_v201.rst", {0.003}, 1e-6},
          Case{"rst/harmonic_shell_v241.rst", {0.0003, 0.0004}, 1e-6, Complex::Real}}) {
        const OpenedRst opened = test::open_corpus({one.path});
        if (!opened.model) GTEST_SKIP() << "the corpus is not here";
        const std::vector<Bending> all = bending_of(opened, one.complex);
        double largest = 0;
        for (const Bending& bending : all) largest = std::max(largest, std::abs(bending.by_strain));
        ASSERT_GT(largest, 0);
        for (const Bending& bending : all) {
            double error = std::abs(bending.by_strain);
            for (const double thickness : one.thicknesses)
                error = std::min(error, std::abs(bending.by_rotation * thickness - bending.by_strain));
            EXPECT_LT(error, one.tolerance * largest) << one.path;
        }
    }
}

}  // namespace
}  // namespace feelem
