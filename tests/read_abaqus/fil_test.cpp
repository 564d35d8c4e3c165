// SPDX-License-Identifier: Apache-2.0
// Results files that an independent writer made from the manual's description.
#include "read_abaqus/fil_text.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace feelem {
namespace {

using test::FilRecord;
using testing::ElementsAre;
using testing::IsNan;

struct Opened {
    std::unique_ptr<Diagnostics> diagnostics = std::make_unique<Diagnostics>();
    std::unique_ptr<ModelSource> model;

    Result load(const std::string& name, std::uint32_t step, Layer layer = Layer::No) const {
        for (std::size_t i = 0; i < model->results().size(); ++i) {
            const ResultInfo& info = model->results()[i];
            if (info.name == name && info.step == step && info.layer == layer) return model->load(i);
        }
        ADD_FAILURE() << "no " << name << " in step " << step;
        return {};
    }
};

Opened open_bytes(std::vector<NamedBytes> files) {
    Opened opened;
    opened.model = open_model(std::move(files), {}, *opened.diagnostics);
    return opened;
}

FilRecord increment(double total, double time, int procedure, int step, int number, double frequency = 0.0) {
    FilRecord record{2000, {total, time, 0.0, 0.0, procedure, step, number, 0, 0.0, frequency, time}};
    record.words.emplace_back("first lo");
    record.words.emplace_back("ad");
    for (int i = 0; i < 8; ++i) record.words.emplace_back("");
    return record;
}
FilRecord head(int id, int point, int section, int at, int direct = 3, int shear = 3) {
    return {1, {id, point, section, at, "", direct, shear, 0, 0}};
}

/// A brick of 8 nodes and a shell on it, in the order Abaqus writes: elements, nodes, sets, degrees of
/// freedom.
std::vector<FilRecord> mesh_records() {
    std::vector<FilRecord> records{
        {1921, {"6.23-1", "02-Dec-2", "024", "13:18:26", 2, 8, 1.0}},
        {1900, {7, "C3D8R", 1, 2, 3, 4, 5, 6, 7, 8}},
        {1900, {9, "S4", 5, 6}},
        {1990, {7, 8}},
        {1900, {11, "SPRINGA", 1, 2}},
    };
    for (int i = 0; i < 8; ++i) {
        const int corner = i % 4;
        records.push_back(
            {1901, {i + 1, corner == 1 || corner == 2 ? 1.0 : 0.0, corner > 1 ? 1.0 : 0.0, i < 4 ? 0.0 : 0.1}}
        );
    }
    records.push_back({1933, {"BRICKS", 7}});
    records.push_back({1931, {"       1", 1, 2}});
    records.push_back({1932, {3, 4}});
    records.push_back({1940, {1, "ASSEMBLY", "_FOOT"}});
    records.push_back({1902, {1, 2, 3, 4, 5, 6}});
    records.push_back({1922, {"A brick ", "and a sh", "ell"}});
    records.push_back({2001, {}});
    return records;
}

std::vector<FilRecord> whole_file() {
    std::vector<FilRecord> records = mesh_records();
    records.push_back(increment(1.5, 0.5, 1, 2, 3));
    records.push_back({1911, {0, "", "C3D8R"}});
    records.push_back(head(7, 1, 0, 0));
    records.push_back({11, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}});
    records.push_back(head(7, 2, 0, 0));
    records.push_back({11, {3.0, 2.0, 3.0, 4.0, 5.0, 7.0}});
    for (const int point : {1, 5}) {
        records.push_back(head(9, 1, point, 0, 2, 1));
        records.push_back({11, {10.0 * point, 20.0, 30.0}});
    }
    records.push_back(head(3, 0, 0, 4));
    records.push_back({21, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}});
    records.push_back(head(7, 4, 0, 2));
    records.push_back({28, {1.0, 0.0, -1.0}});
    records.push_back({1911, {1, ""}});
    records.push_back({101, {2, 0.125, -0.25, 1e-33, 0.5, 0.0, 0.0}});
    records.push_back({101, {99, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0}});
    records.push_back({201, {8, 350.125}});
    records.push_back({2001, {}});
    records.push_back(increment(2.5, 0.0, 41, 3, 1));
    for (int mode = 1; mode <= 2; ++mode) {
        records.push_back({1980, {mode, 4.0 * mode * mode * std::numbers::pi * std::numbers::pi, 1.0, 0.0}});
        records.push_back({1911, {1, ""}});
        records.push_back({101, {1, 0.0, 0.0, 1.0 * mode, 0.0, 0.0, 0.0}});
    }
    records.push_back({2001, {}});
    return records;
}

