// SPDX-License-Identifier: Apache-2.0
// Writes a block of N x N x N hex8 nodes as a deck: as Abaqus/CAE writes .inp, as pre-processors write bulk
// data in each of its three forms, or as VTK's legacy text. The same bytes every time.
#include "block.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using bench::Block;
using bench::Writer;

/// A float of nine digits, always with a point.
std::string cae_real(double value) {
    std::string text = fmt::format("{:.9g}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos) text += '.';
    return text;
}

void write_inp(Writer& out, const Block& block) {
    out.line("*Heading");
    out.line("** Job name: block Model name: Model-1");
    out.line("*Node");
    block.for_each_node([&](int id, const auto& p) {
        out.line("{:7d}, {:>12}, {:>12}, {:>12}", id, cae_real(p[0]), cae_real(p[1]), cae_real(p[2]));
    });
    out.line("*Element, type=C3D8R");
    const auto width = static_cast<int>(std::to_string(block.node_count()).size());
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        out.line(
            "{8:{9}d}, {0:{9}d}, {1:{9}d}, {2:{9}d}, {3:{9}d}, {4:{9}d}, {5:{9}d}, {6:{9}d}, {7:{9}d}",
            n[0],
            n[1],
            n[2],
            n[3],
            n[4],
            n[5],
            n[6],
            n[7],
            id,
            width
        );
    });
    out.line("*Nset, nset=Set-1, generate");
    out.line("{:7d}, {:7d}, {:7d}", 1, block.node_count(), 1);
    out.line("*Elset, elset=Set-1, generate");
    out.line("{:7d}, {:7d}, {:7d}", 1, block.element_count(), 1);
    out.line("*Nset, nset=Bottom");
    const int layer = block.side * block.side;
    for (int first = 1; first <= layer; first += 16) {
        std::string row;
        for (int id = first; id < first + 16 && id <= layer; ++id)
            row += fmt::format("{}{:7d}", id == first ? "" : ",", id);
        out.line("{}", row);
    }
    out.line("** Section: Section-1");
    out.line("*Solid Section, elset=Set-1, material=Material-1");
    out.line(",");
}

/// At most eight columns, as much of the number as they hold.
std::string small_real(double value) {
    std::string text = fmt::format("{:.5f}", value);
    if (text.size() > 8) text.resize(8);
    if (text.find('.') == std::string::npos) text = fmt::format("{:.0f}.", value);
    return text;
}

enum class Form : char {
    Free,
    Small,
    Large,
};

void write_grid(Writer& out, Form form, int id, const std::array<double, 3>& p) {
    switch (form) {
    case Form::Free: out.line("GRID,{},,{:.9f},{:.9f},{:.9f}", id, p[0], p[1], p[2]); break;
    case Form::Small:
        out.line(
            "GRID    {:8d}        {:>8}{:>8}{:>8}", id, small_real(p[0]), small_real(p[1]), small_real(p[2])
        );
        break;
    case Form::Large:
        out.line("GRID*   {:16d}                {:16.9E}{:16.9E}*", id, p[0], p[1]);
        out.line("*       {:16.9E}", p[2]);
        break;
    }
}

void write_hexa(Writer& out, Form form, int id, const std::array<int, 8>& n) {
    switch (form) {
    case Form::Free:
        out.line("CHEXA,{},1,{},{},{},{},{},{},+", id, n[0], n[1], n[2], n[3], n[4], n[5]);
        out.line("+,{},{}", n[6], n[7]);
        break;
    case Form::Small:
        out.line(
            "CHEXA   {:8d}{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}+", id, 1, n[0], n[1], n[2], n[3], n[4], n[5]
        );
        out.line("+       {:8d}{:8d}", n[6], n[7]);
        break;
    case Form::Large:
        out.line("CHEXA*  {:16d}{:16d}{:16d}{:16d}*", id, 1, n[0], n[1]);
        out.line("*       {:16d}{:16d}{:16d}{:16d}*", n[2], n[3], n[4], n[5]);
        out.line("*       {:16d}{:16d}", n[6], n[7]);
        break;
    }
}

void write_bdf(Writer& out, const Block& block, Form form) {
    out.line("SOL 101");
    out.line("CEND");
    out.line("TITLE = block");
    out.line("BEGIN BULK");
    block.for_each_node([&](int id, const auto& p) { write_grid(out, form, id, p); });
    block.for_each_element([&](int id, const std::array<int, 8>& n) { write_hexa(out, form, id, n); });
    out.line("PSOLID,1,1");
    out.line("MAT1,1,2.1E+5,,0.3");
    out.line("ENDDATA");
}

/// For VTK's own reader.
void write_vtk(Writer& out, const Block& block) {
    out.line("# vtk DataFile Version 3.0");
    out.line("block");
    out.line("ASCII");
    out.line("DATASET UNSTRUCTURED_GRID");
    out.line("POINTS {} double", block.node_count());
    block.for_each_node([&](int, const auto& p) {
        out.line("{} {} {}", cae_real(p[0]), cae_real(p[1]), cae_real(p[2]));
    });
    out.line("CELLS {} {}", block.element_count(), 9 * block.element_count());
    block.for_each_element([&](int, const std::array<int, 8>& n) {
        out.line(
            "8 {} {} {} {} {} {} {} {}",
            n[0] - 1,
            n[1] - 1,
            n[2] - 1,
            n[3] - 1,
            n[4] - 1,
            n[5] - 1,
            n[6] - 1,
            n[7] - 1
        );
    });
    out.line("CELL_TYPES {}", block.element_count());
    for (int i = 0; i < block.element_count(); ++i) out.line("12");
}

bool write(std::string_view format, const char* path, const Block& block) {
    Writer out(path);
    if (format == "inp") {
        write_inp(out, block);
    } else if (format == "bdf-free") {
        write_bdf(out, block, Form::Free);
    } else if (format == "bdf-small") {
        write_bdf(out, block, Form::Small);
    } else if (format == "bdf-large") {
        write_bdf(out, block, Form::Large);
    } else if (format == "vtk") {
        write_vtk(out, block);
    } else {
        return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc == 4 ? std::atoi(argv[2]) : 0;
    if (side < 2 || side > 500 || !write(argv[1], argv[3], Block{side})) {
        std::fputs(
            "usage: bench_make_deck inp|bdf-free|bdf-small|bdf-large|vtk NODES_PER_SIDE(2..500) OUT\n", stderr
        );
        return 2;
    }
}
