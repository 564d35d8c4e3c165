// SPDX-License-Identifier: Apache-2.0
// The geometry part of a result file: an index of everything, then one record a node, a type, an element.
#include "read/ansys/rst_mesh.hpp"

#include "model/mesh_builder.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace feelem::rst {
namespace {

/// The longest row of an element: general contact lists up to forty nodes behind ten attributes.
constexpr std::size_t kMostElementItems = 512;
constexpr std::size_t kAttributes = 10;
constexpr std::size_t kComponentHead = 9;

using IdAndIndex = std::pair<ElementId, ElementIndex>;

struct Geometry {
    std::size_t nodes = 0, elements = 0;
    Word types = 0, places = 0, element_table = 0, components = 0;
    std::size_t component_count = 0;
    bool types_by_list = false;  ///< mapFlag: the index of types has a second record with their places.
};

Geometry read_geometry(const Records& records, Word at) {
    const std::vector<std::int32_t> head = records.integers(at);
    const auto count = [&](std::size_t number) {
        const std::int32_t value = item(head, number);
        if (value >= 0 && static_cast<std::size_t>(value) <= records.words())
            return static_cast<std::size_t>(value);
        throw Error(
            Code::BadStructure,
            records.where(at),
            fmt::format("item {} of the geometry header is {}: the file is damaged or cut", number, value)
        );
    };
    Geometry geometry;
    geometry.nodes = count(4);
    geometry.elements = count(5);
    // Old headers hold the pointers in one word.
    const auto place = [&](std::size_t low, std::size_t old) {
        const Word found = pointer(head, low, low + 1);
        return found != 0 ? found : wide(item(head, old), 0);
    };
    geometry.types = place(21, 7);
    geometry.places = place(27, 9);
    geometry.element_table = place(29, 11);
    geometry.component_count = count(49);
    geometry.components = pointer(head, 51, 52);
    geometry.types_by_list = item(head, 65) == 1;
    return geometry;
}

class MeshReader {
public:
    MeshReader(const Records& records, const ResultHeader& header, Diagnostics& diagnostics)
        : records_(records), header_(header), diagnostics_(diagnostics), builder_(diagnostics) {}

    FileMesh read() {
        geometry_ = read_geometry(records_, header_.geometry);
        read_types();
        read_nodes();
        builder_.seal_nodes();
        read_elements();
        declare_unit();
        out_.mesh = builder_.finish();
        index_elements();
        resolve_corners();
        read_components();
        return std::move(out_);
    }

private:
    void read_types() {
        if (geometry_.types == 0) return;
        const Record index = records_.find(geometry_.types);
        std::vector<std::int32_t> places;
        records_.unpack(geometry_.types_by_list ? records_.find(index.next) : index, kSmallRecord, places);
        for (const std::int32_t place : places) {
            if (place == 0) continue;
            // Offsets count from the index, and records do not reach back behind it.
            const auto type = records_.integers(geometry_.types + static_cast<std::uint32_t>(place), 512);
            ElementKindOfFile kind;
            kind.routine = item(type, 2);
            for (std::size_t i = 0; i < kind.keyopts.size(); ++i) kind.keyopts[i] = item(type, 3 + i);
            const std::int32_t corners = item(type, 94);
            kind.result_nodes = corners > 0 && corners <= 20 ? static_cast<std::size_t>(corners) : 0;
            kind.name = ansys::find_element(kind.routine);
            kind_by_number_.insert_or_assign(item(type, 1), static_cast<std::uint32_t>(out_.kinds.size()));
            out_.kinds.push_back(std::move(kind));
        }
    }

    void read_nodes() {
        // Three words of its own at least for each record.
        if (geometry_.nodes > records_.words() / 3) bad_count("nodes", geometry_.nodes);
        builder_.reserve_nodes(geometry_.nodes);
        std::vector<double> row;
        Word at = geometry_.places;
        for (std::size_t i = 0; i < geometry_.nodes; ++i) {
            const Record record = records_.find(at);
            records_.unpack(record, 32, row);
            row.resize(7);
            if (!(row[0] >= 1 && row[0] < 9e15) || row[0] != std::floor(row[0])) {
                throw Error(
                    Code::BadStructure, records_.where(at), fmt::format("{} is no node number", row[0])
                );
            }
            builder_.add_node(
                NodeId{static_cast<std::int64_t>(row[0])}, {row[1], row[2], row[3]}, {row[4], row[5], row[6]}
            );
            at = record.next;
        }
    }

