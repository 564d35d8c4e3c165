// SPDX-License-Identifier: Apache-2.0
// Must: give VTK the whole mesh and every value of the results, bit for bit.
// Assumes: a little-endian machine (checked below).
// Algorithm: the arrays are listed first, so that the XML head knows each one's offset; then each is written
// behind the head as raw bytes after its UInt64 length.
// Where Feelem and VTK differ: wedges are turned (triangle 0 1 2 points out in VTK); an element that leaves
// out mid-side nodes is written by its corners, as VTK has no quadratic cell with gaps; values of a node that
// belongs to several parts are one array a part; unaveraged values are cell arrays with one group of
// components a node of the element. Missing values are NaN.
#include "write/sink.hpp"

#include "feelem/write.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace feelem {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

constexpr std::array<std::uint8_t, 6> kVtkWedge6{0, 2, 1, 3, 5, 4};
constexpr std::array<std::uint8_t, 15> kVtkWedge15{0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13};
constexpr std::array<std::uint8_t, 18> kVtkWedge18{
    0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13, 17, 16, 15};

/// VTK's node i is Feelem's node order[i]; empty: the same.
std::span<const std::uint8_t> vtk_order(ElementType type) {
    switch (type) {
    case ElementType::Wedge6: return kVtkWedge6;
    case ElementType::Wedge15: return kVtkWedge15;
    case ElementType::Wedge18: return kVtkWedge18;
    default: return {};
    }
}

/// One cell: its type and its nodes in VTK's order.
struct Cell {
    ElementType type = ElementType::Point1;
    std::size_t count = 0;
    std::array<NodeIndex, kMaxElementNodes> nodes{};
};

Cell cell_of(const ElementBlock& block, std::size_t position) {
    const ElementRow* row = &element_row(block.type);
    const auto nodes = std::span(block.nodes).subspan(position * row->node_count, row->node_count);
    if (std::ranges::find(nodes, kNoNode) != nodes.end()) row = &element_row(row->linear);
    Cell cell{row->type, row->node_count, {}};
    const auto order = vtk_order(row->type);
    for (std::size_t i = 0; i < cell.count; ++i) cell.nodes[i] = nodes[order.empty() ? i : order[i]];
    return cell;
}

template <class Call>
void for_each_cell(const Mesh& mesh, const Call& call) {
    for (const ElementBlock& block : mesh.blocks) {
        for (std::size_t i = 0; i < block.ids.size(); ++i) call(block, i);
    }
}

/// Text inside an XML attribute.
std::string escaped_for_xml(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += c >= ' ' && c < '\x7f' ? c : '_';
        }
    }
    return out;
}

struct VtuArray {
    std::string name;
    const char* type = "Float32";
    std::vector<std::string> components;  ///< Empty: one without a name.
    std::uint64_t width = 1;              ///< Numbers a point or cell.
    std::uint64_t bytes = 0;
    std::function<void(Sink&)> write;
};

template <class T>
VtuArray array_of(
    std::string name,
    const char* type,
    std::uint64_t width,
    std::uint64_t count,
    std::function<void(Sink&)> write
) {
    return {std::move(name), type, {}, width, count * width * sizeof(T), std::move(write)};
}

std::string array_name(const ResultInfo& info) {
    std::string name = info.name;
    if (info.layer != Layer::No) name += "_" + std::string(word(info.layer));
    if (info.complex != Complex::No) name += "_" + std::string(word(info.complex));
    return name;
}

/// Point and cell arrays of the results.
class ResultArrays {
public:
    explicit ResultArrays(const Mesh& mesh) : mesh_(mesh) {}

    void add(const Result& result) {
        switch (result.info.location) {
        case Location::Nodal: add_rows(points, result, array_name(result.info)); break;
        case Location::Elemental: add_rows(cells, result, array_name(result.info)); break;
        case Location::PartNodal: add_part_nodal(result); break;
        case Location::ElementNodal: add_element_nodal(result); break;
        }
    }

    std::vector<VtuArray> points;
    std::vector<VtuArray> cells;

private:
    std::string unique(const std::string& wanted) {
        std::string name = wanted;
        for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
        return name;
    }

    void add_rows(std::vector<VtuArray>& to, const Result& result, const std::string& name) {
        const std::vector<float>& values = result.values;
        VtuArray array = array_of<float>(
            unique(name),
            "Float32",
            result.component_count(),
            result.row_count(),
            [&values](Sink& out) {
                for (const float value : values) out.raw(value);
            }
        );
        if (result.component_count() > 1) array.components = result.info.components;
        to.push_back(std::move(array));
    }

