// SPDX-License-Identifier: Apache-2.0
// Writes a wavy tube, one layer of AROUND x ALONG hex8 thick, with DISP and NDTEMP as an ASCII .frd: the same
// bytes every time. Its skin is closed and has 8 triangles a hexahedron, and 8 for each at both rims.
#include "block.hpp"

#include <cmath>
#include <numbers>

namespace {

using bench::Writer;

struct Tank {
    int around, along;

    int node_count() const { return 2 * around * (along + 1); }
    /// `layer` 0: inner.
    int node(int a, int z, int layer) const { return 1 + layer + 2 * (a % around + around * z); }
    struct Place {
        double x, y, z, angle, share;
    };
    Place place(int id) const {
        const int layer = (id - 1) % 2, a = (id - 1) / 2 % around, z = (id - 1) / 2 / around;
        const double angle = 2 * std::numbers::pi * a / around, share = static_cast<double>(z) / along;
        const double radius = 500 + 12 * layer + 40 * std::sin(6 * std::numbers::pi * share) +
                              15 * std::sin(5 * angle) * std::sin(2 * std::numbers::pi * share);
        return {radius * std::cos(angle), radius * std::sin(angle), 1600 * share, angle, share};
    }
};

void write_mesh(Writer& out, const Tank& tank) {
    out.line("    1C");
    out.line("    1UPGM               CalculiX");
    out.line("    1UVERSION           Version 2.20");
    out.line("    2C{:30d}{:38d}", tank.node_count(), 1);
    for (int id = 1; id <= tank.node_count(); ++id) {
        const Tank::Place p = tank.place(id);
        out.line(" -1{:10d}{:12.5E}{:12.5E}{:12.5E}", id, p.x, p.y, p.z);
    }
    out.line(" -3");
    out.line("    3C{:30d}{:38d}", tank.around * tank.along, 1);
    int element = 0;
    for (int z = 0; z < tank.along; ++z) {
        for (int a = 0; a < tank.around; ++a) {
            out.line(" -1{:10d}{:5d}{:5d}{:5d}", ++element, 1, 0, 1);
            out.line(
                " -2{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}",
                tank.node(a, z, 0),
                tank.node(a, z, 1),
                tank.node(a + 1, z, 1),
                tank.node(a + 1, z, 0),
                tank.node(a, z + 1, 0),
                tank.node(a, z + 1, 1),
                tank.node(a + 1, z + 1, 1),
                tank.node(a + 1, z + 1, 0)
            );
        }
    }
    out.line(" -3");
}

void write_results(Writer& out, const Tank& tank) {
    const auto head = [&](const char* name, int rows) {
        out.line("  100CL  101 1.000000000{:12d}                     0    1{:12d}", tank.node_count(), 1);
        out.line(" -4  {:8}{:5d}    1", name, rows);
    };
    head("DISP", 4);
    for (int c = 1; c <= 3; ++c) out.line(" -5  D{}          1    2    {}    0", c, c);
    out.line(" -5  ALL         1    2    0    0    1ALL");
    for (int id = 1; id <= tank.node_count(); ++id) {
        const Tank::Place p = tank.place(id);
        const double bulge = 0.4 * std::sin(std::numbers::pi * p.share);
        out.line(
            " -1{:10d}{:12.5E}{:12.5E}{:12.5E}",
            id,
            bulge * std::cos(p.angle),
            bulge * std::sin(p.angle),
            0.2 * p.share
        );
    }
    out.line(" -3");
    head("NDTEMP", 1);
    out.line(" -5  T           1    1    0    0");
    for (int id = 1; id <= tank.node_count(); ++id) {
        const Tank::Place p = tank.place(id);
        out.line(" -1{:10d}{:12.5E}", id, 20 + 150 * p.share + 40 * std::sin(3 * p.angle + 9 * p.share));
    }
    out.line(" -3");
    out.line(" 9999");
}

}  // namespace

int main(int argc, char** argv) {
    const Tank tank{argc > 1 ? std::atoi(argv[1]) : 0, argc > 2 ? std::atoi(argv[2]) : 0};
    if (argc != 4 || tank.around < 3 || tank.along < 1 || tank.around > 20'000 || tank.along > 20'000) {
        std::fputs("usage: bench_make_tank AROUND ALONG FILE.frd\n", stderr);
        return 2;
    }
    Writer out(argv[3]);
    write_mesh(out, tank);
    write_results(out, tank);
    return 0;
}
