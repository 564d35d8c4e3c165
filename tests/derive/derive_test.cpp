// SPDX-License-Identifier: Apache-2.0
#include "derive/tensor.hpp"
#include "support/meshes.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

namespace feelem {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const float kNan = std::numeric_limits<float>::quiet_NaN();

Result vector_result(std::vector<float> values) {
    Result result;
    result.info.name = "displacement";
    result.info.components = {"x", "y", "z"};
    result.info.shape = Shape::Vector;
    result.values = std::move(values);
    return result;
}

Result tensor_result(std::string name, std::vector<float> values) {
    Result result;
    result.info.name = std::move(name);
    result.info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
    result.info.shape = Shape::SymmetricTensor;
    result.values = std::move(values);
    return result;
}

TEST(Derive, magnitude_of_a_vector) {
    const Result magnitude = component_of(vector_result({3, 4, 12, 0, 0, kNan}), "magnitude");

    ASSERT_EQ(magnitude.values.size(), 2U);
    EXPECT_EQ(magnitude.values[0], 13);
    EXPECT_TRUE(std::isnan(magnitude.values[1]));
    EXPECT_THAT(magnitude.info.components, ElementsAre("magnitude"));
    EXPECT_EQ(magnitude.info.shape, Shape::Scalar);
}

TEST(Derive, a_stored_component_comes_out_bit_for_bit) {
    EXPECT_THAT(component_of(vector_result({1, 2.5F, 3, 4, 5.25F, 6}), "y").values, ElementsAre(2.5F, 5.25F));
}

TEST(Derive, uniaxial_tension_and_pure_shear_have_the_text_book_equivalents) {
    const Result stress = tensor_result("stress", {100, 0, 0, 0, 0, 0, 0, 0, 0, 50, 0, 0});

    EXPECT_THAT(
        component_of(stress, "von_mises").values, ElementsAre(100, static_cast<float>(50 * std::sqrt(3.0)))
    );
    EXPECT_THAT(component_of(stress, "tresca").values, ElementsAre(100, 100));
    EXPECT_THAT(component_of(stress, "principal_1").values, ElementsAre(100, 50));
    EXPECT_THAT(component_of(stress, "principal_2").values, ElementsAre(0, 0));
    EXPECT_THAT(component_of(stress, "principal_3").values, ElementsAre(0, -50));
}

TEST(Derive, hydrostatic_stress_has_no_equivalent_stress) {
    const Result stress = tensor_result("stress", {-7, -7, -7, 0, 0, 0});

    EXPECT_THAT(component_of(stress, "von_mises").values, ElementsAre(0));
    EXPECT_THAT(component_of(stress, "tresca").values, ElementsAre(0));
    EXPECT_THAT(component_of(stress, "principal_1").values, ElementsAre(-7));
}

TEST(Derive, several_components_at_once_are_each_what_it_is_alone) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(-100, 100);
    Result stress = tensor_result("stress", {});
    for (int i = 0; i < 6 * 9000; ++i) stress.values.push_back(number(random));
    stress.values[6 * 5000] = kNan;
    stress.info.shear = Shear::Engineering;
    const std::vector<std::string_view> names{"tresca", "zz", "principal_3", "von_mises", "principal_2"};

    const std::vector<Result> together = components_of(stress, names);

    ASSERT_EQ(together.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Result alone = component_of(stress, names[i]);
        EXPECT_THAT(together[i].info.components, ElementsAre(names[i]));
        EXPECT_EQ(together[i].info.shear, alone.info.shear);
        ASSERT_EQ(together[i].values.size(), 9000U);
        EXPECT_EQ(std::isnan(together[i].values[5000]), names[i] != "zz");
        EXPECT_EQ(
            std::memcmp(together[i].values.data(), alone.values.data(), sizeof(float) * alone.values.size()),
            0
        ) << names[i];
    }
    const std::array row{5.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F};
    EXPECT_EQ(component_of(tensor_result("stress", {row.begin(), row.end()}), "principal_1").values[0], 5.0F);
    EXPECT_THAT(made_of_principals(stress.info, names), ElementsAre("tresca", "principal_3", "principal_2"));
}

