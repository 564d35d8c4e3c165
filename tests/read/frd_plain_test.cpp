// SPDX-License-Identifier: Apache-2.0
// Records of a mesh that are taken without looking for line ends are what the general way makes of them. A
// blank at the end of every line sends them the general way and changes nothing else.
#include "read/calculix/frd_blocks.hpp"
#include "read/calculix/frd_mesh.hpp"
#include "read/calculix/frd_values.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace feelem {
namespace {

std::string element(int id, int type, int material, int count, int first, int width, int per_line) {
    std::string text = fmt::format(" -1{:{}d}{:5d}{:5d}{:5d}\n", id, width, type, 0, material);
    for (int i = 0; i < count; ++i) {
        if (i % per_line == 0) text += " -2";
        text += fmt::format("{:{}d}", first + i, width);
        if (i % per_line == per_line - 1 || i == count - 1) text += '\n';
    }
    return text;
}

/// Bricks, quadratic bricks and tetrahedra of two materials, in either width of columns.
std::string mesh_text(bool is_long) {
    const int width = is_long ? 10 : 5, per_line = is_long ? 10 : 15, digit = is_long ? 1 : 0;
    std::string text = "    1C\n" + fmt::format("    2C{:30d}{:38d}\n", 40, digit);
    for (int id = 1; id <= 40; ++id)
        text += fmt::format(
            " -1{:{}d}{:12.5E}{:12.5E}{:12.5E}\n", id, width, id % 4 * 1.25, -id * 0.1, id * id * 1e-3
        );
    text += " -3\n" + fmt::format("    3C{:30d}{:38d}\n", 12, digit);
    for (int id = 1; id <= 12; ++id) {
        if (id < 5) text += element(id, 1, 1, 8, id, width, per_line);
        if (id >= 5 && id < 9) text += element(id, 4, 1, 20, id, width, per_line);
        if (id >= 9) text += element(id, 3, 2, 4, id, width, per_line);
    }
    return text + " -3\n 9999\n";
}

std::string with_line_ends(const std::string& text, std::string_view end) {
    std::string out;
    for (const char c : text) c == '\n' ? out += end : out += c;
    return out;
}

/// Everything in the mesh, bit for bit.
std::string written_out(const std::string& text) {
    Diagnostics diagnostics;
    const Input input = Input::from_memory("a.frd", text);
    Mesh mesh;
    try {
        mesh = frd::read_mesh(input, frd::find_blocks(input, diagnostics), diagnostics);
    } catch (const Error& error) {
        return fmt::format("refused: {}", static_cast<int>(error.code()));
    }
    std::string out;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        out += fmt::format("{}", raw(mesh.node_ids[i]));
        for (const double x : mesh.coordinates[i])
            out += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(x));
    }
    for (const ElementBlock& block : mesh.blocks) {
        out += fmt::format("\n{}:", static_cast<int>(block.type));
        for (const ElementId id : block.ids) out += fmt::format(" {}", raw(id));
        for (const PartIndex part : block.parts) out += fmt::format(" {}", mesh.parts[raw(part)].name);
        for (const NodeIndex node : block.nodes) out += fmt::format(" {}", raw(node));
    }
    for (const Diagnostic& entry : diagnostics.entries())
        out += fmt::format("\n{} {} x{}", entry.where, entry.text, entry.count);
    return out;
}

TEST(FrdPlain, records_are_what_the_general_way_makes_of_them) {
    for (const bool is_long : {true, false}) {
        const std::string text = mesh_text(is_long);
        const std::string plain = written_out(text);

        EXPECT_NE(plain.find("material 2"), std::string::npos) << plain;
        EXPECT_EQ(plain, written_out(with_line_ends(text, " \n")));
        EXPECT_EQ(plain, written_out(with_line_ends(text, "\r\n")));
    }
}

TEST(FrdPlain, damaged_records_are_what_the_general_way_makes_of_them) {
    constexpr std::string_view kStrange = " +-.0123456789E*x";
    std::mt19937 random(17);
    const auto below = [&](std::size_t n) { return random() % n; };
    const std::string whole = mesh_text(true);
    std::size_t read = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string text = whole;
        for (std::size_t k = 0; k < 1 + below(2); ++k) {
            const std::size_t at = text.find('\n') + 1 + below(text.size() - 200);
            if (text[at] != '\n') text[at] = kStrange[below(kStrange.size())];
        }
        const std::string plain = written_out(text);
        read += plain.starts_with("refused") ? 0U : 1U;
        ASSERT_EQ(plain, written_out(with_line_ends(text, " \n"))) << text;
    }
    EXPECT_GT(read, 1'000U);
}

TEST(FrdPlain, a_line_of_nodes_too_many_is_not_used) {
    std::string text = mesh_text(true);
    const std::size_t second = text.find(" -1         2    1");
    ASSERT_NE(second, std::string::npos);
    const std::string before = written_out(text);
    text.insert(second, " -2        40\n");

    EXPECT_EQ(written_out(text), before);
}

