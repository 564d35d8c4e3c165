// SPDX-License-Identifier: Apache-2.0
// Writes a block of N x N x N hex8 nodes as CDWRITE writes an archive: the same bytes every time.
#include "block.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using bench::Block;
using bench::Writer;

/// E21.13E3: an exponent of three digits.
std::string real(double value) {
    const std::string text = fmt::format("{:.13E}", value);
    const std::size_t mark = text.find('E');
    return fmt::format(
        "{:>16}E{}{:03}", text.substr(0, mark), text[mark + 1], std::atoi(text.c_str() + mark + 2)
    );
}

void write_nodes(Writer& out, const Block& block) {
    out.line("NBLOCK,6,SOLID,{:10d},{:10d}", block.node_count(), block.node_count());
    out.line("(3i9,6e21.13e3)");
    block.for_each_node([&](int id, const auto& p) {
        out.line("{:9d}{:9d}{:9d}{}{}{}", id, 0, 0, real(p[0]), real(p[1]), real(p[2]));
    });
    out.line("N,UNBL,LOC,       -1,");
}

void write_elements(Writer& out, const Block& block) {
    out.line("EBLOCK,19,SOLID,{:10d},{:10d}", block.element_count(), block.element_count());
    out.line("(19i10)");
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        out.line(
            "{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}"
            "{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}",
            1,
            1,
            1,
            1,
            0,
            0,
            0,
            0,
            8,
            0,
            id,
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
    out.line("{:10d}", -1);
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc == 3 ? std::atoi(argv[1]) : 0;
    if (side < 2 || side > 500) {
        std::fputs("usage: bench_make_cdb NODES_PER_SIDE(2..500) OUT.cdb\n", stderr);
        return 2;
    }
    const Block block{side};
    Writer out(argv[2]);
    out.line("/PREP7");
    out.line("/UNITS,MPA");
    out.line("ET,        1,185");
    write_nodes(out, block);
    write_elements(out, block);
    out.line("FINISH");
}
