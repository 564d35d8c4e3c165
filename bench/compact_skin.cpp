// SPDX-License-Identifier: Apache-2.0
#include "compact_skin.hpp"

#include "model/element_table.hpp"
#include "model/vector.hpp"
#include "skin/node_buckets.hpp"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

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

/// Facets as they are most often, quads of four corners, and all others.
class FacetNodes {
public:
    explicit FacetNodes(const feelem::Mesh& mesh) : mesh_(mesh) {
        for (const feelem::ElementBlock& block : mesh.blocks) {
            const feelem::ElementRow& row = feelem::element_row(block.type);
            blocks_.push_back({block.nodes.data(), row.node_count, row.facets.data()});
        }
    }

    void fetch(feelem::FacetRef ref) const {
        const Block& block = blocks_[ref.block];
        const NodeIndex* nodes = block.nodes + ref.position * block.width;
        __builtin_prefetch(nodes);
        if (block.width > 8) __builtin_prefetch(nodes + block.width - 1);
    }

    /// Calls quad with the corners of a quad, else other with the outline.
    template <class Quad, class Other>
    void visit(feelem::FacetRef ref, Quad quad, Other other) const {
        const Block& block = blocks_[ref.block];
        const feelem::FacetRow& row = block.facets[ref.facet];
        if (row.type != feelem::ElementType::Quad4) return other(outline_of(mesh_, ref));
        const NodeIndex* nodes = block.nodes + ref.position * block.width;
        const NodeIndex a = nodes[row.nodes[0]], b = nodes[row.nodes[1]], c = nodes[row.nodes[2]],
                        d = nodes[row.nodes[3]];
        if (a == b || b == c || c == d || d == a || a == c || b == d) return other(outline_of(mesh_, ref));
        quad(a, b, c, d);
    }

private:
    struct Block {
        const NodeIndex* nodes;
        std::size_t width;
        const feelem::FacetRow* facets;
    };
    const feelem::Mesh& mesh_;
    std::vector<Block> blocks_;
};

/// Triangles between nodes of the mesh; a byte for each node, 1 where it is used.
void cut(
    const FacetNodes& nodes, std::span<const feelem::FacetRef> facets, std::uint8_t* used, CompactSkin& skin
) {
    constexpr std::size_t kAhead = 16;
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
        if (i + kAhead < facets.size()) nodes.fetch(facets[i + kAhead]);
        const auto triangle = [&](NodeIndex a, NodeIndex b, NodeIndex c) {
            skin.triangles[at] = {raw(a), raw(b), raw(c)};
            skin.facets[at++] = i;
        };
        const auto use = [&](NodeIndex node) { used[raw(node)] = 1; };
        nodes.visit(
            facets[i],
            [&](NodeIndex a, NodeIndex b, NodeIndex c, NodeIndex d) {
                use(a), use(b), use(c), use(d);
                triangle(a, b, c);
                triangle(a, c, d);
            },
            [&](const Outline& facet) {
                for (std::size_t k = 0; k < facet.count; ++k) {
                    use(facet.corners[k]);
                    if (facet.middles[k] != kNoNode) use(facet.middles[k]);
                }
                for_each_triangle(facet, triangle);
            }
        );
    }
    skin.triangle_count = at;
}

/// Of nodes whose byte is 1: bits are not set one by one, since those next to each other wait for each other.
feelem::NodeRanks ranks_of(const std::uint8_t* used, std::size_t nodes) {
    std::vector<std::uint64_t> words((nodes + 63) / 64);
    for (std::size_t i = 0; i < nodes; i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, used + i, std::min<std::size_t>(nodes - i, 8));
        if (eight == 0) continue;
        // The lowest bit of each byte becomes a bit of the top byte.
        words[i / 64] |= ((eight * 0x0102'0408'1020'4080ULL) >> 56U) << (i % 64);
    }
    return feelem::NodeRanks(std::move(words));
}

}  // namespace

CompactSkin compact(
    const feelem::Mesh& mesh, std::span<const feelem::FacetRef> facets, std::span<const float> values
) {
    constexpr std::size_t kMostTriangles = 6;
    CompactSkin skin(mesh.node_count(), facets.size() * kMostTriangles);
    feelem::ZeroedArray<std::uint8_t> used(mesh.node_count());
    cut(FacetNodes(mesh), facets, used.data(), skin);
    const feelem::NodeRanks ranks = ranks_of(used.data(), mesh.node_count());
    skin.point_count = ranks.count();
    // Where every node is used, as on a thin plate, each keeps its number.
    if (skin.point_count < mesh.node_count()) {
        for (std::size_t i = 0; i < skin.triangle_count; ++i) {
            for (std::uint32_t& point : skin.triangles[i]) point = ranks(NodeIndex{point});
        }
    }
    std::size_t point = 0;
    ranks.for_each([&](std::uint32_t node) {
        const feelem::Point3& place = mesh.coordinates[node];
        skin.points[point] = {
            static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])};
        skin.values[point] = values[node];
        skin.nodes[point++] = NodeIndex{node};
    });
    return skin;
}

void measure(const CompactSkin& skin, double& area, double& volume) {
    const auto place = [&](std::uint32_t point) {
        const auto& at = skin.points[point];
        return feelem::Point3{at[0], at[1], at[2]};
    };
    for (const auto& [i, j, k] : skin.triangles.span().first(skin.triangle_count)) {
        const feelem::Point3 a = place(i), b = place(j), c = place(k);
        const feelem::Point3 normal = feelem::cross(feelem::minus(b, a), feelem::minus(c, a));
        area += feelem::length(normal) / 2;
        volume += feelem::dot(normal, a) / 6;
    }
}

}  // namespace bench
