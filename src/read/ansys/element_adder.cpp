// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/element_adder.hpp"

#include "base/huge_pages.hpp"
#include "model/collapse.hpp"
#include "model/element_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace feelem::ansys {

std::string part_name(std::int64_t material, std::string_view body) {
    return body.empty() ? fmt::format("material {}", material)
                        : fmt::format("{} (material {})", body, material);
}

std::optional<PartIndex> find_part_of_material(const Mesh& mesh, std::int64_t material) {
    const std::string plain = part_name(material);
    const std::string of_body = "(" + plain + ")";
    std::optional<PartIndex> found;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const PartIndex part{static_cast<std::uint32_t>(i)};
        if (mesh.parts[i].name == plain) return part;
        if (!mesh.parts[i].name.ends_with(of_body)) continue;
        if (found) return std::nullopt;
        found = part;
    }
    return found;
}

void ElementAdder::set_body(std::string_view body) {
    has_part_ = has_part_ && body == body_;
    body_ = body;
}

void ElementAdder::add(const Input& input, const ElementRowIds& row) {
    const auto where = [&] { return input.where_line(row.offset); };
    if (!seen_.insert(row.id)) {
        note_duplicate(input, row.offset);
        return;
    }
    const TypeShape& type = type_of(row.type);
    const auto shape = shape_of(type, row.nodes.size());
    if (!shape) {
        leave_out(row, type, where);
        return;
    }
    if (add_if_whole(row, *shape)) return;
    if (row.nodes.size() > shape->nodes) warn_of_extra_nodes(row, type, where);
    for (std::size_t i = 0; i < shape->nodes; ++i) nodes_[i] = NodeId{row.nodes[i]};
    builder_.add_element(
        ElementId{row.id}, shape->type, std::span(nodes_).first(shape->nodes), part_of(row.material), where
    );
}

/// Nearly every row: all nodes there and different.
bool ElementAdder::add_if_whole(const ElementRowIds& row, const RowShape& shape) {
    const ElementRow& element = element_row(shape.type);
    if (shape.nodes != row.nodes.size() || shape.nodes != element.node_count) return false;
    const auto found = std::span(found_).first(shape.nodes);
    if (!builder_.nodes().find(row.nodes, found.data())) return false;
    if (element.dimension >= 2 && !all_differ(found.first(element.corner_count))) return false;
    const ElementId id{row.id};
    builder_.add_whole_elements(shape.type, part_of(row.material), std::span(&id, 1), found);
    return true;
}

void ElementAdder::add_taken(const Input& input, const TakenElements& taken) {
    constexpr std::size_t kAtOnce = 1024;
    const std::size_t width = taken.run->nodes_each, count = taken.ids.size();
    const auto shape = shape_of(type_of(taken.run->type), width);
    const ElementRow* element = shape ? &element_row(shape->type) : nullptr;
    const bool is_plain = shape && shape->nodes == width && element->node_count == width;
    for (std::size_t first = 0; first < count; first += kAtOnce) {
        const std::size_t some = std::min(kAtOnce, count - first);
        const auto nodes = taken.nodes.subspan(first * width, some * width);
        taken_nodes_.resize(nodes.size());
        bool is_whole = is_plain && builder_.nodes().find(nodes, taken_nodes_.data());
        if (is_whole && element->dimension >= 2)
            is_whole = all_differ_in_rows(taken_nodes_, width, element->corner_count);
        if (is_whole) {
            const auto ids = taken.ids.subspan(first, some);
            add_whole(input, shape->type, taken.run->material, ids, taken_nodes_, [&](std::size_t i) {
                return taken.offset(first + i);
            });
        } else {
            const TakenElements rows{taken.run, taken.ids.subspan(first, some), nodes};
            for_each_taken(rows, [&](ElementRowIds row) {
                row.offset += taken.offset(first) - taken.run->begin;
                add(input, row);
            });
        }
    }
}

bool ElementAdder::take_over(List& list) {
    const auto is_taken = [](const RowRun& run) { return run.taken > 0; };
    const auto end = std::ranges::find_if_not(list.runs, is_taken);
    const auto runs = static_cast<std::size_t>(end - list.runs.begin());
    if (runs == 0 || !seen_.empty() || std::any_of(end, list.runs.end(), is_taken)) return false;
    const auto type = type_of_all(list, runs);
    std::vector<ElementId>& ids = list.taken.element_ids;
    if (!type || std::ranges::adjacent_find(ids, std::ranges::greater_equal{}) != ids.end() ||
        !find_in_place(list.taken.element_nodes, element_row(*type)))
        return false;
    seen_.insert_first(ids);
    std::vector<PartIndex> parts;
    reserve_big(parts, ids.size());
    for (std::size_t r = 0; r < runs; ++r)
        parts.insert(parts.end(), list.runs[r].taken, part_of(list.runs[r].material));
    builder_.add_whole_elements(*type, std::move(parts), std::move(ids), std::move(list.taken.element_nodes));
    list.in_mesh = runs;
    return true;
}