    /// Values scattered to `count` places; the rest NaN.
    void add_scattered(
        std::vector<VtuArray>& to,
        std::string name,
        std::vector<std::string> components,
        std::size_t width,
        std::vector<float> values
    ) {
        const std::size_t count = values.size() / width;
        VtuArray array =
            array_of<float>(unique(name), "Float32", width, count, [values = std::move(values)](Sink& out) {
                for (const float value : values) out.raw(value);
            });
        if (width > 1) array.components = std::move(components);
        to.push_back(std::move(array));
    }

    bool has_shared_nodes(const Result& result) const {
        std::vector<bool> seen(mesh_.node_count());
        for (const NodeIndex node : result.row_node) {
            if (seen[raw(node)]) return true;
            seen[raw(node)] = true;
        }
        return false;
    }

    void add_part_nodal(const Result& result) {
        const std::size_t width = result.component_count();
        const bool shared = has_shared_nodes(result);
        std::size_t row = 0;
        do {
            std::vector<float> values(mesh_.node_count() * width, std::numeric_limits<float>::quiet_NaN());
            const std::size_t first = row;
            for (; row < result.row_count(); ++row) {
                if (shared && result.row_owner[row] != result.row_owner[first]) break;
                const std::size_t node = raw(result.row_node[row]);
                std::copy_n(&result.values[row * width], width, &values[node * width]);
            }
            std::string name = array_name(result.info);
            if (shared) name += "@" + mesh_.parts[result.row_owner[first]].name;
            add_scattered(points, std::move(name), result.info.components, width, std::move(values));
        } while (row < result.row_count());
    }

    void add_element_nodal(const Result& result) {
        std::size_t most = 1;
        for (const ElementBlock& block : mesh_.blocks)
            most = std::max<std::size_t>(most, element_row(block.type).node_count);
        const std::size_t width = result.component_count();
        std::vector<float> values(
            mesh_.element_count() * most * width, std::numeric_limits<float>::quiet_NaN()
        );
        for (std::size_t row = 0; row < result.row_count(); ++row) {
            const std::size_t element = result.row_owner[row];
            const ElementRef at = element_at(mesh_, ElementIndex{static_cast<std::uint32_t>(element)});
            const Cell cell = cell_of(*at.block, at.position);
            const auto nodes = std::span(cell.nodes).first(cell.count);
            const auto place = std::ranges::find(nodes, result.row_node[row]);
            if (place == nodes.end()) continue;
            const std::size_t slot = element * most + static_cast<std::size_t>(place - nodes.begin());
            std::copy_n(&result.values[row * width], width, &values[slot * width]);
        }
        std::vector<std::string> components;
        for (std::size_t n = 0; n < most; ++n) {
            for (const std::string& component : result.info.components)
                components.push_back(fmt::format("node {} {}", n + 1, component));
        }
        add_scattered(
            cells,
            array_name(result.info) + "_at_nodes",
            std::move(components),
            most * width,
            std::move(values)
        );
    }

    const Mesh& mesh_;
    std::set<std::string> names_{"NodeId", "ElementId", "Part"};
};

VtuArray points_array(const Mesh& mesh) {
    return array_of<double>("Points", "Float64", 3, mesh.node_count(), [&mesh](Sink& out) {
        for (const Point3& point : mesh.coordinates) {
            for (const double x : point) out.raw(x);
        }
    });
}

VtuArray node_ids_array(const Mesh& mesh) {
    return array_of<std::int64_t>("NodeId", "Int64", 1, mesh.node_count(), [&mesh](Sink& out) {
        for (const NodeId id : mesh.node_ids) out.raw(raw(id));
    });
}

std::vector<VtuArray> cell_data_arrays(const Mesh& mesh) {
    const std::uint64_t count = mesh.element_count();
    return {
        array_of<std::int64_t>(
            "ElementId",
            "Int64",
            1,
            count,
            [&mesh](Sink& out) {
                for_each_cell(mesh, [&](const ElementBlock& block, std::size_t i) {
                    out.raw(raw(block.ids[i]));
                });
            }
        ),
        array_of<std::int32_t>("Part", "Int32", 1, count, [&mesh](Sink& out) {
            for_each_cell(mesh, [&](const ElementBlock& block, std::size_t i) {
                out.raw(static_cast<std::int32_t>(raw(block.parts[i])));
            });
        })};
}

