// SPDX-License-Identifier: Apache-2.0
// NBLOCK, EBLOCK and CMBLOCK in all their forms, from tiny decks.
#include "base/number.hpp"
#include "read/ansys/cdb_format.hpp"
#include "read_ansys_cdb/opened_deck.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace feelem {
namespace {

using test::nodes_of;
using test::open_deck;
using test::position_of;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kEndOfNodes = "N,R5.3,LOC,       -1,\n";

/// Eight corners of a unit cube, 1 to 8.
std::string cube_nodes() {
    std::string text = "NBLOCK,6,SOLID,8,8\n(3i9,6e21.13e3)\n";
    const int corners[8][3] = {
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int i = 0; i < 8; ++i) {
        text += fmt::format("{:9}{:9}{:9}", i + 1, 0, 0);
        for (const int x : corners[i]) text += fmt::format(" {}.0000000000000E+000", x);
        text += '\n';
    }
    return text + kEndOfNodes;
}

std::string with_cube(const std::string& commands) {
    return "/PREP7\n" + cube_nodes() + commands;
}

void expect_error(const std::string& deck, Code code, const std::string& place, const std::string& words) {
    try {
        open_deck(deck);
        ADD_FAILURE() << "no error: " << deck;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_EQ(error.where(), place);
        EXPECT_THAT(error.what(), HasSubstr(words));
    }
}

TEST(CdbFormat, formats_give_their_columns) {
    const auto common = ansys::cdb::parse_format("(3i9,6e21.13e3)\r");
    ASSERT_TRUE(common);
    EXPECT_EQ(common->integers, 3u);
    EXPECT_EQ(common->integers_end, 27u);
    EXPECT_EQ(common->others, 6u);
    EXPECT_EQ(common->other_width, 21u);
    EXPECT_EQ(common->decimals, 13u);
    const auto uneven = ansys::cdb::parse_format("(1i7,2i9,6e21.13)");
    ASSERT_TRUE(uneven);
    EXPECT_EQ(uneven->id_width, 7u);
    EXPECT_EQ(uneven->integers_end, 25u);
    EXPECT_EQ(ansys::cdb::parse_format("(19i10)")->integers, 19u);
    for (const char* bad :
         {"",
          "(",
          "()",
          "3i9,6e20.13",
          "(6e20.13)",
          "(3i0)",
          "(3i9,6x20)",
          "(9999i9)",
          "(3i9,6e99.1)",
          "(6e20.13,3i9)",
          "(2i9,3i8,4i7)"})
        EXPECT_FALSE(ansys::cdb::parse_format(bad)) << bad;
}

TEST(CdbFormat, fast_reals_are_the_nearest_doubles) {
    std::mt19937_64 random(7);
    int fast = 0;
    for (int i = 0; i < 200'000; ++i) {
        const bool wide = i % 2 == 0;
        const auto digits =
            static_cast<long long>(random() % (wide ? 100'000'000'000'000ULL : 10'000'000'000ULL));
        const std::string plain = fmt::format("{:0{}}", digits, wide ? 14 : 10);
        const int exponent = static_cast<int>(random() % 60) - 30;
        const std::string form = (i / 2) % 2 == 0 ? fmt::format("{:03}", std::abs(exponent))
                                                  : fmt::format("{:02}", std::abs(exponent));
        std::string text = fmt::format(
            "{}{}.{}E{}{}",
            random() % 2 == 0 ? "-" : " ",
            plain[0],
            plain.substr(1),
            exponent < 0 ? '-' : '+',
            form
        );
        text.insert(0, (wide ? 22 : 20) - text.size(), ' ');
        double value = 0;
        if (!ansys::cdb::fast_real(text.data(), text.size(), wide ? 13 : 9, value)) continue;
        ++fast;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(*parse_double(text)))
            << text;
    }
    EXPECT_GT(fast, 100'000);
    double value = 0;
    for (const char* other :
         {"0.0000000000000D+000 ",
          " 1.000000000000 E+000",
          "11.0000000000000E+000",
          "x1.0000000000000E+000",
          " 1.0000000000000E+0 0",
          "                     ",
          " 1.0000000000000E+999"})
        EXPECT_FALSE(ansys::cdb::fast_real(other, 21, 13, value)) << other;
}

struct NodeForm {
    const char* name;
    const char* head;
    const char* row;  ///< Node 219712 at 0.09893675783053, -0.000807092192240, 8.5376495335856.
};

TEST(CdbNodes, every_format_gives_the_same_node) {
    const NodeForm forms[] = {
        {"CDWRITE",
         "NBLOCK,6,SOLID,219712,1\n(3i9,6e21.13e3)\n",
         "   219712        0        0 9.8936757830530E-002-8.0709219224000E-004 8.5376495335856E+000\n"},
        {"older CDWRITE",
         "NBLOCK,6,SOLID,219712,1\n(3i8,6e20.13)\n",
         "  219712       0       0 9.8936757830530E-02-8.0709219224000E-04 8.5376495335856E+00\n"},
        {"nine wide",
         "NBLOCK,6,SOLID\n(3i9,6e20.13)\n",
         "   219712        0        0 9.8936757830530E-02-8.0709219224000E-04 8.5376495335856E+00\n"},
        {"three reals",
         "NBLOCK,3,SOLID\n(3i9,3e20.13)\n",
         "   219712        0        0 9.8936757830530E-02-8.0709219224000E-04 8.5376495335856E+00\n"},
        {"padded angles",
         "NBLOCK,6,SOLID,    3,    3\n(1i7,2i9,6e21.13)\n",
         " 219712        0        0  9.8936757830530E-02 -8.0709219224000E-04  8.5376495335856E+00  "
         "0.0000000000000E+00\n"},
        {"no entity",
         "nblock,6\n(1i9,6e21.13e3)\n",
         "   219712 9.8936757830530E-002-8.0709219224000E-004 8.5376495335856E+000\n"},
        {"no exponent letter",
         "NBLOCK,6,SOLID\n(3i9,6e21.13)\n",
         "   219712        0        0  9.8936757830530-002-8.0709219224000D-004      8.5376495335856\n"},
        {"carriage returns",
         "NBLOCK,6,SOLID\r\n(3i9,6e20.13)\r\n",
         "   219712        0        0 9.8936757830530E-02-8.0709219224000E-04 8.5376495335856E+00\r\n"},
    };
    for (const NodeForm& form : forms) {
        const auto opened = open_deck(std::string(form.head) + form.row + kEndOfNodes);
        ASSERT_EQ(opened.mesh().node_count(), 1u) << form.name;
        EXPECT_THAT(
            position_of(opened.mesh(), 219712),
            ElementsAre(0.09893675783053, -0.00080709219224, 8.5376495335856)
        ) << form.name;
        EXPECT_TRUE(opened.diagnostics->entries().empty())
            << form.name << test::all_texts(*opened.diagnostics);
    }
}

TEST(CdbNodes, workbench_ends_its_block_with_minus_one) {
    const auto opened =
        open_deck("/prep7\nnblock,3,,2\n(1i9,3e20.9e3)\n"
                  "        1     2.500000000E-02     0.000000000E+00    -1.000000000E-03\n-1\n"
                  "nblock,3\n(1i9,3e20.9e3)\n"
                  "     7354     1.000000000E+00     2.000000000E+00     3.000000000E+00\n-1\n");
    EXPECT_EQ(opened.mesh().node_count(), 2u);
    EXPECT_THAT(position_of(opened.mesh(), 1), ElementsAre(0.025, 0, -0.001));
    EXPECT_THAT(position_of(opened.mesh(), 7354), ElementsAre(1, 2, 3));
}

TEST(CdbNodes, numbers_may_touch_and_zeros_at_the_end_may_be_left_out) {
    const auto opened = open_deck(
        "NBLOCK,6,SOLID\n(3i9,6e20.13)\n"
        "   434596        0        0-4.4672751426697E+00\n"
        "   434597        0        0\n"
        "   434598\n"
        "   434599        0        0 1.0000000000000E+00                    -2.0000000000000E+00\n" +
        kEndOfNodes
    );
    EXPECT_THAT(position_of(opened.mesh(), 434596), ElementsAre(-4.4672751426697, 0, 0));
    EXPECT_THAT(position_of(opened.mesh(), 434597), ElementsAre(0, 0, 0));
    EXPECT_THAT(position_of(opened.mesh(), 434598), ElementsAre(0, 0, 0));
    EXPECT_THAT(position_of(opened.mesh(), 434599), ElementsAre(1, 0, -2));
}

TEST(CdbNodes, angles_turn_the_nodal_system) {
    const auto opened = open_deck(
        "NBLOCK,6,SOLID\n(3i8,6e16.9)\n"
        "       7       0       0 1.000000000E+00\n"
        "       8       0       0 1.000000000E+00 0.000000000E+00 0.000000000E+00"
        " 9.000000000E+01-4.500000000E+01\n" +
        kEndOfNodes
    );
    ASSERT_EQ(opened.mesh().node_angles.size(), 2u);
    EXPECT_THAT(opened.mesh().node_angles[0], ElementsAre(0, 0, 0));
    EXPECT_THAT(opened.mesh().node_angles[1], ElementsAre(90, -45, 0));
}

TEST(CdbNodes, a_node_given_twice_is_where_the_later_block_puts_it) {
    const std::string head = "NBLOCK,6,SOLID\n(3i8,6e16.9)\n       7       0       0 ";
    const auto opened =
        open_deck(head + "1.000000000E+00\n" + kEndOfNodes + head + "2.000000000E+00\n" + kEndOfNodes);
    EXPECT_THAT(position_of(opened.mesh(), 7), ElementsAre(2, 0, 0));
    EXPECT_EQ(opened.diagnostics->count(Code::DuplicateNode), 1u);
}

TEST(CdbNodes, rows_read_fast_are_the_rows_read_slowly) {
    // The same numbers in rows alike, and in rows whose every second is spaced so that the fast way refuses
    // it.
    for (const char* line_end : {"\n", "\r\n"}) {
        std::string alike = fmt::format("NBLOCK,6,SOLID{0}(3i9,6e21.13e3){0}", line_end);
        std::string mixed = alike;
        for (int i = 1; i <= 40; ++i) {
            const std::string row = fmt::format(
                "{:9}{:9}{:9} {}.2345678901234E+00{}-{}.9876543210987E-00{}",
                i,
                i % 7,
                0,
                i % 10,
                i % 9,
                i % 3,
                i % 5
            );
            // Now and then a row leaves its last number out, or comes with angles.
            const std::string more = i % 11 == 0 ? "" : " 3.0000000000000E+000";
            alike += row + more + (i % 13 == 0 ? " 9.0000000000000E+001" : "") + line_end;
            std::string slow = row;
            if (i % 2 == 0) slow[slow.find('E')] = 'e';
            mixed += slow + more + (i % 13 == 0 ? " 9.0000000000000E+001" : "") + line_end;
        }
        const auto fast = open_deck(alike + kEndOfNodes);
        const auto slow = open_deck(mixed + kEndOfNodes);
        ASSERT_EQ(fast.mesh().node_count(), 40u);
        EXPECT_EQ(fast.mesh().coordinates, slow.mesh().coordinates);
        EXPECT_EQ(fast.mesh().node_angles, slow.mesh().node_angles);
        EXPECT_THAT(position_of(fast.mesh(), 22), ElementsAre(22345.678901234, -0.019876543210987, 0));
        EXPECT_EQ(fast.mesh().node_angles.at(25)[0], 90);
    }
}

TEST(CdbElements, rows_alike_and_rows_that_are_not_follow_each_other) {
    const auto row = [](int material, int count, int id, const std::vector<int>& nodes, const char* line_end
                     ) {
        std::string text = fmt::format(
            "{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}",
            material,
            count == 20 ? 2 : 1,
            1,
            1,
            0,
            0,
            0,
            0,
            count,
            0,
            id
        );
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            text += fmt::format("{:9}", nodes[i]);
            if (i == 7 && nodes.size() > 8) text += line_end;
        }
        return text + line_end;
    };
    for (const char* line_end : {"\n", "\r\n"}) {
        std::string deck = "/PREP7\nNBLOCK,6\n(1i9)\n";
        for (int i = 1; i <= 60; ++i) deck += fmt::format("{:9}\n", i);
        deck += fmt::format("-1\nET,1,185\nET,2,186{0}EBLOCK,19,SOLID{0}(19i9){0}", line_end);
        std::map<int, std::vector<std::int64_t>> expected;
        for (int id = 1; id <= 40; ++id) {
            const int count = id % 10 < 5 ? 8 : 20;
            std::vector<int> nodes;
            for (int i = 0; i < count; ++i) nodes.push_back(1 + (id + i) % 60);
            if (id % 9 == 0 && count == 20) nodes[13] = 0;  // A left-out mid-side node.
            deck += row(1 + id % 4 / 2, count, id, nodes, line_end);
            if (id % 17 == 0) deck += line_end;
            expected[id].assign(nodes.begin(), nodes.end());
        }
        const auto opened = open_deck(deck + "       -1\n");
        ASSERT_EQ(opened.mesh().element_count(), 40u);
        for (const auto& [id, nodes] : expected) {
            EXPECT_EQ(nodes_of(opened.mesh(), id), nodes) << id;
            EXPECT_EQ(test::part_of(opened.mesh(), id), fmt::format("material {}", 1 + id % 4 / 2));
        }
    }
}

TEST(CdbNodes, an_overflowed_column_is_a_missing_coordinate) {
    const auto opened =
        open_deck("NBLOCK,6,SOLID\n(3i8,6e16.9)\n       7       0       0****************\n" + kEndOfNodes);
    EXPECT_TRUE(std::isnan(position_of(opened.mesh(), 7)[0]));
    EXPECT_EQ(opened.diagnostics->count(Code::NonFiniteValue), 1u);
}

TEST(CdbNodes, damaged_rows_name_their_line) {
    const std::string head =
        "/PREP7\nNBLOCK,6,SOLID\n(3i9,6e20.13)\n        1        0        0 1.0000000000000E+00\n";
    expect_error(
        head + "        2        0        0 1.00000x0000000E+00\n" + kEndOfNodes,
        Code::BadNumber,
        "deck.cdb:5",
        "NBLOCK"
    );
    expect_error(
        head + "        0        0        0 1.0000000000000E+00\n" + kEndOfNodes,
        Code::BadNumber,
        "deck.cdb:5",
        "NBLOCK"
    );
    expect_error(
        head + "        2        0        0 1.00" + std::string(40, '\0'),
        Code::Truncated,
        "deck.cdb:5",
        "zero"
    );
    expect_error(
        "/PREP7\nNBLOCK,6,SOLID\n        1        0        0\n",
        Code::BadStructure,
        "deck.cdb:2",
        "(3i9,6e21.13e3)"
    );
    expect_error("/PREP7\nNBLOCK,6,SOLID", Code::Truncated, "deck.cdb:2", "end of the file");
    expect_error("/PREP7\nFINISH\n", Code::NoNodes, "deck.cdb", "NBLOCK");
}

TEST(CdbNodes, a_file_that_ends_in_a_block_gives_whole_rows_only) {
    const auto opened = open_deck("NBLOCK,6,SOLID,9,9\n(3i9,6e20.13)\n"
                                  "        1        0        0 1.0000000000000E+00\n"
                                  "        2        0        0 1.0000000000000E+00 2.00");
    EXPECT_EQ(opened.mesh().node_count(), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::TruncatedInput), 1u);
}

TEST(CdbElements, every_width_gives_the_same_brick) {
    for (const int width : {7, 8, 9, 10}) {
        std::string row;
        for (const int field : {3, 1, 1, 1, 0, 0, 0, 0, 8, 0, 41, 1, 2, 3, 4, 5, 6, 7, 8})
            row += fmt::format("{:{}}", field, width);
        const auto opened = open_deck(with_cube(
            fmt::format("ET,1,185\nEBLOCK,19,SOLID,41,1\n(19i{})\n{}\n{:{}}\n", width, row, -1, width)
        ));
        EXPECT_THAT(nodes_of(opened.mesh(), 41), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8)) << width;
        EXPECT_EQ(test::part_of(opened.mesh(), 41), "material 3");
        EXPECT_TRUE(opened.diagnostics->entries().empty()) << test::all_texts(*opened.diagnostics);
    }
}