    void read_elements() {
        std::vector<std::int32_t> table;
        records_.unpack(records_.find(geometry_.element_table), records_.words(), table);
        const bool is_wide = table.size() >= 2 * geometry_.elements;
        if (table.size() < geometry_.elements) bad_count("elements", geometry_.elements);
        out_.elements.reserve(geometry_.elements);
        out_.element_count = geometry_.elements;
        std::vector<std::int32_t> row;
        for (std::size_t i = 0; i < geometry_.elements; ++i) {
            element_number_ = i;
            const Word offset = is_wide ? wide(table[2 * i], table[2 * i + 1]) : wide(table[i], 0);
            const Word at = geometry_.element_table + offset;
            records_.unpack(records_.find(at), kMostElementItems, row);
            if (row.size() < kAttributes) {
                throw Error(
                    Code::BadStructure,
                    records_.where(at),
                    fmt::format("an element of {} items, at least {} are needed", row.size(), kAttributes)
                );
            }
            add_element(row, at);
        }
    }

    void add_element(std::span<const std::int32_t> row, Word at) {
        FileElement element;
        element.id = ElementId{row[8]};
        const auto found = kind_by_number_.find(row[1]);
        if (found == kind_by_number_.end()) return unknown_type(fmt::format("type {}", row[1]), at);
        element.kind = found->second;
        const ElementKindOfFile& kind = out_.kinds[element.kind];
        if (!kind.name) return unknown_type(fmt::format("routine {}", kind.routine), at);
        std::span<const std::int32_t> ids = row.subspan(kAttributes);
        while (!ids.empty() && ids.back() == 0) ids = ids.first(ids.size() - 1);
        const auto shape = ansys::shape_of_row(*kind.name, ids.size(), kind.keyopt(1));
        if (!shape) return builder_.skip_element(kind.name->name);
        nodes_.clear();
        for (const std::int32_t id : ids.first(shape->nodes)) nodes_.push_back(NodeId{id});
        builder_.add_element(element.id, shape->type, nodes_, part_of(row[0]), [&] {
            return records_.where(at);
        });
        // Kept as ids until the mesh knows its indexes: an element may be left out.
        element.first_corner = static_cast<std::uint32_t>(corner_ids_.size());
        element.corner_count = static_cast<std::uint32_t>(std::min(kind.result_nodes, ids.size()));
        for (const std::int32_t id : ids.first(element.corner_count)) corner_ids_.push_back(NodeId{id});
        element.place = static_cast<std::uint32_t>(element_number_);
        out_.elements.push_back(element);
    }

    void unknown_type(const std::string& name, Word at) {
        builder_.skip_element(name);
        diagnostics_.add(
            Code::UnknownElementType,
            [&] { return records_.where(at); },
            fmt::format("elements of {} are left out: Feelem does not know their shape", name)
        );
    }

    PartIndex part_of(std::int32_t material) {
        if (!part_ || material != last_material_) {
            last_material_ = material;
            part_ = builder_.part(fmt::format("material {}", material));
        }
        return *part_;
    }

    /// Named groups; "17 -20" means 17 to 20. After the mesh is finished, so that ranges find what there is.
    void read_components() {
        Word at = geometry_.components;
        // Components name each node a few times, not a thousand.
        std::size_t left = 4 * records_.words();
        std::vector<std::int32_t> row;
        for (std::size_t i = 0; i < geometry_.component_count && at != 0; ++i) {
            const Record record = records_.find(at);
            records_.unpack(record, geometry_.nodes + geometry_.elements + kComponentHead, row);
            if (row.size() < kComponentHead) return;
            const std::span<const std::int32_t> members = std::span(row).subspan(kComponentHead);
            std::size_t used = row.size();
            if (row[0] == 1) {
                NodeSet set{name_of_component(row), {}};
                const std::vector<NodeId>& ids = out_.mesh.node_ids;
                for_each_range(members, [&](std::int64_t first, std::int64_t last) {
                    auto it = std::ranges::lower_bound(ids, NodeId{first});
                    for (; it != ids.end() && raw(*it) <= last && used < left; ++it, ++used)
                        set.nodes.push_back(NodeIndex{static_cast<std::uint32_t>(it - ids.begin())});
                });
                out_.mesh.node_sets.push_back(std::move(set));
            } else if (row[0] == 2) {
                ElementSet set{name_of_component(row), {}};
                for_each_range(members, [&](std::int64_t first, std::int64_t last) {
                    auto it = std::ranges::lower_bound(by_id_, ElementId{first}, {}, &IdAndIndex::first);
                    for (; it != by_id_.end() && raw(it->first) <= last && used < left; ++it, ++used)
                        set.elements.push_back(it->second);
                });
                out_.mesh.element_sets.push_back(std::move(set));
            }
            if (used >= left) {
                throw Error(
                    Code::BadStructure, records_.where(at), "components name more than the file can hold"
                );
            }
            left -= used;
            at = record.next;
        }
    }