/// Of the first runs of a list, which have nothing left out. Nothing when they are not all of one.
std::optional<ElementType> ElementAdder::type_of_all(const List& list, std::size_t runs) {
    const RowRun& first = list.runs.front();
    const auto shape = shape_of(type_of(first.type), first.nodes_each);
    if (!shape || shape->nodes != first.nodes_each || element_row(shape->type).node_count != shape->nodes)
        return std::nullopt;
    const bool is_one = std::ranges::all_of(std::span(list.runs).first(runs), [&](const RowRun& run) {
        return run.type == first.type && run.nodes_each == first.nodes_each;
    });
    return is_one ? std::optional(shape->type) : std::nullopt;
}

/// Indices in the place of ids, when all nodes are there and no corners repeat. False: ids are there still.
bool ElementAdder::find_in_place(std::span<NodeIndex> nodes, const ElementRow& element) {
    const std::size_t width = element.node_count, at_once = 512 * width;
    for (std::size_t first = 0; first < nodes.size(); first += at_once) {
        const auto some = nodes.subspan(first, std::min(at_once, nodes.size() - first));
        taken_nodes_.resize(some.size());
        if (!builder_.nodes().find(std::span<const NodeIndex>(some), taken_nodes_.data()) ||
            (element.dimension >= 2 && !all_differ_in_rows(taken_nodes_, width, element.corner_count))) {
            for (NodeIndex& node : nodes.first(first))
                node = NodeIndex{static_cast<std::uint32_t>(raw(builder_.nodes().id(node)))};
            return false;
        }
        std::ranges::copy(taken_nodes_, some.begin());
    }
    return true;
}

void ElementAdder::add_named(
    const Input& input,
    std::int64_t id,
    std::string_view name,
    std::span<const std::int64_t> nodes,
    std::size_t offset
) {
    if (!seen_.insert(id)) return;  // By another list of values.
    TypeShape type;
    type.name = name;
    type.element = find_element(name);
    const auto where = [&] { return input.where_line(offset); };
    const auto shape = shape_of(type, nodes.size());
    if (!shape) {
        ElementRowIds row;
        row.nodes = nodes;
        leave_out(row, type, where);
        return;
    }
    for (std::size_t i = 0; i < shape->nodes; ++i) nodes_[i] = NodeId{nodes[i]};
    builder_.add_element(
        ElementId{id}, shape->type, std::span(nodes_).first(shape->nodes), builder_.part("elements"), where
    );
}

const TypeShape& ElementAdder::type_of(std::int64_t number) {
    static const TypeShape kNotNamed;
    if (number != last_type_ || type_ == nullptr) {
        last_type_ = number;
        const TypeShape* const named = find_type(number);
        type_ = named != nullptr ? named : &kNotNamed;
    }
    return *type_;
}

const TypeShape* ElementAdder::find_type(std::int64_t number) const {
    if (number < 0 || number > std::numeric_limits<std::int32_t>::max()) return nullptr;
    const auto found = types_.find(static_cast<int>(number));
    return found == types_.end() ? nullptr : &found->second;
}

void ElementAdder::note_duplicate(const Input& input, std::size_t offset) {
    diagnostics_.add(
        Code::DuplicateElement,
        [&] { return input.where_line(offset); },
        "elements are listed more than once; the first counts"
    );
}

PartIndex ElementAdder::part_of(std::int64_t material) {
    if (!has_part_ || material != last_material_) {
        last_material_ = material;
        has_part_ = true;
        part_ = builder_.part(part_name(material, body_));
    }
    return part_;
}

void ElementAdder::leave_out(
    const ElementRowIds& row, const TypeShape& type, const MeshBuilder::Where& where
) {
    const std::string name = type.name.empty() ? fmt::format("type {}", row.type) : type.name;
    builder_.skip_element(name);
    const bool has_no_surface = type.element && !is_drawn(type.element->kind);
    if (has_no_surface && type.element->kind != ElementKind::Revolved) return;
    const std::string why = type.name.empty()
                                ? fmt::format("nothing names their type; --types {}=NAME does", row.type)
                            : !type.element  ? "Feelem does not know this type"
                            : has_no_surface ? "solids of revolution are not drawn"
                                             : fmt::format("{} nodes make no such element", row.nodes.size());
    diagnostics_.add(Code::UnknownElementType, where, fmt::format("{} elements are left out: {}", name, why));
}

/// Beams list a node more, that of their orientation. A solid or a shell that does is of another type.
void ElementAdder::warn_of_extra_nodes(
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

}  // namespace feelem::ansys
