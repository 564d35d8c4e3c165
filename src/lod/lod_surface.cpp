// SPDX-License-Identifier: Apache-2.0
// Which vertices of a skin are one point of the model.
#include "feelem/lod.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace feelem {
namespace {

/// What makes vertices one point: their node, or a sum over what they are mixed from. Order does not matter.
struct PlaceKey {
    std::uint64_t hash = 0;
    std::uint32_t vertex = 0;
};

std::uint64_t stirred(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

std::uint64_t key_of_blend(const Surface& surface, const Blend& blend) {
    std::uint64_t sum = 1;
    for (std::uint32_t i = blend.first; i < blend.first + blend.count; ++i) {
        if (surface.blend_weights[i] == 0) continue;
        std::uint64_t bits = 0;
        std::memcpy(&bits, &surface.blend_weights[i], sizeof bits);
        const NodeIndex node = surface.vertex_node[raw(surface.blend_sources[i])];
        sum += stirred(bits ^ stirred(raw(node)));
    }
    return sum;
}

bool is_near(const Point3& a, const Point3& b) {
    double apart = 0, size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        apart = std::max(apart, std::abs(a[axis] - b[axis]));
        size = std::max({size, std::abs(a[axis]), std::abs(b[axis])});
    }
    return apart <= 1e-9 * size;
}

}  // namespace

LodSurface lod_surface(const Surface& surface) {
    LodSurface out;
    out.positions = surface.positions;
    out.triangles = surface.triangles;
    out.places.resize(surface.positions.size());
    std::iota(out.places.begin(), out.places.end(), 0U);
    out.parts.assign(surface.positions.size(), 0);
    std::vector<PlaceKey> keys;
    std::vector<bool> is_drawn_by_elements(surface.positions.size(), false);
    for (std::size_t i = 0; i < surface.parts.size(); ++i) {
        const SurfacePart& part = surface.parts[i];
        for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
            out.parts[v] = static_cast<std::uint32_t>(i);
            // Rings of tubes and spheres share nodes, but no places.
            is_drawn_by_elements[v] = part.kind == PartKind::Solid || part.kind == PartKind::Shell;
            if (is_drawn_by_elements[v] && surface.vertex_node[v] != kNoNode)
                keys.push_back({stirred(raw(surface.vertex_node[v])), v});
        }
    }
    for (const Blend& blend : surface.blends) {
        if (is_drawn_by_elements[raw(blend.vertex)])
            keys.push_back({key_of_blend(surface, blend), raw(blend.vertex)});
    }
    std::ranges::sort(keys, [](const PlaceKey& a, const PlaceKey& b) {
        return std::pair(a.hash, a.vertex) < std::pair(b.hash, b.vertex);
    });
    for (std::size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].hash != keys[i - 1].hash) continue;
        const std::uint32_t first = out.places[keys[i - 1].vertex];
        if (is_near(surface.positions[keys[i].vertex], surface.positions[first]))
            out.places[keys[i].vertex] = first;
    }
    return out;
}

}  // namespace feelem
