// SPDX-License-Identifier: Apache-2.0
// Solver ids in, a valid Mesh out: the only way to make one.
#pragma once

#include "model/node_lookup.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

/// Nodes first, then seal_nodes(), then elements: so connectivity is held once, as indices.
class MeshBuilder {
public:
    using Where = std::function<std::string()>;  ///< Called only when something is reported.

    explicit MeshBuilder(Diagnostics& diagnostics) : diagnostics_(&diagnostics) {}

    void reserve_nodes(std::size_t count);
    void add_node(NodeId id, const Point3& coordinates);
    /// The same, with the rotation of its nodal system in degrees (about Z, X', Y'').
    void add_node(NodeId id, const Point3& coordinates, const NodalAngles& angles);
    /// Many at once, without nodal systems of their own. As they are, where they are the first.
    void add_nodes(std::vector<NodeId>&& ids, std::vector<Point3>&& coordinates);
    /// Many at once, without nodal systems of their own.
    void add_nodes(std::span<const NodeId> ids, std::span<const Point3> coordinates);
    /// Sorts; a repeated id keeps the later definition (DuplicateNode).
    void seal_nodes();

    /// The part of that name, made on first use.
    PartIndex part(std::string_view name);
    /// So many elements are to come, at most: their memory is taken at once.
    void expect_elements(std::size_t count) { expected_elements_ = count; }
    /// `nodes` in Feelem's order; NodeId{0} where a mid-side node is left out. A row shorter than the type's
    /// nodes (down to its corners) leaves out the rest. Rows that repeat nodes become the simpler shape they
    /// are; rows without any mid-side node become linear. An unknown node leaves the element out
    /// (UnknownNode).
    void add_element(
        ElementId id, ElementType type, std::span<const NodeId> nodes, PartIndex part, const Where& where
    );
    using WhereOf = std::function<std::string(std::size_t row)>;
    /// Many elements of a type and a part: a row of its nodes after the other, each as add_element() wants
    /// them. Several threads find the nodes; the mesh does not depend on how many.
    void add_elements(
        ElementType type,
        PartIndex part,
        std::span<const ElementId> ids,
        std::span<const std::uint32_t> nodes,
        const WhereOf& where
    );
    /// Elements that nothing has to be done for: every node found by nodes(), no corner repeated, no mid-side
    /// node left out. A row after the other in `found`.
    void add_whole_elements(
        ElementType type, PartIndex part, std::span<const ElementId> ids, std::span<const NodeIndex> found
    );
    /// The same, as they are where they are the first of their type; `parts`: one an element.
    void add_whole_elements(
        ElementType type,
        std::vector<PartIndex>&& parts,
        std::vector<ElementId>&& ids,
        std::vector<NodeIndex>&& found
    );
    /// The nodes, when they are sealed.
    const NodeLookup& nodes() const { return *lookup_; }
    /// An element that has no surface of its own: counted by the solver's name of its type.
    void skip_element(std::string_view type_name, std::uint64_t count = 1);

    void set_length_unit(LengthUnit unit) { mesh_.length_unit = std::move(unit); }
    void add_node_set(std::string name, std::span<const NodeId> nodes);

    /// The mesh; the builder is empty afterwards. Reports what was skipped (SkippedElement), once a type.
    Mesh finish();

private:
    /// All nodes given and known, no corner twice: nearly every element. False: the general way.
    bool resolve_plain(std::span<const NodeId> nodes, const ElementRow& row);
    bool resolve(std::span<const NodeId> nodes, std::size_t corners, ElementId id, const Where& where);
    ElementBlock& block_of(ElementType type);

    Diagnostics* diagnostics_;
    Mesh mesh_;
    bool has_angles_ = false;
    std::size_t expected_elements_ = 0;
    std::unique_ptr<NodeLookup> lookup_;
    std::map<std::string, PartIndex, std::less<>> part_by_name_;
    std::array<int, kElementTypeCount> block_by_type_{};
    std::array<NodeIndex, kMaxElementNodes> resolved_{};
};

}  // namespace feelem