std::vector<VtuArray> topology_arrays(const Mesh& mesh) {
    const std::uint64_t cells = mesh.element_count();
    std::uint64_t nodes = 0;
    for_each_cell(mesh, [&](const ElementBlock& block, std::size_t i) { nodes += cell_of(block, i).count; });
    return {
        array_of<std::int64_t>(
            "connectivity",
            "Int64",
            1,
            nodes,
            [&mesh](Sink& out) {
                for_each_cell(mesh, [&](const ElementBlock& block, std::size_t i) {
                    const Cell cell = cell_of(block, i);
                    for (std::size_t n = 0; n < cell.count; ++n)
                        out.raw(static_cast<std::int64_t>(raw(cell.nodes[n])));
                });
            }
        ),
        array_of<std::int64_t>(
            "offsets",
            "Int64",
            1,
            cells,
            [&mesh](Sink& out) {
                std::int64_t end = 0;
                for_each_cell(mesh, [&](const ElementBlock& block, std::size_t i) {
                    end += static_cast<std::int64_t>(cell_of(block, i).count);
                    out.raw(end);
                });
            }
        ),
        array_of<std::uint8_t>("types", "UInt8", 1, cells, [&mesh](Sink& out) {
            for_each_cell(mesh, [&](const ElementBlock& block, std::size_t i) {
                out.raw(element_row(cell_of(block, i).type).vtk_type);
            });
        })};
}

/// The XML head of a group of arrays; moves `offset` on.
void write_heads(Sink& out, const char* group, std::span<const VtuArray> arrays, std::uint64_t& offset) {
    out.text("<{}>\n", group);
    for (const VtuArray& array : arrays) {
        out.text("<DataArray type=\"{}\" Name=\"{}\"", array.type, escaped_for_xml(array.name));
        out.text(" NumberOfComponents=\"{}\"", array.width);
        for (std::size_t i = 0; i < array.components.size(); ++i)
            out.text(" ComponentName{}=\"{}\"", i, escaped_for_xml(array.components[i]));
        out.text(" format=\"appended\" offset=\"{}\"/>\n", offset);
        offset += sizeof(std::uint64_t) + array.bytes;
    }
    out.text("</{}>\n", group);
}

/// VTK writes text as the numbers of its letters.
void write_letters(Sink& out, std::string_view text) {
    for (const char c : text) out.text("{} ", static_cast<int>(static_cast<unsigned char>(c)));
    out.text("0\n");
}

void write_text_array_head(Sink& out, const char* name, std::size_t count) {
    out.text("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">\n", name, count);
}

/// What is no array of points or cells: the step, and the names of the parts by the numbers in the array
/// Part.
void write_field_data(Sink& out, const Mesh& mesh, const Step* step) {
    if (step == nullptr && mesh.parts.empty()) return;
    out.text("<FieldData>\n");
    if (step != nullptr) {
        const char* array = "<DataArray type=\"{}\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">";
        out.text(fmt::runtime(array), "Float64", "TimeValue", 1);
        out.text("{}</DataArray>\n", step->value);
        out.text(fmt::runtime(array), "Int32", "StepNumber", 2);
        out.text("{} {}</DataArray>\n", step->step, step->substep);
        write_text_array_head(out, "StepKind", 1);
        write_letters(out, word(step->kind));
        out.text("</Array>\n");
    }
    if (!mesh.parts.empty()) {
        write_text_array_head(out, "PartNames", mesh.parts.size());
        for (const Part& part : mesh.parts) write_letters(out, part.name);
        out.text("</Array>\n");
    }
    out.text("</FieldData>\n");
}

}  // namespace

void write_vtu(const std::string& path, const Mesh& mesh, std::span<const Result> results, const Step* step) {
    ResultArrays data(mesh);
    data.points.push_back(node_ids_array(mesh));
    data.cells = cell_data_arrays(mesh);
    for (const Result& result : results) data.add(result);
    const std::vector<VtuArray> geometry{points_array(mesh)};
    const std::vector<VtuArray> topology = topology_arrays(mesh);

    AtomicFile file(path);
    Sink out(file);
    std::uint64_t offset = 0;
    out.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"");
    out.text(" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n");
    write_field_data(out, mesh, step);
    out.text("<Piece NumberOfPoints=\"{}\"", mesh.node_count());
    out.text(" NumberOfCells=\"{}\">\n", mesh.element_count());
    write_heads(out, "PointData", data.points, offset);
    write_heads(out, "CellData", data.cells, offset);
    write_heads(out, "Points", geometry, offset);
    write_heads(out, "Cells", topology, offset);
    out.text("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    const std::vector<VtuArray>* const groups[]{&data.points, &data.cells, &geometry, &topology};
    for (const std::vector<VtuArray>* group : groups) {
        for (const VtuArray& array : *group) {
            out.raw(array.bytes);
            array.write(out);
        }
    }
    out.text("\n</AppendedData>\n</VTKFile>\n");
    out.flush();
    file.commit();
}

}  // namespace feelem
