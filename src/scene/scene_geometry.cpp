// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_geometry.hpp"

#include "base/behind.hpp"
#include "base/parallel.hpp"
#include "scene/scene_measure.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem {

double Box::diagonal() const {
    return std::sqrt(side(0) * side(0) + side(1) * side(1) + side(2) * side(2));
}

double Box::largest() const {
    return std::max({side(0), side(1), side(2)});
}

namespace {

constexpr std::int64_t kIdModulus = 1 << 24;  ///< float32 holds every integer up to here.

Box box_of(std::span<const Point3> positions) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    for (const Point3& position : positions) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[axis] = std::min(box.low[axis], position[axis]);
            box.high[axis] = std::max(box.high[axis], position[axis]);
        }
    }
    return box;
}

double largest_rounding(std::span<const Point3> positions, const Point3& origin) {
    double most = 0;
    for (const Point3& position : positions) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double exact = position[axis] - origin[axis];
            most = std::max(most, std::abs(exact - static_cast<double>(static_cast<float>(exact))));
        }
    }
    return most;
}

/// What is subtracted: nothing, or the middle when float32 would lose too much.
Point3 origin_for(std::span<const Point3> positions, const Box& box) {
    if (largest_rounding(positions, {}) <= 1e-6 * box.diagonal()) return {};
    return {std::round(box.centre(0)), std::round(box.centre(1)), std::round(box.centre(2))};
}

void choose_origin(SceneBuild& build, Diagnostics& diagnostics) {
    const std::vector<Point3>& positions = build.contents.surface->positions;
    build.box = box_of(positions);
    const double diagonal = build.box.diagonal();
    if (!std::isfinite(diagonal) || std::max(build.box.largest(), diagonal) > 1e30) {
        throw Error(Code::TooLarge, "", "a coordinate is not finite or beyond 1e30. Is the unit right?");
    }
    build.largest_rounding = largest_rounding(positions, build.origin);
    if (build.largest_rounding <= 1e-6 * diagonal) return;
    build.origin = origin_for(positions, build.box);
    const double before = std::exchange(build.largest_rounding, largest_rounding(positions, build.origin));
    diagnostics.add(
        Code::LargeRounding,
        "",
        fmt::format(
            "float32 would move a coordinate by {:.3g}; {} {} {} was subtracted from all, which leaves "
            "{:.3g}",
            before,
            build.origin[0],
            build.origin[1],
            build.origin[2],
            build.largest_rounding
        )
    );
}

float shifted(const SceneBuild& build, std::size_t vertex, std::size_t axis) {
    return gltf::on_grid(build.contents.surface->positions[vertex][axis] - build.origin[axis], build.grid);
}

float grid_for(const SceneOptions& options, const Box& box) {
    const bool is_rounded = options.compress && options.bound > 0 && box.largest() > 0;
    return is_rounded ? gltf::grid_of(box.largest()) : 0;
}

std::int64_t node_id(const SceneBuild& build, std::size_t vertex) {
    const NodeIndex node = build.contents.surface->vertex_node[vertex];
    return node == kNoNode ? 0 : raw(build.contents.mesh->node_ids[raw(node)]);
}

/// `_NODE_ID` and, when any id needs it, `_NODE_ID_HIGH`.
template <class Id>
void write_node_ids(
    SceneBuild& build,
    const std::string& prefix,
    std::size_t count,
    gltf::Attributes& attributes,
    const Id& id
) {
    bool high = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (id(i) < 0 || id(i) / kIdModulus >= kIdModulus) {
            throw Error(Code::TooLarge, "", fmt::format("node id {}: a scene holds 1 to 2^48", id(i)));
        }
        high = high || id(i) >= kIdModulus;
    }
    ArraySpec low{prefix + "_NODE_ID", 1, count, gltf::kAttributeTarget};
    low.grid = 1;
    attributes.emplace_back("_NODE_ID", build.arrays.floats(low, [&](std::size_t i, float* out) {
        *out = static_cast<float>(id(i) % kIdModulus);
    }));
    if (!high) return;
    const ArraySpec rest{prefix + "_NODE_ID_HIGH", 1, count, gltf::kAttributeTarget};
    attributes.emplace_back("_NODE_ID_HIGH", build.arrays.floats(rest, [&](std::size_t i, float* out) {
        *out = static_cast<float>(id(i) / kIdModulus);
    }));
}

/// glTF wants unit length; a vertex of degenerate facets alone has no direction and gets up.
std::array<float, 3> unit_normal(const std::array<float, 3>& normal) {
    const double x = normal[0], y = normal[1], z = normal[2];
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 1};
    return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
}

