// SPDX-License-Identifier: Apache-2.0
// Writes a block of N x N x N hex8 nodes with DISP, NDTEMP and STRESS as an ASCII .frd: the same bytes every
// time.
#include "block.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

namespace {

using bench::Block;
using bench::Writer;

void write_mesh(Writer& out, const Block& block) {
    out.line("    1C");
    out.line("    1UPGM               CalculiX");
    out.line("    1UVERSION           Version 2.20");
    out.line("    2C{:30d}{:38d}", block.node_count(), 1);
    for (int id = 1; id <= block.node_count(); ++id) {
        const auto p = block.position(id);
        out.line(" -1{:10d}{:12.5E}{:12.5E}{:12.5E}", id, p[0], p[1], p[2]);
    }
    out.line(" -3");
    out.line("    3C{:30d}{:38d}", block.element_count(), 1);
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        out.line(" -1{:10d}{:5d}{:5d}{:5d}", id, 1, 0, 1);
        out.line(
            " -2{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}",
            n[0],
            n[1],
            n[2],
            n[3],
            n[4],
            n[5],
            n[6],
            n[7]
        );
    });
    out.line(" -3");
}

void write_result_head(
    Writer& out, const Block& block, std::string_view name, std::span<const std::string_view> rows
) {
    out.line("  100CL  101 1.000000000{:12d}                     0    1{:12d}", block.node_count(), 1);
    out.line(" -4  {:8}{:5d}    1", name, rows.size());
    for (const std::string_view row : rows) out.line("{}", row);
}

void write_results(Writer& out, const Block& block) {
    constexpr std::array<std::string_view, 4> kDisp{
        " -5  D1          1    2    1    0",
        " -5  D2          1    2    2    0",
        " -5  D3          1    2    3    0",
        " -5  ALL         1    2    0    0    1ALL"};
    write_result_head(out, block, "DISP", kDisp);
    for (int id = 1; id <= block.node_count(); ++id) {
        const auto p = block.position(id);
        out.line(
            " -1{:10d}{:12.5E}{:12.5E}{:12.5E}", id, 1e-3 * p[0], std::sin(0.01 * p[1]), 1e-6 * p[2] * p[2]
        );
    }
    out.line(" -3");
    constexpr std::array<std::string_view, 1> kTemp{" -5  T           1    1    0    0"};
    write_result_head(out, block, "NDTEMP", kTemp);
    for (int id = 1; id <= block.node_count(); ++id) {
        const auto p = block.position(id);
        out.line(" -1{:10d}{:12.5E}", id, 20 + 0.2 * p[0] + 30 * std::cos(0.01 * p[2]));
    }
    out.line(" -3");
    constexpr std::array<std::string_view, 6> kStress{
        " -5  SXX         1    4    1    1",
        " -5  SYY         1    4    2    2",
        " -5  SZZ         1    4    3    3",
        " -5  SXY         1    4    1    2",
        " -5  SYZ         1    4    2    3",
        " -5  SZX         1    4    3    1"};
    write_result_head(out, block, "STRESS", kStress);
    for (int id = 1; id <= block.node_count(); ++id) {
        const auto p = block.position(id);
        const double a = std::sin(0.005 * p[0]), b = std::cos(0.007 * p[1]), c = std::sin(0.003 * p[2]);
        out.line(
            " -1{:10d}{:12.5E}{:12.5E}{:12.5E}{:12.5E}{:12.5E}{:12.5E}",
            id,
            100 * a,
            -80 * b,
            60 * c,
            30 * a * b,
            -20 * b * c,
            10 * c * a
        );
    }
    out.line(" -3");
    out.line(" 9999");
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc == 3 ? std::atoi(argv[1]) : 0;
    if (side < 2 || side > 500) {
        std::fputs("usage: bench_make_frd NODES_PER_SIDE(2..500) OUT.frd\n", stderr);
        return 2;
    }
    const Block block{side};
    Writer out(argv[2]);
    write_mesh(out, block);
    write_results(out, block);
}
