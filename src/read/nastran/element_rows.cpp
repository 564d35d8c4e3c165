// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/element_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace feelem::op2 {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// Words of xx yy zz xy yz zx after the point's grid: of one part, and of the other.
constexpr std::array<std::array<std::size_t, 6>, 2> kComplexColumns{
    {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}}};
/// Words of a ply's row: stresses along and between fibres, the equivalent one, the principal ones.
constexpr std::array<std::size_t, 8> kPlyColumns{2, 3, 4, 5, 6, 10, 8, 9};
/// Words of the equivalent stress, plastic and creep strain after a point's grid, or a fibre's distance.
constexpr std::array<std::size_t, 3> kSolidState{7, 8, 9};
constexpr std::array<std::size_t, 3> kShellState{5, 6, 7};
/// Points C, D, E and F of a bar's section.
constexpr std::size_t kSectionPoints = 4;
/// Words of the equivalent value and the larger and smaller principal one after the fibre's distance.
constexpr std::array<std::size_t, 3> kShellColumns{7, 5, 6};

}  // namespace

void report_values(
    const ElementValues& values, const std::string& table, const std::string& where, Diagnostics& diagnostics
) {
    const auto add = [&](Code code, const char* what, std::uint64_t count) {
        if (count > 0) diagnostics.add(code, where, fmt::format("{} {}", table, what), count);
    };
    add(Code::ResultWithoutNode,
        "lists elements or corners that the mesh does not have",
        values.without_element);
    add(Code::CoordinateSystem,
        "has solids whose tensor is in a system of its own: only its invariant is used",
        values.other_system);
    add(Code::NonFiniteValue,
        "has values that are no finite numbers; they count as missing",
        values.without_number);
}

ElementRowReader::ElementRowReader(const ElementResult& result, const Mesh& mesh, const ElementLookup& lookup)
    : result_(result), mesh_(mesh), lookup_(lookup), nodes_(mesh.node_ids) {
    if (is_by_element(result_.quantity)) values_.values.assign(mesh.element_count() * width(), kNoValue);
}

void ElementRowReader::read(std::int64_t id, const Words& row, const ElementLayout& layout) {
    const ElementIndex element = lookup_(ElementId{id});
    if (element == kNoElement) {
        ++values_.without_element;
        return;
    }
    switch (layout.shape) {
    case RowShape::SolidComplex:
    case RowShape::Solid: read_solid(row, layout, element); break;
    case RowShape::ShellCorner: read_shell(row, layout, element); break;
    case RowShape::ShellCentre: read_centre(row, element); break;
    case RowShape::Ply:
        if (row.integer(1) == result_.ply)
            put(row, kPlyColumns, values_.values.data() + raw(element) * width());
        break;
    case RowShape::NonlinearSolid: read_nonlinear_solid(row, layout, element); break;
    case RowShape::NonlinearShell:
        put(fibre_of(row.part(1, 2 * layout.point_words)),
            kShellState,
            values_.values.data() + raw(element) * width());
        break;
    case RowShape::ShellComplex: read_complex_shell(row, layout, element); break;
    case RowShape::BarEnds: read_ends(row, layout, element); break;
    case RowShape::BarPoints:
    case RowShape::BeamPoints: read_points(row, layout, element); break;
    case RowShape::Bar:
    case RowShape::BarComplex:
        put(row,
            std::array{result_.part == 0 ? layout.corners : layout.point_words},
            values_.values.data() + raw(element));
        break;
    }
}

ElementValues ElementRowReader::finish() {
    if (!is_by_element(result_.quantity)) sort_rows();
    return std::move(values_);
}

std::size_t ElementRowReader::width() const {
    switch (result_.quantity) {
    case Quantity::SolidCorner: return kSolidColumns.size();
    case Quantity::SolidComplex: return kComplexColumns[0].size();
    case Quantity::Axial:
    case Quantity::AxialComplex: return 1;
    case Quantity::BarEnds: return 2;
    case Quantity::BarPoints:
    case Quantity::BeamPoints: return kSectionPoints;
    case Quantity::Ply: return kPlyColumns.size();
    default: return kShellColumns.size();
    }
}

template <std::size_t count>
void ElementRowReader::put(const Words& words, const std::array<std::size_t, count>& columns, float* out) {
    for (std::size_t c = 0; c < count; ++c) {
        const auto value = static_cast<float>(words.real(columns[c]));
        out[c] = std::isfinite(value) ? value : kNoValue;
        if (!std::isfinite(value)) ++values_.without_number;
    }
}

float* ElementRowReader::add_row(ElementIndex element, NodeIndex node) {
    values_.row_owner.push_back(raw(element));
    values_.row_node.push_back(node);
    values_.values.resize(values_.values.size() + width(), kNoValue);
    return values_.values.data() + values_.values.size() - width();
}

/// The node of a corner; kNoNode when the mesh or the element does not have it.
NodeIndex ElementRowReader::corner(std::int64_t grid, ElementIndex element) {
    const NodeIndex node = nodes_(NodeId{grid});
    const auto nodes = element_at(mesh_, element).nodes();
    if (node != kNoNode && std::ranges::find(nodes, node) != nodes.end()) return node;
    ++values_.without_element;
    return kNoNode;
}

