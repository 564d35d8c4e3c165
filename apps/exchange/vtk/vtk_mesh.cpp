// SPDX-License-Identifier: Apache-2.0
#include "vtk/vtk_mesh.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

namespace feelem::exchange {
namespace {

/// Feelem's node i is VTK's node order[i]. The wedge border of the project: see src/write/vtu.cpp for the way
/// out.
constexpr std::array<std::uint8_t, 6> kWedge6{0, 2, 1, 3, 5, 4};
constexpr std::array<std::uint8_t, 15> kWedge15{0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13};
constexpr std::array<std::uint8_t, 18> kWedge18{0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13, 17, 16, 15};
constexpr std::array<std::uint8_t, 8> kVoxel{0, 1, 3, 2, 4, 5, 7, 6};
constexpr std::array<std::uint8_t, 4> kPixel{0, 1, 3, 2};

struct Shape {
    ElementType type;
    std::span<const std::uint8_t> order;  ///< Empty: in order.
};

std::optional<Shape> shape_of(int vtk, vtkIdType points, bool turns_wedges) {
    if (vtk == VTK_VOXEL) return Shape{ElementType::Hex8, kVoxel};
    if (vtk == VTK_PIXEL) return Shape{ElementType::Quad4, kPixel};
    if (vtk == VTK_POLYGON && points == 3) return Shape{ElementType::Tri3, {}};
    if (vtk == VTK_POLYGON && points == 4) return Shape{ElementType::Quad4, {}};
    if (vtk == VTK_POLY_LINE && points == 2) return Shape{ElementType::Line2, {}};
    if (vtk == VTK_POLY_VERTEX && points == 1) return Shape{ElementType::Point1, {}};
    for (std::size_t i = 0; i < kElementTypeCount; ++i) {
        const ElementRow& row = element_row(static_cast<ElementType>(i));
        if (row.vtk_type != vtk || row.node_count != points) continue;
        if (turns_wedges && row.type == ElementType::Wedge6) return Shape{row.type, kWedge6};
        if (turns_wedges && row.type == ElementType::Wedge15) return Shape{row.type, kWedge15};
        if (turns_wedges && row.type == ElementType::Wedge18) return Shape{row.type, kWedge18};
        return Shape{row.type, {}};
    }
    return {};
}

/// Ids of all leaves, or nothing when a leaf has none, or they are no ids.
std::optional<std::vector<std::vector<std::int64_t>>> ids_of(
    const std::vector<Leaf>& leaves, bool points, std::span<const std::string_view> names
) {
    std::vector<std::vector<std::int64_t>> all;
    for (const Leaf& leaf : leaves) {
        vtkDataSetAttributes* const data =
            points ? static_cast<vtkDataSetAttributes*>(leaf.data->GetPointData()) : leaf.data->GetCellData();
        vtkDataArray* array = nullptr;
        for (const std::string_view name : names) {
            if (array == nullptr) array = data->GetArray(std::string(name).c_str());
        }
        const vtkIdType count = points ? leaf.data->GetNumberOfPoints() : leaf.data->GetNumberOfCells();
        if (array == nullptr || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
            return {};
        std::vector<std::int64_t>& ids = all.emplace_back();
        for (vtkIdType i = 0; i < count; ++i) {
            const double value = array->GetComponent(i, 0);
            if (!(value >= 1 && value < 9e15)) return {};
            ids.push_back(static_cast<std::int64_t>(value));
        }
    }
    return all;
}

constexpr std::array<std::string_view, 4> kNodeIds{
    "GlobalNodeId", "GlobalNodeID", "NodeId", "PedigreeNodeId"};
// UserIds: LS-DYNA's.
constexpr std::array<std::string_view, 5> kElementIds{
    "GlobalElementId", "GlobalElementID", "ElementId", "PedigreeElementId", "UserIds"};

using Point = std::array<double, 3>;

struct Nodes {
    std::vector<std::vector<std::uint32_t>> node_of;
    std::vector<std::int64_t> ids;
    std::vector<Point> points;
};

/// Points with the same id are one node. Nothing when such points lie apart: then each block or piece counts
/// its own points.
std::optional<Nodes> nodes_by_id(
    const std::vector<Leaf>& leaves, const std::vector<std::vector<std::int64_t>>& ids
) {
    Nodes nodes;
    std::unordered_map<std::int64_t, std::uint32_t> known;
    for (std::size_t l = 0; l < leaves.size(); ++l) {
        std::vector<std::uint32_t>& places = nodes.node_of.emplace_back();
        for (std::size_t i = 0; i < ids[l].size(); ++i) {
            Point point;
            leaves[l].data->GetPoint(static_cast<vtkIdType>(i), point.data());
            const auto next = static_cast<std::uint32_t>(nodes.ids.size());
            const auto [at, is_new] = known.try_emplace(ids[l][i], next);
            places.push_back(at->second);
            if (is_new) {
                nodes.ids.push_back(ids[l][i]);
                nodes.points.push_back(point);
            } else if (std::memcmp(&nodes.points[at->second], &point, sizeof point) != 0) {
                return {};
            }
        }
    }
    return nodes;
}

Nodes nodes_in_order(const std::vector<Leaf>& leaves) {
    Nodes nodes;
    for (const Leaf& leaf : leaves) {
        std::vector<std::uint32_t>& places = nodes.node_of.emplace_back();
        for (vtkIdType i = 0; i < leaf.data->GetNumberOfPoints(); ++i) {
            leaf.data->GetPoint(i, nodes.points.emplace_back().data());
            places.push_back(static_cast<std::uint32_t>(nodes.ids.size()));
            nodes.ids.push_back(static_cast<std::int64_t>(nodes.ids.size()) + 1);
        }
    }
    return nodes;
}

void merge_nodes(const std::vector<Leaf>& leaves, Merged& merged, NeutralModel& model) {
    const auto ids = ids_of(leaves, true, kNodeIds);
    std::optional<Nodes> nodes = ids ? nodes_by_id(leaves, *ids) : std::nullopt;
    merged.has_node_ids = nodes.has_value();
    if (!nodes) nodes = nodes_in_order(leaves);
    merged.node_of = std::move(nodes->node_of);
    model.node_ids = std::move(nodes->ids);
    for (const Point& point : nodes->points)
        model.coordinates.insert(model.coordinates.end(), point.begin(), point.end());
}

/// Whether most wedges have the triangle 0 1 2 facing away from 3 4 5.
bool are_wedges_turned(vtkDataSet* data) {
    vtkNew<vtkIdList> points;
    std::ptrdiff_t balance = 0;
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
        const int type = data->GetCellType(c);
        if (type != VTK_WEDGE && type != VTK_QUADRATIC_WEDGE && type != VTK_BIQUADRATIC_QUADRATIC_WEDGE)
            continue;
        data->GetCellPoints(c, points);
        double at[4][3];
        for (vtkIdType i = 0; i < 4; ++i) data->GetPoint(points->GetId(i), at[i]);
        double a[3], b[3], d[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = at[1][k] - at[0][k];
            b[k] = at[2][k] - at[0][k];
            d[k] = at[3][k] - at[0][k];
        }
        const double towards = d[0] * (a[1] * b[2] - a[2] * b[1]) + d[1] * (a[2] * b[0] - a[0] * b[2]) +
                               d[2] * (a[0] * b[1] - a[1] * b[0]);
        balance += towards < 0 ? 1 : towards > 0 ? -1 : 0;
    }
    return balance > 0;
}

std::string part_name(const std::string& leaf, std::size_t index, std::size_t count) {
    if (!leaf.empty()) return leaf;
    return count == 1 ? "mesh" : fmt::format("block {}", index + 1);
}

/// What a cell that is left out is called: VTK's word for its type.
std::string kind_of_cell(int type, vtkIdType points) {
    if (type == VTK_EMPTY_CELL) return fmt::format("cell that VTK does not know, of {} points,", points);
    const char* const name = vtkCellTypes::GetClassNameFromTypeId(type);
    const bool any_number = type == VTK_POLYHEDRON || type == VTK_POLYGON || type == VTK_TRIANGLE_STRIP ||
                            type == VTK_POLY_LINE || type == VTK_POLY_VERTEX;
    if (any_number && name != nullptr) return name;
    return fmt::format("{} of {} points", name != nullptr ? name : "cell", points);
}

}  // namespace

bool is_id_array(std::string_view name) {
    constexpr std::string_view kOthers[]{
        "ObjectId", "vtkGhostType", "UserID", "GlobalIds", "Part", "PedigreeIds"};
    return std::ranges::find(kNodeIds, name) != kNodeIds.end() ||
           std::ranges::find(kElementIds, name) != kElementIds.end() ||
           std::ranges::find(kOthers, name) != std::end(kOthers);
}

namespace {

/// The file's ids of cells, each once, or nothing.
std::optional<std::vector<std::vector<std::int64_t>>> element_ids_of(const std::vector<Leaf>& leaves) {
    auto ids = ids_of(leaves, false, kElementIds);
    if (!ids) return {};
    std::unordered_set<std::int64_t> seen;
    for (const auto& leaf : *ids) {
        for (const std::int64_t id : leaf) {
            if (!seen.insert(id).second) return {};
        }
    }
    return ids;
}

bool is_ghost(vtkDataSet* data, vtkIdType cell) {
    vtkUnsignedCharArray* const ghosts = data->GetCellGhostArray();
    return ghosts != nullptr && cell < ghosts->GetNumberOfTuples() && ghosts->GetValue(cell) != 0;
}

void append_nodes(
    vtkIdList* points, const Shape& shape, const std::vector<std::uint32_t>& node_of, NeutralModel& model
) {
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i) {
        const vtkIdType from =
            points->GetId(shape.order.empty() ? i : shape.order[static_cast<std::size_t>(i)]);
        if (from < 0 || static_cast<std::size_t>(from) >= node_of.size())
            throw std::runtime_error("a cell names a point that the file does not have");
        model.element_nodes.push_back(node_of[static_cast<std::size_t>(from)]);
    }
}

}  // namespace

