// SPDX-License-Identifier: Apache-2.0
#include "skin_mesh.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {
namespace {

using feelem::ElementBlock;
using feelem::ElementId;
using feelem::ElementIndex;
using feelem::ElementType;
using feelem::Mesh;
using feelem::NodeId;
using feelem::NodeIndex;
using feelem::PartIndex;
using feelem::Point3;

constexpr std::uint32_t kUnused = 0xFFFFFFFF;
constexpr std::array<std::array<int, 3>, 8> kCorners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
/// The six tetrahedra round the diagonal 0-6 of a cube; neighbours' diagonals agree.
constexpr std::array<std::array<int, 4>, 6> kTets{
    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};

/// Nodes on a grid of half steps, numbered as they are first used.
class Grid {
public:
    explicit Grid(std::array<int, 3> cubes)
        : size_{2 * cubes[0] + 1, 2 * cubes[1] + 1, 2 * cubes[2] + 1},
          number_(
              static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                  static_cast<std::size_t>(size_[2]),
              kUnused
          ) {}

    std::uint32_t node(std::array<int, 3> at, double shift_x = 0) {
        const auto [x, y, z] = at;
        const auto key =
            static_cast<std::size_t>(x) + static_cast<std::size_t>(size_[0]) *
                                              (static_cast<std::size_t>(y) + static_cast<std::size_t>(size_[1]
                                                                             ) * static_cast<std::size_t>(z));
        if (number_[key] == kUnused) {
            number_[key] = static_cast<std::uint32_t>(places.size());
            places.push_back({0.5 * x + shift_x, 0.5 * y, 0.5 * z});
        }
        return number_[key];
    }

    std::vector<Point3> places;

private:
    std::array<int, 3> size_;
    std::vector<std::uint32_t> number_;
};

/// Cubes cut in two, each half a hexahedron with repeated nodes (SOLID185 as a prism), in the upper half of
/// x.
constexpr std::array<std::array<int, 8>, 2> kDegenerate{{{0, 1, 2, 2, 4, 5, 6, 6}, {0, 2, 3, 3, 4, 6, 7, 7}}};

std::array<int, 3> half_steps(std::array<int, 3> cube, int corner) {
    std::array<int, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        at[axis] = 2 * (cube[axis] + kCorners[static_cast<std::size_t>(corner)][axis]);
    }
    return at;
}