const std::string kBrickRow =
    "        1        1        1        1        0        0        0        0        8        0       41"
    "        1        2        3        4        5        6        7        8\n";

TEST(CdbElements, a_block_may_end_with_the_file) {
    const std::string deck = with_cube("ET,1,185\nEBLOCK,19,SOLID,41,1\n(19i9)\n" + kBrickRow);
    EXPECT_TRUE(open_deck(deck).diagnostics->entries().empty());
    const auto cut = open_deck(deck.substr(0, deck.size() - 6));
    EXPECT_EQ(cut.mesh().element_count(), 0u);
    EXPECT_EQ(cut.diagnostics->count(Code::TruncatedInput), 1u);
}

TEST(CdbElements, announced_counts_are_not_believed) {
    const auto more = open_deck(
        with_cube("ET,1,185\nEBLOCK,19,SOLID,999999999,999999999\n(19i9)\n" + kBrickRow + "       -1\n")
    );
    EXPECT_EQ(more.mesh().element_count(), 1u);
    const auto fewer =
        open_deck(with_cube("ET,1,185\nEBLOCK,19,SOLID,1,0\n(19i9)\n" + kBrickRow + "       -1\n"));
    EXPECT_EQ(fewer.mesh().element_count(), 1u);
}

TEST(CdbElements, hypermeshs_uneven_columns_are_read) {
    const auto opened =
        open_deck(with_cube("ET,1,181\nTYPE, 1  $ MAT, 1  $ REAL, 1\nEBLOCK,19,SOLID      ,1\n(19i8)\n"
                            "       1       1       1       0       0       0       0      0        4       "
                            "0      12       1       2       3       4\n"
                            "      -1\n"));
    EXPECT_THAT(nodes_of(opened.mesh(), 12), ElementsAre(1, 2, 3, 4));
}

