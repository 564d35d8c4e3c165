// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/nastran_elements.hpp"

#include <algorithm>
#include <string_view>

namespace feelem::nastran {
namespace {

using Order = std::array<std::uint8_t, kMaxElementNodes>;

/// Corners first, then mid-side nodes along the same edges as Feelem's.
constexpr Order kSame{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
                      14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
/// Nastran goes round the bottom, up the sides, round the top; Feelem bottom, top, sides.
constexpr Order kHexa{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15};
constexpr Order kPenta{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11};
/// CTRIAX6 goes round the triangle: corner, mid-side, corner ...
constexpr Order kRound6{0, 2, 4, 1, 3, 5};

constexpr ElementCard row(
    std::string_view name,
    ElementType type,
    const Order& order = kSame,
    std::uint8_t first_node = 3,
    std::uint8_t property = 2
) {
    return {name, type, first_node, property, order};
}

using enum ElementType;

constexpr std::array kCards{
    row("CBAR", Line2),
    row("CBEAM", Line2),
    row("CBEAM3", Line3),
    row("CBEND", Line2),
    row("CHACAB", Hex20, kHexa),
    row("CHACBR", Hex20, kHexa),
    row("CHEXA", Hex20, kHexa),
    row("CHEXA20", Hex20, kHexa),
    row("CHEXA8", Hex8),
    row("CHEXCZ", Hex20, kHexa),
    row("CIHEX1", Hex8),
    row("CONROD", Line2, kSame, 2, 0),
    row("CPENTA", Wedge15, kPenta),
    row("CPENTCZ", Wedge15, kPenta),
    row("CPLSTN3", Tri3),
    row("CPLSTN4", Quad4),
    row("CPLSTN6", Tri6),
    row("CPLSTN8", Quad8),
    row("CPLSTS3", Tri3),
    row("CPLSTS4", Quad4),
    row("CPLSTS6", Tri6),
    row("CPLSTS8", Quad8),
    row("CPYRA", Pyramid13),
    row("CPYRAM", Pyramid13),
    row("CQUAD", Quad9),
    row("CQUAD1", Quad4),
    row("CQUAD2", Quad4),
    row("CQUAD4", Quad4),
    row("CQUAD8", Quad8),
    row("CQUADR", Quad4),
    row("CQUADX", Quad9),
    row("CQUADX4", Quad4),
    row("CQUADX8", Quad8),
    row("CROD", Line2),
    row("CSHEAR", Quad4),
    row("CTETRA", Tet10),
    row("CTRAX3", Tri3),
    row("CTRAX6", Tri6),
    row("CTRIA1", Tri3),
    row("CTRIA2", Tri3),
    row("CTRIA3", Tri3),
    row("CTRIA6", Tri6),
    row("CTRIAR", Tri3),
    row("CTRIAX", Tri6),
    row("CTRIAX6", Tri6, kRound6),
    row("CTUBE", Line2),
    row("PLOTEL", Line2, kSame, 2, 0),
    row("PLOTEL3", Tri3, kSame, 2, 0),
    row("PLOTEL4", Quad4, kSame, 2, 0),
    row("PLOTEL6", Tri6, kSame, 2, 0),
    row("PLOTEL8", Quad8, kSame, 2, 0),
};

constexpr std::array<std::string_view, 58> kWithoutSurface{
    "CAABSF",  "CAERO1",  "CAERO2",  "CAERO3",  "CAERO4", "CAERO5",  "CAXIF2", "CAXIF3",  "CAXIF4", "CBUSH",
    "CBUSH1D", "CBUSH2D", "CBUTT",   "CCONEAX", "CDAMP1", "CDAMP1D", "CDAMP2", "CDAMP2D", "CDAMP3", "CDAMP4",
    "CDAMP5",  "CDUM1",   "CELAS1",  "CELAS1D", "CELAS2", "CELAS2D", "CELAS3", "CELAS4",  "CFAST",  "CFILLET",
    "CFLUID2", "CFLUID3", "CFLUID4", "CGAP",    "CHBDY",  "CHBDYE",  "CHBDYG", "CHBDYP",  "CMASS1", "CMASS2",
    "CMASS3",  "CMASS4",  "CONM1",   "CONM2",   "CSEAM",  "CVISC",   "CWELD",  "GENEL",   "RBAR",   "RBAR1",
    "RBE1",    "RBE2",    "RBE3",    "RJOINT",  "RROD",   "RSPLINE", "RSSCON", "RTRPLT",
};

constexpr std::string_view name_of(const ElementCard& card) {
    return card.name;
}

static_assert(std::ranges::is_sorted(kWithoutSurface));

}  // namespace

std::span<const ElementCard> element_cards() {
    return kCards;
}

const ElementCard* find_element_card(std::string_view name) {
    const auto at = std::ranges::lower_bound(kCards, name, {}, name_of);
    return at != kCards.end() && at->name == name ? &*at : nullptr;
}

bool is_element_without_surface(std::string_view name) {
    return std::ranges::binary_search(kWithoutSurface, name);
}

std::optional<ElementNodes> arrange_nodes(const ElementCard& card, std::span<const std::int64_t> nodes) {
    const ElementRow& row = element_row(card.type);
    ElementNodes out;
    out.type = card.type;
    bool has_middle = false;
    for (std::size_t i = 0; i < row.node_count; ++i) {
        const std::size_t from = card.order[i];
        const std::int64_t id = from < nodes.size() ? nodes[from] : 0;
        if (id == 0 && i < row.corner_count) return std::nullopt;
        if (id != 0 && i >= row.corner_count) has_middle = true;
        out.nodes[i] = NodeId{id};
    }
    if (row.order == 2 && !has_middle) out.type = row.linear;
    // A nine-node card without its middle node is the usual eight-node one.
    if (out.type == Quad9 && out.nodes[8] == NodeId{0}) out.type = Quad8;
    out.count = element_row(out.type).node_count;
    return out;
}

}  // namespace feelem::nastran
