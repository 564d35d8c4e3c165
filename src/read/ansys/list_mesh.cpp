// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/list_mesh.hpp"

#include "base/huge_pages.hpp"
#include "model/mesh_builder.hpp"
#include "read/ansys/ansys_units.hpp"
#include "read/ansys/element_adder.hpp"
#include "read/ansys/list_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
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

void add_nodes(const ListFile& file, List& list, Diagnostics& diagnostics, ListedNodes& nodes) {
    const bool all_taken = std::ranges::all_of(list.runs, [](const RowRun& run) { return run.taken > 0; });
    if (all_taken && nodes.ids.empty()) {
        nodes.ids = std::move(list.taken.node_ids);
        nodes.positions = std::move(list.taken.places);
        return;
    }
    const std::size_t expected = nodes.ids.size() + list.rows;
    nodes.ids.reserve(expected);
    nodes.positions.reserve(expected);
    const auto add_taken = [&](std::size_t first, std::size_t count) {
        const auto ids = std::span(list.taken.node_ids).subspan(first, count);
        const auto places = std::span(list.taken.places).subspan(first, count);
        nodes.ids.insert(nodes.ids.end(), ids.begin(), ids.end());
        nodes.positions.insert(nodes.positions.end(), places.begin(), places.end());
        if (!nodes.angles.empty()) nodes.angles.resize(nodes.ids.size());
    };
    const auto add_row = [&](const NodeRow& row) {
        const bool rotated = row.angles[0] != 0 || row.angles[1] != 0 || row.angles[2] != 0;
        if (rotated) nodes.angles.resize(nodes.ids.size());
        if (rotated || !nodes.angles.empty()) nodes.angles.push_back(row.angles);
        nodes.ids.push_back(NodeId{row.id});
        nodes.positions.push_back(row.position);
    };
    for_each_node(file, list, &diagnostics, add_row, add_taken);
}

/// Memory of taken rows becomes the mesh's, or goes back as they turn into elements, so that not all of it is
/// there with the mesh.
void add_elements(const ListFile& file, List& list, Diagnostics& diagnostics, ElementAdder& adder) {
    constexpr std::size_t kAtOnce = std::size_t{1} << 21U;
    adder.take_over(list);
    std::vector<NodeIndex>& nodes = list.taken.element_nodes;
    std::size_t used = 0, dropped = 0;
    const auto add_taken = [&](const TakenElements& taken) {
        adder.add_taken(file.input, taken);
        used += taken.nodes.size();
        if (used - dropped < kAtOnce) return;
        drop_pages(nodes.data() + dropped, (used - dropped) * sizeof nodes.front());
        dropped = used;
    };
    const auto add_row = [&](const ElementRowIds& row) { adder.add(file.input, row); };
    for_each_element(file, list, &diagnostics, add_row, add_taken);
}

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
                        file.input,
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

}  // namespace

ListedNodes collect_nodes(std::span<ListFile> files, Diagnostics& diagnostics) {
    ListedNodes nodes;
    for (ListFile& file : files) {
        for (List& list : file.lists) {
            if (list.kind != ListKind::Nodes) continue;
            check_node_list(file, list, diagnostics);
            nodes.has_angles = nodes.has_angles || list.has_angles;
            add_nodes(file, list, diagnostics, nodes);
            list.taken = {};
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
    std::span<ListFile> files,
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
    if (nodes.angles.empty()) builder.add_nodes(std::move(nodes.ids), std::move(nodes.positions));
    for (std::size_t i = 0; i < nodes.angles.size(); ++i)
        builder.add_node(nodes.ids[i], nodes.positions[i], nodes.angles[i]);
    if (const auto unit = length_unit(nodes.length_unit)) builder.set_length_unit(*unit);
    nodes = {};
    builder.seal_nodes();

    std::size_t elements = 0;
    for (const ListFile& file : files) {
        for (const List& list : file.lists) {
            if (list.kind == ListKind::Elements && list.has_nodes) elements += list.rows;
        }
    }
    builder.expect_elements(elements);
    ElementAdder adder(builder, std::move(types), diagnostics);
    for (ListFile& file : files) {
        for (List& list : file.lists) {
            if (list.kind != ListKind::Elements || !list.has_nodes) continue;
            add_elements(file, list, diagnostics, adder);
            list.taken = {};
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