TEST(Derive, equivalents_are_made_for_stress_alone) {
    const Result strain = tensor_result("strain", {1, 2, 3, 0, 0, 0});

    EXPECT_THAT(derivable_components(strain.info), ElementsAre("principal_1", "principal_2", "principal_3"));
    EXPECT_THROW(component_of(strain, "von_mises"), Error);
    EXPECT_THAT(derivable_components(vector_result({}).info), ElementsAre("magnitude"));
}

TEST(Derive, what_the_file_lists_itself_is_not_derived) {
    Result stress = tensor_result("stress", {100, 0, 0, 0, 0, 0, 99.5F});
    stress.info.components.emplace_back("von_mises");

    EXPECT_THAT(
        derivable_components(stress.info), ElementsAre("tresca", "principal_1", "principal_2", "principal_3")
    );
    EXPECT_THAT(component_of(stress, "von_mises").values, ElementsAre(99.5F));
    EXPECT_THAT(component_of(stress, "principal_1").values, ElementsAre(100));
}

TEST(Derive, parts_of_complex_results_have_no_invariants) {
    for (const Complex part : {Complex::Real, Complex::Imaginary, Complex::Amplitude, Complex::Phase}) {
        Result displacement = vector_result({1, 2, 3});
        displacement.info.complex = part;
        EXPECT_THAT(derivable_components(displacement.info), IsEmpty());
        EXPECT_THROW(component_of(displacement, "magnitude"), Error);
    }
}

TEST(Derive, engineering_shear_is_halved_before_principals) {
    Result strain = tensor_result("strain", {0, 0, 0, 2, 0, 0});
    strain.info.shear = Shear::Engineering;
    EXPECT_THAT(component_of(strain, "principal_1").values, ElementsAre(1));

    strain.info.shear = Shear::Tensor;
    EXPECT_THAT(component_of(strain, "principal_1").values, ElementsAre(2));
}

TEST(Derive, an_unknown_component_is_refused_with_the_known_ones) {
    try {
        component_of(vector_result({1, 2, 3}), "magnitud");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnknownName);
        EXPECT_THAT(error.what(), testing::HasSubstr("x y z magnitude"));
    }
}

TEST(Eigenvalues, are_found_for_tensors_built_from_them_near_equal_ones_too) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> angle(-180, 180);
    const std::array<double, 3> cases[]{
        {3, 2, 1},
        {1 + 1e-9, 1, 1 - 1e-9},
        {1, 1, 1},
        {1e8, 1, -1e8},
        {5, 5, -1},
        {0, 0, 0},
        {1e-30, 1e-31, -1e-30},
        {1e30, 3e29, -1e30}};
    for (const auto& expected : cases) {
        for (int i = 0; i < 100; ++i) {
            const Matrix3 axes = nodal_axes({angle(random), angle(random), angle(random)});
            const auto found =
                eigenvalues(to_global(axes, Tensor6{expected[0], expected[1], expected[2], 0, 0, 0}));
            const double size = std::max(std::abs(expected[0]), std::abs(expected[2]));
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 4e-15 * size);
        }
    }
}

/// Two bricks side by side in parts a and b; values are 10 in a, 20 and 30 in b's rows at the shared nodes.
Mesh two_parts() {
    return test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}, "a"},
         {ElementType::Quad4, {2, 5, 6, 3}, "b"},
         {ElementType::Tri3, {2, 5, 3}, "b"}}
    );
}

Result unaveraged() {
    Result result;
    result.info.name = "stress";
    result.info.components = {"value"};
    result.info.location = Location::ElementNodal;
    result.info.averaging = Averaging::None;
    result.row_owner = {0, 0, 1, 1, 2};
    result.row_node = {NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{4}, NodeIndex{1}};
    result.values = {1, 10, 20, kNan, 31};
    return result;
}

