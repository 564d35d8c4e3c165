// SPDX-License-Identifier: Apache-2.0
#include "skin/element_checks.hpp"

#include "base/parallel.hpp"
#include "skin/facet_hash.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>

namespace feelem {
namespace {

/// Below this part of its size cubed, an element counts as flat: the sign of its volume is rounding.
constexpr double kFlat = 1e-12;

std::uint64_t hash_of(const CornerSet& corners) {
    using namespace facet_hash;
    std::uint64_t hash = kLast;
    for (std::size_t i = 0; i < corners.size(); i += 2)
        hash = fold(hash ^ pair(raw(corners[i]), raw(corners[i + 1])), kTriangle ^ hash);
    return hash;
}

double dot_cross(const Point3& a, const Point3& b, const Point3& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

CornerSet corner_set(const ElementBlock& block, std::size_t position) {
    const ElementRow& row = element_row(block.type);
    CornerSet corners;
    corners.fill(kNoNode);
    std::ranges::copy(
        std::span(block.nodes).subspan(position * row.node_count, row.corner_count), corners.begin()
    );
    std::ranges::sort(corners);
    std::fill(std::unique(corners.begin(), corners.end()), corners.end(), kNoNode);
    return corners;
}

std::vector<bool> find_duplicate_solids(const Mesh& mesh) {
    struct Entry {
        std::uint64_t hash;
        std::uint32_t element;
        std::uint32_t position;
        const ElementBlock* block;
    };
    std::vector<Entry> entries;
    std::uint32_t element = 0;
    for (const ElementBlock& block : mesh.blocks) {
        const ElementRow& row = element_row(block.type);
        for (std::uint32_t i = 0; i < block.ids.size(); ++i, ++element) {
            if (row.dimension == 3) entries.push_back({hash_of(corner_set(block, i)), element, i, &block});
        }
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return std::pair(a.hash, a.element) < std::pair(b.hash, b.element);
    });
    const auto corners = [](const Entry& entry) { return corner_set(*entry.block, entry.position); };
    std::vector<bool> duplicate(element);
    for (std::size_t i = 1; i < entries.size(); ++i) {
        if (entries[i].hash == entries[i - 1].hash && corners(entries[i]) == corners(entries[i - 1]))
            duplicate[entries[i].element] = true;
    }
    return duplicate;
}

bool is_inverted(const Mesh& mesh, const ElementBlock& block, std::size_t position) {
    const ElementRow& row = element_row(block.type);
    const auto nodes = std::span(block.nodes).subspan(position * row.node_count, row.node_count);
    const Point3& origin = mesh.coordinates[raw(nodes[0])];
    std::array<Point3, 8> at{};
    double size = 0;
    for (std::size_t i = 0; i < row.corner_count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            at[i][axis] = mesh.coordinates[raw(nodes[i])][axis] - origin[axis];
            size = std::max(size, std::abs(at[i][axis]));
        }
    }
    // Twice six times the volume: each quad is the mean of its two ways of being cut into triangles.
    double volume = 0;
    for (const FacetRow& facet : facets_of(block.type)) {
        const auto c = facet_corners(facet);
        if (c.size() == 3) {
            volume += 2 * dot_cross(at[c[0]], at[c[1]], at[c[2]]);
            continue;
        }
        volume += dot_cross(at[c[0]], at[c[1]], at[c[2]]) + dot_cross(at[c[0]], at[c[2]], at[c[3]]) +
                  dot_cross(at[c[1]], at[c[2]], at[c[3]]) + dot_cross(at[c[1]], at[c[3]], at[c[0]]);
    }
    return volume < -kFlat * size * size * size;
}

std::uint64_t count_inverted_solids(const Mesh& mesh, const std::vector<bool>& set_aside) {
    std::atomic<std::uint64_t> count{0};
    std::size_t before = 0;
    for (const ElementBlock& block : mesh.blocks) {
        if (element_row(block.type).dimension == 3) {
            parallel_chunks(block.ids.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
                std::uint64_t here = 0;
                for (std::size_t i = first; i < last; ++i) {
                    const bool counts = set_aside.empty() || !set_aside[before + i];
                    if (counts && is_inverted(mesh, block, i)) ++here;
                }
                count.fetch_add(here, std::memory_order_relaxed);
            });
        }
        before += block.ids.size();
    }
    return count;
}

bool flip_facets_of_inverted_solids(const Mesh& mesh, std::vector<FacetRef>& facets) {
    std::atomic<bool> any{false};
    parallel_chunks(facets.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        // Those behind `last` are being changed by another thread.
        const auto ours = std::span<const FacetRef>(facets).first(last);
        for (std::size_t i = first; i < last; ++i) {
            fetch_elements(mesh, ours, i);
            const bool same_element = i > first && facets[i].block == facets[i - 1].block &&
                                      facets[i].position == facets[i - 1].position;
            facets[i].flipped = same_element
                                    ? facets[i - 1].flipped
                                    : is_inverted(mesh, mesh.blocks[facets[i].block], facets[i].position);
            if (facets[i].flipped) any.store(true, std::memory_order_relaxed);
        }
    });
    return any;
}

}  // namespace feelem
