// SPDX-License-Identifier: Apache-2.0
// Must: find any triangle that is missing, invented or under a wrong element id. Assumes: the pattern of
// docs/cli.md (quads round a centre, quadratic facets through their mid-side nodes). Algorithm: list all
// facets of all solids, sort by corners, keep those that are alone, cut them by the pattern, and compare the
// sorted lists of (element id, node ids). Data: 40 bytes a facet.
#include "convert/check_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <set>
#include <span>
#include <tuple>

namespace feelem {
namespace {

/// Node ids in ascending order; 0 where no node stands (a centre, a left-out mid-side node).
struct NamedTriangle {
    std::int64_t element = 0;
    std::array<std::int64_t, 3> nodes{};
    auto operator<=>(const NamedTriangle&) const = default;
};

NamedTriangle named(std::int64_t element, std::int64_t a, std::int64_t b, std::int64_t c) {
    NamedTriangle triangle{element, {a, b, c}};
    std::ranges::sort(triangle.nodes);
    return triangle;
}

/// A side of an element: corners in turn, and what lies between each and the next (kNoNode: nothing).
struct Side {
    std::uint32_t element = 0;
    std::vector<NodeIndex> corners, middles;
    NodeIndex centre = kNoNode;
};

Side side_of(const FacetRow& row, std::span<const NodeIndex> nodes, std::uint32_t element) {
    const auto local = facet_nodes(row);
    const std::size_t count = facet_corners(row).size();
    Side side;
    side.element = element;
    for (std::size_t i = 0; i < count; ++i) {
        const NodeIndex corner = nodes[local[i]], next = nodes[local[(i + 1) % count]];
        if (corner == next) continue;
        side.corners.push_back(corner);
        side.middles.push_back(local.size() >= 2 * count ? nodes[local[count + i]] : kNoNode);
    }
    if (local.size() > 2 * count) side.centre = nodes[local[2 * count]];
    if (side.corners.size() == 3) side.centre = kNoNode;
    return side;
}

using CornerKey = std::array<NodeIndex, 4>;

CornerKey key_of(const Side& side) {
    CornerKey key{kNoNode, kNoNode, kNoNode, kNoNode};
    std::ranges::copy(side.corners, key.begin());
    std::ranges::sort(key);
    return key;
}

/// Middle of each side by its two corners: equal on facets that match.
std::set<std::tuple<NodeIndex, NodeIndex, NodeIndex>> middles_of(const Side& side) {
    std::set<std::tuple<NodeIndex, NodeIndex, NodeIndex>> out;
    for (std::size_t i = 0; i < side.corners.size(); ++i) {
        const NodeIndex a = side.corners[i], b = side.corners[(i + 1) % side.corners.size()];
        out.emplace(std::min(a, b), std::max(a, b), side.middles[i]);
    }
    return out;
}

/// Solids whose corners an earlier solid has already: set aside.
std::vector<bool> duplicates_of(const Mesh& mesh) {
    std::set<std::vector<NodeIndex>> seen;
    std::vector<bool> duplicate(mesh.element_count());
    for (std::uint32_t e = 0; e < mesh.element_count(); ++e) {
        const ElementRef element = element_at(mesh, ElementIndex{e});
        const ElementRow& row = element_row(element.block->type);
        if (row.dimension != 3) continue;
        const auto corners = element.nodes().first(row.corner_count);
        std::vector<NodeIndex> key(corners.begin(), corners.end());
        std::ranges::sort(key);
        key.erase(std::unique(key.begin(), key.end()), key.end());
        duplicate[e] = !seen.insert(std::move(key)).second;
    }
    return duplicate;
}

struct KeyedFacet {
    CornerKey key{};
    std::uint32_t element = 0;
    std::uint8_t facet = 0;
};

Side side_at(const Mesh& mesh, const KeyedFacet& facet) {
    const ElementRef element = element_at(mesh, ElementIndex{facet.element});
    return side_of(facets_of(element.block->type)[facet.facet], element.nodes(), facet.element);
}

/// All sides that the skin shows; `exact`: without those between two solids.
std::vector<Side> sides_of(const Mesh& mesh, bool exact) {
    std::vector<KeyedFacet> solids;
    std::vector<Side> sides;
    const std::vector<bool> duplicate = exact ? duplicates_of(mesh) : std::vector<bool>(mesh.element_count());
    for (std::uint32_t e = 0; e < mesh.element_count(); ++e) {
        const ElementRef element = element_at(mesh, ElementIndex{e});
        const std::uint8_t dimension = element_row(element.block->type).dimension;
        if (duplicate[e] || dimension < 2) continue;
        const auto facets = facets_of(element.block->type);
        for (std::uint8_t f = 0; f < facets.size(); ++f) {
            Side side = side_of(facets[f], element.nodes(), e);
            if (side.corners.size() < 3) continue;
            if (dimension == 3 && exact)
                solids.push_back({key_of(side), e, f});
            else
                sides.push_back(std::move(side));
        }
    }
    std::ranges::sort(solids, [](const KeyedFacet& a, const KeyedFacet& b) {
        return std::tie(a.key, a.element, a.facet) < std::tie(b.key, b.element, b.facet);
    });
    for (std::size_t i = 0; i < solids.size();) {
        std::size_t end = i;
        while (end < solids.size() && solids[end].key == solids[i].key) ++end;
        // Alone, or two that do not match in their mid-side nodes.
        const bool kept = end - i == 1 || (end - i == 2 && middles_of(side_at(mesh, solids[i])) !=
                                                               middles_of(side_at(mesh, solids[i + 1])));
        for (; i < end; ++i) {
            if (kept) sides.push_back(side_at(mesh, solids[i]));
        }
    }
    return sides;
}

bool is_placed(const Mesh& mesh, NodeIndex node) {
    if (node == kNoNode) return false;
    return std::ranges::all_of(mesh.coordinates[raw(node)], [](double x) { return std::isfinite(x); });
}

void cut(const Mesh& mesh, Side side, bool through_middles, std::vector<NamedTriangle>& out) {
    const auto place = [&](NodeIndex node) { return node == kNoNode ? 0 : raw(mesh.node_ids[raw(node)]); };
    if (!std::ranges::all_of(side.corners, [&](NodeIndex n) { return is_placed(mesh, n); })) return;
    for (NodeIndex& middle : side.middles) {
        if (!through_middles || !is_placed(mesh, middle)) middle = kNoNode;
    }
    if (!through_middles || !is_placed(mesh, side.centre)) side.centre = kNoNode;
    const bool quadratic = std::ranges::any_of(side.middles, [](NodeIndex n) { return n != kNoNode; });
    const std::int64_t element = raw(element_at(mesh, ElementIndex{side.element}).id());
    const std::size_t count = side.corners.size();
    const auto corner = [&](std::size_t i) { return place(side.corners[i % count]); };
    const auto middle = [&](std::size_t i) { return place(side.middles[i % count]); };
    if (count == 3 && !quadratic) {
        out.push_back(named(element, corner(0), corner(1), corner(2)));
        return;
    }
    if (count == 3) {
        for (std::size_t i = 0; i < 3; ++i)
            out.push_back(named(element, middle(i), corner(i + 1), middle(i + 1)));
        out.push_back(named(element, middle(0), middle(1), middle(2)));
        return;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        if (!quadratic) out.push_back(named(element, corner(i), corner(i + 1), place(side.centre)));
        if (!quadratic) continue;
        out.push_back(named(element, corner(i), middle(i), place(side.centre)));
        out.push_back(named(element, middle(i), corner(i + 1), place(side.centre)));
    }
}

std::vector<NamedTriangle> scene_triangles(const Scene& scene) {
    std::vector<NamedTriangle> out;
    for (const ScenePart& part : scene.parts) {
        if (part.kind != "solid" && part.kind != "shell") continue;
        for (std::size_t t = 0; t < part.triangles.size(); ++t) {
            const auto& [a, b, c] = part.triangles[t];
            out.push_back(named(part.element_ids[t], part.node_ids[a], part.node_ids[b], part.node_ids[c]));
        }
    }
    return out;
}

std::string text_of(const NamedTriangle& t) {
    return fmt::format("nodes {} {} {} of element {}", t.nodes[0], t.nodes[1], t.nodes[2], t.element);
}

Claim difference(
    std::string name, const std::vector<NamedTriangle>& from, const std::vector<NamedTriangle>& in
) {
    std::vector<NamedTriangle> rest;
    std::ranges::set_difference(from, in, std::back_inserter(rest));
    const std::string found =
        rest.empty() ? "0" : fmt::format("{}; first: {}", rest.size(), text_of(rest[0]));
    return {std::move(name), "0", found, rest.empty()};
}

/// With edges cut more finely most vertices have no node: only what the triangles' nodes can be is checked.
Claim check_finer(const Mesh& mesh, const Scene& scene) {
    const ElementTable elements(mesh);
    Tally tally{"triangles lie on their elements"};
    for (const NamedTriangle& triangle : scene_triangles(scene)) {
        const ElementIndex element = elements(triangle.element);
        bool right = element != kNoElement;
        for (const std::int64_t id : triangle.nodes) {
            if (!right || id == 0) continue;
            const auto nodes = element_at(mesh, element).nodes();
            right = std::ranges::find(nodes, find_node(mesh, NodeId{id})) != nodes.end();
        }
        tally.count(right, [&] { return text_of(triangle); });
    }
    return tally.claim();
}

}  // namespace

std::vector<Claim> check_triangles(const Mesh& mesh, const Scene& scene) {
    const auto note = [&](const char* name) {
        const auto found = scene.notes.find(name);
        return found == scene.notes.end() ? std::string() : found->second;
    };
    const std::string subdivide = note("subdivide");
    if (!subdivide.empty() && subdivide != "0" && subdivide != "1") return {check_finer(mesh, scene)};
    const std::string skin = note("skin");
    std::vector<NamedTriangle> wanted;
    for (const Side& side : sides_of(mesh, skin.empty() || skin == "exact"))
        cut(mesh, side, subdivide != "0", wanted);
    std::vector<NamedTriangle> found = scene_triangles(scene);
    std::ranges::sort(wanted);
    std::ranges::sort(found);
    std::vector<Claim> claims{difference("triangles that the inputs do not have", found, wanted)};
    // The node map keeps what it keeps: its triangles are true ones, but not all.
    if (skin != "node-list") claims.push_back(difference("triangles missing from the scene", wanted, found));
    return claims;
}

}  // namespace feelem
