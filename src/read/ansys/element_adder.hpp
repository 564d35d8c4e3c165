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
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace feelem::ansys {

/// Decision 9: a part is a material, within a body where the file names bodies.
std::string part_name(std::int64_t material, std::string_view body = {});

/// The part of a material: "material 2", or the only body of it. Empty when there is none.
std::optional<PartIndex> find_part_of_material(const Mesh& mesh, std::int64_t material);

/// Whether an element id was there before: a bit an id, in pages of ids that lie near each other, so that ids
/// cost as little as they are dense, in whatever order they come.
class SeenIds {
public:
    /// False when it was there.
    bool insert(std::int64_t id) {
        if (id >= first_ && id <= last_) return false;
        constexpr int kBits = 9;
        if (id >> kBits != page_ || bits_ == nullptr) {
            page_ = id >> kBits;
            bits_ = &pages_[page_];
        }
        const auto at = static_cast<std::uint64_t>(id) & ((1U << kBits) - 1);
        std::uint64_t& word = (*bits_)[at / 64];
        const std::uint64_t bit = std::uint64_t{1} << (at % 64);
        const bool is_new = (word & bit) == 0;
        word |= bit;
        return is_new;
    }

    /// Ids in ascending order, before all others.
    void insert_first(std::span<const ElementId> ids) {
        first_ = raw(ids.front());
        last_ = raw(ids.back());
        const bool has_holes = static_cast<std::uint64_t>(last_ - first_) != ids.size() - 1;
        if (!has_holes) return;
        last_ = first_ - 1;
        for (const ElementId id : ids) insert(raw(id));
    }
    bool empty() const { return pages_.empty() && first_ > last_; }

private:
    using Page = std::array<std::uint64_t, 8>;
    std::unordered_map<std::int64_t, Page> pages_;
    std::int64_t page_ = 0;
    Page* bits_ = nullptr;                ///< Of page_: ids mostly ascend.
    std::int64_t first_ = 0, last_ = -1;  ///< All between them are there.
};

class ElementAdder {
public:
    ElementAdder(MeshBuilder& builder, TypeTable types, Diagnostics& diagnostics)
        : builder_(builder), types_(std::move(types)), diagnostics_(diagnostics) {}

    /// The body that further rows belong to; empty: none is known.
    void set_body(std::string_view body);

    void add(const Input& input, const ElementRowIds& row);

    void add_taken(const Input& input, const TakenElements& taken);
    /// The rows taken of a list, when they are the first of all, of one type and whole, and ascend: their
    /// memory becomes the mesh's. False, with the list as it was, when they are not.
    bool take_over(List& list);

    /// An element that only a list of its values names: its corners, in the order of their rows.
    void add_named(
        const Input& input,
        std::int64_t id,
        std::string_view name,
        std::span<const std::int64_t> nodes,
        std::size_t offset
    );

    /// Rows of one type and material that nothing has to be done for but to see whether their ids are new:
    /// MeshBuilder::add_whole_elements. `offset(i)`: where the i-th stands.
    template <class Offset>
    void add_whole(
        const Input& input,
        ElementType type,
        std::int64_t material,
        std::span<const ElementId> ids,
        std::span<const NodeIndex> found,
        const Offset& offset
    ) {
        const PartIndex part = part_of(material);
        const std::size_t width = ids.empty() ? 0 : found.size() / ids.size();
        std::size_t first = 0;  // Of those that are not added yet.
        const auto add_until = [&](std::size_t end) {
            builder_.add_whole_elements(
                type,
                part,
                ids.subspan(first, end - first),
                found.subspan(first * width, (end - first) * width)
            );
        };
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (seen_.insert(raw(ids[i]))) continue;
            if (i > first) add_until(i);
            first = i + 1;
            note_duplicate(input, offset(i));
        }
        if (ids.size() > first) add_until(ids.size());
    }

    const TypeShape& type_of(std::int64_t number);
    /// The same; nothing for a number that no table has. For several threads at once.
    const TypeShape* find_type(std::int64_t number) const;

private:
    std::optional<ElementType> type_of_all(const List& list, std::size_t runs);
    bool find_in_place(std::span<NodeIndex> nodes, const ElementRow& element);
    PartIndex part_of(std::int64_t material);
    bool add_if_whole(const ElementRowIds& row, const RowShape& shape);
    void note_duplicate(const Input& input, std::size_t offset);
    void leave_out(const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where);
    void warn_of_extra_nodes(
        const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where
    );

    MeshBuilder& builder_;
    const TypeTable types_;  ///< Several threads look at it while elements are added.
    Diagnostics& diagnostics_;
    SeenIds seen_;
    std::array<NodeId, kMaxElementNodes> nodes_{};
    std::array<NodeIndex, kMaxElementNodes> found_{};
    std::vector<NodeIndex> taken_nodes_;
    std::int64_t last_type_ = -1;
    const TypeShape* type_ = nullptr;
    std::string body_;
    std::int64_t last_material_ = -1;
    bool has_part_ = false;
    PartIndex part_{};
};

}  // namespace feelem::ansys
