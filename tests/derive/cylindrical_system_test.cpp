// SPDX-License-Identifier: Apache-2.0
// Radial, hoop and axial components against Lamé's thick-walled cylinder and by hand.
#include "support/meshes.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace feelem {
namespace {

using testing::ElementsAre;

/// Stress in a cylinder of inner radius 1 and outer radius 2 under inner pressure 3, drawn along its axis
/// with 5.
struct Lame {
    static constexpr double kPressure = 3, kInner = 1, kOuter = 2, kAxial = 5;
    static double mean() { return kPressure * kInner * kInner / (kOuter * kOuter - kInner * kInner); }
    static double radial(double r) { return mean() * (1 - kOuter * kOuter / (r * r)); }
    static double hoop(double r) { return mean() * (1 + kOuter * kOuter / (r * r)); }
};

/// Nodes on rays through the wall, about an axis along z through (10, -20, z).
Mesh wall() {
    Mesh mesh;
    for (int i = 0; i < 40; ++i) {
        const double r = 1 + (i % 5) / 4.0, angle = 2 * std::numbers::pi * i / 40;
        mesh.node_ids.push_back(NodeId{i + 1});
        mesh.coordinates.push_back({10 + r * std::cos(angle), -20 + r * std::sin(angle), 0.3 * i});
    }
    return mesh;
}

double radius_of(const Point3& p) {
    return std::hypot(p[0] - 10, p[1] + 20);
}

/// The field in the global system, written down from Mohr's circle.
Result global_stress(const Mesh& mesh, Shear shear = Shear::NotApplicable) {
    Result result;
    result.info.name = "stress";
    result.info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
    result.info.shape = Shape::SymmetricTensor;
    result.info.shear = shear;
    for (const Point3& p : mesh.coordinates) {
        const double r = radius_of(p), c = (p[0] - 10) / r, s = (p[1] + 20) / r;
        const double radial = Lame::radial(r), hoop = Lame::hoop(r);
        const double xy = (radial - hoop) * s * c * (shear == Shear::Engineering ? 2 : 1);
        for (const double value :
             {radial * c * c + hoop * s * s, radial * s * s + hoop * c * c, Lame::kAxial, xy, 0.0, 0.0})
            result.values.push_back(static_cast<float>(value));
    }
    return result;
}

TEST(CylindricalSystem, gives_lames_radial_and_hoop_stress_through_the_wall) {
    const Mesh mesh = wall();
    const CylindricalSystem system{{10, -20, 7}, {0, 0, 2}};

    const Result turned = to_cylindrical(mesh, global_stress(mesh), system);

    EXPECT_THAT(
        turned.info.components,
        ElementsAre("radial", "hoop", "axial", "radial_hoop", "hoop_axial", "axial_radial")
    );
    EXPECT_EQ(turned.info.shape, Shape::Other) << "so that nobody derives invariants from it";
    for (std::size_t node = 0; node < mesh.node_count(); ++node) {
        const float* values = &turned.values[node * 6];
        const double r = radius_of(mesh.coordinates[node]);
        EXPECT_NEAR(values[0], Lame::radial(r), 1e-6);
        EXPECT_NEAR(values[1], Lame::hoop(r), 1e-6);
        EXPECT_NEAR(values[2], Lame::kAxial, 1e-6);
        for (int shear = 3; shear < 6; ++shear) EXPECT_NEAR(values[shear], 0, 1e-6);
    }
}

TEST(CylindricalSystem, engineering_shear_is_halved_on_the_way_and_doubled_again) {
    const Mesh mesh = wall();
    const CylindricalSystem system{{10, -20, 0}, {0, 0, 1}};

    const Result tensor = to_cylindrical(mesh, global_stress(mesh), system);
    const Result engineering = to_cylindrical(mesh, global_stress(mesh, Shear::Engineering), system);

    for (std::size_t i = 0; i < tensor.values.size(); ++i)
        EXPECT_NEAR(tensor.values[i], engineering.values[i], 1e-6);
    // About another axis there is shear left: twice as much.
    const CylindricalSystem other{{0, 0, 0}, {0, 0, 1}};
    const Result a = to_cylindrical(mesh, global_stress(mesh), other);
    const Result b = to_cylindrical(mesh, global_stress(mesh, Shear::Engineering), other);
    EXPECT_GT(std::abs(a.values[3]), 0.1);
    for (std::size_t node = 0; node < mesh.node_count(); ++node)
        EXPECT_NEAR(2 * a.values[node * 6 + 3], b.values[node * 6 + 3], 1e-5);
}

TEST(CylindricalSystem, a_vector_on_a_tilted_axis_is_split_by_hand) {
    Mesh mesh;
    mesh.node_ids = {NodeId{1}, NodeId{2}};
    mesh.coordinates = {{5, 0, 2}, {3, 0, 0}};  // The first 2 away from the axis x in z; the second on it.
    Result result;
    result.info.components = {"x", "y", "z"};
    result.info.shape = Shape::Vector;
    result.values = {1, 2, 3, 4, 5, 6};

    const Result turned = to_cylindrical(mesh, result, {{0, 0, 0}, {1, 0, 0}});

    // r = z, theta = x cross z = -y, z = x.
    EXPECT_THAT(std::vector<float>(turned.values.begin(), turned.values.begin() + 3), ElementsAre(3, -2, 1));
    EXPECT_TRUE(std::isnan(turned.values[3])) << "on the axis there is no radial direction";
    EXPECT_TRUE(std::isnan(turned.values[4]));
    EXPECT_EQ(turned.values[5], 4);
}

TEST(CylindricalSystem, an_elements_value_stands_at_the_mean_of_its_corners) {
    const Mesh mesh = test::brick_grid(1, 1, 1);
    Result result;
    result.info.components = {"x", "y", "z"};
    result.info.shape = Shape::Vector;
    result.info.location = Location::Elemental;
    result.values = {7, 0, 0};

    const Result turned = to_cylindrical(mesh, result, {{0.5, 0, 0}, {0, 0, 1}});  // Straight above: r = y.

    EXPECT_NEAR(turned.values[0], 0, 1e-6);
    EXPECT_NEAR(turned.values[1], -7, 1e-6);
}

TEST(CylindricalSystem, on_the_axis_a_tensor_has_its_axial_component_alone) {
    Mesh mesh;
    mesh.node_ids = {NodeId{1}, NodeId{2}, NodeId{3}};
    // On the axis far from its origin but for rounding; at the origin itself; and away from the axis.
    mesh.coordinates = {{1e-12, 0, 5000}, {0, 0, 0}, {2, 0, 5000}};
    Result result = global_stress(mesh);
    result.values.clear();
    for (int node = 0; node < 3; ++node) result.values.insert(result.values.end(), {1, 2, 3, 4, 5, 6});

    const Result turned = to_cylindrical(mesh, result, {{0, 0, 0}, {0, 0, 1}});

    for (const std::size_t node : {0U, 1U}) {
        for (std::size_t c = 0; c < 6; ++c) {
            const float value = turned.values[node * 6 + c];
            if (c == 2)
                EXPECT_EQ(value, 3) << "node " << node;
            else
                EXPECT_TRUE(std::isnan(value)) << "node " << node << ", component " << c;
        }
    }
    EXPECT_THAT(
        std::vector<float>(turned.values.begin() + 12, turned.values.end()), ElementsAre(1, 2, 3, 4, 5, 6)
    );
}

TEST(CylindricalSystem, an_element_whose_centre_is_on_the_axis_has_its_axial_component_alone) {
    const Mesh mesh = test::brick_grid(1, 1, 1);
    Result result;
    result.info.components = {"x", "y", "z"};
    result.info.shape = Shape::Vector;
    result.info.location = Location::Elemental;
    result.values = {7, 8, 9};

    const Result turned = to_cylindrical(mesh, result, {{0.5, 0.5, 0}, {0, 0, 1}});

    EXPECT_TRUE(std::isnan(turned.values[0]));
    EXPECT_TRUE(std::isnan(turned.values[1]));
    EXPECT_EQ(turned.values[2], 9);
}

TEST(CylindricalSystem, a_missing_component_spoils_only_what_it_takes_part_in) {
    Mesh mesh;
    mesh.node_ids = {NodeId{1}};
    mesh.coordinates = {{0, 3, 0}};  // r = y, theta = -x.
    Result result = global_stress(mesh);
    result.values = {std::numeric_limits<float>::quiet_NaN(), 2, 3, 4, 5, 6};

    const Result turned = to_cylindrical(mesh, result, {{0, 0, 0}, {0, 0, 1}});

    EXPECT_EQ(turned.values[2], 3) << "axial stress needs no xx";
    EXPECT_TRUE(std::isnan(turned.values[1])) << "hoop stress is xx here";
}

TEST(CylindricalSystem, an_axis_the_other_way_turns_hoop_and_axial_round) {
    Mesh mesh;
    mesh.node_ids = {NodeId{1}};
    mesh.coordinates = {{2, 0, 0}};
    Result result;
    result.info.components = {"x", "y", "z"};
    result.info.shape = Shape::Vector;
    result.values = {1, 2, 3};
    EXPECT_THAT(to_cylindrical(mesh, result, {{0, 0, 0}, {0, 0, 1}}).values, ElementsAre(1, 2, 3));
    EXPECT_THAT(to_cylindrical(mesh, result, {{0, 0, 9}, {0, 0, -4}}).values, ElementsAre(1, -2, -3));
}

TEST(CylindricalSystem, a_node_of_two_parts_is_turned_once_a_part_and_layers_stay) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {-1, 1, 0}, {-1, 2, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}, "a"}, {ElementType::Quad4, {5, 1, 4, 6}, "b"}}
    );
    Result result;
    result.info.components = {"x", "y", "z"};
    result.info.shape = Shape::Vector;
    result.info.location = Location::ElementNodal;
    result.info.averaging = Averaging::None;
    result.info.layer = Layer::Bottom;
    result.row_owner = {0, 0, 1};
    result.row_node = {NodeIndex{0}, NodeIndex{1}, NodeIndex{0}};
    result.values = {1, 2, 3, 0, 0, 0, 10, 20, 30};

    const Result parts = average(mesh, result, Averaging::Part);
    const Result turned = to_cylindrical(mesh, parts, {{0, 0, 0}, {0, 0, 1}});

    EXPECT_EQ(turned.info.layer, Layer::Bottom);
    EXPECT_EQ(turned.info.location, Location::PartNodal);
    EXPECT_THAT(turned.row_owner, ElementsAre(0, 0, 1));
    EXPECT_EQ(turned.row_node, parts.row_node);
    // Node 1 is straight above: r = y, theta = -x.
    EXPECT_THAT(std::vector<float>(turned.values.begin(), turned.values.begin() + 3), ElementsAre(2, -1, 3));
    EXPECT_THAT(std::vector<float>(turned.values.begin() + 6, turned.values.end()), ElementsAre(20, -10, 30));
}

