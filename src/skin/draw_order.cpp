// SPDX-License-Identifier: Apache-2.0
// Triangles and vertices of a surface in the order in which graphics cards, and codecs, like them best.
// Must: keep every triangle with its element and winding, every vertex with its node, and parts apart.
// Assumes: edges and blends name vertices of their own part. Algorithm: Sander, Nehab, Barczak, "Fast
// triangle reordering for vertex locality and reduced overdraw" (2007) as meshoptimizer has it; vertices in
// the order of their first use.
#include "feelem/skin.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace feelem {
namespace {

using Indices = std::vector<std::uint32_t>;  ///< Three a triangle, counted from the part's first vertex.

Indices local_indices(const Surface& surface, const SurfacePart& part) {
    Indices out;
    out.reserve(3 * std::size_t{part.triangle_count});
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
        for (const VertexIndex corner : surface.triangles[part.first_triangle + t])
            out.push_back(raw(corner) - part.first_vertex);
    }
    return out;
}

struct KeyedTriangle {
    std::array<std::uint32_t, 3> corners;  ///< From the smallest on, the way round kept.
    std::uint32_t place;
    auto operator<=>(const KeyedTriangle&) const = default;
};

std::vector<KeyedTriangle> keyed(const Indices& indices) {
    std::vector<KeyedTriangle> out(indices.size() / 3);
    for (std::size_t t = 0; t < out.size(); ++t) {
        KeyedTriangle& triangle = out[t];
        std::copy_n(indices.begin() + static_cast<std::ptrdiff_t>(3 * t), 3, triangle.corners.begin());
        std::ranges::rotate(triangle.corners, std::ranges::min_element(triangle.corners));
        triangle.place = static_cast<std::uint32_t>(t);
    }
    std::ranges::sort(out, std::less<>{});
    return out;
}

/// For each triangle of `to`, where it stood in `from`: the same triangles in another order, corners turned.
std::vector<std::uint32_t> where_from(const Indices& from, const Indices& to) {
    const std::vector<KeyedTriangle> before = keyed(from), after = keyed(to);
    std::vector<std::uint32_t> out(after.size());
    for (std::size_t i = 0; i < after.size(); ++i) out[after[i].place] = before[i].place;
    return out;
}

/// Corners turned as the index codec of EXT_meshopt_compression hands them back.
void turn_as_packed(Indices& indices, std::size_t vertices) {
    std::vector<unsigned char> packed(meshopt_encodeIndexBufferBound(indices.size(), vertices));
    for (int round = 0; round < 4; ++round) {
        const std::size_t size =
            meshopt_encodeIndexBuffer(packed.data(), packed.size(), indices.data(), indices.size());
        Indices turned(indices.size());
        const int status = meshopt_decodeIndexBuffer(turned.data(), turned.size(), 4, packed.data(), size);
        if (status != 0 || turned == indices) return;
        indices = std::move(turned);
    }
}

/// old vertex -> new vertex, both counted from the part's first.
Indices order_by_use(const Indices& indices, std::size_t vertices) {
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    Indices place(vertices, kUnused);
    std::uint32_t next = 0;
    for (const std::uint32_t index : indices) {
        if (place[index] == kUnused) place[index] = next++;
    }
    for (std::uint32_t& one : place) {
        if (one == kUnused) one = next++;
    }
    return place;
}

template <class T>
void move_rows(std::vector<T>& rows, std::size_t first, const Indices& place) {
    if (rows.empty()) return;
    std::vector<T> moved(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) moved[place[i]] = rows[first + i];
    std::ranges::copy(moved, rows.begin() + static_cast<std::ptrdiff_t>(first));
}

void order_part(Surface& surface, const SurfacePart& part, Indices& place_of_all) {
    if (part.triangle_count == 0) return;
    const Indices before = local_indices(surface, part);
    Indices after(before.size());
    meshopt_optimizeVertexCache(after.data(), before.data(), before.size(), part.vertex_count);
    const Indices place = order_by_use(after, part.vertex_count);
    const std::vector<std::uint32_t> from = where_from(before, after);
    for (std::uint32_t& index : after) index = place[index];
    turn_as_packed(after, part.vertex_count);

    std::vector<ElementIndex> elements(part.triangle_count);
    for (std::uint32_t t = 0; t < part.triangle_count; ++t)
        elements[t] = surface.triangle_element[part.first_triangle + from[t]];
    std::ranges::copy(elements, surface.triangle_element.begin() + part.first_triangle);
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            surface.triangles[part.first_triangle + t][corner] =
                VertexIndex{part.first_vertex + after[3 * std::size_t{t} + corner]};
    }
    move_rows(surface.positions, part.first_vertex, place);
    move_rows(surface.normals, part.first_vertex, place);
    move_rows(surface.vertex_node, part.first_vertex, place);
    move_rows(surface.vertex_element, part.first_vertex, place);
    for (std::size_t v = 0; v < place.size(); ++v)
        place_of_all[part.first_vertex + v] = part.first_vertex + place[v];
}

}  // namespace

void order_for_drawing(Surface& surface) {
    Indices place(surface.positions.size());
    for (std::size_t v = 0; v < place.size(); ++v) place[v] = static_cast<std::uint32_t>(v);
    for (const SurfacePart& part : surface.parts) order_part(surface, part, place);
    const auto move = [&](VertexIndex& vertex) { vertex = VertexIndex{place[raw(vertex)]}; };
    for (auto& edge : surface.edges) std::ranges::for_each(edge, move);
    for (Blend& blend : surface.blends) move(blend.vertex);
    std::ranges::for_each(surface.blend_sources, move);
    std::ranges::sort(surface.blends, {}, [](const Blend& blend) { return raw(blend.vertex); });
}

}  // namespace feelem
