// SPDX-License-Identifier: Apache-2.0
// Cyclic models with all their sectors: SYNTHETIC ones and two real files, a static one and modes.
#include "read_ansys_rst/opened_rst.hpp"

#include "feelem/derive.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace feelem {
namespace {

using test::load_wanted;
using test::open_written;
using test::OpenedRst;
using test::value_at;
using test::WrittenModel;
using test::WrittenSet;

const ReadOptions kExpand{.from = {}, .types = {}, .expand_cyclic = true};

/// A quarter of a ring of four bricks: nodes 1 to 4 at y = 0, 5 to 8 at x = 0.
WrittenModel quarter() {
    WrittenModel model;
    model.types = {{185, 8, 0, 0}};
    const std::array<std::array<double, 2>, 4> section{{{1, 0}, {2, 0}, {2, 1}, {1, 1}}};
    for (int side = 0; side < 2; ++side) {
        for (int k = 0; k < 4; ++k) {
            const auto [radius, z] = section[static_cast<std::size_t>(k)];
            const int id = 4 * side + k + 1;
            model.nodes.push_back({double(id), side == 0 ? radius : 0, side == 0 ? 0 : radius, z, 0, 0, 0});
            model.storage.push_back(id);
        }
    }
    model.elements = {{1, 1, 1, {1, 2, 6, 5, 4, 3, 7, 8}}};
    model.sectors = 4;
    model.has_axis = true;
    model.sector_nodes = 8;
    model.sector_elements = 1;
    return model;
}

/// Radial motion, the same all round.
WrittenSet breathing() {
    WrittenSet set;
    for (int side = 0; side < 2; ++side) {
        for (int k = 0; k < 4; ++k) {
            set.solution.push_back(side == 0 ? k + 1 : 0);
            set.solution.push_back(side == 0 ? 0 : k + 1);
            set.solution.push_back(0.5);
        }
    }
    return set;
}

/// All nodes move along one direction: the harmonic index 1.
WrittenSet sideways(double x, double y) {
    WrittenSet set;
    for (int node = 0; node < 8; ++node) set.solution.insert(set.solution.end(), {x, y, 0});
    return set;
}

TEST(RstCyclic, sectors_share_nodes_and_make_a_closed_ring) {
    WrittenModel model = quarter();
    model.sets = {breathing()};
    const OpenedRst opened = open_written(model, kExpand);
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 16u);
    EXPECT_EQ(mesh.element_count(), 4u);
    Diagnostics ignored;
    const Surface surface = make_skin(mesh, {}, ignored);
    EXPECT_TRUE(surface.report.closed);
    EXPECT_EQ(surface.report.solid_quad_kept, 16u);
    // Sector 2 stands for 180 degrees; its nodes are 21 to 24.
    EXPECT_EQ(mesh.coordinates[raw(find_node(mesh, NodeId{22}))], (Point3{-2, 0, 0}));
    EXPECT_EQ(find_node(mesh, NodeId{25}), kNoNode);  // It is node 31.
}

TEST(RstCyclic, vectors_and_tensors_turn_with_their_sector) {
    WrittenModel model = quarter();
    model.sets = {breathing()};
    std::vector<double> stress;
    for (int k = 0; k < 8; ++k) stress.insert(stress.end(), {1, 2, 3, 4, 5, 6});
    model.sets[0].element_records.push_back({0, 3, stress, 0});
    const OpenedRst opened = open_written(model, kExpand);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_EQ(value_at(opened, u, 2, "x"), 2.0F);
    EXPECT_EQ(value_at(opened, u, 12, "y"), 2.0F);
    EXPECT_EQ(value_at(opened, u, 22, "x"), -2.0F);
    EXPECT_EQ(value_at(opened, u, 32, "y"), -2.0F);
    EXPECT_EQ(value_at(opened, u, 32, "z"), 0.5F);
    const Result tensor = load_wanted(opened, {"stress"});
    ASSERT_EQ(tensor.row_count(), 32u);
    const std::array<float, 6> quarter_turn{2, 1, 3, -4, 6, -5};
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(tensor.values[8 * 6 + c], quarter_turn[c]) << c;
}

