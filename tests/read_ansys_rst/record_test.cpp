// SPDX-License-Identifier: Apache-2.0
// Every packing of a record, and what must not come out of damaged ones.
#include "read/ansys/rst_record.hpp"
#include "read_ansys_rst/rst_writer.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

namespace feelem::rst {
namespace {

using test::Bytes;
using test::kFloats;
using test::kIntegers;
using test::kMask;
using test::kReals;
using test::kShorts;
using test::kWindows;
using test::kZlib;
using test::RecordFile;
using testing::ElementsAre;

Records records_of(std::uint8_t flags, const Bytes& payload) {
    RecordFile file;
    file.add(flags, payload.text());
    return Records(Input::from_memory("made.rst", file.bytes()));
}

std::vector<double> reals(std::uint8_t flags, const Bytes& payload, std::size_t most = 1000) {
    const Records records = records_of(flags, payload);
    std::vector<double> unpacked = records.reals(0, most);
    const Reals seen(records, records.find(0), most);
    EXPECT_EQ(seen.size(), unpacked.size());
    for (std::size_t i = 0; i < std::min(seen.size(), unpacked.size()); ++i) EXPECT_EQ(seen[i], unpacked[i]);
    return unpacked;
}

std::vector<std::int32_t> integers(std::uint8_t flags, const Bytes& payload) {
    return records_of(flags, payload).integers(0);
}

Code code_of(std::uint8_t flags, const Bytes& payload) {
    try {
        reals(flags, payload);
    } catch (const Error& error) {
        EXPECT_NE(error.where(), "");
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return Code::BadOption;
}

TEST(Record, plain_numbers_of_four_kinds_are_read) {
    EXPECT_THAT(reals(kReals, Bytes().put(0.1).put(-2.0)), ElementsAre(0.1, -2.0));
    EXPECT_THAT(reals(kFloats, Bytes().put(0.5F).put(3.0F)), ElementsAre(0.5, 3.0));
    EXPECT_THAT(integers(kIntegers, Bytes().put(7).put(-8)), ElementsAre(7, -8));
    const Bytes shorts = Bytes().put(std::int16_t{7}).put(std::int16_t{-32768});
    EXPECT_THAT(integers(kShorts, shorts), ElementsAre(7, -32768));
}

TEST(Record, masked_record_holds_what_is_not_zero) {
    const Bytes payload = Bytes().put(7).put(0b0001011).put(12.0).put(1.5).put(2.5);
    EXPECT_THAT(reals(kReals | kMask, payload), ElementsAre(12.0, 1.5, 0, 2.5, 0, 0, 0));
    const Bytes shorts = Bytes().put(4).put(0b1001).put(std::int16_t{5}).put(std::int16_t{-6});
    EXPECT_THAT(integers(kShorts | kMask, shorts), ElementsAre(5, 0, 0, -6));
}

TEST(Record, windows_hold_single_values_runs_and_repeats) {
    // One value at 1, values from 3, one value repeated from 6; a window at 0 is a run, for 0 has no sign.
    const Bytes payload = Bytes()
                              .put(9)
                              .put(4)
                              .put(0)
                              .put(1)
                              .put(9.0)
                              .put(1)
                              .put(1.5)
                              .put(-3)
                              .put(2)
                              .put(3.5)
                              .put(4.5)
                              .put(-6)
                              .put(-3)
                              .put(7.0);
    EXPECT_THAT(reals(kReals | kWindows, payload), ElementsAre(9, 1.5, 0, 3.5, 4.5, 0, 7, 7, 7));
    const Bytes ints = Bytes().put(3).put(1).put(-1).put(-2).put(4);
    EXPECT_THAT(integers(kIntegers | kWindows, ints), ElementsAre(0, 4, 4));
    const Bytes shorts = Bytes().put(3).put(1).put(0).put(2).put(std::int16_t{8}).put(std::int16_t{9});
    EXPECT_THAT(integers(kShorts | kWindows, shorts), ElementsAre(8, 9, 0));
}

TEST(Record, both_bits_are_groups_of_columns_side_by_side) {
    // Two rows of U (3 columns) and ROT (3 columns): the second node has no rotations.
    const double none = std::ldexp(1.0, 100);
    const Bytes payload = Bytes()
                              .put(12)
                              .put(2)
                              .put(3)
                              .put(3)  // size, groups, columns
                              .put(1)
                              .put(0)
                              .put(6)
                              .put(1.0)
                              .put(2.0)
                              .put(3.0)
                              .put(4.0)
                              .put(5.0)
                              .put(6.0)
                              .put(2)
                              .put(0)
                              .put(3)
                              .put(0.1)
                              .put(0.2)
                              .put(0.3)
                              .put(-3)
                              .put(-3)
                              .put(none);
    EXPECT_THAT(
        reals(kReals | kWindows | kMask, payload),
        ElementsAre(1, 2, 3, 0.1, 0.2, 0.3, 4, 5, 6, none, none, none)
    );
}

TEST(Record, groups_of_other_widths_are_placed_by_row) {
    const Bytes payload =
        Bytes().put(8).put(2).put(3).put(1).put(1).put(0).put(-6).put(2.0).put(1).put(1).put(25.0);
    EXPECT_THAT(reals(kReals | kWindows | kMask, payload), ElementsAre(2, 2, 2, 0, 2, 2, 2, 25));
}

// SYNTHETIC: no real file has the bit.
TEST(Record, zlib_stream_is_inflated_behind_any_count) {
    const std::string plain = Bytes().put(1.0).put(2.0).put(3.0).text();
    std::string packed(200, '\0');
    uLongf length = packed.size();
    ASSERT_EQ(
        compress(
            reinterpret_cast<Bytef*>(packed.data()),
            &length,
            reinterpret_cast<const Bytef*>(plain.data()),
            plain.size()
        ),
        Z_OK
    );
    packed.resize(length);
    for (const std::size_t counts : std::initializer_list<std::size_t>{0, 1, 2}) {
        RecordFile file;
        file.add(kReals | kZlib, std::string(4 * counts, '\3') + packed);
        EXPECT_THAT(Records(Input::from_memory("z.rst", file.bytes())).reals(0), ElementsAre(1, 2, 3));
    }
    packed[packed.size() - 1] = static_cast<char>(packed.back() ^ 1);  // The checksum is the last word.
    RecordFile file;
    file.add(kReals | kZlib, packed);
    EXPECT_THROW(Records(Input::from_memory("z.rst", file.bytes())).reals(0), Error);
}

TEST(Record, size_that_nobody_asked_for_is_refused_before_it_is_allocated) {
    for (const std::int32_t size : {1001, 2147483647, -1}) {
        EXPECT_EQ(code_of(kReals | kWindows, Bytes().put(size).put(0)), Code::BadStructure);
        EXPECT_EQ(code_of(kReals | kMask, Bytes().put(size).put(0)), Code::BadStructure);
        EXPECT_EQ(
            code_of(kReals | kMask | kWindows, Bytes().put(size).put(1).put(1).put(0)), Code::BadStructure
        );
    }
}

TEST(Record, window_outside_its_record_is_refused) {
    EXPECT_EQ(code_of(kReals | kWindows, Bytes().put(3).put(1).put(3).put(1.0)), Code::BadStructure);
    EXPECT_EQ(code_of(kReals | kWindows, Bytes().put(3).put(1).put(-1).put(-3).put(1.0)), Code::BadStructure);
    const std::int32_t least = std::numeric_limits<std::int32_t>::min();
    EXPECT_EQ(
        code_of(kReals | kWindows, Bytes().put(3).put(1).put(least).put(1).put(1.0)), Code::BadStructure
    );
    EXPECT_EQ(
        code_of(kReals | kWindows, Bytes().put(3).put(1).put(0).put(least).put(1.0)), Code::BadStructure
    );
    EXPECT_EQ(code_of(kReals | kWindows, Bytes().put(3).put(1).put(0).put(3).put(1.0)), Code::BadStructure);
}

TEST(Record, windows_that_lie_on_each_other_cannot_cost_time) {
    Bytes payload;
    payload.put(1000).put(500);
    for (int i = 0; i < 500; ++i) payload.put(0).put(-1000).put(1.0);
    EXPECT_EQ(code_of(kReals | kWindows, payload), Code::BadStructure);
}

TEST(Record, groups_that_are_no_whole_rows_are_refused) {
    EXPECT_EQ(code_of(kReals | kMask | kWindows, Bytes().put(7).put(2).put(3).put(3)), Code::BadStructure);
    EXPECT_EQ(code_of(kReals | kMask | kWindows, Bytes().put(6).put(0)), Code::BadStructure);
    EXPECT_EQ(code_of(kReals | kMask | kWindows, Bytes().put(6).put(1).put(0)), Code::BadStructure);
    EXPECT_EQ(code_of(kReals | kMask | kWindows, Bytes().put(6).put(1000000)), Code::BadStructure);
}

TEST(Record, length_must_stand_at_both_ends) {
    RecordFile file;
    file.add(std::vector<double>{1, 2});
    std::string bytes = file.bytes();
    bytes[bytes.size() - 4] = 9;
    EXPECT_THROW(Records(Input::from_memory("a.rst", bytes)).find(0), Error);
    bytes = file.bytes().substr(0, file.bytes().size() - 4);
    EXPECT_THROW(Records(Input::from_memory("a.rst", bytes)).find(0), Error);
    EXPECT_THROW(Records(Input::from_memory("a.rst", bytes)).find(~Word{0}), Error);
    EXPECT_THROW(Records(Input::from_memory("a.rst", bytes)).find(~Word{0} / 4), Error);
}

TEST(Record, reals_are_never_taken_for_integers) {
    EXPECT_THROW(integers(kReals, Bytes().put(1.0)), Error);
    EXPECT_THAT(reals(kIntegers, Bytes().put(3).put(-4)), ElementsAre(3, -4));
}

}  // namespace
}  // namespace feelem::rst
