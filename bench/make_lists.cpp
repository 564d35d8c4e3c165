// SPDX-License-Identifier: Apache-2.0
// Writes the block of N x N x N hex8 nodes as Ansys lists: NLIST, ELIST, PRNSOL of displacement and of
// stress, with the heads of their pages. The same bytes every time.
#include "block.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using bench::Block;
using bench::Writer;

/// Fortran's G: so many significant digits and four blanks, or 0. and an exponent where that would be too
/// short.
std::string general(double value, int digits) {
    const double size = std::abs(value);
    const int before = size == 0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
    if (before >= 0 && before <= digits) return fmt::format("{:.{}f}    ", value, digits - before);
    return fmt::format(
        "{:.{}f}E{}{:02}", value / std::pow(10.0, before), digits, before < 0 ? '-' : '+', std::abs(before)
    );
}

std::string path_of(const std::string& folder, const char* name) {
    return folder + "/" + name;
}

void write_nodes(const std::string& path, const Block& block) {
    Writer out(path.c_str());
    out.line("\n LIST ALL SELECTED NODES.   DSYS=      0");
    block.for_each_node([&](int id, const auto& p) {
        if (id % 20 == 1)
            out.line("\n    NODE        X                   Y                   Z                THXY     "
                     "THYZ     THZX");
        out.line(
            "{:8d}{:>22}{:>20}{:>20}     0.00     0.00     0.00",
            id,
            general(p[0], 12),
            general(p[1], 12),
            general(p[2], 12)
        );
    });
}

void write_elements(const std::string& path, const Block& block) {
    Writer out(path.c_str());
    out.line("\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)");
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        if (id % 20 == 1) out.line("\n    ELEM MAT TYP REL ESY SEC        NODES\n");
        out.line(
            "{:8d}{:4d}{:4d}{:4d}{:4d}{:4d}      {:8d}{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}",
            id,
            1,
            1,
            1,
            0,
            1,
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
}

/// Columns that wave through the block, from 1e-4 to 1e2 in size.
double value_at(int id, int column) {
    return std::pow(10.0, column % 4 - 2) * std::sin(1e-5 * id * (column + 1)) + 1e-4 * column;
}

void write_values(const std::string& path, const Block& block, const char* head, int columns) {
    Writer out(path.c_str());
    out.line("{}", head);
    const std::string names =
        columns == 4 ? "    NODE    UX          UY          UZ          USUM"
                     : "    NODE    SX          SY          SZ          SXY         SYZ         SXZ";
    for (int id = 1; id <= block.node_count(); ++id) {
        if (id % 37 == 1) out.line("\n{}", names);
        std::string row;
        double square = 0;
        for (int c = 0; c < columns; ++c) {
            const double value = columns == 4 && c == 3 ? std::sqrt(square) : value_at(id, c);
            square += value * value;
            row += fmt::format("{:>12}", general(value, 5));
        }
        out.line("{:8d} {}", id, row);
    }
}

constexpr const char* kDisplacement = R"(
 PRINT U    NODAL SOLUTION PER NODE

  ***** POST1 NODAL DEGREE OF FREEDOM LISTING *****

  LOAD STEP=     1  SUBSTEP=     1
   TIME=    1.0000      LOAD CASE=   0

  THE FOLLOWING DEGREE OF FREEDOM RESULTS ARE IN THE GLOBAL COORDINATE SYSTEM)";
constexpr const char* kStress = R"(
 PRINT S    NODAL SOLUTION PER NODE

  ***** POST1 NODAL STRESS LISTING *****

  LOAD STEP=     1  SUBSTEP=     1
   TIME=    1.0000      LOAD CASE=   0

  THE FOLLOWING X,Y,Z VALUES ARE IN THE GLOBAL COORDINATE SYSTEM)";

}  // namespace

int main(int argc, char** argv) {
    const int side = argc == 3 ? std::atoi(argv[1]) : 0;
    if (side < 2 || side > 300) {
        std::fputs("usage: bench_make_lists NODES_PER_SIDE(2..300) FOLDER\n", stderr);
        return 2;
    }
    const Block block{side};
    const std::string folder = argv[2];
    write_nodes(path_of(folder, "NLIST.lis"), block);
    write_elements(path_of(folder, "ELIST.lis"), block);
    write_values(path_of(folder, "PRNSOL_U.lis"), block, kDisplacement, 4);
    write_values(path_of(folder, "PRNSOL_S.lis"), block, kStress, 6);
    Writer types(path_of(folder, "ETLIST.lis").c_str());
    types.line("\n LIST ELEMENT TYPES FROM       1 TO       1 BY       1\n");
    types.line(" ELEMENT TYPE         1 IS SOLID185     3-D 8-NODE STRUCTURAL SOLID");
}
