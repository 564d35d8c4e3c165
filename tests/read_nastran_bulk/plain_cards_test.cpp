// SPDX-License-Identifier: Apache-2.0
// Cards read the fast way: each is refused, or is what BulkCard makes of it.
#include "base/parallel.hpp"
#include "read/nastran/bulk_card.hpp"
#include "read/nastran/bulk_mesh.hpp"
#include "read/nastran/nastran_elements.hpp"
#include "read/nastran/plain_cards.hpp"
#include "read/nastran/plain_elements.hpp"
#include "read/nastran/plain_grids.hpp"
#include "support/mesh_text.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {
namespace {

using namespace nastran;

/// Where the card behind the one at `at` starts, and whether the card's marks agree, by the general way.
struct General {
    BulkCard card;
    std::size_t next = 0;
};
General general_way(std::string_view text, std::size_t at) {
    General out;
    BulkLines lines(text, at);
    lines.advance();
    out.card.read(text, card_head(lines.line(), at));
    out.next = text.size();
    while (lines.advance()) {
        if (is_continuation(lines.line())) continue;
        out.next = lines.offset();
        break;
    }
    return out;
}

void expect_same_grid(std::string_view text, std::size_t at, const BulkGrid& grid, std::size_t next) {
    const General general = general_way(text, at);
    EXPECT_EQ(grid.id, general.card.integer(1));
    EXPECT_EQ(grid.place_system, general.card.is_blank(2) ? kBlankField : general.card.integer(2));
    EXPECT_EQ(grid.value_system, general.card.is_blank(6) ? kBlankField : general.card.integer(6));
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(general.card.real(3 + i).has_value());
        EXPECT_EQ(
            std::bit_cast<std::uint64_t>(grid.place[i]),
            std::bit_cast<std::uint64_t>(*general.card.real(3 + i))
        );
    }
    EXPECT_EQ(next, general.next);
    EXPECT_FALSE(general.card.marks_differ());
}

/// Compares what is read the fast way at `at`; whether it was read at all.
bool compare_at(std::string_view text, std::size_t at) {
    SCOPED_TRACE(std::string(text.substr(at, 200)));
    if (text.substr(at, 4) == "GRID") {
        BulkGrid grid;
        const auto next = read_plain_grid(text, at, grid);
        if (next) expect_same_grid(text, at, grid, *next);
        return next.has_value();
    }
    const std::size_t length = text.substr(at, 9).find_first_of(" ,*\t\r\n");
    if (length == std::string_view::npos || find_element_card(text.substr(at, length)) == nullptr)
        return false;
    const auto head = look_over_plain_card(text, at, length);
    if (head) {
        const General general = general_way(text, at);
        EXPECT_EQ(head->id, general.card.is_blank(1) ? kBlankField : general.card.integer(1));
        EXPECT_EQ(head->next, general.next);
        EXPECT_FALSE(general.card.marks_differ());
    }
    PlainFields fields;
    for (const std::size_t wanted : {5U, 10U, 22U}) {
        if (!head || !read_plain_fields(text, at, length, wanted, fields)) continue;
        const General general = general_way(text, at);
        for (std::size_t i = 0; i < wanted; ++i) {
            EXPECT_EQ(
                fields.values[i], general.card.is_blank(i + 1) ? kBlankField : general.card.integer(i + 1)
            ) << "field "
              << i + 1;
        }
    }
    return head.has_value();
}

const std::string kRoom(300, 'X');

std::vector<std::string> usual_cards() {
    return {
        "GRID           1         0.36162 0.55636-0.73793\n",
        "GRID           2       3-1.5E-3 .70441-0.17746       4\n",
        "GRID    12345678      10    1.-3     -2.    1.+2\r\n",
        "GRID*                  1                 3.616154320E-01-5.563610221E-01*\n*        "
        "7.379313711E-01\n",
        "GRID*                  1               2             1.5            -2.5*G1\n"
        "*G1                 3.-2               7\n",
        "GRID,1,,0.361615432,-0.556361023,.5\n",
        "GRID,12345,3,1.5E+3,-2.,1.-3,4\r\n",
        "CHEXA          1       1       1       2     102     101   10001   10002+\n+          10102   "
        "10101\n",
        "CHEXA          1       1       1       2     102     101   10001   10002+E1\n+E1        10102   "
        "10101\n",
        "CHEXA          1       1       1       2     102     101   10001   10002\n           10102   "
        "10101\n",
        "CHEXA*                 1               1               1               2*\n"
        "*                    102             101           10001           10002*\n"
        "*                  10102           10101\n",
        "CHEXA,1,1,1,2,102,101,10001,10002,+\n+,10102,10101\n",
        "CHEXA,1,1,1,2,102,101,10001,10002\n,10102,10101\n",
        "CQUAD4         1       7       1       2     102     101     30.     0.1\n",
        "CQUAD4  1       7       1       2       102     101\n",
        "CQUAD4,1,7,1,2,102,101,30.,0.1\n",
        "CTETRA         1       1       1       2     102     101   10001   10002+\n"
        "+          10102   10101       7       8\n",
        "CROD    5       1       17      18\r\n",
    };
}