TEST(CdbElements, short_and_degenerate_rows_have_their_shapes) {
    const auto row = [](int type, int count, int id, std::vector<int> nodes) {
        std::string text = fmt::format(
            "{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}", 1, type, 1, 1, 0, 0, 0, -7, count, 0, id
        );
        for (const int node : nodes) text += fmt::format("{:9}", node);
        return text + "\n";
    };
    const auto opened = open_deck(with_cube(
        "ET,1,185\nET,2,92\nET,3,226\nET,4,188\nET,5,181\nEBLOCK,19,SOLID\n(19i9)\n" +
        row(1, 8, 1, {1, 2, 3, 3, 5, 6, 7, 7}) + row(2, 7, 2, {1, 2, 3, 5, 4, 0, 6}) +
        row(3, 8, 3, {1, 2, 3, 4, 5, 6, 7, 8}) + row(4, 3, 4, {1, 2, 8}) + row(5, 4, 5, {1, 2, 3, 3}) +
        "       -1\n"
    ));
    EXPECT_THAT(
        test::element_counts(opened.mesh()),
        (std::map<std::string, std::size_t>{
            {"wedge6", 1}, {"tet10", 1}, {"hex8", 1}, {"line2", 1}, {"tri3", 1}})
    );
    EXPECT_THAT(nodes_of(opened.mesh(), 2), ElementsAre(1, 2, 3, 5, 4, 0, 6, 0, 0, 0));
    EXPECT_THAT(nodes_of(opened.mesh(), 4), ElementsAre(1, 2));
}