Merged merge(const std::vector<Leaf>& leaves, bool own_format, NeutralModel& model) {
    Merged merged;
    merge_nodes(leaves, merged, model);
    const auto ids = element_ids_of(leaves);
    merged.has_element_ids = ids.has_value();
    std::map<std::string, std::uint64_t> skipped;
    vtkNew<vtkIdList> points;
    std::int64_t cell_number = 0;
    for (std::size_t l = 0; l < leaves.size(); ++l) {
        vtkDataSet* const data = leaves[l].data;
        std::vector<std::uint32_t>& places = merged.element_of.emplace_back();
        const bool turns_wedges = own_format || are_wedges_turned(data);
        model.parts.push_back(part_name(leaves[l].name, l, leaves.size()));
        for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
            ++cell_number;
            data->GetCellPoints(c, points);
            const int type = data->GetCellType(c);
            const vtkIdType count = points->GetNumberOfIds();
            const bool ghost = is_ghost(data, c);
            const auto shape = ghost ? std::nullopt : shape_of(type, count, turns_wedges);
            if (!shape) {
                if (!ghost) ++skipped[kind_of_cell(type, count)];
                places.push_back(kNowhere);
                continue;
            }
            places.push_back(static_cast<std::uint32_t>(model.types.size()));
            model.types.push_back(shape->type);
            model.element_parts.push_back(static_cast<std::uint32_t>(l));
            model.element_ids.push_back(ids ? (*ids)[l][static_cast<std::size_t>(c)] : cell_number);
            append_nodes(points, *shape, merged.node_of[l], model);
        }
    }
    merged.nodes = model.node_ids.size();
    merged.elements = model.types.size();
    model.skipped.assign(skipped.begin(), skipped.end());
    return merged;
}

}  // namespace feelem::exchange