TEST(PlainCards, as_pre_processors_write_them_are_read) {
    for (const std::string& card : usual_cards()) {
        const std::string text = card + kRoom;
        EXPECT_TRUE(compare_at(text, 0)) << card;
    }
}

TEST(PlainCards, with_anything_else_in_them_are_read_the_same_or_refused) {
    constexpr std::string_view kStrange = " \t\n\r,+*$0123456789.-EeDGC\"";
    std::mt19937 random(5);
    const auto below = [&](std::size_t n) { return random() % n; };
    std::size_t read = 0;
    for (int round = 0; round < 4000; ++round) {
        for (std::string card : usual_cards()) {
            for (std::size_t k = 0; k < 1 + below(3); ++k) {
                const std::size_t at = 4 + below(card.size() - 4);
                const char c = kStrange[below(kStrange.size())];
                switch (below(3)) {
                case 0: card[at] = c; break;
                case 1: card.insert(at, 1, c); break;
                default: card.erase(at, 1); break;
                }
                if (card.size() < 8) break;
            }
            const std::string text = card + (below(2) == 0 ? "" : "\n") + kRoom;
            if (compare_at(text, 0)) ++read;
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(read, 10'000U);
}

/// What a card says by the general way is what was read.
void expect_same_element(
    std::string_view text, std::size_t at, const PlainElement& element, std::size_t next
) {
    const General general = general_way(text, at);
    const auto field = [&](std::size_t i) {
        return general.card.is_blank(i) ? std::optional(kBlankField) : general.card.integer(i);
    };
    EXPECT_EQ(next, general.next);
    EXPECT_FALSE(general.card.marks_differ());
    EXPECT_EQ(element.id, field(1));
    EXPECT_EQ(element.property, field(element.card->property));
    for (std::size_t i = 0; i < element.card->node_count(); ++i) {
        const std::uint32_t node = i < element.count ? element.nodes[i] : 0;
        const auto wanted = field(element.card->first_node + i);
        EXPECT_EQ(node, wanted == kBlankField ? 0 : wanted) << "node " << i + 1;
    }
}

TEST(PlainElements, read_after_each_other_are_what_the_general_way_reads_or_refused) {
    constexpr std::string_view kStrange = " \n\r,,+*$0123456789.-E";
    const std::vector<std::string> kCards{
        "CHEXA,1,1,1,2,102,101,10001,10002,+\n+,10102,10101\n",
        "CHEXA,7,,1,2,102,101,10001,10002\r\n,10102,10101\r\n",
        "CTETRA,123456789,4,1,2,3,4\n",
        "CTETRA,12,4, 1,2 ,3,4,5,6,\n,7,8,9,10\n",
        "CQUAD4,12,4,1,2,3,4,0.5\n",
        "CHEXA          1       1       1       2     102     101   10001   10002+\n"
        "+          10102   10101\n",
        "CHEXA   1       7       1       2       102     101     10001   10002   +E1\n"
        "+E1     10102   10101\n",
        "CHEXA*         123456789               1               1               2*\n"
        "*                    102             101           10001           10002*\n"
        "*                  10102           10101\n",
        "CTRIA3        12               1       2       3     0.5\r\n",
        "CTETRA         1       1       1       2     102     101   10001   10002\n"
        "           10102       0       7       8\n",
    };
    std::mt19937 random(11);
    const auto below = [&](std::size_t n) { return random() % n; };
    std::size_t read = 0;
    for (int round = 0; round < 30'000; ++round) {
        const std::string& first = kCards[below(kCards.size())];
        std::string second = below(4) == 0 ? kCards[below(kCards.size())] : first;
        for (std::size_t k = 0; k < below(4); ++k)
            second[6 + below(second.size() - 6)] = kStrange[below(kStrange.size())];
        const std::string text =
            "CEND\nBEGIN BULK $ so that there are bytes before\n" + first + second + kRoom;
        SCOPED_TRACE(first + second);
        PlainElements cards(text);
        PlainElement element;
        const std::size_t at = text.find(first);
        const auto next = cards.read(at, element);
        if (!next || *next >= text.size() - kRoom.size()) continue;
        expect_same_element(text, at, element, *next);
        const auto end = cards.read(*next, element);
        if (!end) continue;
        expect_same_element(text, *next, element, *end);
        ++read;
        if (HasFailure()) return;
    }
    EXPECT_GT(read, 12'000U);
}

/// Everything that a deck's mesh says, and what was said about it.
std::string written_out(const std::string& deck, unsigned threads) {
    set_thread_count(threads);
    Diagnostics diagnostics;
    std::string text;
    try {
        const BulkModel model = read_bulk({Input::from_memory("deck.bdf", deck)}, nullptr, diagnostics);
        text = fmt::format("{} cards, {} grids\n", model.cards, model.grids);
        text += test::mesh_text(model.mesh);
    } catch (const Error& error) {
        text = error.what();
    }
    text += test::diagnostics_text(diagnostics);
    set_thread_count(0);
    return text;
}

/// Some megabytes of cards; now and then something stands among them that is not plain.
std::string large_deck(bool odd) {
    const auto grid = [](int id) {
        return fmt::format("GRID,{},,{}.25,{}.5,-{}.125\n", id, id, id % 7, id % 11);
    };
    std::string deck;
    for (int id = 1; id <= 90'000; ++id) {
        if (odd && id % 9001 == 0) deck += fmt::format("$ a comment at {}\n", id);
        if (odd && id % 11'003 == 0) {
            deck += fmt::format("GRID    {:<8}        {:<8}1.5-3   2.\n", id, "1.+1");
        } else {
            deck += grid(id);
        }
    }
    for (int id = 1; id <= 60'000; ++id) {
        if (odd && id % 7001 == 0) deck += fmt::format("cquad4\t{}\t3\t1\t2\t3\t{}\n", 100'000 + id, id);
        if (odd && id % 13'007 == 0)
            deck += fmt::format("CHEXA,{},3,1,2,3,4,5,6,$\n,7,{}\n", id, id);
        else if (odd && id % 5003 == 0)
            deck += fmt::format("CHEXA,{},3,1,2,3,4,5,6,\n,7,9{}\n", id, id);
        else
            deck +=
                fmt::format("CHEXA,{0},{1},1,2,3,4,5,6,+\n+,{2},{3}\n", id, 1 + id / 20'000, 10 + id, 9 + id);
    }
    return deck + "PSOLID,1,1\nENDDATA\n" + grid(95'000);
}

TEST(BulkData, is_the_same_whatever_the_number_of_threads) {
    for (const bool odd : {false, true}) {
        const std::string deck = large_deck(odd);
        ASSERT_GT(deck.size(), 5'000'000U);
        const std::string one = written_out(deck, 1);
        EXPECT_EQ(one.find("unknown_node deck.bdf:") != std::string::npos, odd)
            << one.substr(one.size() - 300);
        EXPECT_EQ(one, written_out(deck, 4));
        EXPECT_NE(one.find("90000 grids"), std::string::npos) << one.substr(0, 100);
    }
}

TEST(BulkData, with_a_tab_before_every_comment_is_the_same_as_plain) {
    // A comment behind a card's last field sends the card the general way and says nothing.
    const std::string plain = large_deck(false);
    std::string odd;
    odd.reserve(plain.size() * 5 / 4);
    for (const char c : plain) {
        if (c == '\n' && !odd.ends_with('+')) odd += "\t$";
        odd += c;
    }
    EXPECT_EQ(written_out(plain, 1), written_out(odd, 1));
}

TEST(PlainCards, near_the_end_of_the_text_are_refused) {
    for (const std::string& card : usual_cards()) {
        for (const std::size_t room : {0U, 1U, 7U, 40U, 63U}) {
            const std::string text = card + std::string(room, 'X');
            compare_at(text, 0);
        }
    }
}

TEST(PlainCards, of_real_decks_are_read_as_the_general_way_reads_them) {
    const auto file = test::corpus_file("nastran/answers_bdf.json");
    if (!file) GTEST_SKIP() << "the corpus is not here";
    const std::string root = file->substr(0, file->rfind('/') + 1);
    std::size_t cards = 0, read = 0;
    const auto answers = nlohmann::json::parse(test::read_file(*file));
    for (const auto& [name, answer] : answers.items()) {
        SCOPED_TRACE(name);
        const std::string text = test::read_file(root + name);
        for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
            if (text[at] != 'G' && text[at] != 'C') continue;
            ++cards;
            if (compare_at(text, at)) ++read;
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(cards, 2'000U);
    EXPECT_GT(2 * read, cards) << "most cards of real decks are plain";
}

}  // namespace
}  // namespace feelem
