// SPDX-License-Identifier: Apache-2.0
#include "read/unv/unv_elements.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace feelem::unv {
namespace {

struct Range {
    std::int64_t first, last;
    Family family;
    std::string_view name;
};
constexpr Range kRanges[]{
    {11, 11, Family::Line, "rod"},
    {21, 24, Family::Line, "beam"},
    {31, 32, Family::Line, "pipe"},
    {41, 46, Family::Surface, "plane stress"},
    {51, 56, Family::Surface, "plane strain"},
    {61, 66, Family::Surface, "plate"},
    {71, 76, Family::Surface, "membrane"},
    {81, 86, Family::Surface, "axisymmetric solid"},
    {91, 96, Family::Surface, "thin shell"},
    {101, 106, Family::Solid, "thick shell"},
    {111, 118, Family::Solid, "solid"},
    {121, 122, Family::NoSurface, "rigid element"},
    {136, 139, Family::NoSurface, "spring"},
    {141, 142, Family::NoSurface, "damper"},
    {151, 152, Family::NoSurface, "gap"},
    {161, 161, Family::NoSurface, "lumped mass"},
    {171, 172, Family::Line, "axisymmetric shell"},
    {181, 181, Family::NoSurface, "constraint"},
};

const Range* range_of(std::int64_t descriptor) {
    for (const Range& range : kRanges) {
        if (descriptor >= range.first && descriptor <= range.last) return &range;
    }
    return nullptr;
}

constexpr std::array<std::uint8_t, 3> kLine3{0, 2, 1};
constexpr std::array<std::uint8_t, 6> kTri6{0, 2, 4, 1, 3, 5};
constexpr std::array<std::uint8_t, 8> kQuad8{0, 2, 4, 6, 1, 3, 5, 7};
constexpr std::array<std::uint8_t, 10> kTet10{0, 2, 4, 9, 1, 3, 5, 6, 7, 8};
constexpr std::array<std::uint8_t, 15> kWedge15{0, 2, 4, 9, 11, 13, 1, 3, 5, 10, 12, 14, 6, 7, 8};
constexpr std::array<std::uint8_t, 20> kHex20{0, 2, 4,  6,  12, 14, 16, 18, 1,  3,
                                              5, 7, 13, 15, 17, 19, 8,  9,  10, 11};

}  // namespace

Family family_of(std::int64_t descriptor) {
    const Range* range = range_of(descriptor);
    return range != nullptr ? range->family : Family::Unknown;
}

bool has_beam_line(std::int64_t descriptor) {
    return descriptor == 11 || (descriptor >= 21 && descriptor <= 24) || descriptor == 31 || descriptor == 32;
}

std::optional<ElementType> type_of(std::int64_t descriptor, std::size_t node_count) {
    switch (family_of(descriptor)) {
    case Family::Line:
        if (node_count == 2) return ElementType::Line2;
        if (node_count == 3) return ElementType::Line3;
        break;
    case Family::Surface:
        if (node_count == 3) return ElementType::Tri3;
        if (node_count == 4) return ElementType::Quad4;
        if (node_count == 6) return ElementType::Tri6;
        if (node_count == 8) return ElementType::Quad8;
        break;
    case Family::Solid:
        if (node_count == 4) return ElementType::Tet4;
        if (node_count == 6) return ElementType::Wedge6;
        if (node_count == 8) return ElementType::Hex8;
        if (node_count == 10) return ElementType::Tet10;
        if (node_count == 15) return ElementType::Wedge15;
        if (node_count == 20) return ElementType::Hex20;
        break;
    case Family::NoSurface:
    case Family::Unknown: break;
    }
    return {};
}

std::string descriptor_name(std::int64_t descriptor) {
    const Range* range = range_of(descriptor);
    return fmt::format("{} ({})", range != nullptr ? range->name : "descriptor", descriptor);
}

std::span<const std::uint8_t> file_order(ElementType type) {
    switch (type) {
    case ElementType::Line3: return kLine3;
    case ElementType::Tri6: return kTri6;
    case ElementType::Quad8: return kQuad8;
    case ElementType::Tet10: return kTet10;
    case ElementType::Wedge15: return kWedge15;
    case ElementType::Hex20: return kHex20;
    default: return {};
    }
}

}  // namespace feelem::unv