TEST(Average, is_the_mean_of_the_elements_values_within_a_part) {
    const Result result = average(two_parts(), unaveraged(), Averaging::Part);

    EXPECT_EQ(result.info.location, Location::PartNodal);
    EXPECT_EQ(result.info.averaging, Averaging::Part);
    EXPECT_THAT(result.row_owner, ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(result.row_node, ElementsAre(NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{4}));
    EXPECT_THAT(result.values, ElementsAre(1, 10, 25.5F, testing::IsNan()));
}

TEST(Average, over_all_parts_gives_one_value_a_node) {
    const Result result = average(two_parts(), unaveraged(), Averaging::All);

    EXPECT_EQ(result.info.location, Location::Nodal);
    ASSERT_EQ(result.values.size(), 6U);
    EXPECT_EQ(result.values[0], 1);
    EXPECT_EQ(result.values[1], static_cast<float>(61.0 / 3));
    EXPECT_TRUE(std::isnan(result.values[2]));
    EXPECT_TRUE(std::isnan(result.values[4]));
}

TEST(Average, leaves_averaged_results_alone) {
    Result result = vector_result({1, 2, 3});
    result.info.averaging = Averaging::Solver;

    EXPECT_EQ(average(two_parts(), result, Averaging::Part).info.averaging, Averaging::Solver);
    EXPECT_EQ(average(two_parts(), unaveraged(), Averaging::None).info.location, Location::ElementNodal);
}

/// Six components (and more) at the nodes that two_parts()'s elements share.
Result unaveraged_tensor(std::vector<std::string> components, std::vector<float> values) {
    Result result = unaveraged();
    result.info.components = std::move(components);
    result.info.shape = Shape::SymmetricTensor;
    result.row_owner = {0, 1};
    result.row_node = {NodeIndex{1}, NodeIndex{1}};
    result.values = std::move(values);
    return result;
}

TEST(Average, invariants_are_those_of_the_mean_not_means_of_invariants) {
    // Pull in one element, push in its neighbour: the file says 100 in both, the mean is free of stress.
    const Result result = unaveraged_tensor(
        {"xx", "yy", "zz", "xy", "yz", "zx", "von_mises", "temperature"},
        {100, 0, 0, 0, 0, 0, 100, 20, -100, 0, 0, 0, 0, 0, 100, 40}
    );
    EXPECT_EQ(component_of(result, "von_mises").values[1], 100) << "of elements the file's own";

    const Result all = average(two_parts(), result, Averaging::All);

    EXPECT_THAT(all.info.components, ElementsAre("xx", "yy", "zz", "xy", "yz", "zx", "temperature"));
    EXPECT_EQ(component_of(all, "von_mises").values[1], 0);
    EXPECT_EQ(component_of(all, "temperature").values[1], 30);
    EXPECT_EQ(averaged_info(result.info, Averaging::All).components, all.info.components);
    const Result parts = average(two_parts(), result, Averaging::Part);
    EXPECT_EQ(component_of(parts, "von_mises").values[0], 100) << "alone in its part";
}

TEST(Average, a_missing_component_does_not_take_the_others_with_it) {
    const Result result =
        unaveraged_tensor({"xx", "yy", "zz", "xy", "yz", "zx"}, {1, 2, 3, 4, 5, 6, 3, kNan, 5, 6, 7, kNan});

    const Result all = average(two_parts(), result, Averaging::All);

    EXPECT_THAT(
        std::vector<float>(all.values.begin() + 6, all.values.begin() + 12), ElementsAre(2, 2, 4, 5, 6, 6)
    );
}

TEST(Average, nodes_of_elements_without_values_have_none_and_no_row_in_their_part) {
    Result result = unaveraged();
    result.row_owner = {0};
    result.row_node = {NodeIndex{1}};
    result.values = {10};

    const Result parts = average(two_parts(), result, Averaging::Part);
    EXPECT_THAT(parts.row_owner, ElementsAre(0)) << "part b shares node 2, and has no value there";
    EXPECT_THAT(parts.values, ElementsAre(10));
    const Result all = average(two_parts(), result, Averaging::All);
    for (std::size_t node = 0; node < 6; ++node) EXPECT_EQ(std::isnan(all.values[node]), node != 1) << node;
}

TEST(Average, one_element_alone_keeps_its_value_bit_for_bit) {
    Result result = unaveraged();
    result.values = {0.1F, 1e-38F, 3.4e38F, -0.3F, 3.4e38F};

    const Result parts = average(two_parts(), result, Averaging::Part);

    EXPECT_EQ(parts.values[0], 0.1F);
    EXPECT_EQ(parts.values[1], 1e-38F);
    EXPECT_EQ(parts.values[2], 3.4e38F) << "two of the largest do not overflow";
    EXPECT_EQ(parts.values[3], -0.3F);
}

TEST(Average, a_layer_stays_a_layer) {
    Result top = unaveraged();
    top.info.layer = Layer::Top;
    top.info.corner_only = true;
    top.info.unit = "MPa";
    for (const Averaging averaging : {Averaging::Part, Averaging::All}) {
        const Result mean = average(two_parts(), top, averaging);
        EXPECT_EQ(mean.info.layer, Layer::Top);
        EXPECT_TRUE(mean.info.corner_only);
        EXPECT_EQ(mean.info.unit, "MPa");
    }
}

TEST(Average, results_along_the_axes_of_each_element_are_left_alone) {
    Result force = unaveraged();
    force.info.averaging = Averaging::NotApplicable;

    for (const Averaging averaging : {Averaging::Part, Averaging::All}) {
        const Result same = average(two_parts(), force, averaging);
        EXPECT_EQ(same.info.location, Location::ElementNodal);
        EXPECT_EQ(same.row_owner, force.row_owner);
        EXPECT_EQ(averaged_info(force.info, averaging).location, Location::ElementNodal);
    }
}

TEST(NodalSystem, one_angle_turns_about_its_axis) {
    Mesh mesh = test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Tri3, {1, 2, 3}}});
    mesh.node_angles = {{90, 0, 0}, {0, 90, 0}, {0, 0, 90}};
    Result local = vector_result({1, 2, 3, 1, 2, 3, 1, 2, 3});
    local.info.nodal_system = true;

    const Result global = to_global(mesh, local);

    // THXY turns x to y, THYZ y to z, THZX z to x.
    EXPECT_THAT(global.values, ElementsAre(-2, 1, 3, 1, -3, 2, 3, 2, -1));
    EXPECT_FALSE(global.info.nodal_system);
}