TEST(RstCyclic, pair_of_modes_runs_round_as_a_wave) {
    WrittenModel model = quarter();
    model.analysis = 2;
    // A moves along x, so that the second sector, seen from itself, moves against y: B there is +-y.
    model.sets = {sideways(1, 0), sideways(0, 1)};
    model.sets[1].substep = 2;
    model.harmonics = {1, -1};
    const OpenedRst opened = open_written(model, kExpand);
    EXPECT_FALSE(opened.diagnostics->has(Code::StepsLeftOut));
    for (const std::uint32_t step : {0U, 1U}) {
        const Result u = load_wanted(opened, {"displacement", step});
        for (const NodeId id : opened.model->mesh().node_ids) {
            // The whole ring moves as one.
            EXPECT_NEAR(value_at(opened, u, raw(id), step == 0 ? "x" : "y"), 1.0F, 1e-6F) << raw(id);
            EXPECT_NEAR(value_at(opened, u, raw(id), step == 0 ? "y" : "x"), 0.0F, 1e-6F) << raw(id);
        }
    }
}

TEST(RstCyclic, steps_that_do_not_run_on_are_left_out_and_said) {
    WrittenModel model = quarter();
    model.analysis = 2;
    model.sets = {sideways(1, 0), breathing(), sideways(1, 0)};
    for (int i = 0; i < 3; ++i) model.sets[static_cast<std::size_t>(i)].substep = i + 1;
    model.sets[2].time = 7;       // No other mode has its frequency.
    model.harmonics = {0, 0, 1};  // The first one is not what it says.
    const OpenedRst opened = open_written(model, kExpand);
    EXPECT_EQ(opened.diagnostics->count(Code::StepsLeftOut), 2u);
    EXPECT_FALSE(test::has_wanted(opened, {"displacement", 0}));
    EXPECT_TRUE(test::has_wanted(opened, {"displacement", 1}));
    EXPECT_FALSE(test::has_wanted(opened, {"displacement", 2}));
    EXPECT_EQ(opened.model->steps().size(), 3u);
}

TEST(RstCyclic, half_of_the_sectors_move_against_the_others_at_the_highest_index) {
    WrittenModel model = quarter();
    model.analysis = 2;
    model.sets = {breathing()};
    // Seen from its own sector each side moves against the other.
    for (std::size_t i = 12; i < 24; ++i) model.sets[0].solution[i] *= -1;
    model.harmonics = {2};
    const OpenedRst opened = open_written(model, kExpand);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_EQ(value_at(opened, u, 2, "x"), 2.0F);
    EXPECT_NEAR(value_at(opened, u, 12, "y"), -2.0F, 1e-6F);
    EXPECT_NEAR(value_at(opened, u, 22, "x"), -2.0F, 1e-6F);
}

TEST(RstCyclic, second_sector_of_the_file_is_b_and_is_not_drawn) {
    WrittenModel model = quarter();
    model.analysis = 2;
    for (int i = 0; i < 8; ++i) {
        model.nodes.push_back(model.nodes[static_cast<std::size_t>(i)]);
        model.nodes.back()[0] += 8;
        model.storage.push_back(9 + i);
    }
    model.elements.push_back({2, 1, 1, {9, 10, 14, 13, 12, 11, 15, 16}});
    model.sets = {sideways(1, 0)};
    const WrittenSet b = sideways(0, -1);
    model.sets[0].solution.insert(model.sets[0].solution.end(), b.solution.begin(), b.solution.end());
    model.harmonics = {1};
    const OpenedRst opened = open_written(model, kExpand);
    EXPECT_EQ(opened.model->mesh().element_count(), 4u);
    const Result u = load_wanted(opened, {"displacement"});
    for (const NodeId id : opened.model->mesh().node_ids)
        EXPECT_NEAR(value_at(opened, u, raw(id), "x"), 1.0F, 1e-6F) << raw(id);
}