TEST(CylindricalSystem, takes_whole_vectors_and_tensors_but_no_amplitudes) {
    ResultInfo info = global_stress(wall()).info;
    EXPECT_TRUE(can_be_cylindrical(info));
    info.complex = Complex::Real;
    EXPECT_TRUE(can_be_cylindrical(info));
    info.complex = Complex::Amplitude;
    EXPECT_FALSE(can_be_cylindrical(info));
    EXPECT_FALSE(can_be_cylindrical(cylindrical_info(global_stress(wall()).info)));
}

TEST(CylindricalSystem, on_the_boiler_keeps_the_trace_and_equals_yy_where_hoop_is_y) {
    Diagnostics diagnostics;
    const std::vector<std::string> paths{test::project_file("examples/boiler/hex_linear/static.frd")};
    const auto model = open_model(paths, {}, diagnostics);
    const Mesh& mesh = model->mesh();
    for (std::size_t i = 0; i < model->results().size(); ++i) {
        if (model->results()[i].name != "stress") continue;
        const Result stress = model->load(i);
        const Result turned = to_cylindrical(mesh, stress, {});
        std::size_t along_x = 0;
        for (std::size_t node = 0; node < mesh.node_count(); ++node) {
            const float* from = &stress.values[node * stress.component_count()];
            const float* to = &turned.values[node * 6];
            if (std::hypot(mesh.coordinates[node][0], mesh.coordinates[node][1]) < 1e-6)
                continue;  // On the axis.
            EXPECT_NEAR(to[0] + to[1] + to[2], from[0] + from[1] + from[2], 1e-4);
            EXPECT_EQ(to[2], from[2]);
            if (mesh.coordinates[node][1] != 0 || mesh.coordinates[node][0] <= 0) continue;
            ++along_x;
            EXPECT_EQ(to[0], from[0]);
            EXPECT_EQ(to[1], from[1]);
        }
        EXPECT_GT(along_x, 20U);
        return;
    }
    FAIL() << "no stress";
}

}  // namespace
}  // namespace feelem
