// SPDX-License-Identifier: Apache-2.0
// Writes a block of N x N x N hex8 nodes as a deck: as Abaqus/CAE writes .inp, as pre-processors write bulk
// data in each of its three forms, as gmsh and I-deas write theirs, or as VTK's legacy text. The same bytes
// every time.
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

/// As gmsh writes a block of one volume.
void write_msh22(Writer& out, const Block& block) {
    out.line("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}", block.node_count());
    block.for_each_node([&](int id, const auto& p) {
        out.line("{} {:.16g} {:.16g} {:.16g}", id, p[0], p[1], p[2]);
    });
    out.line("$EndNodes\n$Elements\n{}", block.element_count());
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        out.line("{} 5 2 1 1 {} {} {} {} {} {} {} {}", id, n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]);
    });
    out.line("$EndElements");
}

std::string entities_41() {
    return "$Entities\n0 0 0 1\n1 0 0 0 1000 1000 1000 0 0\n$EndEntities";
}

void write_msh41(Writer& out, const Block& block) {
    const int nodes = block.node_count(), elements = block.element_count();
    out.line(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{}\n$Nodes\n1 {} 1 {}\n3 1 0 {}",
        entities_41(),
        nodes,
        nodes,
        nodes
    );
    for (int id = 1; id <= nodes; ++id) out.line("{}", id);
    block.for_each_node([&](int, const auto& p) { out.line("{:.16g} {:.16g} {:.16g}", p[0], p[1], p[2]); });
    out.line("$EndNodes\n$Elements\n1 {} 1 {}\n3 1 5 {}", elements, elements, elements);
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        out.line("{} {} {} {} {} {} {} {} {} ", id, n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]);
    });
    out.line("$EndElements");
}

template <class T, class... More>
void bytes(Writer& out, T first, More... more) {
    out.bytes(&first, sizeof first);
    if constexpr (sizeof...(more) > 0) bytes(out, more...);
}

using Count = unsigned long long;  // size_t of the file.

void write_msh41_binary(Writer& out, const Block& block) {
    const auto nodes = static_cast<Count>(block.node_count()),
               elements = static_cast<Count>(block.element_count());
    out.line("$MeshFormat\n4.1 1 8");
    bytes(out, 1);
    out.line("\n$EndMeshFormat\n$Entities");
    bytes(out, Count{0}, Count{0}, Count{0}, Count{1}, 1, 0.0, 0.0, 0.0, 1e3, 1e3, 1e3, Count{0}, Count{0});
    out.line("\n$EndEntities\n$Nodes");
    bytes(out, Count{1}, nodes, Count{1}, nodes, 3, 1, 0, nodes);
    for (Count id = 1; id <= nodes; ++id) bytes(out, id);
    block.for_each_node([&](int, const auto& p) { bytes(out, p[0], p[1], p[2]); });
    out.line("\n$EndNodes\n$Elements");
    bytes(out, Count{1}, elements, Count{1}, elements, 3, 1, 5, elements);
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        bytes(out, static_cast<Count>(id));
        for (const int node : n) bytes(out, static_cast<Count>(node));
    });
    out.line("\n$EndElements");
}

std::string unv_real(double value) {
    std::string text = fmt::format("{:25.16E}", value);
    text[text.find('E')] = 'D';
    return text;
}

/// Datasets 2411 and 2412, as I-deas writes them.
void write_unv(Writer& out, const Block& block) {
    out.line("    -1\n  2411");
    block.for_each_node([&](int id, const auto& p) {
        out.line("{:10d}{:10d}{:10d}{:10d}", id, 1, 1, 11);
        out.line("{}{}{}", unv_real(p[0]), unv_real(p[1]), unv_real(p[2]));
    });
    out.line("    -1\n    -1\n  2412");
    block.for_each_element([&](int id, const std::array<int, 8>& n) {
        out.line("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}", id, 115, 1, 1, 7, 8);
        out.line(
            "{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}", n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]
        );
    });
    out.line("    -1");
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
    } else if (format == "msh22") {
        write_msh22(out, block);
    } else if (format == "msh41") {
        write_msh41(out, block);
    } else if (format == "msh41-binary") {
        write_msh41_binary(out, block);
    } else if (format == "unv") {
        write_unv(out, block);
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
            "usage: bench_make_deck inp|bdf-free|bdf-small|bdf-large|vtk|msh22|msh41|msh41-binary|unv "
            "NODES_PER_SIDE(2..500) OUT\n",
            stderr
        );
        return 2;
    }
}
