// SPDX-License-Identifier: Apache-2.0
// Rows taken the fast way are what the general way makes of them, whole and damaged. A plus sign before a
// row's label sends it the general way and changes nothing else.
#include "base/parallel.hpp"
#include "read/abaqus/deck_mesh.hpp"
#include "read/abaqus/deck_model.hpp"
#include "support/mesh_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {
namespace {

using namespace abaqus;

/// Rows need room behind them to be taken the fast way.
std::string comments() {
    std::string text;
    for (int i = 0; i < 40; ++i)
        text += "** a comment of some length, so that there is room behind the rows\n";
    return text;
}

std::optional<DeckModel> model_of(const std::string& text) {
    const std::vector<Input> inputs{Input::from_memory("deck.inp", text)};
    Diagnostics diagnostics;
    try {
        return read_deck(scan_decks(inputs, nullptr, diagnostics), diagnostics);
    } catch (const Error&) {
        return {};
    }
}

/// Everything that rows say, bit for bit.
std::string written_out(const std::optional<DeckModel>& model) {
    if (!model) return "refused";
    std::string text;
    const Scope& scope = model->model;
    for (std::size_t i = 0; i < scope.node_ids.size(); ++i) {
        text += fmt::format("{}", scope.node_ids[i]);
        for (const double x : scope.places[i]) text += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(x));
        text += '\n';
    }
    for (const ElementRun& run : scope.runs) {
        text += fmt::format("{}:", run.type_name);
        for (const Label id : run.ids) text += fmt::format(" {}", id);
        for (const Label node : run.nodes) text += fmt::format(" {}", node);
        text += '\n';
    }
    return text;
}

struct Rows {
    std::string keyword;
    std::vector<std::string> rows;

    std::string text(std::string_view sign) const {
        // Rows need some room before them too.
        std::string out = "** a comment of some length before the first row\n" + keyword + "\n";
        for (const std::string& row : rows) {
            const std::size_t first = std::min(row.find_first_not_of(' '), row.size());
            const bool is_row = first < row.size() && row[first] >= '0' && row[first] <= '9';
            out += row.substr(0, first) + (is_row ? std::string(sign) : "") + row.substr(first);
        }
        return out + comments();
    }
};

/// Nodes and elements as programs write them: padded, tight, with what is left out, over two lines.
std::vector<Rows> usual_rows() {
    return {
        {"*NODE",
         {"      1,  0.361615419,   0.55636102,  0.737931371\n",
          "      2,   10.6742878,  0.924606025,  0.996024013\n",
          "      3,  -20.6742878, -0.924606025,           0.\n",
          "     14,  1.5e-05    ,  1.5E+05    ,          -2.\n"}},
        {"*NODE", {"1, 1.5, 2.5, 3.5\n", "2, 2.5, 3.5, 4.5\n", "3, 1.5, 3.25\n", "14,1,2,3\n", "15, 7.\n"}},
        {"*NODE",
         {"1,1.0000000000000000e+00,2.5000000000000000e-01,3.0\r\n",
          "2,1.5,2.5,3.5\r\n",
          "3,1.5,2.5,3.5\r\n"}},
        {"*ELEMENT, TYPE=C3D8",
         {"      1,       1,       2,     102,     101,   10001,   10002,   10102,   10101\n",
          "      2,       2,       3,     103,     102,   10002,   10003,   10103,   10102\n",
          "      3,       3,       4,     104,     103,   10003,   10004,   10104,   10103\n"}},
        {"*ELEMENT, TYPE=C3D4",
         {"1,1,2,3,4\n", "2,2,3,4,5\n", "3,3,4,5,6\n", "14,24,25,26,27\n", "15,25,26,27,28\n"}},
        {"*ELEMENT, TYPE=C3D10",
         {"1, 1, 2, 3, 4, 5, 6,\n7, 8, 9, 10\n",
          "2, 1, 2, 3, 4, 5, 6,\n7, 8, 9, 11\n",
          "3, 1, 2, 3, 4, 5, 6,\n 7, 8, 9, 11\n",
          "4, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n"}},
        {"*ELEMENT, TYPE=C3D10",
         {"1, 1, 2, 3, 4, 5, 6,\r\n7, 8, 9, 10\r\n", "2, 1, 2, 3, 4, 5, 6,\r\n7, 8, 9, 11\r\n"}},
        {"*ELEMENT, TYPE=B31", {"1, 1, 2\n", "2, 2, 3\n", "3, 3, 4\n"}},
    };
}

TEST(PlainRows, are_what_the_general_way_makes_of_them) {
    for (const Rows& rows : usual_rows()) {
        const auto model = model_of(rows.text(""));
        ASSERT_TRUE(model.has_value()) << rows.text("").substr(0, 200);
        EXPECT_EQ(written_out(model), written_out(model_of(rows.text("+"))));
        const std::size_t found =
            model->model.node_ids.size() + (model->model.runs.empty() ? 0 : model->model.runs[0].ids.size());
        EXPECT_EQ(found, rows.rows.size());
    }
}