TEST(FrdPlain, an_odd_element_among_others_is_what_the_general_way_makes_of_it) {
    for (const int type : {1, 4, 3}) {
        const int count = type == 1 ? 8 : type == 4 ? 20 : 4;
        for (const int odd :
             {0, 3, 999}) {  // One that is there and may be left out, a corner's, an unknown one.
            for (const std::size_t place : {std::size_t{1}, static_cast<std::size_t>(count) - 1}) {
                std::string text = "    1C\n" + fmt::format("    2C{:30d}{:38d}\n", 100, 1);
                for (int id = 0; id < 100; ++id)
                    text += fmt::format(
                        " -1{:10d}{:12.5E}{:12.5E}{:12.5E}\n", id, 1.0 * id, 0.5 * id, id * id * 1e-3
                    );
                text += " -3\n" + fmt::format("    3C{:30d}{:38d}\n", 80, 1);
                for (int id = 1; id <= 80; ++id) {
                    std::string one = element(id, type, 1, count, id == 70 ? 3 : id, 10, 10);
                    const std::size_t first = one.find(" -2") + 3;
                    const std::size_t at = first + 10 * place + 4 * (place / 10);
                    if (id == 70) one.replace(at, 10, fmt::format("{:10d}", odd));
                    if (id == 75 && type == 1) {  // A wedge.
                        for (const std::size_t k : {3U, 7U})
                            one.replace(first + 10 * k, 10, one, first + 10 * k - 10, 10);
                    }
                    text += one;
                }
                text += " -3\n 9999\n";
                EXPECT_EQ(written_out(text), written_out(with_line_ends(text, " \n"))) << type << ' ' << odd;
            }
        }
    }
}

/// The second column of three, or the last three of eight, on some of the nodes 1 to 140; the mesh has the
/// even ones.
struct ValueText {
    explicit ValueText(unsigned seed) : random(seed), count(seed % 2 == 0 ? 3 : 8) {}

    std::string text() {
        std::string body;
        int records = 0;
        // Long runs of nodes that the mesh has, and some that it has not.
        for (int id = 1; id <= 140; ++id) {
            if (random() % 8 == 0 || (id % 2 == 1 && random() % 16 != 0)) continue;
            ++records;
            for (int c = 0; c < count; ++c) {
                if (c % 6 == 0) body += c == 0 ? fmt::format(" -1{:10}", id) : std::string(" -2          ");
                body += number();
                if (c % 6 == 5 || c == count - 1) body += '\n';
            }
        }
        std::string head = fmt::format("  100CL  101 1.000000000{:12}{:22}{:5}{:12}\n", records, 0, 1, 1);
        head += fmt::format(" -4  SDV     {:5}    1\n", count);
        for (int c = 0; c < count; ++c) head += fmt::format(" -5  SDV{:<9}1    1    0    0\n", c);
        return "    1C\n" + head + body + " -3\n 9999\n";
    }

    std::string number() {
        const auto kind = random() % 200;
        if (kind == 0) return "         NaN";
        if (kind == 1) return " 1.00000E-30";
        return fmt::format("{:12.5E}", (static_cast<double>(random() % 2'000'001) - 1'000'000) * 1e-3);
    }

    std::mt19937 random;
    int count;
};

std::string written_values(const std::string& text, frd::Columns columns) {
    Diagnostics diagnostics;
    const Input input = Input::from_memory("a.frd", text);
    const frd::Layout layout = frd::find_blocks(input, diagnostics);
    if (layout.results.size() != 1) return "no values";
    Mesh mesh;
    for (int id = 2; id <= 140; id += 2) mesh.node_ids.push_back(NodeId{id});
    mesh.coordinates.resize(mesh.node_ids.size());
    const frd::Values found = frd::read_values(input, layout.results[0], columns, mesh, false);
    std::string out = fmt::format("{} {}", found.without_node, found.without_number);
    for (const float value : found.values)
        out += std::isnan(value) ? " nan" : fmt::format(" {:x}", std::bit_cast<std::uint32_t>(value));
    return out;
}

TEST(FrdPlain, values_are_what_the_general_way_makes_of_them) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const std::string text = ValueText(seed).text();
        // A record longer than the others: then each line is looked at.
        std::string uneven = text;
        uneven.insert(uneven.find("\n -3"), " ");
        const frd::Columns columns = seed % 2 == 0 ? frd::Columns{1, 1} : frd::Columns{5, 3};
        const std::string plain = written_values(text, columns);
        ASSERT_NE(plain, "no values") << text;
        ASSERT_EQ(plain, written_values(uneven, columns)) << text;
    }
}

}  // namespace
}  // namespace feelem
