// SPDX-License-Identifier: Apache-2.0
#include "support/skin_checks.hpp"

#include "skin/outline.hpp"
#include "skin/pattern.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace feelem::test {

Mesh shuffled(const Mesh& mesh, unsigned seed) {
    Mesh out = mesh;
    std::mt19937 random(seed);
    for (ElementBlock& block : out.blocks) {
        const ElementBlock before = block;
        const std::size_t width = element_row(block.type).node_count;
        std::vector<std::size_t> order(block.ids.size());
        std::iota(order.begin(), order.end(), 0U);
        std::shuffle(order.begin(), order.end(), random);
        for (std::size_t i = 0; i < order.size(); ++i) {
            block.ids[i] = before.ids[order[i]];
            block.parts[i] = before.parts[order[i]];
            for (std::size_t k = 0; k < width; ++k)
                block.nodes[i * width + k] = before.nodes[order[i] * width + k];
        }
    }
    return out;
}

Mesh renumbered(const Mesh& mesh, unsigned seed) {
    Mesh out = mesh;
    std::mt19937 random(seed);
    std::vector<std::uint32_t> place(mesh.node_count());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), random);
    for (std::size_t i = 0; i < place.size(); ++i) out.coordinates[place[i]] = mesh.coordinates[i];
    for (ElementBlock& block : out.blocks) {
        for (NodeIndex& node : block.nodes) {
            if (node != kNoNode) node = NodeIndex{place[raw(node)]};
        }
    }
    return out;
}

Mesh mirrored(const Mesh& mesh) {
    Mesh out = mesh;
    for (Point3& at : out.coordinates) at[0] = -at[0];
    return out;
}

Mesh with_copy(const Mesh& mesh, double distance) {
    Mesh out = mesh;
    const auto count = static_cast<std::uint32_t>(mesh.node_count());
    for (std::uint32_t i = 0; i < count; ++i) {
        out.node_ids.push_back(NodeId{raw(mesh.node_ids.back()) + 1 + i});
        Point3 at = mesh.coordinates[i];
        at[0] += distance;
        out.coordinates.push_back(at);
    }
    for (ElementBlock& block : out.blocks) {
        const ElementBlock before = block;
        block.ids.insert(block.ids.end(), before.ids.begin(), before.ids.end());
        block.parts.insert(block.parts.end(), before.parts.begin(), before.parts.end());
        for (const NodeIndex node : before.nodes)
            block.nodes.push_back(node == kNoNode ? kNoNode : NodeIndex{raw(node) + count});
    }
    return out;
}

Mesh with_duplicates(const Mesh& mesh, std::size_t first, std::size_t last) {
    Mesh out = mesh;
    for (ElementBlock& block : out.blocks) {
        const ElementBlock before = block;
        const ElementRow& row = element_row(block.type);
        for (std::size_t i = first; row.dimension == 3 && i < std::min(last, before.ids.size()); ++i) {
            block.ids.push_back(ElementId{raw(before.ids[i]) + 1'000'000});
            block.parts.push_back(before.parts[i]);
            for (std::size_t k = 0; k < row.node_count; ++k)
                block.nodes.push_back(before.nodes[i * row.node_count + k]);
        }
    }
    return out;
}

namespace {

template <class Visit>
void for_each_solid_facet(const Mesh& mesh, Visit visit) {
    std::size_t element = 0;
    for (const ElementBlock& block : mesh.blocks) {
        const ElementRow& row = element_row(block.type);
        for (std::size_t i = 0; i < block.ids.size(); ++i, ++element) {
            if (row.dimension != 3) continue;
            const auto nodes = std::span(block.nodes).subspan(i * row.node_count, row.node_count);
            for (const FacetRow& facet : facets_of(block.type)) visit(element, outline_of(facet, nodes));
        }
    }
}

}  // namespace

double volume_of_elements(const Mesh& mesh) {
    double sum = 0;
    double element_sum = 0;
    std::size_t last = 0;
    for_each_solid_facet(mesh, [&](std::size_t element, const Outline& facet) {
        if (element != last) {
            sum += std::abs(element_sum);
            element_sum = 0;
            last = element;
        }
        if (facet.count == 0) return;
        const FacetPlaces at = places_of(facet, mesh.coordinates);
        for (const FacetTriangle& t : pattern_of(facet))
            element_sum += dot(at[t[0]], cross(at[t[1]], at[t[2]])) / 6;
    });
    return sum + std::abs(element_sum);
}

std::map<std::vector<std::uint32_t>, int> facet_owners(const Mesh& mesh) {
    std::map<std::vector<std::uint32_t>, int> owners;
    for_each_solid_facet(mesh, [&](std::size_t, const Outline& facet) {
        if (facet.count == 0) return;
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < facet.count; ++i) corners.push_back(raw(facet.corners[i]));
        std::ranges::sort(corners);
        ++owners[corners];
    });
    return owners;
}

namespace {

/// Every normal points away from its triangle's back, and the volume is positive: the skin is oriented.
void expect_oriented(const Surface& surface, const char* variation) {
    EXPECT_GT(surface.report.volume, 0) << variation;
    for (const auto& t : surface.triangles) {
        const Point3 area = area_vector(
            surface.positions[raw(t[0])], surface.positions[raw(t[1])], surface.positions[raw(t[2])]
        );
        for (const VertexIndex vertex : t) {
            const auto& n = surface.normals[raw(vertex)];
            ASSERT_GT(dot(area, {double(n[0]), double(n[1]), double(n[2])}), 0) << variation;
        }
    }
}

}  // namespace

Surface check_skin(const Mesh& mesh, const SkinOptions& options) {
    Diagnostics diagnostics;
    const Surface plain = make_skin(mesh, options, diagnostics);
    const double volume = volume_of_elements(mesh);
    const auto check = [&](const Mesh& variation, const char* name, std::uint64_t times) {
        Diagnostics ignored;
        const Surface surface = make_skin(variation, options, ignored);
        EXPECT_TRUE(surface.report.closed) << name;
        expect_oriented(surface, name);
        EXPECT_EQ(surface.report.triangles, plain.report.triangles * times) << name;
        EXPECT_EQ(surface.report.vertices, plain.report.vertices * times) << name;
        const double expected = volume * static_cast<double>(times);
        EXPECT_NEAR(surface.report.volume, expected, 1e-9 * std::abs(expected)) << name;
        const SkinReport& r = surface.report;
        EXPECT_EQ(
            r.solid_facets_in,
            r.solid_facets_kept + r.facets_inner + r.facets_many_owners + r.facets_collapsed +
                r.facets_of_duplicates
        ) << name;
    };
    check(mesh, "as is", 1);
    check(shuffled(mesh, 1), "shuffled", 1);
    check(renumbered(mesh, 2), "renumbered", 1);
    check(shuffled(renumbered(mesh, 3), 4), "renumbered and shuffled", 1);
    check(mirrored(mesh), "mirrored", 1);
    check(with_copy(mesh, 1000), "two copies", 2);
    return plain;
}

}  // namespace feelem::test