TEST(PlainRows, damaged_are_what_the_general_way_makes_of_them) {
    constexpr std::string_view kStrange = " \t\n\r,,*+-.0123456789eEdD";
    std::mt19937 random(3);
    const auto below = [&](std::size_t n) { return random() % n; };
    std::size_t read = 0;
    for (int round = 0; round < 1500; ++round) {
        for (Rows rows : usual_rows()) {
            std::string& row = rows.rows[1 + below(rows.rows.size() - 1)];
            for (std::size_t k = 0; k < 1 + below(2); ++k) {
                // Behind the label, before which the sign goes.
                const std::size_t first = row.find_first_of("0123456789") + 1;
                if (first + 1 >= row.size()) break;
                const std::size_t at = first + below(row.size() - 1 - first);  // Its end stays.
                const char c = kStrange[below(kStrange.size())];
                switch (below(3)) {
                case 0: row[at] = c; break;
                case 1: row.insert(at, 1, c); break;
                default: row.erase(at, 1); break;
                }
            }
            const auto model = model_of(rows.text(""));
            read += model.has_value() ? 1U : 0U;
            ASSERT_EQ(written_out(model), written_out(model_of(rows.text("+"))))
                << rows.text("").substr(0, 400);
        }
    }
    EXPECT_GT(read, 4'000U);
}

/// Everything that a deck's mesh says, and what was said about it.
std::string mesh_written_out(const std::string& text, unsigned threads) {
    set_thread_count(threads);
    Diagnostics diagnostics;
    std::string out;
    try {
        const std::vector<Input> inputs{Input::from_memory("deck.inp", text)};
        const Deck deck = scan_decks(inputs, nullptr, diagnostics);
        DeckModel model = read_deck(deck, diagnostics);
        out = written_out(model);
        out += test::mesh_text(build_mesh(deck, model, diagnostics));
    } catch (const Error& error) {
        out = error.what();
    }
    out += test::diagnostics_text(diagnostics);
    set_thread_count(0);
    return out;
}

/// Some megabytes of rows; now and then something stands among them that is not plain.
std::string large_deck(bool odd) {
    std::string deck = "*HEADING\nlarge\n** so that there are bytes before the first row\n*NODE, NSET=ALL\n";
    for (int id = 1; id <= 90'000; ++id) {
        if (odd && id % 9001 == 0) deck += "** a comment, with a comma\n\n";
        if (odd && id % 11'003 == 0) {
            deck += fmt::format("+{}, {}., 1.5\n", id, id);
        } else {
            deck += fmt::format("{:7}, {:>12}, {:>12}, -{}.125\r\n", id, id + 0.25, id % 7 + 0.5, id % 11);
        }
    }
    deck += "*ELEMENT, TYPE=C3D10, ELSET=SOLID\n";
    for (int id = 1; id <= 40'000; ++id) {
        if (odd && id % 7001 == 0) deck += "** between rows\n";
        const int last = odd && id % 5003 == 0 ? 95'000 + id : id + 10;
        const char* const end = odd && id % 13'007 == 0 ? ",\n** within a row\n" : ",\n";
        deck += fmt::format(
            "{0:7}, 1, 2, 3, 4, 5, 6{1}      {2}, 8, 9, {3}\n", id, end, 7 + (id % 50'000), last + 100
        );
    }
    deck += "*ELEMENT, TYPE=C3D4\n";
    for (int id = 50'001; id <= 90'000; ++id)
        deck += fmt::format("{},{},{},{},{}\n", id, id - 3, id - 2, id - 1, id);
    return deck + "*SOLID SECTION, ELSET=SOLID\n";
}

TEST(PlainRows, are_the_same_whatever_the_number_of_threads) {
    for (const bool odd : {false, true}) {
        const std::string deck = large_deck(odd);
        ASSERT_GT(deck.size(), 6'000'000U);
        const std::string one = mesh_written_out(deck, 1);
        EXPECT_EQ(one, mesh_written_out(deck, 4));
        EXPECT_EQ(one.find("unknown_node deck.inp:") != std::string::npos, odd)
            << one.substr(one.size() - 300);
    }
}

TEST(PlainRows, damaged_far_behind_are_reported_where_they_stand_whatever_the_number_of_threads) {
    std::string deck = large_deck(false);
    const std::size_t at = deck.find("  80000,");
    ASSERT_NE(at, std::string::npos);
    deck[at + 12] = 'x';
    const std::string one = mesh_written_out(deck, 1);
    EXPECT_NE(one.find("deck.inp:80004"), std::string::npos) << one.substr(0, 300);
    EXPECT_EQ(one, mesh_written_out(deck, 4));
}

TEST(PlainRows, at_the_start_and_the_end_of_a_file_are_read_too) {
    const auto model = model_of("*NODE\n1,1,2,3\n2,2,3,4\n3,3,4,5");

    ASSERT_TRUE(model.has_value());
    EXPECT_EQ(model->model.node_ids, (std::vector<Label>{1, 2, 3}));
    EXPECT_EQ(model->model.places[2], (Point3{3, 4, 5}));
}

}  // namespace
}  // namespace feelem
