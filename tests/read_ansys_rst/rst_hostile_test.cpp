// SPDX-License-Identifier: Apache-2.0
// Counts and pointers of a SYNTHETIC result file turned into anything: a model or an Error, nothing else.
#include "read_ansys_rst/opened_rst.hpp"
#include "support/exercise.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace feelem {
namespace {

using test::WrittenModel;

/// A file with everything that this reader reads.
std::string full_file() {
    WrittenModel model = test::two_bricks();
    model.units = 6;
    model.nodes[0][4] = 30;
    model.components = {{"FIXED", true, {10, 30, -60}}, {"RIGHT", false, {7, -8}}};
    test::WrittenSet set;
    set.solution.assign(36, 0.5);
    set.reaction_at = {1, 2, 3};
    set.reactions = {1, 2, 3};
    for (std::size_t element = 0; element < 2; ++element) {
        set.element_records.push_back({element, 3, std::vector<double>(48, 2.0), 0});
        set.element_records.push_back({element, 6, std::vector<double>(56, 0.001), 0});
        set.element_records.push_back({element, 9, {}, 64});
        set.element_records.push_back({element, 10, {30, 0, 0}, 0});
    }
    model.sets = {set, set};
    return test::write_rst(model);
}

/// A quarter of a ring, with a pair of modes.
std::string cyclic_file() {
    WrittenModel model;
    model.types = {{185, 8, 0, 0}};
    const double section[4][2] = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
    for (int i = 0; i < 8; ++i) {
        const double radius = section[i % 4][0];
        model.nodes.push_back({i + 1.0, i < 4 ? radius : 0, i < 4 ? 0 : radius, section[i % 4][1], 0, 0, 0});
        model.storage.push_back(i + 1);
    }
    model.elements = {{1, 1, 1, {1, 2, 6, 5, 4, 3, 7, 8}}};
    model.sectors = 4;
    model.has_axis = true;
    model.sector_nodes = 8;
    model.sector_elements = 1;
    model.analysis = 2;
    model.harmonics = {1, -1};
    for (int mode = 0; mode < 2; ++mode) {
        test::WrittenSet set;
        set.substep = mode + 1;
        for (int node = 0; node < 8; ++node)
            set.solution.insert(set.solution.end(), {mode == 0 ? 1.0 : 0.0, mode == 0 ? 0.0 : 1.0, 0});
        set.element_records.push_back({0, 3, std::vector<double>(48, 2.0), 0});
        model.sets.push_back(set);
    }
    return test::write_rst(model);
}

/// Empty when all is well.
std::string survive(const std::string& bytes, bool expand = false) {
    try {
        ReadOptions options;
        options.expand_cyclic = expand;
        test::OpenedRst opened;
        opened.model = open_model(std::vector<NamedBytes>{{"made.rst", bytes}}, options, *opened.diagnostics);
        return test::exercise(*opened.model);
    } catch (const Error& error) {
        return std::string(error.what()).size() < 10 ? "an error without words" : "";
    }
}

TEST(RstHostile, whole_file_is_sound) {
    EXPECT_EQ(survive(full_file()), "");
    EXPECT_NO_THROW(test::open_bytes(full_file()));
}

// The fuzzer starts from it, and the test Hostile damages it.
TEST(RstHostile, shipped_file_is_what_the_writer_writes) {
    const std::string path = test::project_file("tests/data/ansys/bricks.rst");
    if (std::getenv("FEELEM_UPDATE_GOLDEN") != nullptr) test::write_file(path, full_file());
    EXPECT_EQ(test::read_file(path), full_file()) << "FEELEM_UPDATE_GOLDEN=1 writes it again";
}

TEST(RstHostile, sets_that_the_file_cannot_hold_are_not_believed) {
    std::string bytes = full_file();
    const std::int32_t many = 10;  // As many as the table holds.
    std::memcpy(bytes.data() + 4 * (103 + 2 + 8), &many, sizeof many);
    EXPECT_NO_THROW(test::open_bytes(bytes));
    // The same in a table of a million entries that takes six words.
    const std::int32_t more = 1'000'000;
    std::memcpy(bytes.data() + 4 * (103 + 2 + 8), &more, sizeof more);
    std::memcpy(bytes.data() + 4 * (103 + 2 + 3), &more, sizeof more);
    EXPECT_THROW(test::open_bytes(bytes), Error);
}

TEST(RstHostile, every_word_may_be_anything) {
    const std::string good = full_file();
    for (std::size_t at = 0; at + 4 <= good.size(); at += 4) {
        for (const std::int32_t value : {-1, 0, 1, 103, 2147483647, -2147483647 - 1}) {
            std::string bytes = good;
            std::memcpy(bytes.data() + at, &value, sizeof value);
            ASSERT_EQ(survive(bytes), "") << "word " << at / 4 << " = " << value;
        }
    }
}

TEST(RstHostile, every_word_of_a_cyclic_model_may_be_anything) {
    const std::string good = cyclic_file();
    ASSERT_EQ(survive(good, true), "");
    for (std::size_t at = 0; at + 4 <= good.size(); at += 4) {
        for (const std::int32_t value : {-1, 0, 1, 2147483647, -2147483647 - 1}) {
            std::string bytes = good;
            std::memcpy(bytes.data() + at, &value, sizeof value);
            ASSERT_EQ(survive(bytes, true), "") << "word " << at / 4 << " = " << value;
        }
    }
}

TEST(RstHostile, file_may_end_at_every_word) {
    const std::string good = full_file();
    for (std::size_t length = 0; length < good.size(); length += 4)
        ASSERT_EQ(survive(good.substr(0, length)), "") << length;
}

TEST(RstHostile, cut_file_keeps_the_sets_that_are_whole) {
    WrittenModel model = test::two_bricks();
    test::WrittenSet set;
    set.solution.assign(36, 0.5);
    model.sets = {set};
    const std::size_t one = test::write_rst(model).size();
    model.sets = {set, set};
    const auto opened = test::open_bytes(test::write_rst(model).substr(0, one));
    EXPECT_EQ(opened.model->steps().size(), 1u);
    EXPECT_TRUE(opened.diagnostics->has(Code::TruncatedInput));
    EXPECT_EQ(test::value_at(opened, test::load_wanted(opened, {"displacement"}), 10, "x"), 0.5F);
}

}  // namespace
}  // namespace feelem