void write_triangles(SceneBuild& build, ScenePartBuild& part) {
    const SurfacePart& range = *part.range;
    const Surface& surface = *build.contents.surface;
    gltf::Primitive& primitive = part.mesh.primitive;
    const ArraySpec indices{part.prefix + "indices", 1, 3ull * range.triangle_count, gltf::kIndexTarget};
    primitive.indices = build.arrays.indices(indices, range.vertex_count, [&](std::size_t i) {
        return raw(surface.triangles[range.first_triangle + i / 3][i % 3]) - range.first_vertex;
    });
    const ArraySpec elements{part.prefix + "elements", 1, range.triangle_count};
    build.arrays.indices(elements, std::numeric_limits<std::uint32_t>::max(), [&](std::size_t i) {
        const ElementIndex index = surface.triangle_element[range.first_triangle + i];
        const std::int64_t id = raw(element_at(*build.contents.mesh, index).id());
        if (id < 0 || id > std::numeric_limits<std::uint32_t>::max()) {
            throw Error(Code::TooLarge, "", fmt::format("element id {}: a scene holds 0 to 2^32 - 1", id));
        }
        return static_cast<std::uint32_t>(id);
    });
}

void write_vertices(SceneBuild& build, ScenePartBuild& part) {
    const std::size_t first = part.range->first_vertex;
    const std::size_t count = part.range->vertex_count;
    gltf::Attributes& attributes = part.mesh.primitive.attributes;
    ArraySpec positions{part.prefix + "POSITION", 3, count, gltf::kAttributeTarget};
    positions.grid = build.grid;
    attributes.emplace_back("POSITION", build.arrays.floats(positions, [&](std::size_t i, float* out) {
        for (std::size_t axis = 0; axis < 3; ++axis) out[axis] = shifted(build, first + i, axis);
    }));
    ArraySpec normals{part.prefix + "NORMAL", 3, count, gltf::kAttributeTarget, false};
    normals.grid = build.grid > 0 ? gltf::kNormalGrid : 0;
    attributes.emplace_back("NORMAL", build.arrays.floats(normals, [&](std::size_t i, float* out) {
        std::ranges::copy(unit_normal(build.contents.surface->normals[first + i]), out);
    }));
    write_node_ids(build, part.prefix, count, attributes, [&](std::size_t i) {
        return node_id(build, first + i);
    });
}

/// Element edges with vertices of their own, a little outside the surface so that they are not hidden in it.
void write_edges(SceneBuild& build, ScenePartBuild& part) {
    const SurfacePart& range = *part.range;
    const Surface& surface = *build.contents.surface;
    if (range.edge_count == 0) return;
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> place(range.vertex_count, kUnused);
    std::vector<std::uint32_t> used;
    const auto edges = std::span(surface.edges).subspan(range.first_edge, range.edge_count);
    for (const auto& edge : edges) {
        for (const VertexIndex vertex : edge) {
            std::uint32_t& slot = place[raw(vertex) - range.first_vertex];
            if (slot != kUnused) continue;
            slot = static_cast<std::uint32_t>(used.size());
            used.push_back(raw(vertex));
        }
    }
    gltf::Mesh mesh;
    mesh.name = part.name + " edges";
    mesh.primitive.mode = gltf::kLines;
    const std::string prefix = part.prefix + "edges/";
    const double offset = 0.0005 * build.box.diagonal();
    ArraySpec positions{prefix + "POSITION", 3, used.size(), gltf::kAttributeTarget};
    positions.grid = build.grid;
    const int position = build.arrays.floats(positions, [&](std::size_t i, float* out) {
        const std::array<float, 3> normal = unit_normal(surface.normals[used[i]]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double at = surface.positions[used[i]][axis] - build.origin[axis];
            out[axis] = static_cast<float>(at + offset * static_cast<double>(normal[axis]));
        }
    });
    mesh.primitive.attributes.emplace_back("POSITION", position);
    write_node_ids(build, prefix, used.size(), mesh.primitive.attributes, [&](std::size_t i) {
        return node_id(build, used[i]);
    });
    ArraySpec indices{prefix + "indices", 1, 2 * edges.size(), gltf::kIndexTarget};
    indices.of_lines = true;
    const auto most = static_cast<std::uint32_t>(used.size());
    mesh.primitive.indices = build.arrays.indices(indices, most, [&](std::size_t i) {
        return place[raw(edges[i / 2][i % 2]) - range.first_vertex];
    });
    build.edges += edges.size();
    part.edge_mesh = static_cast<int>(build.document.meshes.size());
    build.document.meshes.push_back(std::move(mesh));
}

/// Area and enclosed volume of what the scene holds: float32 positions, in triangle order, about its first
/// vertex. `check` repeats exactly this.
void measure(SceneBuild& build) {
    const Surface& surface = *build.contents.surface;
    for (const ScenePartBuild& part : build.parts) {
        if (part.range->kind != PartKind::Solid && part.range->kind != PartKind::Shell) continue;
        for (std::uint32_t t = 0; t < part.range->triangle_count; ++t) {
            std::array<std::array<float, 3>, 3> corners{};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::size_t vertex = raw(surface.triangles[part.range->first_triangle + t][corner]);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    corners[corner][axis] = shifted(build, vertex, axis);
            }
            build.area += triangle_area(corners);
            if (part.range->kind == PartKind::Solid) build.volume += triangle_volume(corners);
        }
    }
}

}  // namespace