TEST(NodalSystem, angles_are_taken_about_z_then_the_new_x_then_the_newest_y) {
    // Z by 90: X' = y, Y' = -x. X' by 90: Y'' = z, Z'' = x. Y'' by 90: X''' = -Z'' = -x, Z''' = X'' = y.
    const Matrix3 axes = nodal_axes({90, 90, 90});

    EXPECT_THAT(to_global(axes, std::array<double, 3>{1, 0, 0}), ElementsAre(-1, 0, 0));
    EXPECT_THAT(to_global(axes, std::array<double, 3>{0, 1, 0}), ElementsAre(0, 0, 1));
    EXPECT_THAT(to_global(axes, std::array<double, 3>{0, 0, 1}), ElementsAre(0, 1, 0));
}

TEST(NodalSystem, tensors_turn_too_and_engineering_shear_stays_engineering) {
    Mesh mesh = test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Tri3, {1, 2, 3}}});
    mesh.node_angles = {{90, 0, 0}, {45, 0, 0}, {0, 0, 0}};
    Result local = tensor_result("strain", {1, 2, 3, 4, 5, 6, 1, -1, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6});
    local.info.nodal_system = true;
    local.info.shear = Shear::Engineering;

    const Result global = to_global(mesh, local);

    const std::vector<float> first(global.values.begin(), global.values.begin() + 6);
    EXPECT_THAT(first, ElementsAre(2, 1, 3, -4, 6, -5));
    EXPECT_NEAR(global.values[6], 0, 1e-15);
    EXPECT_NEAR(global.values[9], 2, 1e-6);  // twice the tensor's 1
    const std::vector<float> last(global.values.begin() + 12, global.values.end());
    EXPECT_THAT(last, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(NodalSystem, a_missing_component_spoils_only_what_it_takes_part_in) {
    Mesh mesh = test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Tri3, {1, 2, 3}}});
    mesh.node_angles = {{90, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    Result local = vector_result({1, 2, kNan, 1, 2, kNan, 1, 2, kNan});
    local.info.nodal_system = true;

    const Result global = to_global(mesh, local);

    EXPECT_EQ(global.values[0], -2);
    EXPECT_EQ(global.values[1], 1);
    EXPECT_TRUE(std::isnan(global.values[2]));
}

TEST(NodalSystem, results_in_the_global_system_stay_as_they_are) {
    Mesh mesh = test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Tri3, {1, 2, 3}}});
    mesh.node_angles = {{90, 0, 0}, {90, 0, 0}, {90, 0, 0}};

    EXPECT_THAT(to_global(mesh, vector_result({1, 2, 3})).values, ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace feelem