void expect_whole_file(const Opened& opened) {
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 8U);
    ASSERT_EQ(mesh.blocks.size(), 2U);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Hex8);
    EXPECT_EQ(mesh.blocks[1].type, ElementType::Quad4);
    EXPECT_EQ(mesh.skipped_elements.at("SPRINGA"), 1U);
    EXPECT_EQ(mesh.node_sets.at(0).name, "ASSEMBLY_FOOT");
    EXPECT_EQ(mesh.node_sets.at(0).nodes.size(), 4U);
    EXPECT_EQ(mesh.element_sets.at(0).name, "BRICKS");
    EXPECT_EQ(opened.model->title(), "A brick and a shell");
    EXPECT_EQ(opened.model->solver().version, "6.23-1");

    const auto steps = opened.model->steps();
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[0].step, 2);
    EXPECT_EQ(steps[0].substep, 3);
    EXPECT_EQ(steps[0].kind, StepKind::Static);
    EXPECT_EQ(steps[0].value, 1.5);
    EXPECT_EQ(steps[0].label, "first load");
    EXPECT_EQ(steps[2].kind, StepKind::Mode);
    EXPECT_EQ(steps[2].substep, 2);
    EXPECT_NEAR(steps[2].value, 2, 1e-12);

    const Result stress = opened.load("stress", 0);
    EXPECT_EQ(stress.info.location, Location::Elemental);
    EXPECT_THAT(stress.info.components, ElementsAre("xx", "yy", "zz", "xy", "yz", "zx"));
    // The mean of two points; 13 and 23 change places.
    EXPECT_THAT(
        std::vector(stress.values.begin(), stress.values.begin() + 6), ElementsAre(2, 2, 3, 4, 6.5F, 5)
    );
    EXPECT_TRUE(std::isnan(stress.values[6])) << "the shell has values at section points only";
    EXPECT_EQ(opened.load("stress", 0, Layer::Bottom).values[6], 10);
    const Result top = opened.load("stress", 0, Layer::Top);
    EXPECT_EQ(top.values[6], 50);
    EXPECT_EQ(top.values[7], 20);
    EXPECT_TRUE(std::isnan(top.values[8])) << "a shell lists no zz";
    EXPECT_EQ(top.values[9], 30);

    const Result strain = opened.load("strain", 0);
    EXPECT_EQ(strain.info.location, Location::Nodal);
    EXPECT_EQ(strain.info.averaging, Averaging::Solver);
    EXPECT_EQ(strain.info.shear, Shear::Engineering);
    EXPECT_EQ(strain.values[2 * 6 + 4], 0.6F);
    EXPECT_EQ(strain.values[2 * 6 + 5], 0.5F);

    const Result flux = opened.load("heat_flux", 0);
    EXPECT_EQ(flux.info.location, Location::ElementNodal);
    EXPECT_THAT(flux.row_owner, ElementsAre(0U));
    EXPECT_THAT(flux.row_node, ElementsAre(NodeIndex{3}));
    EXPECT_THAT(flux.values, ElementsAre(1, 0, -1));

    const Result displacement = opened.load("displacement", 0);
    EXPECT_THAT(displacement.info.components, ElementsAre("x", "y", "z"));
    EXPECT_THAT(
        std::vector(displacement.values.begin(), displacement.values.begin() + 6),
        ElementsAre(IsNan(), IsNan(), IsNan(), 0.125F, -0.25F, 1e-33F)
    );
    EXPECT_EQ(opened.load("rotation", 0).values[3], 0.5F);
    EXPECT_EQ(opened.load("temperature", 0).values[7], 350.125F);
    EXPECT_EQ(opened.load("displacement", 2).values[2], 2);
    EXPECT_EQ(opened.diagnostics->count(Code::ResultWithoutNode), 2U)
        << "node 99, for displacement and rotation";
    EXPECT_TRUE(opened.diagnostics->has(Code::CoordinateSystem))
        << "stresses of shells are in their directions";
}

TEST(Fil, ascii_file_gives_mesh_steps_and_values_at_every_place) {
    expect_whole_file(open_bytes({{"job.fil", test::ascii_fil(whole_file())}}));
}

TEST(Fil, ascii_lines_that_lost_their_blanks_are_filled_again) {
    std::string text = test::ascii_fil(whole_file()), stripped;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        std::string line = text.substr(at, end - at);
        line.erase(line.find_last_not_of(' ') + 1);
        stripped += line + "\r\n";
        at = end + 1;
    }
    expect_whole_file(open_bytes({{"job.fil", stripped}}));
}

TEST(Fil, binary_files_of_either_byte_order_give_the_same) {
    expect_whole_file(open_bytes({{"job.fil", test::binary_fil(whole_file())}}));
    expect_whole_file(open_bytes({{"job.fil", test::binary_fil(whole_file(), true)}}));
}