void plan_parts(SceneBuild& build, Diagnostics& diagnostics) {
    choose_origin(build, diagnostics);
    build.grid = grid_for(build.options, build.box);
    for (const SurfacePart& range : build.contents.surface->parts) {
        if (range.vertex_count == 0 || range.triangle_count == 0) continue;
        ScenePartBuild part;
        part.range = &range;
        part.prefix = fmt::format("p{}/", build.parts.size());
        part.name = build.contents.mesh->parts[raw(range.part)].name;
        if (part.name.empty()) part.name = fmt::format("part {}", build.parts.size());
        part.mesh.name = part.name;
        part.double_sided = range.kind == PartKind::Shell;
        build.parts.push_back(std::move(part));
    }
    if (build.parts.empty()) throw Error(Code::NoElements, "", "there is no triangle to write");
}

void write_geometry(SceneBuild& build) {
    // Sums in one order cannot be shared out, but they need not be waited for.
    Behind measuring(1);
    const bool is_shared = thread_count() > 1;
    if (is_shared) measuring.add([&] { measure(build); });
    for (ScenePartBuild& part : build.parts) {
        write_vertices(build, part);
        write_triangles(build, part);
    }
    for (ScenePartBuild& part : build.parts) write_edges(build, part);
    if (is_shared)
        measuring.wait();
    else
        measure(build);
}

double scale_to_metres(const SceneBuild& build) {
    const std::optional<LengthUnit>& unit = build.contents.mesh->length_unit;
    if (unit && unit->metres > 0) return unit->metres;
    const double largest = build.box.largest();
    return largest > 0 ? 0.8 / largest : 1;
}

std::array<double, 16> model_matrix(char up, double metres) {
    const double m = metres;
    if (up == 'x') return {0, m, 0, 0, -m, 0, 0, 0, 0, 0, m, 0, 0, 0, 0, 1};
    if (up == 'y') return {m, 0, 0, 0, 0, m, 0, 0, 0, 0, m, 0, 0, 0, 0, 1};
    return {m, 0, 0, 0, 0, 0, -m, 0, 0, m, 0, 0, 0, 0, 0, 1};
}

Point3 to_metres(const SceneBuild& build, const Point3& point) {
    const std::array<double, 16> matrix = model_matrix(build.contents.up, scale_to_metres(build));
    Point3 out{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            out[row] += matrix[4 * axis + row] * (point[axis] - build.origin[axis]);
    }
    return out;
}

void write_tree(SceneBuild& build, const std::vector<gltf::Node>& beside) {
    gltf::Document& document = build.document;
    document.roots.push_back(0);
    const std::array<double, 16> matrix = model_matrix(build.contents.up, scale_to_metres(build));
    document.nodes.push_back({"model", "model", -1, -1, {}, matrix});
    const auto add = [&](gltf::Node node) {
        document.nodes.push_back(std::move(node));
        return static_cast<int>(document.nodes.size()) - 1;
    };
    const auto add_child = [&](std::size_t parent, gltf::Node node) {
        const int child = add(std::move(node));
        document.nodes[parent].children.push_back(child);
        return child;
    };
    for (std::size_t i = 0; i < build.parts.size(); ++i) {
        ScenePartBuild& part = build.parts[i];
        const int mesh = static_cast<int>(document.meshes.size()), id = static_cast<int>(i);
        document.meshes.push_back(std::move(part.mesh));
        part.node = add_child(0, {part.name, "part", id, mesh, {}, {}});
        if (part.edge_mesh >= 0) add_child(0, {part.name + " edges", "edges", id, part.edge_mesh, {}, {}});
    }
    for (const gltf::Node& node : beside) {
        gltf::Node top = node;
        top.children.clear();
        const int place = add(std::move(top));
        document.roots.push_back(place);
        for (const int mesh : node.children) {
            const std::string name = document.meshes[static_cast<std::size_t>(mesh)].name;
            add_child(static_cast<std::size_t>(place), {name, node.role, -1, mesh, {}, {}});
        }
    }
}

std::vector<Point3> scene_positions(const Surface& surface, const SceneOptions& options) {
    const Box box = box_of(surface.positions);
    const Point3 origin = origin_for(surface.positions, box);
    const float grid = grid_for(options, box);
    std::vector<Point3> positions = surface.positions;
    for (Point3& position : positions) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            position[axis] = static_cast<double>(gltf::on_grid(position[axis] - origin[axis], grid));
    }
    return positions;
}

}  // namespace feelem
