// SPDX-License-Identifier: Apache-2.0
// Questions to the volume behind the skin: sections, isosurfaces, the value at a place. Solids alone have an
// inside; shells and lines are not cut.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace feelem {

/// The volume elements that count: one that has the corners of an earlier one is set aside, as in the skin.
struct Solids {
    const Mesh* mesh = nullptr;   ///< Must outlive this.
    std::vector<bool> set_aside;  ///< One an element; empty when the mesh has no solids.
    std::vector<Point3> moved;    ///< Places of a deformed shape; empty: those of the mesh.
    std::uint64_t count = 0;      ///< Solids, without those set aside.

    std::span<const Point3> places() const { return moved.empty() ? mesh->coordinates : moved; }
};
Solids find_solids(const Mesh& mesh);
/// The same solids where a displacement (nodal, components x y z in the global system) times `scale` brings
/// them. Nodes without a displacement stay, as they are drawn. Throws Error(BadOption) for another kind of
/// result.
Solids moved_by(const Solids& solids, const Result& displacement, double scale);

/// One component of a result, which is as it is shown: averaged, in the global system. Must outlive this.
struct FieldOf {
    const Result* result = nullptr;
    std::size_t component = 0;
};

/// normal * place = offset; the normal need not have length 1, but must not be 0.
struct Plane {
    Point3 normal{1, 0, 0};
    double offset = 0;
};

struct SectionLimits {
    std::size_t most_triangles = std::size_t{1} << 22U;
    std::function<bool()> is_cancelled{};  ///< Asked now and then, from any thread.
};

/// Triangles through the inside. Vertices are those of one element each.
struct Section {
    std::vector<Point3> positions;
    std::vector<float> values;  ///< Per vertex; NaN: a node that it needs has none.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<ElementIndex> triangle_element;
    double area = 0;
    std::uint64_t elements = 0;                ///< Cut.
    std::uint64_t elements_without_place = 0;  ///< Solids with a corner without coordinates: not cut.
};

/// Elements are cut as the skin draws them: the triangles of each facet with the element's centre make
/// tetrahedra, in which places and values are linear. So sections of neighbours join, and the rim has the
/// skin's values. What lies in a facet between two elements is cut on the side away from the normal;
/// triangles look along the normal. Elemental results are constant in an element. The same bytes whatever the
/// number of threads. Empty when cancelled. Throws Error(TooLarge) beyond the limit, Error(BadOption) for a
/// plane that is none.
std::optional<Section> cut_plane(
    const Solids& solids, const FieldOf& field, const Plane& plane, const SectionLimits& limits = {}
);

/// Where a field has a value, in the same tetrahedra: none where it is missing. Vertices have the values of
/// `colour`, or the level itself. Throws Error(BadOption) for an elemental result, which has steps and no
/// level.
std::optional<Section> isosurface(
    const Solids& solids,
    const FieldOf& field,
    double level,
    const std::optional<FieldOf>& colour = {},
    const SectionLimits& limits = {}
);

/// Where in which element a place is.
struct InteriorPlace {
    ElementIndex element = kNoElement;  ///< The smallest index where several meet.
    Point3 natural{};                   ///< In the reference element of the element table.
    std::vector<NodeIndex> nodes;       ///< Of the element, those that are there.
    std::vector<double> weights;        ///< Of these nodes: the element's shape functions.
};

/// Finds the element of a place. Made once, then asked from any thread.
class InteriorFinder {
public:
    /// `solids` must outlive this.
    explicit InteriorFinder(const Solids& solids);
    ~InteriorFinder();
    InteriorFinder(const InteriorFinder&) = delete;
    InteriorFinder& operator=(const InteriorFinder&) = delete;

    std::optional<InteriorPlace> find(const Point3& place) const;

private:
    struct Tree;
    std::unique_ptr<const Tree> tree_;
};

/// A component of a result at a place inside: all it is made of, and what comes of it.
struct InteriorValue {
    float value = 0;  ///< By the shape functions, in double, rounded once; NaN: a node has none.
    std::vector<float> node_values;  ///< As InteriorPlace::nodes; of an elemental result the element's own.
};
InteriorValue value_at(const Mesh& mesh, const FieldOf& field, const InteriorPlace& place);

}  // namespace feelem