void ElementRowReader::read_solid(const Words& row, const ElementLayout& layout, ElementIndex element) {
    const bool is_basic = row.integer(1) == 0;
    if (!is_basic) ++values_.other_system;
    for (std::size_t i = 1; i <= layout.corners; ++i) {
        const Words point = row.part(kSolidHead + i * layout.point_words, layout.point_words);
        if (point.integer(0) == 0) continue;
        const NodeIndex node = corner(point.integer(0), element);
        if (node == kNoNode) continue;
        float* out = add_row(element, node);
        if (layout.shape == RowShape::Solid) {
            put(point, kSolidColumns, out);
        } else {
            put(point, kComplexColumns[result_.part == 0 ? 0 : 1], out);
        }
        if (!is_basic) std::fill(out, out + 6, kNoValue);
    }
}

/// The fibre with the smaller distance is the lower one, wherever it stands.
Words ElementRowReader::fibre_of(const Words& fibres) const {
    const std::size_t words = fibres.count() / 2;
    const Words first = fibres.part(0, words);
    const Words second = fibres.part(words, words);
    const bool swapped = !result_.kind.curvature && second.real(0) < first.real(0);
    return (result_.fibre == 0) != swapped ? first : second;
}

void ElementRowReader::read_shell(const Words& row, const ElementLayout& layout, ElementIndex element) {
    for (std::size_t i = 1; i <= layout.corners; ++i) {
        const Words point = row.part(kShellHead + i * kShellPoint, kShellPoint);
        if (point.integer(0) == 0) continue;
        const NodeIndex node = corner(point.integer(0), element);
        if (node != kNoNode)
            put(fibre_of(point.part(1, 2 * kFibreWords)), kShellColumns, add_row(element, node));
    }
}

/// Beside shells with corners, those without have the same values at each of theirs.
void ElementRowReader::read_centre(const Words& row, ElementIndex element) {
    const Words fibre = fibre_of(row.part(1, 2 * kFibreWords));
    if (is_by_element(result_.quantity)) {
        put(fibre, kShellColumns, values_.values.data() + raw(element) * width());
        return;
    }
    const ElementRef found = element_at(mesh_, element);
    const std::size_t corners = element_row(found.block->type).corner_count;
    for (const NodeIndex node : found.nodes().first(corners))
        put(fibre, kShellColumns, add_row(element, node));
}

void ElementRowReader::read_ends(const Words& row, const ElementLayout& layout, ElementIndex element) {
    constexpr std::array<std::array<std::size_t, 2>, 2> kBarColumns{{{6, 7}, {13, 14}}};
    constexpr std::array<std::size_t, 2> kBeamColumns{6, 7};
    for (std::size_t i = 0; i < layout.corners; ++i) {
        if (layout.point_words == 0) {
            const auto nodes = element_at(mesh_, element).nodes();
            if (i < nodes.size()) put(row, kBarColumns[i], add_row(element, nodes[i]));
            continue;
        }
        const Words station = row.part(1 + i * kBeamStation, kBeamStation);
        if (station.integer(0) == 0) continue;
        const NodeIndex node = corner(station.integer(0), element);
        if (node != kNoNode) put(station, kBeamColumns, add_row(element, node));
    }
}

/// The centre alone: averages of corners in different elements' systems would mean nothing.
void ElementRowReader::read_complex_shell(
    const Words& row, const ElementLayout& layout, ElementIndex element
) {
    const std::size_t first = layout.corners == 0 ? 1 : kShellHead + 1;
    const Words fibre = fibre_of(row.part(first, 2 * layout.point_words));
    const std::size_t part = result_.part == 0 ? 1 : 2;
    put(fibre, std::array{part, part + 2, part + 4}, values_.values.data() + raw(element) * width());
}

/// Four points of the section, one part behind the other.
void ElementRowReader::read_points(const Words& row, const ElementLayout& layout, ElementIndex element) {
    const auto columns = [&](std::size_t first) {
        return std::array{first, first + 1, first + 2, first + 3};
    };
    const bool is_beam = layout.shape == RowShape::BeamPoints;
    const std::size_t part = result_.part == 0 ? 0 : (is_beam ? kSectionPoints : kSectionPoints + 1);
    const auto nodes = element_at(mesh_, element).nodes();
    for (std::size_t i = 0; i < layout.corners; ++i) {
        if (is_beam) {
            const Words station = row.part(1 + i * kBeamStation, kBeamStation);
            if (station.integer(0) == 0) continue;
            const NodeIndex node = corner(station.integer(0), element);
            if (node != kNoNode) put(station, columns(2 + part), add_row(element, node));
        } else if (i < nodes.size()) {
            // End A has the axial stress behind each part, end B has not.
            put(row,
                i == 0 ? columns(1 + part) : columns(11 + (part == 0 ? 0 : kSectionPoints)),
                add_row(element, nodes[i]));
        }
    }
}

void ElementRowReader::read_nonlinear_solid(
    const Words& row, const ElementLayout& layout, ElementIndex element
) {
    for (std::size_t i = 1; i <= layout.corners; ++i) {
        const Words point = row.part(kNonlinearHead + i * layout.point_words, layout.point_words);
        if (point.integer(0) == 0) continue;
        const NodeIndex node = corner(point.integer(0), element);
        if (node != kNoNode) put(point, kSolidState, add_row(element, node));
    }
}

void ElementRowReader::sort_rows() {
    const auto key = [&](std::size_t row) {
        return std::pair(values_.row_owner[row], values_.row_node[row]);
    };
    std::vector<std::size_t> order(values_.row_owner.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, key);
    ElementValues sorted = values_;
    for (std::size_t i = 0; i < order.size(); ++i) {
        sorted.row_owner[i] = values_.row_owner[order[i]];
        sorted.row_node[i] = values_.row_node[order[i]];
        std::copy_n(values_.values.data() + order[i] * width(), width(), sorted.values.data() + i * width());
    }
    values_ = std::move(sorted);
}

}  // namespace feelem::op2
