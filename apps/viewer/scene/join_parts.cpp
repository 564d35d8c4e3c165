// SPDX-License-Identifier: Apache-2.0
#include "viewer/scene/join_parts.hpp"

#include "scene/scene_read.hpp"

#include "feelem/error.hpp"
#include "feelem/pick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace feelem::viewer {
namespace {

[[noreturn]] void bad(const SceneFile& file, const std::string& text) {
    throw Error(Code::BadScene, file.path(), text);
}

std::uint32_t counted(std::size_t count) {
    return static_cast<std::uint32_t>(count);
}

void append_part(
    const SceneFile& file, const gltf::Primitive& primitive, const ScenePart& part, Geometry& out
) {
    if (part.positions.size() > std::numeric_limits<std::uint32_t>::max() - out.positions.size())
        bad(file, "all parts together have more vertices than can be counted");
    PartRange range;
    range.first_vertex = counted(out.positions.size());
    range.vertices = counted(part.positions.size());
    range.first_triangle = counted(out.triangles.size());
    range.triangles = counted(part.triangles.size());
    const std::vector<float> normals = file.floats(attribute_of(file, primitive, "NORMAL"), 3);
    if (normals.size() != part.positions.size() * 3) bad(file, "normals do not match the vertices");
    for (std::size_t i = 0; i < normals.size(); i += 3)
        out.normals.push_back({normals[i], normals[i + 1], normals[i + 2]});
    out.positions.insert(out.positions.end(), part.positions.begin(), part.positions.end());
    for (const auto& [a, b, c] : part.triangles)
        out.triangles.push_back({a + range.first_vertex, b + range.first_vertex, c + range.first_vertex});
    out.node_ids.insert(out.node_ids.end(), part.node_ids.begin(), part.node_ids.end());
    out.element_ids.insert(out.element_ids.end(), part.element_ids.begin(), part.element_ids.end());
    out.parts.push_back(range);
}

/// From the places of edges back to the vertices of the skin: by node id, and by place where there is none.
class VertexFinder {
public:
    explicit VertexFinder(const ScenePart& part) : part_(part) {
        for (std::size_t v = 0; v < part.node_ids.size(); ++v)
            if (part.node_ids[v] != 0) by_id_.emplace_back(part.node_ids[v], counted(v));
        std::ranges::sort(by_id_);
    }
    std::uint32_t find(std::int64_t id, const std::array<float, 3>& place) {
        const auto at = std::ranges::lower_bound(by_id_, std::pair{id, std::uint32_t{0}});
        if (id != 0 && at != by_id_.end() && at->first == id) return at->second;
        if (!picker_) picker_.emplace(part_.positions, part_.triangles);
        const auto hit = picker_->nearest({place[0], place[1], place[2]});
        if (!hit) return 0;
        const auto most = std::ranges::max_element(hit->weights) - hit->weights.begin();
        return part_.triangles[hit->triangle][static_cast<std::size_t>(most)];
    }

private:
    const ScenePart& part_;
    std::vector<std::pair<std::int64_t, std::uint32_t>> by_id_;
    std::optional<Picker> picker_;
};

void append_edges(
    const SceneFile& file,
    const gltf::Primitive& primitive,
    const ScenePart& part,
    PartRange& range,
    Geometry& out
) {
    const std::vector<float> places = file.floats(attribute_of(file, primitive, "POSITION"), 3);
    const std::vector<std::int64_t> ids = read_node_ids(file, primitive, places.size() / 3);
    const std::vector<std::uint32_t> ends = file.integers(primitive.indices);
    const std::uint32_t first = counted(out.edge_positions.size());
    VertexFinder vertices(part);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        out.edge_positions.push_back({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
        out.edge_vertices.push_back(range.first_vertex + vertices.find(ids[i], out.edge_positions.back()));
    }
    range.first_edge = counted(out.edges.size());
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        if (ends[i] >= ids.size() || ends[i + 1] >= ids.size())
            bad(file, fmt::format("edge {} has no end", i / 2));
        out.edges.push_back({first + ends[i], first + ends[i + 1]});
    }
    range.edges = counted(out.edges.size()) - range.first_edge;
}

void find_box(Geometry& geometry) {
    if (geometry.positions.empty()) return;
    geometry.low = geometry.high = geometry.positions.front();
    for (const auto& place : geometry.positions) {
        for (std::size_t k = 0; k < 3; ++k) {
            geometry.low[k] = std::min(geometry.low[k], place[k]);
            geometry.high[k] = std::max(geometry.high[k], place[k]);
        }
    }
}

}  // namespace

Geometry join_parts(const SceneFile& file, std::span<const ScenePart> parts) {
    const SceneDocument& document = file.document();
    Geometry out;
    for (std::size_t p = 0; p < parts.size(); ++p) append_part(file, document.parts[p], parts[p], out);
    for (std::size_t e = 0; e < document.edges.size(); ++e) {
        const std::size_t part = document.edge_parts[e];
        append_edges(file, document.edges[e], parts[part], out.parts[part], out);
    }
    find_box(out);
    return out;
}

std::vector<std::array<std::uint32_t, 3>> join_level(
    const SceneFile& file, const Geometry& geometry, std::size_t level
) {
    std::vector<std::array<std::uint32_t, 3>> out;
    const std::vector<std::string>& names = file.document().level_indices.at(level);
    for (std::size_t p = 0; p < names.size(); ++p) {
        if (names[p].empty()) continue;
        const PartRange& range = geometry.parts.at(p);
        const std::vector<std::uint32_t> corners = file.integers(file.find(names[p]));
        if (corners.size() % 3 != 0) bad(file, fmt::format("{}: a triangle with too few corners", names[p]));
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            std::array<std::uint32_t, 3> triangle{};
            for (std::size_t k = 0; k < 3; ++k) {
                if (corners[i + k] >= range.vertices)
                    bad(file, fmt::format("{}: corner {} is no vertex", names[p], i + k));
                triangle[k] = corners[i + k] + range.first_vertex;
            }
            out.push_back(triangle);
        }
    }
    return out;
}

}  // namespace feelem::viewer