std::array<int, 3> between(std::array<int, 3> a, std::array<int, 3> b) {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// An element of `type` on these corners of a cube, with the middles of its edges.
void add(
    Grid& grid, ElementBlock& block, std::array<int, 3> cube, std::span<const int> corners, double shift_x = 0
) {
    std::array<std::array<int, 3>, 8> at{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        at[i] = corners[i] == 8 ? between(half_steps(cube, 0), half_steps(cube, 6))
                                : half_steps(cube, corners[i]);
        block.nodes.push_back(NodeIndex{grid.node(at[i], shift_x)});
    }
    for (const feelem::EdgeRow& edge : feelem::edges_of(block.type)) {
        if (edge.middle == feelem::kNoLocalNode) continue;
        block.nodes.push_back(NodeIndex{grid.node(between(at[edge.first], at[edge.second]), shift_x)});
    }
}

void add_tets(Grid& grid, ElementBlock& block, std::array<int, 3> cube, double shift_x = 0) {
    for (const std::array<int, 4>& tet : kTets) add(grid, block, cube, tet, shift_x);
}

void add_hex(Grid& grid, ElementBlock& block, std::array<int, 3> cube) {
    constexpr std::array<int, 8> kAll{0, 1, 2, 3, 4, 5, 6, 7};
    add(grid, block, cube, kAll);
}

void add_wedges(Grid& grid, ElementBlock& block, std::array<int, 3> cube) {
    // Triangle 0 1 2 faces 3 4 5: its normal points into the wedge.
    add(grid, block, cube, std::array{0, 1, 2, 4, 5, 6});
    add(grid, block, cube, std::array{0, 2, 3, 4, 6, 7});
}

void add_pyramids(Grid& grid, ElementBlock& block, std::array<int, 3> cube) {
    constexpr std::array<std::array<int, 5>, 6> kBases{
        {{0, 1, 2, 3, 8},
         {4, 7, 6, 5, 8},
         {0, 4, 5, 1, 8},
         {1, 5, 6, 2, 8},
         {2, 6, 7, 3, 8},
         {3, 7, 4, 0, 8}}};
    for (const std::array<int, 5>& base : kBases) add(grid, block, cube, base);
}

template <class Visit>
void for_each_cube(std::array<int, 3> cubes, Visit visit) {
    for (int z = 0; z < cubes[2]; ++z) {
        for (int y = 0; y < cubes[1]; ++y) {
            for (int x = 0; x < cubes[0]; ++x) visit(std::array<int, 3>{x, y, z});
        }
    }
}

int side_of(std::size_t cells, double cells_a_cube) {
    return std::max(1, static_cast<int>(std::lround(std::cbrt(static_cast<double>(cells) / cells_a_cube))));
}

/// Four zones along x of one cube in four each: by cells, about one hex to two wedges, six pyramids and six
/// tets.
std::vector<Point3> make_mixed(std::size_t cells, Mesh& mesh) {
    const int side = std::max(4, side_of(cells, (1 + 2 + 6 + 6) / 4.0) / 4 * 4);
    for (const ElementType type :
         {ElementType::Hex8, ElementType::Wedge6, ElementType::Pyramid5, ElementType::Tet4}) {
        mesh.blocks.push_back({type, {}, {}, {}});
    }
    Grid grid({side + 1, side, side});
    for_each_cube({side, side, side}, [&](std::array<int, 3> cube) {
        switch (cube[0] * 4 / side) {
        case 0: return add_hex(grid, mesh.blocks[0], cube);
        case 1: return add_wedges(grid, mesh.blocks[1], cube);
        case 2: return add_pyramids(grid, mesh.blocks[2], cube);
        default:
            return add_tets(
                grid, mesh.blocks[3], {cube[0] + 1, cube[1], cube[2]}
            );  // Quads do not fit triangles.
        }
    });
    return std::move(grid.places);
}

std::vector<Point3> make_uniform(const std::string& kind, std::size_t cells, Mesh& mesh) {
    const bool is_tet = kind == "tet4" || kind == "tet10";
    const bool is_quadratic = kind == "hex20" || kind == "tet10";
    const int side = kind == "plate"
                         ? std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells)))))
                         : side_of(cells, is_tet ? 6 : 1);
    const std::array<int, 3> cubes{side, side, kind == "plate" ? 1 : side};
    const ElementType type = is_tet ? (is_quadratic ? ElementType::Tet10 : ElementType::Tet4)
                                    : (is_quadratic ? ElementType::Hex20 : ElementType::Hex8);
    mesh.blocks.push_back({type, {}, {}, {}});
    ElementBlock& block = mesh.blocks.front();
    Grid grid(cubes);
    for_each_cube(cubes, [&](std::array<int, 3> cube) {
        if (kind == "degenerate" && cube[0] * 2 >= side) {
            for (const auto& half : kDegenerate) add(grid, block, cube, half);
            return;
        }
        is_tet ? add_tets(grid, block, cube) : add_hex(grid, block, cube);
    });
    return std::move(grid.places);
}

/// Linear tetrahedra from a file of free_tets.py: two counts, coordinates, corners.
std::vector<Point3> read_free_tets(const std::string& path, Mesh& mesh) {
    std::ifstream file(path, std::ios::binary);
    std::array<std::uint64_t, 2> counts{};
    file.read(reinterpret_cast<char*>(counts.data()), sizeof counts);
    std::vector<Point3> places(file ? counts[0] : 0);
    mesh.blocks.push_back({ElementType::Tet4, {}, {}, std::vector<NodeIndex>(file ? counts[1] * 4 : 0)});
    file.read(
        reinterpret_cast<char*>(places.data()), static_cast<std::streamsize>(places.size() * sizeof(Point3))
    );
    file.read(
        reinterpret_cast<char*>(mesh.blocks[0].nodes.data()),
        static_cast<std::streamsize>(mesh.blocks[0].nodes.size() * sizeof(NodeIndex))
    );
    if (!file || places.empty()) throw std::invalid_argument("no tetrahedra in " + path);
    return places;
}