TEST(CdbElements, rows_of_twenty_nodes_take_two_lines) {
    std::string nodes = "/PREP7\nNBLOCK,6,SOLID\n(3i9,6e21.13e3)\n";
    for (int i = 1; i <= 20; ++i)
        nodes += fmt::format("{:9}{:9}{:9} {}.0000000000000E+000\n", i, 0, 0, i % 10);
    nodes += kEndOfNodes;
    std::string ids, first, rest;
    for (int i = 1; i <= 20; ++i) (i <= 8 ? first : rest) += fmt::format("{:9}", i);
    const std::string attributes =
        fmt::format("{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}", 1, 1, 1, 1, 0, 0, 0, 0, 20, 0, 5);
    const auto solid = open_deck(
        nodes + "ET,1,186\nEBLOCK,19,SOLID\n(19i9)\n" + attributes + first + "\n" + rest + "\n       -1\n"
    );
    EXPECT_EQ(nodes_of(solid.mesh(), 5).size(), 20u);
    EXPECT_EQ(nodes_of(solid.mesh(), 5).back(), 20);
    // COMPACT: eleven columns a line; the type is the current one.
    std::string compact_first = fmt::format("{:9}", 5), compact_rest;
    for (int i = 1; i <= 20; ++i) (i <= 10 ? compact_first : compact_rest) += fmt::format("{:9}", i);
    const std::string two = compact_first + "\n" + compact_rest + "\n";
    std::string second = two;
    second.replace(0, 9, "        6");
    const auto compact = open_deck(
        nodes + "et,1,154\net,2,186\nMAT,4 $ TYPE,2 $ REAL,1\neblock,11,COMPACT,,2\n(11i9)\n" + two + second +
        "-1\n"
    );
    EXPECT_EQ(compact.mesh().element_count(), 2u);
    EXPECT_EQ(nodes_of(compact.mesh(), 6), nodes_of(solid.mesh(), 5));
    EXPECT_EQ(test::part_of(compact.mesh(), 5), "material 4");
    const auto plain = open_deck(
        nodes + "et,2,186\neblock,10,,,1\n(15i9)\n" + fmt::format("{:9}{:9}{:9}{:9}{:9}", 5, 2, 1, 3, 0) +
        compact_first.substr(9) + "\n" + compact_rest + "\n-1\n"
    );
    EXPECT_EQ(nodes_of(plain.mesh(), 5), nodes_of(solid.mesh(), 5));
    EXPECT_EQ(test::part_of(plain.mesh(), 5), "material 3");
}

