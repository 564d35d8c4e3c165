// SPDX-License-Identifier: Apache-2.0
// Long blocks are read in chunks of about a megabyte, by several threads: the mesh is that of the same rows
// in many short blocks, whatever the number of threads.
#include "base/parallel.hpp"
#include "read/ansys/cdb_deck.hpp"
#include "read/ansys/element_adder.hpp"
#include "read_ansys_cdb/opened_deck.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <random>

namespace feelem {
namespace {

using test::open_deck;

constexpr int kNodes = 40'000;
constexpr int kElements = 16'000;

/// As many threads as asked for while it lives.
struct Threads {
    explicit Threads(unsigned count) { set_thread_count(count); }
    ~Threads() { set_thread_count(0); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
};

/// Rows of kinds that readers must tell apart, cut into blocks of `most` rows: zeros left out at the end,
/// turned nodal systems, no number at all; elements of one line and of two, unknown nodes, collapsed corners,
/// left-out mid-side nodes, repeated numbers, parts and types in turn, many of which no command names.
class LongDeck {
public:
    LongDeck(std::size_t most, const char* line_end) : most_(most), end_(line_end) {
        text_ = fmt::format("/PREP7{0}ET,1,185{0}ET,2,186{0}ET,3,187{0}ET,4,188{0}", end_);
        add_nodes();
        add_elements();
    }
    const std::string& text() const { return text_; }

private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    }

    void add_nodes() {
        for (std::size_t row = 0; row < kNodes; ++row) {
            const int id = static_cast<int>(row) + 1;
            if (row % most_ == 0) add("NBLOCK,6,SOLID{0}(3i9,6e21.13e3){0}", end_);
            add("{:9}{:9}{:9}", id, 0, 0);
            const int reals = id % 7 == 0 ? 2 : id % 5003 == 0 ? 6 : 3;
            for (int i = 0; i < reals; ++i) {
                if (id % 6007 == 0 && i == 0) {
                    add("{:>21}", "NaN");
                    continue;
                }
                const std::string digits =
                    fmt::format("{:.13E}", std::ldexp(random_() % 100'000'000, -12) - 9000);
                add("{:>17}{}{}",
                    digits.substr(0, digits.find('E') + 1),
                    digits[digits.find('E') + 1],
                    "0" + digits.substr(digits.find('E') + 2));
            }
            text_ += end_;
            if (row % most_ == most_ - 1 || row + 1 == kNodes) add("N,R5.3,LOC,       -1,{}", end_);
        }
    }

    void add_elements() {
        for (std::size_t row = 0; row < kElements; ++row) {
            if (row % most_ == 0) add("EBLOCK,19,SOLID{0}(19i9){0}", end_);
            add_element(static_cast<int>(row) + 1);
            if (row % most_ == most_ - 1 || row + 1 == kElements) add("{:9}{}", -1, end_);
        }
    }

    void add_element(int row) {
        const bool is_named = row % 13 != 0;
        const int type = !is_named             ? 5 + row / 400
                         : row < kElements / 2 ? 1
                                               : 1 + static_cast<int>(random_() % 4);
        const std::size_t count = type == 1 || !is_named ? 8 : type == 2 ? 20 : type == 3 ? 10 : 3;
        std::vector<int> nodes(count);
        // Far apart, so that no corner is repeated by chance.
        for (std::size_t i = 0; i < count; ++i)
            nodes[i] = 1 + static_cast<int>((random_() % 1900) + 2000 * i);
        if (row % 97 == 0 && type == 1) nodes[3] = nodes[2], nodes[7] = nodes[6];
        if (row % 101 == 0) nodes[1] = kNodes + row;
        if (row % 103 == 0 && type == 2) nodes[9] = 0;
        const int id = row % 211 == 0 ? row - 100 : row;
        const int material = 1 + row / 700 % 3;
        add("{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}", material, type, 1, 1, 0, 0, 0, 0, count, 0, id);
        for (std::size_t i = 0; i < count; ++i) {
            if (i == 8) text_ += end_;
            add("{:9}", nodes[i]);
        }
        text_ += end_;
    }