/// Where each of `count` things goes.
std::vector<std::uint32_t> shuffled(std::size_t count, std::size_t window, std::uint32_t seed) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::mt19937 random(seed);
    for (std::size_t first = 0; first < count; first += window) {
        const std::size_t last = std::min(count, first + window);
        for (std::size_t i = last - 1; i > first; --i)
            std::swap(order[i], order[first + random() % (i - first + 1)]);
    }
    return order;
}

void renumber(Mesh& mesh, std::size_t window) {
    const std::vector<std::uint32_t> place = shuffled(mesh.coordinates.size(), window, 1);
    std::vector<Point3> moved(mesh.coordinates.size());
    for (std::size_t i = 0; i < moved.size(); ++i) moved[place[i]] = mesh.coordinates[i];
    mesh.coordinates = std::move(moved);
    for (ElementBlock& block : mesh.blocks) {
        const std::size_t width = feelem::element_row(block.type).node_count;
        const std::vector<std::uint32_t> to = shuffled(block.nodes.size() / width, window, 2);
        std::vector<NodeIndex> nodes(block.nodes.size());
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
            nodes[to[i / width] * width + i % width] = NodeIndex{place[feelem::raw(block.nodes[i])]};
        }
        block.nodes = std::move(nodes);
    }
}

std::size_t status_kib(const char* word) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(word)) return std::stoul(line.substr(line.find(':') + 1)) * 1024;
    }
    return 0;
}

}  // namespace

Mesh make_mesh(const std::string& kind, std::size_t cells, const std::string& numbering) {
    constexpr std::array kKinds{"hex8", "tet4", "hex20", "tet10", "mixed", "plate", "degenerate"};
    const bool is_file = kind.starts_with("free=");
    if (!is_file && std::ranges::find(kKinds, kind) == kKinds.end())
        throw std::invalid_argument("unknown mesh " + kind);
    Mesh mesh;
    mesh.coordinates = is_file           ? read_free_tets(kind.substr(5), mesh)
                       : kind == "mixed" ? make_mixed(cells, mesh)
                                         : make_uniform(kind, cells, mesh);
    if (numbering == "windowed")
        renumber(mesh, 4096);
    else if (numbering == "random")
        renumber(mesh, mesh.coordinates.size() * 8);
    else if (numbering != "natural")
        throw std::invalid_argument("unknown numbering " + numbering);
    std::int32_t next = 1;
    mesh.node_ids.reserve(mesh.coordinates.size());
    for (std::size_t i = 0; i < mesh.coordinates.size(); ++i) mesh.node_ids.push_back(NodeId{next++});
    mesh.parts.push_back({"block"});
    next = 1;
    for (ElementBlock& block : mesh.blocks) {
        const std::size_t count = block.nodes.size() / feelem::element_row(block.type).node_count;
        block.nodes.shrink_to_fit();
        block.parts.assign(count, PartIndex{0});
        for (std::size_t i = 0; i < count; ++i) block.ids.push_back(ElementId{next++});
    }
    return mesh;
}

float value_at(std::uint32_t index) {
    return static_cast<float>((index * 2654435761U) >> 12U);
}

void FacetSum::add(std::span<std::uint32_t> corners) {
    std::ranges::sort(corners);
    std::uint64_t mixed = corners.size();
    for (const std::uint32_t corner : corners) {
        mixed = (mixed ^ (corner + 0x9E3779B97F4A7C15ULL)) * 0xFF51AFD7ED558CCDULL;
        mixed ^= mixed >> 32U;
    }
    sum += mixed;
    ++count;
}

std::size_t resident_bytes() {
    return status_kib("VmRSS");
}
std::size_t peak_bytes() {
    return status_kib("VmHWM");
}
void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace bench