TEST(CdbElements, an_element_given_twice_counts_once) {
    const auto opened =
        open_deck(with_cube("ET,1,185\nEBLOCK,19,SOLID\n(19i9)\n" + kBrickRow + kBrickRow + "       -1\n"));
    EXPECT_EQ(opened.mesh().element_count(), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::DuplicateElement), 1u);
}

TEST(CdbElements, damaged_rows_name_their_line) {
    const std::string head = with_cube("ET,1,185\nEBLOCK,19,SOLID\n(19i9)\n");
    std::string row = kBrickRow;
    row.replace(99 + 8, 1, "x");
    expect_error(head + row + "       -1\n", Code::BadNumber, "deck.cdb:16", "EBLOCK");
    row = kBrickRow;
    row.replace(97, 2, " 0");
    expect_error(head + row + "       -1\n", Code::BadNumber, "deck.cdb:16", "EBLOCK");
    expect_error(
        with_cube("EBLOCK,19,SOLID\n(3i9,4e20.3)\n"), Code::BadStructure, "deck.cdb:13", "one width"
    );
}

TEST(CdbElements, nodes_that_are_not_there_leave_their_element_out) {
    std::string row = kBrickRow;
    row.replace(99 + 7, 2, "77");
    const auto opened = open_deck(with_cube("ET,1,185\nEBLOCK,19,SOLID\n(19i9)\n" + row + "       -1\n"));
    EXPECT_EQ(opened.mesh().element_count(), 0u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownNode), 1u);
}

