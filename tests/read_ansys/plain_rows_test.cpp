// SPDX-License-Identifier: Apache-2.0
// Rows that look as solvers print them take a fast way. A tab behind each row sends it through the general
// one: both must say the same, whatever the rows look like.
#include "read_ansys/opened_lists.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

namespace feelem {
namespace {

using test::open_texts;

/// A number as Fortran's G prints it, in a field.
std::string general(double value, int digits, std::size_t width) {
    const double size = std::abs(value);
    const int before = size == 0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
    if (before >= 0 && before <= digits)
        return fmt::format("{:>{}}    ", fmt::format("{:.{}f}", value, digits - before), width - 4);
    const double mantissa = value / std::pow(10.0, before);
    return fmt::format(
        "{:>{}}",
        fmt::format("{:.{}f}E{}{:02}", mantissa, digits, before < 0 ? '-' : '+', std::abs(before)),
        width
    );
}

class Lists {
public:
    Lists(std::string row_end, unsigned seed) : end_(std::move(row_end)), random_(seed) {
        add_nodes();
        add_elements();
        add_values();
    }
    std::vector<std::string> texts() const { return {nodes_, elements_, values_}; }

private:
    static constexpr int kNodes = 3000;

    double real() {
        const double size = std::pow(10.0, static_cast<int>(random_() % 14) - 7);
        return size * (static_cast<double>(random_() % 2'000'001) / 1'000'000 - 1);
    }

    void add_nodes() {
        nodes_ = "\n LIST ALL SELECTED NODES.   DSYS=      0\n";
        for (int id = 1; id <= kNodes; ++id) {
            if (id % 20 == 1)
                nodes_ += "\n    NODE        X                   Y                   Z                THXY   "
                          "  THYZ     THZX\n";
            nodes_ += fmt::format("{:8}  ", id);
            for (int i = 0; i < 3; ++i) nodes_ += general(real(), 12, 20);
            for (int i = 0; i < 3; ++i) nodes_ += fmt::format("{:9.2f}", id % 50 == 0 ? 10.0 * i : 0.0);
            nodes_ += end_;
        }
    }

    void add_elements() {
        elements_ = "\n LIST ELEMENT TYPES FROM       1 TO       3 BY       1\n\n ELEMENT TYPE         1 IS "
                    "SOLID185\n"
                    " ELEMENT TYPE         2 IS SOLID186\n ELEMENT TYPE         3 IS SOLID187\n"
                    "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n";
        for (int id = 1; id <= 2000; ++id) {
            if (id % 20 == 1) elements_ += "\n    ELEM MAT TYP REL ESY SEC        NODES\n\n";
            const int type = id < 1000 ? 1 : 1 + static_cast<int>(random_() % 3);
            const int count = type == 1 ? 8 : type == 2 ? 20 : 10;
            elements_ += fmt::format(
                "{:8}{:4}{:4}{:4}{:4}{:4}      ", id, 1 + id / 300, type, 1, id % 90 == 0 ? -3 : 0, 1
            );
            for (int i = 0; i < count; ++i) {
                if (i > 0 && i % 8 == 0) elements_ += end_ + std::string(34, ' ');
                // Some are wide, so that a blank is missing between them and the ids before; some are
                // unknown.
                const int node = 1 + static_cast<int>(random_() % 130) + 140 * i;
                elements_ += id % 111 == 0 && i == 3 ? fmt::format("{:7}", 1'000'000 + node)
                                                     : fmt::format("{:7}", node);
            }
            elements_ += end_;
        }
    }

    void add_values() {
        values_ =
            "\n PRINT U    NODAL SOLUTION PER NODE\n\n  ***** POST1 NODAL DEGREE OF FREEDOM LISTING *****\n\n"
            "  LOAD STEP=     1  SUBSTEP=     1\n   TIME=    1.0000      LOAD CASE=   0\n\n"
            "  THE FOLLOWING DEGREE OF FREEDOM RESULTS ARE IN THE GLOBAL COORDINATE SYSTEM\n";
        for (int id = 1; id <= kNodes; ++id) {
            if (id % 37 == 1) values_ += "\n    NODE    UX          UY          UZ          USUM\n";
            values_ += fmt::format("{:8} ", id);
            for (int i = 0; i < 4; ++i) {
                const auto kind = random_() % 60;
                values_ += kind == 0   ? std::string(12, ' ')
                           : kind == 1 ? std::string("   *********")
                           : kind == 2 ? std::string("     NaN    ")
                           : kind == 3 ? std::string(" 1.2345-103 ")
                                       : general(real(), 5, 12);
            }
            values_ += end_;
        }
    }

    std::string end_;
    std::mt19937 random_;
    std::string nodes_, elements_, values_;
};

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_TRUE(std::memcmp(&a[i], &b[i], sizeof(T)) == 0) << "row " << i;
    }
}

