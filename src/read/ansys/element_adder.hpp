// SPDX-License-Identifier: Apache-2.0
// Ansys' rows of element nodes into a mesh: shapes by type table, parts by material, what has no surface
// counted.
#pragma once

#include "base/input.hpp"
#include "model/mesh_builder.hpp"
#include "read/ansys/list_types.hpp"

#include "feelem/diagnostics.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace feelem::ansys {

/// Decision 9: a part is a material, within a body where the file names bodies.
std::string part_name(std::int64_t material, std::string_view body = {});

/// The part of a material: "material 2", or the only body of it. Empty when there is none.
std::optional<PartIndex> find_part_of_material(const Mesh& mesh, std::int64_t material);

/// Whether an element id was there before: cheap as long as ids ascend.
class SeenIds {
public:
    bool insert(std::int64_t id);

private:
    std::vector<std::int64_t> ids_;
    std::unordered_set<std::int64_t> set_;
};

class ElementAdder {
public:
    ElementAdder(MeshBuilder& builder, TypeTable types, Diagnostics& diagnostics)
        : builder_(builder), types_(std::move(types)), diagnostics_(diagnostics) {}

    /// The body that further rows belong to; empty: none is known.
    void set_body(std::string_view body);

    void add(const Input& input, const ElementRowIds& row);

    /// An element that only a list of its values names: its corners, in the order of their rows.
    void add_named(
        const Input& input,
        std::int64_t id,
        std::string_view name,
        std::span<const std::int64_t> nodes,
        std::size_t offset
    );

    const TypeShape& type_of(std::int64_t number);

private:
    PartIndex part_of(std::int64_t material);
    void leave_out(const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where);
    void warn_of_extra_nodes(
        const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where
    );

    MeshBuilder& builder_;
    TypeTable types_;
    Diagnostics& diagnostics_;
    SeenIds seen_;
    std::array<NodeId, kMaxElementNodes> nodes_{};
    std::int64_t last_type_ = -1;
    const TypeShape* type_ = nullptr;
    std::string body_;
    std::int64_t last_material_ = -1;
    bool has_part_ = false;
    PartIndex part_{};
};

}  // namespace feelem::ansys
