// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.hpp"
#include "base/byte_reader.hpp"
#include "base/input.hpp"
#include "base/number.hpp"
#include "base/sha256.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace feelem {
namespace {

TEST(Input, names_the_line_of_an_offset) {
    const Input input = Input::from_memory("a.txt", "one\ntwo\nthree");

    EXPECT_EQ(input.where_line(0), "a.txt:1");
    EXPECT_EQ(input.where_line(4), "a.txt:2");
    EXPECT_EQ(input.where_line(12), "a.txt:3");
}

TEST(Input, a_missing_file_is_an_error_with_its_name) {
    try {
        Input::from_file("/nowhere/at/all.frd");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::FileNotFound);
        EXPECT_EQ(error.where(), "/nowhere/at/all.frd");
    }
}

TEST(Input, a_folder_is_no_file_to_read) {
    try {
        Input::from_file(test::scratch_folder("input_folder"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::FileUnreadable);
        EXPECT_THAT(error.what(), testing::HasSubstr("not a regular file"));
    }
}

TEST(Input, released_pages_can_be_read_again) {
    const std::string path = test::scratch_folder("input") + "/big.bin";
    test::write_file(path, std::string(1 << 20, 'x'));
    const Input input = Input::from_file(path);

    input.release(0, input.size());

    EXPECT_EQ(input.text()[1 << 19], 'x');
}

TEST(Number, reads_what_solvers_print) {
    EXPECT_EQ(parse_double(" 1.5 "), 1.5);
    EXPECT_EQ(parse_double("+.5"), 0.5);
    EXPECT_EQ(parse_double("0."), 0.0);
    EXPECT_EQ(parse_double("1.5D+02"), 150.0);
    EXPECT_EQ(parse_double("1.5-3"), 0.0015);
    EXPECT_EQ(parse_double("-0.1234-101"), -0.1234e-101);
    EXPECT_EQ(parse_float("5.e-003"), 0.005F);
    EXPECT_TRUE(std::isnan(parse_float("NaN").value()));
    EXPECT_TRUE(std::isnan(parse_float("*********").value()));
    EXPECT_TRUE(std::isnan(parse_float("-Infinity").value()));
    EXPECT_EQ(parse_float("1e99"), HUGE_VALF);
}

TEST(Number, refuses_what_is_no_number) {
    for (const char* text : {"", " ", "x", "1.5x", "1 2", "--1", "+-1", "1.5D", "1e", "."}) {
        EXPECT_FALSE(parse_double(text).has_value()) << '"' << text << '"';
    }
    EXPECT_FALSE(parse_integer("1.0").has_value());
    EXPECT_FALSE(parse_integer("99999999999999999999").has_value());
}

TEST(ByteReader, reading_beyond_the_end_names_the_byte) {
    const Input input = Input::from_memory("a.bin", std::string("\x01\x00\x00\x00\x02", 5));
    ByteReader reader(input, 0);

    EXPECT_EQ(reader.read<std::uint32_t>(), 1U);
    EXPECT_THROW(reader.read<std::uint32_t>(), Error);
    EXPECT_EQ(ByteReader(input, 0, true).read<std::uint32_t>(), 0x01000000U);
}

TEST(AtomicFile, leaves_the_old_file_unless_committed) {
    const std::string path = test::scratch_folder("atomic") + "/out.txt";
    test::write_file(path, "old");

    {
        AtomicFile file(path);
        file.write(std::string_view("half"));
    }
    EXPECT_EQ(test::read_file(path), "old");

    AtomicFile file(path);
    file.write(std::string_view("new"));
    file.commit();
    EXPECT_EQ(test::read_file(path), "new");
}

TEST(Sha256, agrees_with_the_standards_example) {
    const Input input = Input::from_memory("abc", "abc");

    EXPECT_EQ(sha256_hex(input), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace feelem
