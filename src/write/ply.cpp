// SPDX-License-Identifier: Apache-2.0
// The skin as ASCII .ply. Numbers are the shortest that read back to the same bits; missing values are nan.
#include "write/sink.hpp"

#include "feelem/write.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace feelem {
namespace {

/// PLY's names are single words.
std::string property_name(const NamedField& field, const std::string& component) {
    std::string name =
        component == "value" || component == field.name ? field.name : field.name + "_" + component;
    std::ranges::replace_if(
        name, [](char c) { return c <= ' ' || c == '\x7f'; }, '_'
    );
    return name;
}

std::vector<std::string> property_names(std::span<const NamedField> fields) {
    std::vector<std::string> names;
    std::set<std::string> taken{"x", "y", "z", "node_id"};
    for (const NamedField& field : fields) {
        for (const std::string& component : field.components) {
            const std::string wanted = property_name(field, component);
            std::string name = wanted;
            for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
            names.push_back(std::move(name));
        }
    }
    return names;
}

std::int64_t node_id(const Mesh& mesh, NodeIndex node) {
    return node == kNoNode ? 0 : raw(mesh.node_ids[raw(node)]);
}

/// PLY knows integers up to 32 bits; a double holds larger ids exactly (to 2^53).
const char* id_type(std::int64_t smallest, std::int64_t largest) {
    using Limits = std::numeric_limits<std::int32_t>;
    return smallest >= Limits::min() && largest <= Limits::max() ? "int" : "double";
}

const char* node_id_type(const Mesh& mesh) {
    if (mesh.node_ids.empty()) return "int";
    return id_type(raw(mesh.node_ids.front()), raw(mesh.node_ids.back()));
}

const char* element_id_type(const Mesh& mesh) {
    std::int64_t smallest = 0, largest = 0;
    for (const ElementBlock& block : mesh.blocks) {
        for (const ElementId id : block.ids) {
            smallest = std::min(smallest, raw(id));
            largest = std::max(largest, raw(id));
        }
    }
    return id_type(smallest, largest);
}

void write_head(
    Sink& out, const Mesh& mesh, const Surface& surface, std::span<const NamedField> fields, const Step* step
) {
    out.text("ply\nformat ascii 1.0\ncomment Feelem: node_id 0 is a point between nodes\n");
    if (step != nullptr) {  // Not its label, which is the file's and may hold line ends.
        out.text(
            "comment step {}.{}, {}, value {}\n", step->step, step->substep, word(step->kind), step->value
        );
    }
    out.text("element vertex {}\n", surface.positions.size());
    out.text("property double x\nproperty double y\nproperty double z\n");
    for (const std::string& name : property_names(fields)) out.text("property float {}\n", name);
    out.text("property {} node_id\n", node_id_type(mesh));
    out.text("element face {}\n", surface.triangles.size());
    out.text("property list uchar int vertex_indices\nproperty {} element_id\n", element_id_type(mesh));
    out.text("end_header\n");
}

}  // namespace

void write_ply(
    const std::string& path,
    const Mesh& mesh,
    const Surface& surface,
    std::span<const NamedField> fields,
    const Step* step
) {
    AtomicFile file(path);
    Sink out(file);
    write_head(out, mesh, surface, fields, step);
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const Point3& at = surface.positions[v];
        out.text("{} {} {}", at[0], at[1], at[2]);
        for (const NamedField& named : fields) {
            assert(named.components.size() == named.field.component_count);
            const std::size_t width = named.field.component_count;
            for (std::size_t c = 0; c < width; ++c) out.text(" {}", named.field.values[v * width + c]);
        }
        out.text(" {}\n", node_id(mesh, surface.vertex_node[v]));
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& corners = surface.triangles[t];
        const ElementId id = element_at(mesh, surface.triangle_element[t]).id();
        out.text("3 {} {} {} {}\n", raw(corners[0]), raw(corners[1]), raw(corners[2]), raw(id));
    }
    out.flush();
    file.commit();
}

}  // namespace feelem
