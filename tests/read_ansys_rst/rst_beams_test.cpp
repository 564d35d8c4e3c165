// SPDX-License-Identifier: Apache-2.0
// Forces and stresses of beams, volumes and energies: SYNTHETIC files for where they stand, and the laws of
// mechanics for what they are in real files.
#include "model/vector.hpp"
#include "read_ansys_rst/opened_rst.hpp"
#include "support/paths.hpp"

#include "feelem/derive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace feelem {
namespace {

using test::load_wanted;
using test::open_written;
using test::OpenedRst;
using test::WrittenModel;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

constexpr std::size_t kSummable = 1, kStress = 3, kEnergy = 4, kElasticStrain = 6, kNotSummable = 13;

/// 1, 2, 3 ... times a factor: item n holds n.
std::vector<double> counted(std::size_t count, double factor = 1) {
    std::vector<double> values;
    for (std::size_t i = 1; i <= count; ++i) values.push_back(factor * static_cast<double>(i));
    return values;
}

/// Beams 1 (nodes 10, 20) and 2 (20, 30), with a third node for orientation.
WrittenModel two_beams(std::int32_t routine, std::vector<test::WrittenElementRecord> records) {
    WrittenModel model = test::two_bricks();
    model.types = {{routine, 2, 0, 0}};
    model.elements = {{1, 1, 1, {10, 20, 50}}, {2, 1, 1, {20, 30, 50}}};
    test::WrittenSet set;
    set.element_records = std::move(records);
    model.sets.push_back(set);
    return model;
}

TEST(RstBeams, items_of_beam188_stand_at_its_ends_under_their_numbers) {
    const OpenedRst opened =
        open_written(two_beams(188, {{0, kSummable, counted(164), 0}, {1, kSummable, counted(164, 1000), 0}})
        );
    const Result force = load_wanted(opened, {"beam_force"});
    EXPECT_THAT(force.info.components, ElementsAre("fx", "fy", "fz"));
    EXPECT_EQ(force.info.location, Location::ElementNodal);
    EXPECT_THAT(force.row_owner, ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(force.row_node, ElementsAre(NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{2}));
    EXPECT_THAT(force.values, ElementsAre(1, 6, 5, 14, 19, 18, 1000, 6000, 5000, 14000, 19000, 18000));
    const Result moment = load_wanted(opened, {"beam_moment"});
    EXPECT_THAT(
        std::vector(moment.values.begin(), moment.values.begin() + 6), ElementsAre(4, 2, 3, 17, 15, 16)
    );
    const Result stress = load_wanted(opened, {"beam_stress"});
    EXPECT_THAT(stress.info.components, ElementsAre("sdir", "sbyt", "sbyb", "sbzt", "sbzb"));
    EXPECT_EQ(stress.values[0], 31);
    EXPECT_EQ(stress.values[9], 40);
    EXPECT_EQ(load_wanted(opened, {"beam_strain"}).values[5], 46);
    EXPECT_FALSE(test::has_wanted(opened, {"stress"}));
    EXPECT_FALSE(test::has_wanted(opened, {"beam_stress_extremes"}));
}

TEST(RstBeams, items_of_beam4_stand_in_the_records_of_stress_and_strain) {
    const OpenedRst opened = open_written(two_beams(
        4,
        {{0, kSummable, counted(26), 0},
         {0, kStress, counted(10, 10), 0},
         {0, kElasticStrain, counted(10, 0.5), 0},
         {0, kNotSummable, counted(4, 7), 0}}
    ));
    EXPECT_THAT(load_wanted(opened, {"beam_force"}).values, ElementsAre(1, 2, 3, 7, 8, 9));
    EXPECT_THAT(load_wanted(opened, {"beam_moment"}).values, ElementsAre(4, 5, 6, 10, 11, 12));
    EXPECT_THAT(
        load_wanted(opened, {"beam_stress"}).values, ElementsAre(10, 20, 30, 40, 50, 60, 70, 80, 90, 100)
    );
    EXPECT_EQ(load_wanted(opened, {"beam_strain"}).values[5], 3);
    EXPECT_THAT(load_wanted(opened, {"beam_stress_extremes"}).values, ElementsAre(7, 14, 21, 28));
}

TEST(RstBeams, are_never_averaged_for_their_axes_differ) {
    const OpenedRst opened = open_written(two_beams(188, {{0, kSummable, counted(164), 0}}));
    const Result force = load_wanted(opened, {"beam_force"});
    const Result same = average(opened.model->mesh(), force, Averaging::Part);
    EXPECT_EQ(same.info.location, Location::ElementNodal);
    EXPECT_EQ(same.values, force.values);
}

TEST(RstBeams, a_record_too_short_for_its_items_is_left_out_and_counted) {
    const OpenedRst opened =
        open_written(two_beams(188, {{0, kSummable, counted(18), 0}, {1, kSummable, counted(19), 0}}));
    EXPECT_EQ(load_wanted(opened, {"beam_force"}).row_count(), 2u);
    EXPECT_EQ(opened.diagnostics->count(Code::ResultForPartOfModel), 1u);
}

TEST(RstBeams, lines_whose_order_of_items_was_not_proved_are_named_and_counted) {
    const OpenedRst opened = open_written(two_beams(180, {{0, kSummable, counted(30), 0}}));
    EXPECT_FALSE(test::has_wanted(opened, {"beam_force"}));
    ASSERT_EQ(opened.diagnostics->count(Code::UnknownBlock), 2u);
    EXPECT_THAT(
        opened.diagnostics->entries(),
        testing::Contains(testing::Field(&Diagnostic::text, HasSubstr("stresses of LINK180 are left out")))
    );
}

TEST(RstBeams, wait_to_be_asked_for_beside_shells) {
    WrittenModel model = two_beams(188, {{0, kSummable, counted(164), 0}});
    const auto on_request = [](const WrittenModel& written) {
        return load_wanted(open_written(written), {"beam_force"}).info.on_request;
    };
    EXPECT_FALSE(on_request(model));
    model.types.push_back({181, 4, 0, 2});
    model.elements.push_back({3, 2, 1, {10, 20, 50, 40}});
    EXPECT_TRUE(on_request(model));
}

TEST(RstEnergies, what_an_element_has_not_is_missing_and_what_none_has_is_not_listed) {
    constexpr double kNone = 0x1p-100;
    WrittenModel model = test::two_bricks();
    test::WrittenSet set;
    set.element_records = {{0, kEnergy, {2, 0, kNone, kNone}, 0}, {1, kEnergy, {3, kNone, kNone, kNone}, 0}};
    model.sets.push_back(set);
    const OpenedRst opened = open_written(model);
    const Result volume = load_wanted(opened, {"element_volume"});
    EXPECT_EQ(volume.info.location, Location::Elemental);
    EXPECT_TRUE(volume.info.on_request);
    EXPECT_THAT(volume.values, ElementsAre(2, 3));
    EXPECT_THAT(load_wanted(opened, {"strain_energy"}).values, ElementsAre(0, IsNan()));
    EXPECT_FALSE(test::has_wanted(opened, {"artificial_energy"}));
    EXPECT_FALSE(test::has_wanted(opened, {"kinetic_energy"}));
}

TEST(RstEnergies, of_other_fields_than_displacement_are_volumes_alone) {
    WrittenModel model = test::two_bricks();
    model.dofs = {20};
    test::WrittenSet set;
    set.element_records = {{0, kEnergy, {2, 5, 6, 7}, 0}};
    model.sets.push_back(set);
    const OpenedRst opened = open_written(model);
    EXPECT_TRUE(test::has_wanted(opened, {"element_volume"}));
    EXPECT_FALSE(test::has_wanted(opened, {"strain_energy"}));
}

TEST(RstEnergies, of_a_distributed_run_are_put_together_by_element) {
    WrittenModel first = test::two_bricks(), second = test::two_bricks();
    test::WrittenSet set;
    set.element_records = {{0, kEnergy, {2, 1, 1, 1}, 0}};
    first.nodes_of_all = second.nodes_of_all = 13;
    first.elements.resize(1);
    first.sets.push_back(set);
    second.elements.erase(second.elements.begin());
    set.element_records = {{0, kEnergy, {3, 1, 1, 1}, 0}};
    second.sets.push_back(set);
    const OpenedRst opened = open_written({first, second});
    EXPECT_THAT(load_wanted(opened, {"element_volume"}).values, ElementsAre(2, 3));
}

class RstBeamsOfCorpus : public testing::Test {
protected:
    void SetUp() override {
        if (!test::corpus_file("ansys/answers.json")) GTEST_SKIP() << "the corpus is not here";
    }
};

double at(const Result& result, std::size_t row, std::string_view component) {
    const auto c = static_cast<std::size_t>(component_index(result.info, component));
    return static_cast<double>(result.values[row * result.component_count() + c]);
}

/// The same to the rounding of single precision.
void expect_float(double found, double right) {
    EXPECT_NEAR(found, right, 5e-7 * std::abs(right) + 1e-30);
}

double length_of(const Mesh& mesh, const Result& result, std::size_t row) {
    const Point3 along =
        minus(mesh.coordinates[raw(result.row_node[row + 1])], mesh.coordinates[raw(result.row_node[row])]);
    return std::sqrt(dot(along, along));
}

// Equilibrium of each of the 40 beams, and stress out of force by the area that its volume gives.
TEST_F(RstBeamsOfCorpus, beam188_is_in_equilibrium_with_itself_and_with_its_support) {
    const OpenedRst opened = test::open_corpus({"rst/beams_v242.rst"});
    const Mesh& mesh = opened.model->mesh();
    const Result force = load_wanted(opened, {"beam_force"}), moment = load_wanted(opened, {"beam_moment"});
    const Result stress = load_wanted(opened, {"beam_stress"});
    const Result volume = load_wanted(opened, {"element_volume"});
    ASSERT_EQ(force.row_count(), 80u);
    EXPECT_EQ(force.info.unit, "lbf");
    EXPECT_EQ(stress.info.unit, "psi");
    for (std::size_t i = 0; i < 80; i += 2) {
        const double length = length_of(mesh, force, i);
        const double area = static_cast<double>(volume.values[force.row_owner[i]]) / length;
        EXPECT_NEAR(
            at(force, i, "fx") / area, at(stress, i, "sdir"), 1e-5 * std::abs(at(stress, i, "sdir")) + 1e-9
        );
        EXPECT_NEAR((at(moment, i, "mz") - at(moment, i + 1, "mz")) / length, at(force, i, "fy"), 1e-5);
        EXPECT_NEAR((at(moment, i + 1, "my") - at(moment, i, "my")) / length, at(force, i, "fz"), 1e-5);
        EXPECT_NEAR(at(moment, i, "mx"), at(moment, i + 1, "mx"), 1e-5);
        for (const std::size_t end : {i, i + 1}) {
            expect_float(at(stress, end, "sbyt"), -at(stress, end, "sbyb"));
            expect_float(at(stress, end, "sbzt"), -at(stress, end, "sbzb"));
            // A square section of area a: its section modulus is a^1.5 / 6.
            const double modulus = std::pow(area, 1.5) / 6;
            EXPECT_NEAR(
                at(stress, end, "sbyt"),
                -at(moment, end, "mz") / modulus,
                2e-3 * std::abs(at(stress, end, "sbyt")) + 1e-2
            );
            EXPECT_NEAR(
                at(stress, end, "sbzt"),
                at(moment, end, "my") / modulus,
                2e-3 * std::abs(at(stress, end, "sbzt")) + 1e-2
            );
        }
    }
    // The first beam runs along x from the only support: its force is the reaction with the other sign.
    const Result reaction = load_wanted(opened, {"reaction_force"});
    const auto reaction_in = [&](const char* axis) {
        return static_cast<double>(test::value_at(opened, reaction, 1, axis));
    };
    for (std::size_t row = 0; row < 80; ++row) {
        if (raw(mesh.node_ids[raw(force.row_node[row])]) != 1) continue;
        expect_float(at(force, row, "fx"), -reaction_in("x"));
        expect_float(std::abs(at(force, row, "fy")), std::abs(reaction_in("y")));
        expect_float(std::abs(at(force, row, "fz")), std::abs(reaction_in("z")));
    }
}

// Ansys writes the extremes itself: direct stress and the larger of both sides of both bendings.
TEST_F(RstBeamsOfCorpus, extremes_of_beam4_and_beam44_are_made_of_direct_and_bending_stresses) {
    for (const char* file : {"rst/beam44_v130.rst", "rst/shell63_beam4_v191.rst"}) {
        SCOPED_TRACE(file);
        const OpenedRst opened = test::open_corpus({file});
        const Result stress = load_wanted(opened, {"beam_stress"});
        const Result extremes = load_wanted(opened, {"beam_stress_extremes"});
        ASSERT_EQ(stress.row_count(), extremes.row_count());
        EXPECT_GE(stress.row_count(), 32u);
        for (std::size_t i = 0; i < stress.row_count(); ++i) {
            const auto s = [&](const char* name) { return at(stress, i, name); };
            const double most = s("sdir") + std::max(s("sbyt"), s("sbyb")) + std::max(s("sbzt"), s("sbzb"));
            const double least = s("sdir") + std::min(s("sbyt"), s("sbyb")) + std::min(s("sbzt"), s("sbzb"));
            const double rounding = 1e-6 * std::max(std::abs(most), std::abs(least)) + 1e-9;
            EXPECT_NEAR(at(extremes, i, "smax"), most, rounding);
            EXPECT_NEAR(at(extremes, i, "smin"), least, rounding);
        }
    }
}

TEST_F(RstBeamsOfCorpus, bending_of_beam44_balances_its_shear_force) {
    const OpenedRst opened = test::open_corpus({"rst/beam44_v130.rst"});
    const Result force = load_wanted(opened, {"beam_force"}), moment = load_wanted(opened, {"beam_moment"});
    ASSERT_EQ(force.row_count(), 32u);
    for (std::size_t i = 0; i < 32; i += 2) {
        const double length = length_of(opened.model->mesh(), force, i);
        EXPECT_NEAR((at(moment, i + 1, "my") - at(moment, i, "my")) / length, at(force, i, "fz"), 1e-3);
    }
}

double sum_of(const Result& result) {
    double sum = 0;
    for (const float value : result.values) sum += std::isnan(value) ? 0 : static_cast<double>(value);
    return sum;
}

TEST_F(RstBeamsOfCorpus, both_energies_of_a_mode_of_unit_mass_are_half_of_its_angular_frequency_squared) {
    const OpenedRst opened = test::open_corpus({"rst/hexbeam_v150/file.rst"});
    ASSERT_EQ(opened.model->steps().size(), 6u);
    for (std::uint32_t step = 0; step < 6; ++step) {
        const double omega = 2 * std::numbers::pi * opened.model->steps()[step].value;
        EXPECT_NEAR(
            sum_of(load_wanted(opened, {"strain_energy", step})), omega * omega / 2, 1e-5 * omega * omega
        );
        EXPECT_NEAR(
            sum_of(load_wanted(opened, {"kinetic_energy", step})), omega * omega / 2, 1e-5 * omega * omega
        );
    }
}

TEST_F(RstBeamsOfCorpus, volumes_of_solids_add_up_to_what_the_skin_encloses) {
    for (const auto& [file, volume] : std::map<const char*, double>{
             {"rst/solid185_v130.rst", 1.0},
             {"rst/static_v211.rst", 2.7e-5},
             {"rst/hexbeam_v150/file.rst", 5.0},
             {"workbench/two_cubes/file.rst", 2000.0}}) {
        const OpenedRst opened = test::open_corpus({file});
        EXPECT_NEAR(sum_of(load_wanted(opened, {"element_volume"})), volume, 1e-5 * volume) << file;
    }
}

// Ansys' own S1 S2 S3 SINT SEQV of each corner, in single precision.
TEST_F(RstBeamsOfCorpus, invariants_that_an_old_file_stores_equal_derived_ones) {
    const OpenedRst opened = test::open_corpus({"rst/solid185_v130.rst"});
    const Result stored = load_wanted(opened, {"stress"});
    ASSERT_EQ(stored.component_count(), 11u);
    ASSERT_EQ(stored.row_count(), 1000u);
    Result alone = stored;
    alone.info.components.resize(6);
    alone.values.clear();
    for (std::size_t row = 0; row < stored.row_count(); ++row) {
        const auto from = stored.values.begin() + static_cast<std::ptrdiff_t>(11 * row);
        alone.values.insert(alone.values.end(), from, from + 6);
    }
    for (const char* name : {"principal_1", "principal_2", "principal_3", "tresca", "von_mises"}) {
        const Result ours = component_of(alone, name), theirs = component_of(stored, name);
        for (std::size_t row = 0; row < 1000; ++row) {
            // Stresses reach 3.5e8: a difference of them has their rounding.
            ASSERT_NEAR(ours.values[row], theirs.values[row], 64) << name << " of row " << row;
        }
    }
}

}  // namespace
}  // namespace feelem