    std::size_t most_;
    const char* end_;
    std::string text_;
    std::mt19937 random_{11};
};

bool same_bits(const Point3& a, const Point3& b) {
    return std::ranges::equal(a, b, [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

void expect_same_mesh(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.node_ids, b.node_ids);
    EXPECT_TRUE(std::ranges::equal(a.coordinates, b.coordinates, same_bits));
    EXPECT_EQ(a.node_angles, b.node_angles);
    ASSERT_EQ(a.blocks.size(), b.blocks.size());
    for (std::size_t i = 0; i < a.blocks.size(); ++i) {
        EXPECT_EQ(a.blocks[i].type, b.blocks[i].type);
        EXPECT_EQ(a.blocks[i].ids, b.blocks[i].ids);
        EXPECT_EQ(a.blocks[i].parts, b.blocks[i].parts);
        EXPECT_EQ(a.blocks[i].nodes, b.blocks[i].nodes);
    }
    EXPECT_TRUE(std::ranges::equal(a.parts, b.parts, {}, &Part::name, &Part::name));
    EXPECT_EQ(a.skipped_elements, b.skipped_elements);
}

void expect_same_losses(const Diagnostics& a, const Diagnostics& b) {
    for (const Code code :
         {Code::UnknownNode,
          Code::DuplicateElement,
          Code::DegenerateElement,
          Code::MissingMidside,
          Code::SkippedElement,
          Code::GuessedElementType,
          Code::NonFiniteValue,
          Code::TruncatedInput}) {
        EXPECT_EQ(a.count(code), b.count(code)) << code_info(code).word;
    }
}

TEST(CdbChunks, a_long_block_is_read_like_many_short_ones_by_any_number_of_threads) {
    for (const char* line_end : {"\n", "\r\n"}) {
        const auto pieces = open_deck(LongDeck(300, line_end).text());
        EXPECT_GT(pieces.diagnostics->count(Code::UnknownNode), 0u);
        EXPECT_GT(pieces.diagnostics->count(Code::DuplicateElement), 0u);
        EXPECT_GT(pieces.diagnostics->count(Code::DegenerateElement), 0u);
        EXPECT_EQ(pieces.diagnostics->count(Code::NonFiniteValue), static_cast<std::uint64_t>(kNodes / 6007));
        EXPECT_FALSE(pieces.mesh().node_angles.empty());
        const LongDeck whole(1'000'000, line_end);
        ASSERT_GT(whole.text().size(), 5u << 20u) << "too short for several chunks";
        for (const unsigned count : {1U, 2U, 4U}) {
            const Threads threads(count);
            const auto opened = open_deck(whole.text());
            expect_same_mesh(opened.mesh(), pieces.mesh());
            expect_same_losses(*opened.diagnostics, *pieces.diagnostics);
        }
    }
}

/// Nothing tells whether a full line begins an element: half of the chunks begin in the middle of one.
TEST(CdbChunks, a_chunk_that_begins_inside_an_element_is_read_again) {
    const auto deck = [](int rows) {
        std::string text = "ET,1,186\nNBLOCK,6\n(3i8,6e16.9)\n";
        for (int id = 1; id <= 200; ++id)
            text += fmt::format("{:8}{:8}{:8}{:16.9E}{:16.9E}\n", id, 0, 0, 0.5 * id, 0.25 * id * id);
        text += "N,R5.3,LOC,       -1,\n";
        for (int id = 1; id <= 15'000; ++id) {
            if ((id - 1) % rows == 0) text += "EBLOCK,10\n(15i8)\n";
            text += fmt::format("{:8}{:8}{:8}{:8}{:8}", id, 1, 1, 1 + id / 4000, 0);
            for (int i = 0; i < 10; ++i) text += fmt::format("{:8}", 1 + (id + 7 * i) % 200);
            text += '\n';
            for (int i = 10; i < 20; ++i) text += fmt::format("{:8}", 1 + (id + 7 * i) % 200);
            text += fmt::format("{:8}{:8}{:8}{:8}{:8}\n", 0, 0, 0, 0, 0);
            if (id % rows == 0 || id == 15'000) text += "      -1\n";
        }
        return text;
    };
    const auto pieces = open_deck(deck(100));
    ASSERT_EQ(pieces.mesh().element_count(), 15'000u) << test::all_texts(*pieces.diagnostics);
    for (const unsigned count : {1U, 3U}) {
        const Threads threads(count);
        expect_same_mesh(open_deck(deck(1'000'000)).mesh(), pieces.mesh());
    }
}

TEST(CdbChunks, of_two_bad_rows_the_first_is_told) {
    const Threads threads(4);
    const LongDeck whole(1'000'000, "\n");
    std::string text = whole.text();
    const std::size_t rows = text.find("(3i9");
    const std::size_t first = text.find('\n', rows + 2'000'000), second = text.find('\n', rows + 2'900'000);
    text[first + 5] = 'x';
    text[second + 5] = 'x';
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(first) + 1, '\n');
    try {
        open_deck(text);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.where(), fmt::format("deck.cdb:{}", line));
    }
}

/// Alike rows of bricks, `count` as the command announces them; `hidden` stands for as many bytes of rows in
/// their midst.
std::string even_deck(const std::string& count, const std::string& hidden, const char* line_end) {
    std::string text = "/PREP7" + std::string(line_end) + "ET,1,185" + line_end;
    const auto block = [&](const char* head, const char* format, int rows, const auto& row) {
        text += head + count + line_end + format + line_end;
        for (int i = 1; i <= rows; ++i) text += row(i) + line_end;
    };
    block("NBLOCK,6,SOLID", "(3i9,6e21.13e3)", 12'000, [](int i) {
        return fmt::format(
            "{:9}{:9}{:9}{:16.13f}E+000{:16.13f}E+000{:16.13f}E+000",
            i,
            0,
            0,
            1.5,
            i % 7 + 0.25,
            i % 9 + 0.125
        );
    });
    text += std::string("N,R5.3,LOC,       -1,") + line_end;
    const std::size_t first = text.size();
    block("EBLOCK,19,SOLID", "(19i9)", 12'000, [](int i) {
        std::string row =
            fmt::format("{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}{:9}", 1, 1, 1, 1, 0, 0, 0, 0, 8, 0, i);
        for (int k = 0; k < 8; ++k) row += fmt::format("{:9}", i % 1000 + 1000 * k + 1);
        return row;
    });
    if (!hidden.empty()) {
        const std::size_t size = 19 * 9 + std::string(line_end).size();
        const std::size_t middle =
            text.find(line_end, text.find(line_end, first) + 1) + std::string(line_end).size() + 7000 * size;
        if (hidden.size() == size) return text.replace(middle, size, hidden) + "       -1" + line_end;
        const std::size_t taken = (hidden.size() / size + 1) * size;
        const std::size_t padding = taken - hidden.size() - 1 - std::string(line_end).size();
        // The comment comes behind the first line, which ends the block.
        const std::size_t head = hidden.find(line_end) + std::string(line_end).size();
        text.replace(
            middle,
            taken,
            hidden.substr(0, head) + "!" + std::string(padding, 'x') + line_end + hidden.substr(head)
        );
    }
    return text + "       -1" + line_end;
}

TEST(CdbChunks, blocks_that_are_as_long_as_announced_are_not_looked_at_before_they_are_read) {
    for (const char* line_end : {"\n", "\r\n"}) {
        const std::string text = even_deck(",    12000,    12000", "", line_end);
        Diagnostics diagnostics;
        const auto deck =
            ansys::cdb::scan_deck(Input::from_memory("deck.cdb", text), nullptr, diagnostics, true);
        ASSERT_EQ(deck.node_blocks.size(), 1u);
        ASSERT_EQ(deck.element_blocks.size(), 1u);
        EXPECT_TRUE(deck.node_blocks[0].assumed);
        EXPECT_TRUE(deck.element_blocks[0].rows.assumed);
        const auto counted = open_deck(text);
        EXPECT_EQ(counted.mesh().element_count(), 12'000u);
        expect_same_mesh(counted.mesh(), open_deck(even_deck("", "", line_end)).mesh());
    }
}

TEST(CdbChunks, an_announced_number_that_leads_beyond_the_end_is_not_believed) {
    const std::string rows =
        "        1        1        1        1        0        0        0        0        8        0";
    for (const std::string end : {"\n", "\r\n"}) {
        for (const std::string& hidden :
             {"       -1" + end + "MAT,5" + end + "EBLOCK,19,SOLID" + end + "(19i9)" + end,
              "FINISH" + end + "/EOF" + end,
              end + end,
              rows + "  " + end + "        7        8" + end,
              // A row but for its sign, which ends the block.
              "       -1" + rows.substr(9) +
                  "     7001        1        2        3        4        5        6        7        8" +
                  end}) {
            const auto told = [&](const std::string& count) -> std::pair<Mesh, std::string> {
                try {
                    const auto opened = open_deck(even_deck(count, hidden, end.c_str()));
                    return {opened.mesh(), test::all_texts(*opened.diagnostics)};
                } catch (const Error& error) {
                    return {Mesh{}, error.where() + error.what()};
                }
            };
            const auto counted = told(",    12000,    12000"), honest = told("");
            expect_same_mesh(counted.first, honest.first);
            // Lines count from the same place, but for the words of what was announced.
            EXPECT_EQ(counted.second.substr(0, 30), honest.second.substr(0, 30));
        }
    }
}

TEST(SeenIds, knows_ids_in_any_order) {
    ansys::SeenIds seen;
    std::mt19937_64 random(3);
    std::vector<std::int64_t> ids;
    for (int i = 0; i < 5000; ++i) ids.push_back(static_cast<std::int64_t>(random() % 1'000'000));
    for (int i = 0; i < 2000; ++i) ids.push_back(2'000'000 + i);
    ids.push_back(9'000'000'000'000'000'000);
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::ranges::shuffle(ids, random);
    for (const std::int64_t id : ids) EXPECT_TRUE(seen.insert(id)) << id;
    for (const std::int64_t id : ids) EXPECT_FALSE(seen.insert(id)) << id;
}

}  // namespace
}  // namespace feelem
