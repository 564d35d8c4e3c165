// SPDX-License-Identifier: Apache-2.0
#include "compact_skin.hpp"

#include "base/huge_pages.hpp"
#include "model/vector.hpp"
#include "skin/node_buckets.hpp"

namespace bench {
namespace {

using feelem::kNoNode;
using feelem::NodeIndex;
using feelem::Outline;

/// Corners and, where there are middles, those: ears at the corners, then what they leave.
template <class Triangle>
void for_each_triangle(const Outline& facet, Triangle triangle) {
    const auto& c = facet.corners;
    const auto& m = facet.middles;
    bool all_middles = true;
    for (std::size_t i = 0; i < facet.count; ++i) all_middles = all_middles && m[i] != kNoNode;
    const auto& inner = all_middles ? m : c;
    if (all_middles) {
        for (std::size_t i = 0; i < facet.count; ++i)
            triangle(m[i == 0 ? facet.count - 1U : i - 1], c[i], m[i]);
    }
    triangle(inner[0], inner[1], inner[2]);
    if (facet.count == 4) triangle(inner[0], inner[2], inner[3]);
}

}  // namespace

CompactSkin compact(
    const feelem::Mesh& mesh, std::span<const feelem::FacetRef> facets, std::span<const float> values
) {
    CompactSkin skin;
    feelem::NodeRanks ranks(mesh.node_count());
    // As many as there may be: what is not used is never touched.
    constexpr std::size_t kMostTriangles = 6;
    feelem::reserve_big(skin.triangles, facets.size() * kMostTriangles);
    feelem::reserve_big(skin.facets, facets.size() * kMostTriangles);
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        feelem::fetch_elements(mesh, facets, i);
        const Outline facet = feelem::outline_of(mesh, facets[i]);
        for (std::size_t k = 0; k < facet.count; ++k) {
            ranks.mark(facet.corners[k]);
            if (facet.middles[k] != kNoNode) ranks.mark(facet.middles[k]);
        }
        for_each_triangle(facet, [&](NodeIndex a, NodeIndex b, NodeIndex c) {
            skin.triangles.push_back({raw(a), raw(b), raw(c)});
            skin.facets.push_back(i);
        });
    }
    ranks.seal();
    for (auto& triangle : skin.triangles) {
        for (std::uint32_t& point : triangle) point = ranks(NodeIndex{point});
    }
    feelem::reserve_big(skin.points, ranks.count());
    feelem::reserve_big(skin.values, ranks.count());
    feelem::reserve_big(skin.nodes, ranks.count());
    ranks.for_each([&](std::uint32_t node) {
        const feelem::Point3& at = mesh.coordinates[node];
        skin.points.push_back(
            {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])}
        );
        skin.values.push_back(values[node]);
        skin.nodes.push_back(NodeIndex{node});
    });
    return skin;
}

void measure(const CompactSkin& skin, double& area, double& volume) {
    const auto place = [&](std::uint32_t point) {
        const auto& at = skin.points[point];
        return feelem::Point3{at[0], at[1], at[2]};
    };
    for (const auto& [i, j, k] : skin.triangles) {
        const feelem::Point3 a = place(i), b = place(j), c = place(k);
        const feelem::Point3 normal = feelem::cross(feelem::minus(b, a), feelem::minus(c, a));
        area += feelem::length(normal) / 2;
        volume += feelem::dot(normal, a) / 6;
    }
}

}  // namespace bench