TEST(Fil, degrees_of_freedom_that_are_not_active_have_no_component) {
    std::vector<FilRecord> records{
        {1921, {"6.14", "", "", "", 1, 3, 1.0}},
        {1900, {1, "CPS3", 1, 2, 3}},
        {1901, {1, 0.0, 0.0}},
        {1901, {2, 1.0, 0.0}},
        {1901, {3, 0.0, 1.0}},
        {1902, {1, 2, 0, 0, 0, 3}},
        {2001, {}},
        increment(1, 1, 1, 1, 1),
        {1911, {1, ""}},
        {101, {2, 0.25, 0.5, 0.75}},
        {2001, {}},
    };
    const Opened opened = open_bytes({{"job.fil", test::ascii_fil(records)}});
    const Result displacement = opened.load("displacement", 0);
    EXPECT_THAT(displacement.info.components, ElementsAre("x", "y"));
    EXPECT_EQ(displacement.values[2], 0.25F);
    const Result rotation = opened.load("rotation", 0);
    EXPECT_THAT(rotation.info.components, ElementsAre("z"));
    EXPECT_EQ(rotation.values[1], 0.75F);
}

TEST(Fil, harmonic_values_are_real_parts_then_imaginary_ones) {
    std::vector<FilRecord> records = mesh_records();
    records.push_back(increment(0, 0, 94, 1, 1, 50.0));
    records.push_back({1911, {1, ""}});
    records.push_back({101, {1, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0, -1.0, -2.0, -3.0, 0.0, 0.0, 0.0}});
    records.push_back({2001, {}});
    const Opened opened = open_bytes({{"job.fil", test::ascii_fil(records)}});
    ASSERT_EQ(opened.model->steps().size(), 1U);
    EXPECT_EQ(opened.model->steps()[0].kind, StepKind::Frequency);
    EXPECT_EQ(opened.model->steps()[0].value, 50);
    for (std::size_t i = 0; i < opened.model->results().size(); ++i) {
        const Result result = opened.model->load(i);
        if (result.info.name != "displacement") continue;
        EXPECT_EQ(result.values[1], result.info.complex == Complex::Real ? 2 : -2);
    }
    EXPECT_EQ(opened.model->results().size(), 4U);
}

TEST(Fil, vectors_are_in_the_nodal_systems_that_the_deck_beside_it_defines) {
    const std::string deck =
        "*NODE,NSET=ALL\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,.1\n6,1,0,.1\n7,1,1,.1\n8,0,1,.1\n"
        "*ELEMENT,TYPE=C3D8R,ELSET=STEEL\n7,1,2,3,4,5,6,7,8\n*ELEMENT,TYPE=S4,ELSET=SKIN\n9,5,6,7,8\n"
        "*TRANSFORM,NSET=ALL,TYPE=C\n-1,0,0,-1,0,1\n";
    const Opened opened = open_bytes({{"job.inp", deck}, {"job.fil", test::ascii_fil(whole_file())}});
    EXPECT_TRUE(opened.load("displacement", 0).info.nodal_system);
    EXPECT_FALSE(opened.load("temperature", 0).info.nodal_system);
    EXPECT_EQ(opened.model->mesh().parts.at(0).name, "STEEL");
}

TEST(Fil, deck_with_other_numbers_is_refused) {
    const std::string deck = "*NODE\n1,5,0,0\n2,1,0,0\n3,1,1,0\n*ELEMENT,TYPE=S3\n1,1,2,3\n";
    try {
        open_bytes({{"job.inp", deck}, {"job.fil", test::ascii_fil(whole_file())}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
    }
}

TEST(Fil, shipped_example_holds_two_instances_and_their_parts) {
    const Opened opened = open_bytes(
        {{"two_bricks.fil", test::read_file(test::project_file("tests/data/abaqus/two_bricks.fil"))}}
    );
    EXPECT_EQ(opened.model->mesh().node_count(), 16U);
    EXPECT_EQ(raw(opened.model->mesh().node_ids.back()), 1000008);
    ASSERT_EQ(opened.model->mesh().parts.size(), 2U);
    EXPECT_EQ(opened.model->mesh().parts[1].name, "BRICK-2");
    EXPECT_EQ(opened.model->steps().size(), 4U);
    EXPECT_EQ(opened.load("stress", 1).info.location, Location::ElementNodal);
}

TEST(Fil, file_that_ends_early_keeps_what_is_whole) {
    const std::string text = test::ascii_fil(whole_file());
    const Opened opened = open_bytes({{"job.fil", text.substr(0, text.find("I 3201"))}});
    EXPECT_TRUE(opened.diagnostics->has(Code::TruncatedInput));
    EXPECT_EQ(opened.load("displacement", 0).values[3], 0.125F);
}

TEST(Fil, any_damage_ends_in_a_model_or_an_error) {
    std::mt19937_64 random(7);
    for (const std::string& whole : {test::ascii_fil(whole_file()), test::binary_fil(whole_file())}) {
        for (int i = 0; i < 300; ++i) {
            std::string bytes = whole;
            for (int flips = 0; flips < 3; ++flips)
                bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
            if (i % 3 == 0) bytes.resize(random() % bytes.size());
            try {
                const Opened opened = open_bytes({{"job.fil", bytes}});
                for (std::size_t r = 0; r < opened.model->results().size(); ++r) opened.model->load(r);
            } catch (const Error& error) {
                EXPECT_GT(std::string(error.what()).size(), 10U);
            }
        }
    }
}

}  // namespace
}  // namespace feelem
