// SPDX-License-Identifier: Apache-2.0
// CalculiX' printed tables: small ones, and those of its test suite beside its .frd of the same job.
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <set>

namespace feelem {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsNan;

struct Opened {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;

    Result load(const std::string& name, std::uint32_t step = 0) const {
        for (std::size_t i = 0; i < model->results().size(); ++i) {
            const ResultInfo& info = model->results()[i];
            if (info.name == name && info.step == step) return model->load(i);
        }
        ADD_FAILURE() << "no " << name << " in step " << step;
        return {};
    }
};

constexpr const char* kDeck =
    "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT,TYPE=S4\n1,1,2,3,4\n2,2,5,6,3\n";

Opened open_tables(const std::string& tables) {
    Opened opened;
    opened.model =
        open_model(std::vector<NamedBytes>{{"job.dat", tables}, {"job.inp", kDeck}}, {}, *opened.diagnostics);
    return opened;
}

constexpr const char* kTables = R"(
                        S T E P       1


                                INCREMENT     1


 displacements (vx,vy,vz) for set LEFT and time  0.1000000E+01

         1  1.250000E-01  0.000000E+00 -2.500000E-01
         4  1.000000E+00  2.000000E+00  3.000000E+00

 displacements (vx,vy,vz) for set RIGHT and time  0.1000000E+01

         5  5.000000E+00  6.000000E+00  7.000000E+00
       999  5.000000E+00  6.000000E+00  7.000000E+00

 total force (fx,fy,fz) for set LEFT and time  0.1000000E+01

        1.000000E+00  2.000000E+00  3.000000E+00

 stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set ALL and time  0.1000000E+01

         2   1  1.000000E+00  2.000000E+00  3.000000E+00  4.000000E+00  5.000000E+00  6.000000E+00
         2   2  3.000000E+00  2.000000E+00  3.000000E+00  4.000000E+00  5.000000E+00  8.000000E+00

                        S T E P       2


                                INCREMENT     3


 temperatures for set ALL and time  0.2500000E+01

         2  3.501234E+02
         3  NaN

 internal energy (element, energy) for set ALL and time  0.2500000E+01

         1  7.500000E-01
)";

TEST(DatTables, tables_of_several_sets_are_one_result) {
    const Opened opened = open_tables(kTables);
    const Result displacement = opened.load("displacement");
    EXPECT_THAT(displacement.info.components, ElementsAre("x", "y", "z"));
    EXPECT_THAT(
        std::vector(displacement.values.begin(), displacement.values.begin() + 4),
        ElementsAre(0.125F, 0, -0.25F, IsNan())
    );
    EXPECT_EQ(displacement.values[3 * 4 + 2], 7);
    EXPECT_EQ(opened.diagnostics->count(Code::ResultWithoutNode), 1U);
    EXPECT_TRUE(opened.diagnostics->has(Code::ResultForPartOfModel));
}

TEST(DatTables, element_shows_the_mean_of_its_integration_points) {
    const Result stress = open_tables(kTables).load("stress");
    EXPECT_EQ(stress.info.location, Location::Elemental);
    EXPECT_EQ(stress.info.shape, Shape::SymmetricTensor);
    EXPECT_THAT(stress.info.solver_name, testing::HasSubstr("mean of integration points"));
    EXPECT_TRUE(std::isnan(stress.values[0]));
    // sxz and syz change places.
    EXPECT_THAT(std::vector(stress.values.begin() + 6, stress.values.end()), ElementsAre(2, 2, 3, 4, 7, 5));
}

TEST(DatTables, steps_increments_and_times_are_those_of_the_heads) {
    const Opened opened = open_tables(kTables);
    ASSERT_EQ(opened.model->steps().size(), 2U);
    EXPECT_EQ(opened.model->steps()[1].step, 2);
    EXPECT_EQ(opened.model->steps()[1].substep, 3);
    EXPECT_EQ(opened.model->steps()[1].value, 2.5);
    EXPECT_EQ(opened.load("temperature", 1).values[1], 350.1234F);
    EXPECT_EQ(opened.load("internal_energy", 1).values[0], 0.75F);
    EXPECT_EQ(opened.diagnostics->count(Code::NonFiniteValue), 1U);
    EXPECT_EQ(opened.model->results().size(), 4U) << "a total is no result";
}