    template <class Use>
    static void for_each_range(std::span<const std::int32_t> members, Use use) {
        std::int64_t last = 0;
        for (const std::int64_t number : members) {
            if (number > 0) use(number, number);
            if (number < 0 && last > 0) use(last + 1, -number);
            last = number;
        }
    }

    static std::string name_of_component(std::span<const std::int32_t> row) {
        std::string name;
        for (std::size_t i = 1; i < kComponentHead; ++i) {
            for (const int shift : {24, 16, 8, 0})
                name += static_cast<char>(static_cast<std::uint32_t>(row[i]) >> shift & 0xFF);
        }
        name.resize(std::min(name.find('\0'), name.size()));
        name.resize(name.find_last_not_of(' ') + 1);
        return name;
    }

    void declare_unit() {
        constexpr std::array<std::pair<std::string_view, double>, 5> kMetres{
            {{"m", 1.0}, {"cm", 0.01}, {"ft", 0.3048}, {"in", 0.0254}, {"mm", 0.001}}};
        const std::string_view name = units_of(header_.units).length;
        if (name == "um") builder_.set_length_unit({"um", 1e-6});
        for (const auto& [unit, metres] : kMetres) {
            if (unit == name) builder_.set_length_unit({std::string(name), metres});
        }
    }

    void index_elements() {
        std::uint32_t index = 0;
        for (const ElementBlock& block : out_.mesh.blocks) {
            for (const ElementId id : block.ids) by_id_.emplace_back(id, ElementIndex{index++});
        }
        if (!std::ranges::is_sorted(by_id_, {}, &IdAndIndex::first))
            std::ranges::stable_sort(by_id_, {}, &IdAndIndex::first);
        for (FileElement& element : out_.elements) {
            if (element.corner_count > 0) element.index = find_element_index(element.id);
        }
    }

    ElementIndex find_element_index(ElementId id) const {
        const auto found = std::ranges::lower_bound(by_id_, id, {}, &IdAndIndex::first);
        return found != by_id_.end() && found->first == id ? found->second : kNoElement;
    }

    void resolve_corners() {
        const NodeLookup lookup(out_.mesh.node_ids);
        out_.corners.reserve(corner_ids_.size());
        for (const NodeId id : corner_ids_) out_.corners.push_back(lookup(id));
    }

    [[noreturn]] void bad_count(const char* what, std::size_t count) const {
        throw Error(
            Code::Truncated,
            records_.where(header_.geometry),
            fmt::format("the file speaks of {} {}, more than it can hold. Was it copied whole?", count, what)
        );
    }

    const Records& records_;
    const ResultHeader& header_;
    Diagnostics& diagnostics_;
    MeshBuilder builder_;
    Geometry geometry_;
    FileMesh out_;
    std::map<std::int32_t, std::uint32_t> kind_by_number_;
    std::size_t element_number_ = 0;
    std::vector<NodeId> nodes_;
    std::vector<NodeId> corner_ids_;
    std::vector<IdAndIndex> by_id_;
    std::optional<PartIndex> part_;
    std::int32_t last_material_ = 0;
};

}  // namespace

FileMesh read_file_mesh(const Records& records, const ResultHeader& header, Diagnostics& diagnostics) {
    return MeshReader(records, header, diagnostics).read();
}

}  // namespace feelem::rst
