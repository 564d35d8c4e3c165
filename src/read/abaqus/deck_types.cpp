// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_types.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace feelem::abaqus {
namespace {

enum class Family : std::uint8_t {
    Solid,
    Surface,  ///< Shells, membranes, plane and axisymmetric continua, rigid faces.
    Line,     ///< The digit is the number of nodes.
    Line1,    ///< The digit is the order: 1 two nodes, 2 three.
    Beam,     ///< Two digits: space and order. 3 is cubic, with two nodes.
    Line2,    ///< Always two nodes.
    Skip,
};

struct FamilyRow {
    std::string_view prefix;
    Family family;
};

/// The longest prefix that fits counts. A digit must follow those of shapes.
constexpr auto kFamilies = std::to_array<FamilyRow>({
    {"C3D", Family::Solid},     {"DC3D", Family::Solid},       {"DCC3D", Family::Solid},
    {"AC3D", Family::Solid},    {"Q3D", Family::Solid},        {"EC3D", Family::Solid},
    {"EMC3D", Family::Solid},   {"FC3D", Family::Solid},       {"SC", Family::Solid},
    {"CSS", Family::Solid},     {"F3D", Family::Solid},        {"S", Family::Surface},
    {"STRI", Family::Surface},  {"DS", Family::Surface},       {"SFM3D", Family::Surface},
    {"M3D", Family::Surface},   {"R3D", Family::Surface},      {"CPS", Family::Surface},
    {"CPE", Family::Surface},   {"CPEG", Family::Surface},     {"CAX", Family::Surface},
    {"CGAX", Family::Surface},  {"DC2D", Family::Surface},     {"DCAX", Family::Surface},
    {"DCC2D", Family::Surface}, {"DCCAX", Family::Surface},    {"AC2D", Family::Surface},
    {"ACAX", Family::Surface},  {"EMC2D", Family::Surface},    {"US", Family::Surface},
    {"T2D", Family::Line},      {"T3D", Family::Line},         {"DC1D", Family::Line},
    {"DCC1D", Family::Line},    {"AC1D", Family::Line},        {"R2D", Family::Line},
    {"RAX", Family::Line},      {"SAX", Family::Line1},        {"DSAX", Family::Line1},
    {"MAX", Family::Line1},     {"MGAX", Family::Line1},       {"SFMAX", Family::Line1},
    {"SFMGAX", Family::Line1},  {"B", Family::Beam},           {"PIPE", Family::Beam},
    {"ELBOW", Family::Beam},    {"RB2D", Family::Line2},       {"RB3D", Family::Line2},
    {"FRAME2D", Family::Line2}, {"FRAME3D", Family::Line2},    {"SPRING", Family::Skip},
    {"DASHPOT", Family::Skip},  {"MASS", Family::Skip},        {"ROTARYI", Family::Skip},
    {"HEATCAP", Family::Skip},  {"CAPACITANCE", Family::Skip}, {"CONN2D", Family::Skip},
    {"CONN3D", Family::Skip},   {"DCOUP", Family::Skip},       {"GAP", Family::Skip},
    {"DGAP", Family::Skip},     {"JOINT", Family::Skip},       {"GK", Family::Skip},
    {"COH", Family::Skip},      {"COD", Family::Skip},         {"CIN", Family::Skip},
    {"ACIN", Family::Skip},     {"ASI", Family::Skip},         {"IRS", Family::Skip},
    {"ISL", Family::Skip},      {"ISP", Family::Skip},         {"ITS", Family::Skip},
    {"ITT", Family::Skip},      {"LS3S", Family::Skip},        {"LS6", Family::Skip},
    {"PSI", Family::Skip},      {"PD3D", Family::Skip},        {"PC3D", Family::Skip},
    {"DRAG", Family::Skip},     {"FLINK", Family::Skip},       {"F2D", Family::Skip},
    {"FAX", Family::Skip},      {"FP", Family::Skip},          {"FPC", Family::Skip},
    {"DINTER", Family::Skip},   {"INTER", Family::Skip},       {"TUBE", Family::Skip},
    {"U", Family::Skip},        {"VU", Family::Skip},          {"Z", Family::Skip},
    {"D", Family::Skip},
});

// Abaqus' C3D27: mid-body, then faces z-, z+, y-, x+, y+, x-; ours: x- x+ y- y+ z- z+, mid-body.
constexpr std::array<std::uint8_t, 27> kHex27{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
                                              14, 15, 16, 17, 18, 19, 26, 24, 23, 25, 21, 22, 20};

// Lines have their middle between their ends; ours comes last.
constexpr std::array<std::uint8_t, 3> kLine3{0, 2, 1};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

const FamilyRow* family_of(std::string_view name) {
    const FamilyRow* best = nullptr;
    for (const FamilyRow& row : kFamilies) {
        if (!name.starts_with(row.prefix)) continue;
        const std::string_view rest = name.substr(row.prefix.size());
        // "D" and "U1" are types, "DISTRIBUTED" is none.
        const bool short_name = row.prefix.size() <= 2 && row.family == Family::Skip;
        const bool fits = row.family == Family::Skip
                              ? !short_name || rest.empty() || is_digit(rest[0]) || row.prefix == "GK"
                              : !rest.empty() && is_digit(rest[0]);
        const bool whole = row.family == Family::Line2 || fits;
        if (whole && (best == nullptr || row.prefix.size() > best->prefix.size())) best = &row;
    }
    return best;
}

/// The number behind the prefix; one digit only for beams, whose second digit is the order.
int number_behind(std::string_view name, std::size_t at) {
    int number = 0;
    for (; at < name.size() && is_digit(name[at]) && number < 100; ++at)
        number = number * 10 + (name[at] - '0');
    return number;
}

std::optional<ElementType> solid_of(int nodes) {
    switch (nodes) {
    case 4: return ElementType::Tet4;
    case 5: return ElementType::Pyramid5;
    case 6: return ElementType::Wedge6;
    case 8: return ElementType::Hex8;
    case 10: return ElementType::Tet10;
    case 13: return ElementType::Pyramid13;
    case 15: return ElementType::Wedge15;
    case 20: return ElementType::Hex20;
    case 27: return ElementType::Hex27;
    default: return {};
    }
}

std::optional<ElementType> surface_of(int nodes) {
    switch (nodes) {
    case 3: return ElementType::Tri3;
    case 4: return ElementType::Quad4;
    case 6:
    case 65: return ElementType::Tri6;  // STRI65: six nodes, five degrees of freedom.
    case 8: return ElementType::Quad8;
    case 9: return ElementType::Quad9;
    case 45: return ElementType::Quad4;  // US45: four nodes.
    default: return {};
    }
}

std::optional<ElementType> line_of(int nodes) {
    if (nodes == 2) return ElementType::Line2;
    if (nodes == 3) return ElementType::Line3;
    return {};
}

std::optional<ElementType> shape_of(const FamilyRow& row, int number) {
    switch (row.family) {
    case Family::Solid: return solid_of(number);
    case Family::Surface: return surface_of(number);
    case Family::Line: return line_of(number);
    case Family::Line1: return line_of(number + 1);
    case Family::Beam: {
        const int space = number / 10, order = number % 10;
        if (space != 2 && space != 3) return {};
        return line_of(order == 2 ? 3 : order == 1 || order == 3 ? 2 : 0);
    }
    case Family::Line2: return ElementType::Line2;
    case Family::Skip: break;
    }
    return {};
}

}  // namespace

DeckType deck_type(std::string_view name) {
    const FamilyRow* row = family_of(name);
    DeckType type;
    if (row == nullptr) return type;
    const int number = number_behind(name, row->prefix.size());
    // Abaqus' F3D3 and F3D4 are faces of fluid cavities; CalculiX' F3D8 and F3D6 are solids.
    const bool cavity = row->prefix == "F3D" && number < 6;
    if (row->family == Family::Skip || cavity) {
        type.use = Use::Skip;
        return type;
    }
    const auto shape = shape_of(*row, number);
    if (!shape) return type;
    type.use = Use::Shape;
    type.shape = *shape;
    type.most_nodes = type.least_nodes = element_row(*shape).node_count;
    if (*shape == ElementType::Wedge15 && name.substr(row->prefix.size()).starts_with("15V")) {
        type.shape = ElementType::Wedge18;
        type.most_nodes = 18;
    }
    if (*shape == ElementType::Line3) type.order = kLine3;
    if (*shape == ElementType::Hex27) {
        type.least_nodes = 20;
        type.order = kHex27;
    }
    return type;
}

}  // namespace feelem::abaqus
