// SPDX-License-Identifier: Apache-2.0
// Which result drives which sense when nobody has said so.
#include "feelem/present.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace feelem {
namespace {

using ::testing::ElementsAre;

const Candidate kTemperature{.name = "temperature", .component = "value", .unit = "degC"};
const Candidate kDisplacement{.name = "displacement", .component = "magnitude", .unit = "mm"};
const Candidate kStress{.name = "stress", .component = "von_mises", .unit = "MPa"};
const Candidate kPlasticStrain{.name = "plastic_strain", .component = "von_mises"};

std::string_view word(Sense sense) {
    return std::array<std::string_view, 5>{"colour", "pitch", "ticks", "pulses", "shape"}.at(
        static_cast<std::size_t>(sense)
    );
}
/// "T colour": what drives what.
std::vector<std::string> assignment(const Presentation& presentation) {
    std::vector<std::string> all;
    for (const PresentedEffect& effect : presentation.effects) {
        all.push_back(effect.result + " " + std::string(word(effect.sense)));
    }
    return all;
}
Presentation chosen(std::vector<Candidate> candidates) {
    return choose_presentation(candidates, "model");
}

TEST(Choose, temperature_and_displacement_are_seen_and_heard_as_in_the_paper) {
    EXPECT_THAT(assignment(chosen({kDisplacement, kTemperature})), ElementsAre("T colour", "U pitch"));
}

TEST(Choose, stress_is_felt_beside_them) {
    const Presentation p = chosen({kTemperature, kDisplacement, kStress});

    EXPECT_THAT(assignment(p), ElementsAre("T colour", "U pitch", "S pulses"));
    EXPECT_EQ(p.deformation_result, "U");
    EXPECT_EQ(p.results[2].range_mode, "percentile");
    EXPECT_EQ(p.results[0].range_mode, "auto");
    EXPECT_THAT(p.card, ElementsAre("T", "U", "S"));
    EXPECT_TRUE(p.effects[2].falls_back_to_ticks);
}

TEST(Choose, fourth_result_ticks) {
    EXPECT_THAT(
        assignment(chosen({kPlasticStrain, kTemperature, kDisplacement, kStress})),
        ElementsAre("T colour", "U pitch", "S pulses", "PE ticks")
    );
}

TEST(Choose, fifth_result_is_left_to_the_card_of_numbers) {
    const Presentation p = chosen(
        {kTemperature, kDisplacement, kStress, kPlasticStrain, {.name = "damage", .component = "value"}}
    );

    EXPECT_EQ(p.results.size(), 4U);
    EXPECT_EQ(p.effects.size(), 4U);
}

TEST(Choose, static_model_sees_stress_and_hears_displacement) {
    EXPECT_THAT(assignment(chosen({kDisplacement, kStress})), ElementsAre("S colour", "U pitch"));
}

TEST(Choose, single_result_is_seen_and_heard) {
    EXPECT_THAT(assignment(chosen({kDisplacement})), ElementsAre("U colour", "U pitch"));
    EXPECT_EQ(chosen({kDisplacement}).deformation_result, "U");
}

TEST(Choose, most_telling_component_speaks_for_a_result) {
    const Presentation p = chosen({
        {.name = "displacement", .component = "x", .has_sign = true},
        {.name = "displacement", .component = "magnitude"},
        {.name = "stress", .component = "xx", .has_sign = true},
        {.name = "stress", .component = "principal_1", .has_sign = true},
        {.name = "stress", .component = "von_mises"},
    });

    ASSERT_EQ(p.results.size(), 2U);
    EXPECT_EQ(p.results[0].component, "magnitude");
    EXPECT_EQ(p.results[1].component, "von_mises");
}

TEST(Choose, signed_stress_gets_a_diverging_map_and_a_symmetric_range_and_never_a_rate) {
    const Presentation p = chosen({{.name = "stress", .component = "xx", .has_sign = true}, kDisplacement});

    EXPECT_THAT(assignment(p), ElementsAre("S colour", "U pitch"));
    EXPECT_EQ(p.effects[0].colour.map, "cool_warm");
    EXPECT_EQ(p.results[1].scale, Scale::Signed);
    EXPECT_TRUE(p.results[1].symmetric);
}

TEST(Choose, temperature_below_zero_is_no_signed_result) {
    Candidate frost = kTemperature;
    frost.has_sign = true;

    EXPECT_EQ(chosen({frost}).results[0].scale, Scale::Linear);
    EXPECT_EQ(chosen({frost}).effects[0].colour.map, "batlow");
}

TEST(Choose, mostly_zero_field_is_felt_or_ticks_rather_than_seen) {
    Candidate plastic = kPlasticStrain;
    plastic.mostly_zero = true;

    EXPECT_THAT(
        assignment(chosen({plastic, kDisplacement, kStress})), ElementsAre("S colour", "U pitch", "PE ticks")
    );
}

TEST(Choose, low_safety_factor_is_the_alarm) {
    const Presentation p = chosen({{.name = "safety_factor", .component = "value"}});

    EXPECT_TRUE(p.effects[0].colour.invert);
}

TEST(Choose, ids_are_never_heard) {
    const Presentation alone = chosen({{.name = "material_id", .component = "value"}});
    const Presentation beside =
        chosen({{.name = "thickness", .component = "value"}, kTemperature, kDisplacement});

    EXPECT_THAT(assignment(alone), ElementsAre("M colour"));
    EXPECT_THAT(assignment(beside), ElementsAre("T colour", "U pitch"));
}

TEST(Choose, results_of_two_files_keep_keys_of_their_own) {
    const Presentation p = chosen({
        {.name = "temperature@a.frd", .component = "value"},
        {.name = "temperature@b.frd", .component = "value"},
    });

    EXPECT_THAT(assignment(p), ElementsAre("T colour", "T2 pitch"));
    EXPECT_EQ(p.results[1].name, "temperature@b.frd");
}

TEST(Choose, nothing_to_show_is_an_empty_presentation) {
    EXPECT_TRUE(chosen({}).effects.empty());
    EXPECT_TRUE(chosen({}).results.empty());
    EXPECT_EQ(chosen({}).title, "model");
}

TEST(Choose, whatever_is_offered_gives_a_presentation_that_reads_back) {
    const std::vector<std::string> names{
        "temperature",
        "displacement",
        "stress",
        "heat_flux",
        "pressure",
        "velocity",
        "Ünknown",
        "safety_factor",
        "part_id",
        ""};
    const std::vector<std::string> components{"value", "magnitude", "von_mises", "xx", ""};
    for (std::size_t seed = 1; seed < 500; ++seed) {
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < 1 + seed % 6; ++i) {
            const std::size_t pick = (seed * 7919 + i * 104729) % 1009;
            candidates.push_back({
                .name = names[pick % names.size()],
                .component = components[pick % components.size()],
                .has_sign = pick % 3 == 0,
                .mostly_zero = pick % 5 == 0,
            });
        }
        Presentation p = choose_presentation(candidates, "any");
        for (PresentedResult& result : p.results) {
            result.name = result.name.empty() ? "unnamed" : result.name;
        }

        const Presentation back = parse_presentation(presentation_json(p), "p.json");

        EXPECT_EQ(back.effects, p.effects);
        EXPECT_EQ(back.results, p.results);
        EXPECT_FALSE(p.effects.empty());
    }
}

}  // namespace
}  // namespace feelem