TEST(DatTables, six_degrees_of_freedom_are_a_displacement_and_a_rotation) {
    const Opened opened = open_tables(
        "\n                        S T E P       1\n\n displacements (v(i),i=1..ndof) for set N and time  "
        "0.1000000E+01\n\n"
        "         2 -9.891993E+00  2.231520E+01  0.000000E+00  0.000000E+00  0.000000E+00  8.666687E-01\n"
    );
    EXPECT_EQ(opened.load("displacement").values[4], 22.3152F);
    EXPECT_EQ(opened.load("rotation").values[5], 0.8666687F);
}

TEST(DatTables, tables_without_a_mesh_say_what_is_missing) {
    Diagnostics diagnostics;
    try {
        open_model(std::vector<NamedBytes>{{"job.dat", kTables}}, {}, diagnostics);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::NoNodes);
        EXPECT_THAT(error.what(), testing::HasSubstr(".inp or .frd"));
    }
}

TEST(DatTables, any_damage_ends_in_a_model_or_an_error) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 500; ++i) {
        std::string bytes = kTables;
        for (int flips = 0; flips < 3; ++flips)
            bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
        if (i % 3 == 0) bytes.resize(random() % bytes.size());
        try {
            const Opened opened = open_tables(bytes);
            for (std::size_t r = 0; r < opened.model->results().size(); ++r) opened.model->load(r);
        } catch (const Error& error) {
            EXPECT_GT(std::string(error.what()).size(), 10U);
        }
    }
}

/// Names under which the .frd has what a table has.
const std::map<std::string, std::string> kSame{
    {"displacement", "displacement"},
    {"velocity", "velocity"},
    {"temperature", "temperature"},
    {"reaction_force", "reaction_force"}};

TEST(DatTables, printed_values_of_calculix_are_those_of_its_frd) {
    const auto folder = test::corpus_file("calculix/test");
    if (!folder) GTEST_SKIP() << "the corpus is not here";
    std::size_t compared = 0;
    std::set<std::string> jobs;
    for (const auto& entry : fs::directory_iterator(*folder)) {
        const std::string path = entry.path().string();
        if (!path.ends_with(".dat.ref") || entry.file_size() == 0) continue;
        const std::string job = entry.path().stem().stem().string();
        SCOPED_TRACE(job);
        Opened opened;
        const std::string frd = *folder + "/" + job + ".frd.ref";
        opened.model = open_model(std::vector<std::string>{frd, path}, {}, *opened.diagnostics);
        const auto results = opened.model->results();
        const auto steps = opened.model->steps();
        for (std::size_t d = 0; d < results.size(); ++d) {
            const Step& when = steps[results[d].step];
            if (when.input != 1 || !kSame.contains(results[d].name)) continue;
            const auto same = [&](const ResultInfo& info) {
                const Step& step = steps[info.step];
                return step.input == 0 && step.value == when.value && info.complex == Complex::No &&
                       info.name == kSame.at(results[d].name);
            };
            const auto f = std::ranges::find_if(results, same);
            if (f == results.end()) continue;
            const Result printed = opened.model->load(d);
            const Result stored = opened.model->load(static_cast<std::size_t>(f - results.begin()));
            // Six digits in the .frd, seven here; tiny numbers are the rest of a subtraction.
            double largest = 0;
            for (const float value : stored.values) {
                if (!std::isnan(value)) largest = std::max(largest, std::abs(static_cast<double>(value)));
            }
            const std::size_t ours = printed.component_count(), theirs = stored.component_count();
            ASSERT_LE(ours, theirs) << "the .frd may hold rotations too";
            for (std::size_t row = 0; row < printed.row_count(); ++row) {
                for (std::size_t i = 0; i < ours; ++i) {
                    const double a = static_cast<double>(printed.values[row * ours + i]);
                    const double b = static_cast<double>(stored.values[row * theirs + i]);
                    if (std::isnan(a) || std::isnan(b)) continue;
                    EXPECT_NEAR(a, b, 1e-5 * std::abs(b) + 1e-9 * largest)
                        << results[d].name << " row " << row;
                    ++compared;
                }
            }
            jobs.insert(job);
        }
    }
    std::cout << compared << " values of " << jobs.size() << " jobs\n";
    EXPECT_GT(compared, 1000U);
    EXPECT_GT(jobs.size(), 5U);
}

}  // namespace
}  // namespace feelem
