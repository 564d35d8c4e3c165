// SPDX-License-Identifier: Apache-2.0
// Rows like the one before are read while lists are looked for. A tab in place of the blank before each node
// sends an element through the general way: both must say the same, wherever pages, lines and files end.
#include "read_ansys/opened_lists.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <random>
#include <string>

namespace feelem {
namespace {

using test::open_texts;

constexpr int kNodes = 900;

std::string node_list() {
    std::string text =
        "\n LIST ALL SELECTED NODES.   DSYS=      0\n\n    NODE        X          Y          Z\n";
    for (int id = 1; id <= kNodes; ++id)
        text += fmt::format(
            "{:8}  {:12.6f}  {:12.6f}  {:12.6f}\n", id, 0.1 * (id % 9), 0.1 * (id / 9 % 10), 0.01 * id
        );
    return text;
}

const std::string kTypes = "\n LIST ELEMENT TYPES FROM       1 TO       3 BY       1\n\n"
                           " ELEMENT TYPE         1 IS SOLID185\n ELEMENT TYPE         2 IS SOLID186\n"
                           " ELEMENT TYPE         3 IS SOLID187\n";

struct Form {
    int id_width = 8;
    int node_width = 8;
    std::string line_end = "\n";
    int page = 20;  ///< Lines, so that heads stand between those of an element too.
    unsigned seed = 0;
    int gap = 6;          ///< Before the first node.
    int of_a_type = 200;  ///< Elements.
    int only_odd = 0;     ///< The one element that may be odd; 0: many are.
    unsigned odd = 0;     ///< What is odd about it.
};

/// One is left out, one is unknown, one is there twice, one fills its column, and one is long.
long node_of(const Form& form, int id, int i, unsigned odd) {
    const int node = 1 + id % 40 + 40 * i;
    if (odd == 2 && i == 9) return 0;
    if (odd == 3 && i == 2) return 99999;
    if (odd == 4 && i == 3) return node - 40;
    if (odd == 7 && i == 4 && form.node_width <= 8)
        return std::lround(std::pow(10.0, form.node_width - 1)) + node;
    if (odd == 8 && i == 4 && form.node_width > 7) return 1'000'000 + node;
    return node;
}

/// Bricks, then bricks of 20 nodes, then tetrahedra of 10, in three materials; some odd ones among them.
std::string element_list(const Form& form) {
    std::mt19937 random(form.seed);
    std::string text = "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n";
    int lines = 0;
    const auto begin_line = [&] {
        if (lines++ % form.page == 0) text += "\n    ELEM MAT TYP REL ESY SEC        NODES\n\n";
    };
    for (int id = 1; id <= 600; ++id) {
        const int type = 1 + (id - 1) / form.of_a_type;
        const int count = type == 1 ? 8 : type == 2 ? 20 : 10;
        begin_line();
        const auto any = static_cast<unsigned>(random() % 60);
        const unsigned odd = form.only_odd == 0 ? any : form.only_odd == id ? form.odd : 59;
        text += fmt::format(
            "{:{}}{:4}{:4}{:4}{:4}{:4}{:{}}",
            odd == 1 ? id - 1 : id,
            form.id_width,
            1 + id / 170,
            type,
            1,
            odd == 0 ? -3 : 0,
            1,
            "",
            form.gap
        );
        for (int i = 0; i < count; ++i) {
            if (i > 0 && i % 8 == 0) {
                text += form.line_end;
                begin_line();
                text += std::string(static_cast<std::size_t>(form.id_width + 20 + form.gap), ' ');
            }
            text += fmt::format("{:{}}", node_of(form, id, i, odd), form.node_width);
        }
        text += form.line_end;
        if (odd == 5) text += "\n";
        if (odd == 6) text += " a note\n";
    }
    return text;
}

/// Tabs where blanks stood before the nodes.
std::string with_tabs(std::string text, int id_width) {
    std::size_t column = 0;
    for (std::size_t i = 0; i < text.size(); ++i, ++column) {
        const bool digit = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
        if (digit && column > static_cast<std::size_t>(id_width) + 22 && text[i - 1] == ' ')
            text[i - 1] = '\t';
        if (text[i] == '\n') column = static_cast<std::size_t>(-1);
    }
    return text;
}

void expect_same_mesh(const std::string& elements, const std::string& tabbed, const std::string& types = "") {
    test::OpenedLists plain, general_way;
    std::string error, general_error;
    const auto open = [&](const std::string& list, test::OpenedLists& opened, std::string& what) {
        try {
            opened = open_texts({list, node_list(), kTypes}, types);
        } catch (const Error& wrong) {
            what = wrong.what();
        }
    };
    open(elements, plain, error);
    open(tabbed, general_way, general_error);
    ASSERT_EQ(error.substr(0, 60), general_error.substr(0, 60));
    if (!error.empty()) return;
    const Mesh& one = plain.model->mesh();
    const Mesh& other = general_way.model->mesh();
    ASSERT_EQ(one.parts.size(), other.parts.size());
    for (std::size_t i = 0; i < one.parts.size(); ++i) EXPECT_EQ(one.parts[i].name, other.parts[i].name);
    ASSERT_EQ(one.blocks.size(), other.blocks.size());
    for (std::size_t i = 0; i < one.blocks.size(); ++i) {
        EXPECT_EQ(one.blocks[i].type, other.blocks[i].type);
        EXPECT_EQ(one.blocks[i].ids, other.blocks[i].ids);
        EXPECT_EQ(one.blocks[i].nodes, other.blocks[i].nodes);
        EXPECT_EQ(one.blocks[i].parts, other.blocks[i].parts);
    }
    EXPECT_EQ(test::all_texts(*plain.diagnostics), test::all_texts(*general_way.diagnostics));
}

TEST(TakenRows, elements_are_those_of_the_general_way_whatever_their_columns) {
    for (const int id_width : {7, 8, 9}) {
        for (const int node_width : {6, 7, 8, 9, 10, 12, 16}) {
            for (const char* line_end : {"\n", "   \n", "\r\n"}) {
                const Form form{
                    id_width, node_width, line_end, 20 + node_width % 3, static_cast<unsigned>(node_width)};
                SCOPED_TRACE(fmt::format("ids of {}, nodes of {}", id_width, node_width));
                const std::string text = element_list(form);
                expect_same_mesh(text, with_tabs(text, id_width));
            }
        }
    }
}

TEST(TakenRows, elements_of_one_type_become_the_mesh_as_they_stand_unless_one_is_odd) {
    for (unsigned odd = 0; odd <= 8; ++odd) {
        for (const int at : {2, 300, 599, 600}) {
            SCOPED_TRACE(fmt::format("odd in way {} at {}", odd, at));
            const std::string text = element_list({8, 8, "\n", 20, 1, 6, 600, at, odd});
            expect_same_mesh(text, with_tabs(text, 8));
            for (const int of_a_type : {150, 600}) {
                const std::string others = text + element_list({8, 8, "\n", 20, 2, 6, of_a_type, 1, 9});
                expect_same_mesh(others, with_tabs(others, 8));
            }
        }
    }
}

TEST(TakenRows, ids_in_columns_of_six_come_apart_as_they_always_did) {
    for (const int node_width : {6, 12}) {
        const std::string text = element_list({8, node_width, "\n", 20, 9, 1});
        expect_same_mesh(text, with_tabs(text, 8));
    }
}

TEST(TakenRows, an_element_cut_at_the_end_of_a_line_is_left_out) {
    const std::string text = element_list({8, 8, "\n", 1000, 3});
    auto whole = open_texts({text, node_list(), kTypes});
    std::size_t cuts = 0;
    for (std::size_t end = text.find('\n', text.size() / 2); end != std::string::npos && ++cuts < 60;
         end = text.find('\n', end + 1)) {
        for (const std::size_t size : {end, end + 1, end - 3}) {
            const std::string cut = text.substr(0, size);
            expect_same_mesh(cut, with_tabs(cut, 8));
        }
    }
    EXPECT_GE(cuts, 60u);
}

TEST(TakenRows, a_last_element_that_lost_its_further_lines_is_left_out_though_others_have_one_line) {
    std::string text = "    ELEM MAT TYP REL ESY SEC        NODES\n\n";
    const auto add = [&](int id, int count) {
        text += fmt::format("{:8}   1   2   1   0   {}      ", id, count == 8 ? 1 : 2);
        for (int i = 0; i < count; ++i) {
            if (i > 0 && i % 8 == 0) text += "\n" + std::string(34, ' ');
            text += fmt::format("{:8}", id + 40 * i);
        }
        text += "\n";
    };
    for (int id = 1; id <= 8; ++id) add(id, id % 2 == 1 ? 20 : 8);
    for (int id = 9; id <= 18; ++id) add(id, 20);
    add(19, 8);
    auto opened = open_texts({text, node_list(), kTypes});
    EXPECT_EQ(opened.model->mesh().element_count(), 18u);
    EXPECT_NE(test::text_of(*opened.diagnostics, Code::TruncatedInput), "");
    expect_same_mesh(text, with_tabs(text, 8));
}

TEST(TakenRows, a_further_line_belongs_to_the_element_before_it) {
    // Bricks of one line each, and behind them a brick of 20 nodes that begins like them, on the next page.
    std::string text = "    ELEM MAT TYP REL ESY SEC        NODES\n\n";
    for (int id = 1; id <= 8; ++id) {
        text += fmt::format("{:8}   1   2   1   0   1      ", id);
        for (int i = 0; i < 8; ++i) text += fmt::format("{:8}", id + 40 * i);
        text += "\n";
    }
    for (const char* between : {"", "\n", "\n    ELEM MAT TYP REL ESY SEC        NODES\n\n", "\n a note\n"}) {
        std::string all = text + between;
        for (int line = 0; line < 2; ++line) {
            all += std::string(34, ' ');
            for (int i = 0; i < (line == 0 ? 8 : 4); ++i)
                all += fmt::format("{:8}", 8 + 40 * (8 + 8 * line + i));
            all += "\n";
        }
        auto opened = open_texts({all, node_list(), kTypes});
        const Mesh& mesh = opened.model->mesh();
        ASSERT_EQ(mesh.blocks.size(), 2u) << between << test::all_texts(*opened.diagnostics);
        EXPECT_EQ(mesh.blocks[0].ids.size(), 7u);
        EXPECT_EQ(mesh.blocks[1].type, ElementType::Hex20);
        expect_same_mesh(all, with_tabs(all, 8));
    }
}

TEST(TakenRows, types_without_a_name_are_guessed_from_them) {
    std::string text = element_list({8, 8, "\n", 20, 5});
    auto opened = open_texts({text, node_list()});
    std::uint64_t guessed = 0;
    for (const ElementBlock& block : opened.model->mesh().blocks) guessed += block.ids.size();
    EXPECT_GT(guessed, 500u);
    EXPECT_EQ(test::text_of(*opened.diagnostics, Code::GuessedElementType).substr(0, 14), "element type 1");
    expect_same_mesh(text, with_tabs(text, 8), "3=SOLID187");
}

TEST(TakenRows, nodes_keep_their_own_angles_when_many_differ) {
    const auto list = [](const char* end) {
        std::string text = "    NODE        X                   Y                   Z                THXY    "
                           " THYZ     THZX\n";
        for (int id = 1; id <= 200; ++id) {
            // Twelve rows with other angles each, and then some again.
            const double angle = id < 3 ? 0 : id < 15 ? id : id % 2 == 0 ? 10 : 0;
            text += fmt::format(
                "{:8}{:18.12f}    {:16.12f}    {:16.12f}    {:9.2f}{:9.2f}{:9.2f}{}",
                id,
                1.5 * id,
                -2.5,
                0.25,
                angle,
                0.0,
                0.0,
                end
            );
        }
        return text;
    };
    auto plain = open_texts({list("\n")});
    auto general_way = open_texts({list("\t\n")});
    const Mesh& mesh = plain.model->mesh();
    ASSERT_EQ(mesh.node_angles.size(), 200u);
    for (std::size_t i = 0; i < 200; ++i) {
        const int id = static_cast<int>(i) + 1;
        EXPECT_EQ(mesh.node_angles[i][0], id < 3 ? 0 : id < 15 ? id : id % 2 == 0 ? 10 : 0) << id;
    }
    EXPECT_EQ(mesh.node_angles, general_way.model->mesh().node_angles);
    EXPECT_EQ(mesh.coordinates, general_way.model->mesh().coordinates);
}

TEST(TakenRows, nodes_of_several_lists_come_together_in_order) {
    const std::string first = node_list();
    std::string second = node_list();
    // The same nodes 801 to 900 again, and one in the middle that says something else.
    const std::size_t rows = second.find("\n     801 ");
    second = "    NODE        X          Y          Z\n" + second.substr(rows + 1);
    auto opened = open_texts({second, first});
    const Mesh& mesh = opened.model->mesh();
    ASSERT_EQ(mesh.node_count(), static_cast<std::size_t>(kNodes));
    for (int id = 1; id <= kNodes; ++id)
        EXPECT_DOUBLE_EQ(mesh.coordinates[static_cast<std::size_t>(id) - 1][2], 0.01 * id);
}

}  // namespace
}  // namespace feelem