void expect_same(test::OpenedLists& a, test::OpenedLists& b) {
    const Mesh& mesh = a.model->mesh();
    EXPECT_EQ(mesh.node_ids, b.model->mesh().node_ids);
    expect_same_bits(mesh.coordinates, b.model->mesh().coordinates);
    expect_same_bits(mesh.node_angles, b.model->mesh().node_angles);
    ASSERT_EQ(mesh.blocks.size(), b.model->mesh().blocks.size());
    for (std::size_t i = 0; i < mesh.blocks.size(); ++i) {
        EXPECT_EQ(mesh.blocks[i].ids, b.model->mesh().blocks[i].ids);
        EXPECT_EQ(mesh.blocks[i].nodes, b.model->mesh().blocks[i].nodes);
        EXPECT_EQ(mesh.blocks[i].parts, b.model->mesh().blocks[i].parts);
    }
    ASSERT_EQ(a.model->results().size(), b.model->results().size());
    for (std::size_t i = 0; i < a.model->results().size(); ++i) {
        const Result one = a.model->load(i), other = b.model->load(i);
        ASSERT_EQ(one.values.size(), other.values.size());
        for (std::size_t k = 0; k < one.values.size(); ++k) {
            const bool both_missing = std::isnan(one.values[k]) && std::isnan(other.values[k]);
            ASSERT_TRUE(
                both_missing ||
                std::bit_cast<std::uint32_t>(one.values[k]) == std::bit_cast<std::uint32_t>(other.values[k])
            ) << k
              << ": " << one.values[k] << " and " << other.values[k];
        }
    }
    EXPECT_EQ(test::all_texts(*a.diagnostics), test::all_texts(*b.diagnostics));
}

TEST(PlainRows, say_what_the_general_way_says) {
    for (unsigned seed = 0; seed < 3; ++seed) {
        auto general_way = open_texts(Lists("\t\n", seed).texts());
        ASSERT_EQ(general_way.model->mesh().node_count(), 3000u);
        ASSERT_GT(general_way.model->mesh().element_count(), 1900u)
            << test::all_texts(*general_way.diagnostics);
        ASSERT_EQ(general_way.model->results().size(), 1u);
        for (const char* end : {"\n", "    \n", "\r\n"}) {
            auto plain = open_texts(Lists(end, seed).texts());
            expect_same(plain, general_way);
        }
    }
}

/// Nodes 1 to 400 with values of five columns, which make two results, or four, which make one.
class ValueList {
public:
    explicit ValueList(int columns) : columns_(columns) {
        for (int id = 1; id <= 400; ++id) add(id);
    }
    void add(int id) {
        std::string row = fmt::format("{:8} ", id);
        for (int i = 0; i < columns_; ++i)
            row += general(std::sin(0.1 * id + i) * std::pow(10.0, i - 2), 5, 12);
        rows.push_back(row);
    }
    void repeat(std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) rows.push_back(std::string(rows[i]));
    }
    std::vector<std::string> texts(const std::string& row_end, const std::string& notes) const {
        std::string nodes = "\n LIST ALL SELECTED NODES.   DSYS=      0\n\n    NODE        X   Y   Z\n";
        for (int id = 1; id <= 500; ++id)
            nodes += fmt::format("{:8}  {:12.6f}  0.000  0.000\n", id, 0.1 * id);
        std::string values =
            "\n  ***** POST1 NODAL DEGREE OF FREEDOM LISTING *****\n\n"
            "  LOAD STEP=     1  SUBSTEP=     1\n   TIME=    1.0000      LOAD CASE=   0\n\n" +
            notes;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i % 150 == 0) {
                values += "\n    NODE    UX          UY          UZ          ";
                values += columns_ == 4 ? "USUM\n" : "ROTX        TEMP\n";
            }
            values += rows[i] + row_end;
        }
        return {nodes, values};
    }

    std::vector<std::string> rows;

private:
    int columns_;
};

TEST(PlainRows, many_values_at_once_go_where_each_belongs) {
    const std::string layers = "  SHELL NODAL RESULTS ARE AT TOP/BOTTOM FOR MATERIAL   1\n \n";
    for (const int columns : {4, 5}) {
        for (const std::string& notes : {std::string(), layers}) {
            for (int way = 0; way < 6; ++way) {
                SCOPED_TRACE(fmt::format("{} columns, way {}", columns, way));
                ValueList list(columns);
                if (way == 1) std::swap(list.rows[37], list.rows[38]);
                if (way == 2) list.repeat(90, 140);
                if (way == 3) list.rows[77].replace(9, 12, general(5.55, 5, 12));
                if (way == 3) list.repeat(60, 90);
                if (way == 3) list.rows[420].replace(9, 12, general(7.77, 5, 12));
                if (way == 4) list.add(501), list.add(502), list.add(499);
                if (way == 5) list.rows[300].replace(9, 12, "         ***");
                auto general_way = open_texts(list.texts("\t\n", notes));
                auto plain = open_texts(list.texts("\n", notes));
                ASSERT_GT(plain.model->results().size(), 0u);
                expect_same(plain, general_way);
            }
        }
    }
}

TEST(PlainRows, two_lines_as_long_as_a_row_are_two_lines) {
    ValueList list(4);
    const std::size_t length = list.rows[0].size();
    const std::string id = "     100\n", footer = " MINIMUM VALUES ";
    list.rows[99] = id + footer + std::string(length - id.size() - footer.size(), '-');
    auto opened = open_texts(list.texts("\n", ""));
    const Result result = opened.model->load(0);
    ASSERT_EQ(list.rows[99].size(), length);
    EXPECT_FALSE(std::isnan(result.values.at(4 * 98)));
    EXPECT_TRUE(std::isnan(result.values.at(4 * 99))) << "a row without values";
    EXPECT_TRUE(std::isnan(result.values.at(4 * 100))) << "a row behind the footer";
}

}  // namespace
}  // namespace feelem