TEST(RstCyclic, without_an_axis_the_sector_stays_alone) {
    WrittenModel model = quarter();
    model.has_axis = false;
    model.sets = {breathing()};
    const OpenedRst opened = open_written(model, kExpand);
    EXPECT_EQ(opened.model->mesh().node_count(), 8u);
    EXPECT_TRUE(opened.diagnostics->has(Code::ResultForPartOfModel));
    model = quarter();
    model.sets = {breathing()};
    model.sectors = 2147483647;
    EXPECT_EQ(open_written(model, kExpand).model->mesh().node_count(), 8u);
    model.sectors = 5;  // Its sides do not meet at 72 degrees.
    EXPECT_EQ(open_written(model, kExpand).model->mesh().node_count(), 8u);
}

TEST(RstCyclic, sector_is_shown_alone_unless_asked) {
    WrittenModel model = quarter();
    model.sets = {breathing()};
    const OpenedRst opened = open_written(model);
    EXPECT_EQ(opened.model->mesh().node_count(), 8u);
    EXPECT_TRUE(opened.diagnostics->has(Code::ResultForPartOfModel));
}

double largest_magnitude(const Result& u) {
    double most = 0;
    for (std::size_t row = 0; row < u.row_count(); ++row) {
        const float* v = u.values.data() + 3 * row;
        most = std::fmax(most, std::hypot(double(v[0]), double(v[1]), double(v[2])));
    }
    return most;
}

TEST(RstCyclic, real_modes_of_all_harmonic_indexes_fit) {
    const OpenedRst opened = test::open_corpus({"rst/cyclic_modal_v202.rst"}, kExpand);
    if (!opened.model) GTEST_SKIP() << "the corpus is not here";
    EXPECT_FALSE(opened.diagnostics->has(Code::StepsLeftOut));
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.element_count(), 32u);
    Diagnostics ignored;
    const Surface surface = make_skin(mesh, {}, ignored);
    EXPECT_TRUE(surface.report.closed);
    // The file's sector stands as it is.
    EXPECT_FLOAT_EQ(value_at(opened, load_wanted(opened, {"displacement", 0}), 17, "y"), 267.36043F);
    // Two modes of one frequency are one shape, turned: they reach equally far.
    for (std::uint32_t step = 6; step < 24; step += 2) {
        const double first = largest_magnitude(load_wanted(opened, {"displacement", step}));
        const double second = largest_magnitude(load_wanted(opened, {"displacement", step + 1}));
        EXPECT_NEAR(first, second, 1e-5 * first) << step;
    }
}

TEST(RstCyclic, real_static_model_is_the_same_in_each_sector) {
    const OpenedRst opened = test::open_corpus({"rst/rotated_nodes_cyclic_v242.rst"}, kExpand);
    if (!opened.model) GTEST_SKIP() << "the corpus is not here";
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.element_count(), 8u * 384);
    EXPECT_EQ(mesh.node_count(), 8u * (636 - 32));
    Diagnostics ignored;
    const Surface surface = make_skin(mesh, {}, ignored);
    EXPECT_TRUE(surface.report.closed);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_FALSE(u.info.nodal_system);
    for (const std::int64_t node : {695, 245, 589}) {
        const auto radius = [&](std::int64_t id) {
            return std::hypot(value_at(opened, u, id, "x"), value_at(opened, u, id, "y"));
        };
        for (int s = 1; s < 8; ++s)
            EXPECT_NEAR(radius(node + 1000 * s), radius(node), 1e-5F * radius(node)) << node << " " << s;
    }
    const Result stress = average(mesh, load_wanted(opened, {"stress"}), Averaging::All);
    // A quarter turn away x and y have changed places.
    EXPECT_NEAR(value_at(opened, stress, 2589, "yy"), value_at(opened, stress, 589, "xx"), 0.01F);
    EXPECT_NEAR(value_at(opened, stress, 589, "xx"), 1245.1144F, 0.01F);
}

}  // namespace
}  // namespace feelem
