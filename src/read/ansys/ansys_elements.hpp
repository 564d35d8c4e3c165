// SPDX-License-Identifier: Apache-2.0
// Ansys' element types: which shape a row of nodes is, and which types have no surface of their own.
#pragma once

#include "feelem/element_type.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace feelem::ansys {

enum class ElementKind {
    Solid,
    Shell,
    Plane,          ///< 2-D: drawn as a flat shell.
    Line,           ///< Beams, links, pipes; also axisymmetric shells.
    MeshOnly,       ///< MESH200: its shape stands in KEYOPT(1).
    Point,          ///< Masses.
    Spring,         ///< Springs, joints, matrices.
    Contact,        ///< Contact and target: they lie on facets of other elements.
    SurfaceEffect,  ///< Likewise.
    Revolved,       ///< General axisymmetric solids: their nodes are no mesh in space.
    Other,
};

struct ElementName {
    int number = 0;         ///< 185
    std::string_view name;  ///< "SOLID185"
    ElementKind kind = ElementKind::Other;
    ElementType type = ElementType::Point1;  ///< With all its nodes; Point1 when it has no surface.
};

/// By routine number, as .rst and ET,1,185 give it.
std::optional<ElementName> find_element(int number);
/// By name in any case ("SOLID185", "solid185.") or by number ("185").
std::optional<ElementName> find_element(std::string_view name);

/// Solids, shells, planes and lines.
bool is_drawn(ElementKind kind);

/// What a row of node ids is: the type, and how many of its first ids are geometry (orientation and extra
/// nodes follow them).
struct RowShape {
    ElementType type = ElementType::Point1;
    std::size_t nodes = 0;
};
/// `count`: ids in the row; trailing mid-side nodes may be left out. `keyopt1` is KEYOPT(1), 0 when unknown.
/// Empty when so many ids make no such element. Node order is Feelem's already.
std::optional<RowShape> shape_of_row(const ElementName& element, std::size_t count, int keyopt1);

}  // namespace feelem::ansys