TEST(CdbComponents, a_negative_number_ends_a_range_even_on_the_next_row) {
    const auto opened = open_deck(with_cube(
        "ET,1,185\nEBLOCK,19,SOLID\n(19i9)\n" + kBrickRow +
        "       -1\n"
        "CMBLOCK,MY.SIDE ,NODE,       5  ! users node component definition\n(2i10)\n"
        "         1        -3\n         3         6\n        -7\n"
        "CMBLOCK,ALL_OF_IT,ELEM,      2,,,,1\n(8i10)\n         1-999999999\nFINISH\n"
    ));
    const Mesh& mesh = opened.mesh();
    ASSERT_EQ(mesh.node_sets.size(), 1u);
    EXPECT_EQ(mesh.node_sets[0].name, "MY.SIDE");
    EXPECT_THAT(
        mesh.node_sets[0].nodes,
        ElementsAre(NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{5}, NodeIndex{6})
    );
    ASSERT_EQ(mesh.element_sets.size(), 1u);
    EXPECT_EQ(mesh.element_sets[0].name, "ALL_OF_IT");
    EXPECT_THAT(mesh.element_sets[0].elements, ElementsAre(ElementIndex{0}));
}

TEST(CdbComponents, more_members_than_a_deck_can_mean_are_refused) {
    std::string deck = with_cube("");
    for (int i = 0; i < 2000; ++i) deck += "CMBLOCK,A,NODE\n(2i4)\n   1-999\n";
    EXPECT_NO_THROW(open_deck(deck));
    std::string nodes = "NBLOCK,6\n(1i9)\n";
    for (int i = 1; i <= 2000; ++i) nodes += fmt::format("{:9}\n", i);
    deck = nodes + "-1\n";
    for (int i = 0; i < 2000; ++i) deck += "CMBLOCK,A,NODE\n(2i9)\n        1-99999999\n";
    expect_error(deck, Code::TooLarge, "deck.cdb", "components");
}

}  // namespace
}  // namespace feelem
