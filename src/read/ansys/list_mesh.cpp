// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/list_mesh.hpp"

#include "model/mesh_builder.hpp"
#include "read/ansys/list_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace feelem::ansys {
namespace {

constexpr int kFewDigits = 6;

void check_node_list(const ListFile& file, const List& list, Diagnostics& diagnostics) {
    const auto where = [&] {
        return list.runs.empty() ? file.input.name() : file.input.where_line(list.runs[0].begin);
    };
    if (list.display_system != 0) {
        diagnostics.add(
            Code::CoordinateSystem,
            where,
            fmt::format(
                "nodes are listed in coordinate system {} (DSYS={}): taken as they stand, the shape is "
                "wrong. List "
                "them again after DSYS,0.",
                list.display_system,
                list.display_system
            )
        );
    }
    const int digits = coordinate_digits(file, list);
    if (digits > 0 && digits <= kFewDigits) {
        diagnostics.add(
            Code::LowPrecision,
            where,
            fmt::format("coordinates have {} digits; NLIST,ALL,,,COORD lists twelve", digits)
        );
    }
}

template <class T>
void take(std::vector<T>& values, std::span<const std::uint32_t> order) {
    std::vector<T> taken;
    taken.reserve(order.size());
    for (const std::uint32_t at : order) taken.push_back(values[at]);
    values = std::move(taken);
}

bool same_bits(const Point3& a, const Point3& b) {
    return std::ranges::equal(a, b, [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

/// Whether an element id was there before: cheap as long as ids ascend.
class SeenIds {
public:
    bool insert(std::int64_t id) {
        if (set_.empty() && (ids_.empty() || id > ids_.back())) {
            ids_.push_back(id);
            return true;
        }
        if (set_.empty()) set_.insert(ids_.begin(), ids_.end());
        return set_.insert(id).second;
    }

private:
    std::vector<std::int64_t> ids_;
    std::unordered_set<std::int64_t> set_;
};

/// Element rows of all lists into the builder.
class ElementAdder {
public:
    ElementAdder(MeshBuilder& builder, TypeTable types, Diagnostics& diagnostics)
        : builder_(builder), types_(std::move(types)), diagnostics_(diagnostics) {}

    void add(const ListFile& file, const ElementRowIds& row) {
        const auto where = [&] { return file.input.where_line(row.offset); };
        if (!seen_.insert(row.id)) {
            diagnostics_.add(
                Code::DuplicateElement, where, "elements are listed more than once; the first counts"
            );
            return;
        }
        const TypeShape& type = type_of(row.type);
        const auto shape = shape_of(type, row.nodes.size());
        if (!shape) {
            leave_out(row, type, where);
            return;
        }
        warn_of_extra_nodes(row, type, where);
        for (std::size_t i = 0; i < shape->nodes; ++i) nodes_[i] = NodeId{row.nodes[i]};
        builder_.add_element(
            ElementId{row.id},
            shape->type,
            std::span(nodes_).first(shape->nodes),
            part_of(row.material),
            where
        );
    }

    /// An element that only a list of its values names: its corners, in the order of their rows.
    void add_named(
        const ListFile& file,
        std::int64_t id,
        std::string_view name,
        std::span<const std::int64_t> nodes,
        std::size_t offset
    ) {
        if (!seen_.insert(id)) return;  // By another list of values.
        TypeShape type;
        type.name = name;
        type.element = find_element(name);
        const auto where = [&] { return file.input.where_line(offset); };
        const auto shape = shape_of(type, nodes.size());
        if (!shape) {
            ElementRowIds row;
            row.nodes = nodes;
            leave_out(row, type, where);
            return;
        }
        for (std::size_t i = 0; i < shape->nodes; ++i) nodes_[i] = NodeId{nodes[i]};
        builder_.add_element(
            ElementId{id},
            shape->type,
            std::span(nodes_).first(shape->nodes),
            builder_.part("elements"),
            where
        );
    }

private:
    const TypeShape& type_of(std::int64_t number) {
        if (number != last_type_ || type_ == nullptr) {
            last_type_ = number;
            const bool fits = number <= std::numeric_limits<std::int32_t>::max();
            type_ = &types_[fits ? static_cast<int>(number) : std::numeric_limits<std::int32_t>::max()];
        }
        return *type_;
    }

    PartIndex part_of(std::int64_t material) {
        if (material != last_material_) {
            last_material_ = material;
            part_ = builder_.part(part_name(material));
        }
        return part_;
    }

    void leave_out(const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where) {
        const std::string name = type.name.empty() ? fmt::format("type {}", row.type) : type.name;
        builder_.skip_element(name);
        const bool has_no_surface = type.element && !is_drawn(type.element->kind);
        if (has_no_surface && type.element->kind != ElementKind::Revolved) return;
        const std::string why = !type.element ? "Feelem does not know this type"
                                : has_no_surface
                                    ? "solids of revolution are not drawn"
                                    : fmt::format("{} nodes make no such element", row.nodes.size());
        diagnostics_.add(
            Code::UnknownElementType, where, fmt::format("{} elements are left out: {}", name, why)
        );
    }

    /// Beams list a node more, that of their orientation. A solid or a shell that does is of another type.
    void warn_of_extra_nodes(
        const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where
    ) {
        if (!type.element || type.element->kind == ElementKind::Line ||
            type.element->kind == ElementKind::MeshOnly)
            return;
        const std::size_t most = element_row(type.element->type).node_count;
        if (row.nodes.size() <= most) return;
        diagnostics_.add(
            Code::GuessedElementType,
            where,
            fmt::format(
                "elements of type {} list {} nodes, but {} has {}: the others are not used. Does the type "
                "list "
                "(--types, ETLIST) belong to these elements?",
                row.type,
                row.nodes.size(),
                type.element->name,
                most
            )
        );
    }

    MeshBuilder& builder_;
    TypeTable types_;
    Diagnostics& diagnostics_;
    SeenIds seen_;
    std::array<NodeId, kMaxElementNodes> nodes_{};
    std::int64_t last_type_ = -1;
    const TypeShape* type_ = nullptr;
    std::int64_t last_material_ = -1;
    PartIndex part_{};
};

/// Elements out of PRESOL listings, when no list of elements is there.
void add_elements_of_values(std::span<const ListFile> files, ElementAdder& adder) {
    for (const ListFile& file : files) {
        for (const List& list : file.lists) {
            if (list.kind != ListKind::ElementNodalValues) continue;
            ValueRow current;
            std::vector<std::int64_t> nodes;
            const auto close = [&] {
                const std::size_t layers = count_layers(nodes);
                if (!nodes.empty()) {
                    adder.add_named(
                        file,
                        current.element,
                        current.element_type,
                        std::span(nodes).first(nodes.size() / layers),
                        current.offset
                    );
                }
                nodes.clear();
            };
            for_each_value_row(file, list, nullptr, [&](const ValueRow& row) {
                if (row.element != current.element) {
                    close();
                    current = row;
                }
                nodes.push_back(row.id);
            });
            close();
        }
    }
}

std::optional<LengthUnit> length_unit(const std::string& name) {
    struct Row {
        std::string_view name;
        double metres;
    };
    constexpr std::array kUnits{
        Row{"m", 1},
        Row{"mm", 0.001},
        Row{"cm", 0.01},
        Row{"in", 0.0254},
        Row{"ft", 0.3048},
        Row{"um", 1e-6}};
    const auto* found = std::ranges::find(kUnits, name, &Row::name);
    if (found == kUnits.end()) return std::nullopt;
    return LengthUnit{name, found->metres};
}

}  // namespace

std::string part_name(std::int64_t material) {
    return fmt::format("material {}", material);
}

ListedNodes collect_nodes(std::span<const ListFile> files, Diagnostics& diagnostics) {
    ListedNodes nodes;
    for (const ListFile& file : files) {
        for (const List& list : file.lists) {
            if (list.kind != ListKind::Nodes) continue;
            check_node_list(file, list, diagnostics);
            nodes.has_angles = nodes.has_angles || list.has_angles;
            const std::size_t expected = nodes.ids.size() + list.rows;
            nodes.ids.reserve(expected);
            nodes.positions.reserve(expected);
            for_each_node(file, list, &diagnostics, [&](const NodeRow& row) {
                const bool rotated = row.angles[0] != 0 || row.angles[1] != 0 || row.angles[2] != 0;
                if (rotated) nodes.angles.resize(nodes.ids.size());
                if (rotated || !nodes.angles.empty()) nodes.angles.push_back(row.angles);
                nodes.ids.push_back(NodeId{row.id});
                nodes.positions.push_back(row.position);
            });
        }
    }
    sort_nodes(nodes);
    return nodes;
}

void sort_nodes(ListedNodes& nodes) {
    if (std::ranges::adjacent_find(nodes.ids, std::ranges::greater_equal{}) == nodes.ids.end()) return;
    std::vector<std::uint32_t> order(nodes.ids.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t at) { return nodes.ids[at]; });
    const auto repeats = [&](std::uint32_t a, std::uint32_t b) {
        const bool same_angles = nodes.angles.empty() || nodes.angles[a] == nodes.angles[b];
        return nodes.ids[a] == nodes.ids[b] && same_bits(nodes.positions[a], nodes.positions[b]) &&
               same_angles;
    };
    order.erase(std::unique(order.begin(), order.end(), repeats), order.end());
    take(nodes.ids, order);
    take(nodes.positions, order);
    if (!nodes.angles.empty()) take(nodes.angles, order);
}

void add_unplaced(ListedNodes& nodes, std::vector<NodeId> ids) {
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    const std::size_t placed = nodes.ids.size();
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    for (const NodeId id : ids) {
        if (std::binary_search(
                nodes.ids.begin(), nodes.ids.begin() + static_cast<std::ptrdiff_t>(placed), id
            ))
            continue;
        nodes.ids.push_back(id);
        nodes.positions.push_back({kNowhere, kNowhere, kNowhere});
        if (!nodes.angles.empty()) nodes.angles.push_back({});
    }
    sort_nodes(nodes);
}

std::vector<NodeId> nodes_of_elements(std::span<const ListFile> files) {
    std::vector<NodeId> ids;
    for (const ListFile& file : files) {
        for (const List& list : file.lists) {
            if (list.kind != ListKind::Elements || !list.has_nodes) continue;
            for_each_element(file, list, nullptr, [&](const ElementRowIds& row) {
                for (const std::int64_t id : row.nodes) {
                    if (id != 0) ids.push_back(NodeId{id});
                }
            });
        }
    }
    return ids;
}

Mesh build_mesh(
    std::span<const ListFile> files,
    TypeTable types,
    ListedNodes nodes,
    std::span<const std::string> parts,
    Diagnostics& diagnostics
) {
    const NodeLookup lookup(nodes.ids);
    const FindPosition position = [&](std::int64_t id) -> std::optional<Point3> {
        const NodeIndex index = lookup(NodeId{id});
        return index == kNoNode ? std::nullopt : std::optional(nodes.positions[raw(index)]);
    };
    guess_types(files, position, types, diagnostics);

    MeshBuilder builder(diagnostics);
    builder.reserve_nodes(nodes.ids.size());
    for (std::size_t i = 0; i < nodes.ids.size(); ++i) {
        if (nodes.angles.empty())
            builder.add_node(nodes.ids[i], nodes.positions[i]);
        else
            builder.add_node(nodes.ids[i], nodes.positions[i], nodes.angles[i]);
    }
    if (const auto unit = length_unit(nodes.length_unit)) builder.set_length_unit(*unit);
    nodes = {};
    builder.seal_nodes();

    ElementAdder adder(builder, std::move(types), diagnostics);
    for (const ListFile& file : files) {
        for (const List& list : file.lists) {
            if (list.kind != ListKind::Elements || !list.has_nodes) continue;
            for_each_element(file, list, &diagnostics, [&](const ElementRowIds& row) {
                adder.add(file, row);
            });
        }
    }
    const bool has_element_list = std::ranges::any_of(files, [](const ListFile& file) {
        return std::ranges::any_of(file.lists, [](const List& list) {
            return list.kind == ListKind::Elements && list.has_nodes;
        });
    });
    if (!has_element_list) add_elements_of_values(files, adder);
    for (const std::string& part : parts) builder.part(part);
    return builder.finish();
}

}  // namespace feelem::ansys
