// SPDX-License-Identifier: Apache-2.0
// Must: call things the same only where id and place (or corners) agree.
// Algorithm: nodes are sorted by id in every mesh, so one walk along both finds the pairs; elements are
// looked up in a sorted table of the shown mesh.
#include "read/mesh_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace feelem {
namespace {

constexpr std::size_t kMostNamed = 5;

double largest_coordinate(const Mesh& mesh) {
    double largest = 0;
    for (const Point3& point : mesh.coordinates) {
        for (const double x : point) {
            if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
        }
    }
    return largest;
}

/// NaN when one of the places is not known.
double distance_between(const Point3& a, const Point3& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

bool same_place(const Point3& a, const Point3& b, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        const bool gaps = std::isnan(a[i]) && std::isnan(b[i]);
        if (!gaps && !(a[i] == b[i] || std::abs(a[i] - b[i]) <= tolerance)) return false;
    }
    return true;
}

void pair_nodes(const Mesh& other, const Mesh& shown, MeshMap& map) {
    map.nodes.assign(other.node_count(), kNoNode);
    const double tolerance = kPlaceTolerance * largest_coordinate(shown);
    std::size_t at = 0;
    for (std::size_t i = 0; i < other.node_count(); ++i) {
        const NodeId id = other.node_ids[i];
        for (; at < shown.node_count() && shown.node_ids[at] < id; ++at) {
            map.nodes_only_shown.add(raw(shown.node_ids[at]));
        }
        if (at == shown.node_count() || shown.node_ids[at] != id) {
            map.nodes_only_other.add(raw(id));
            continue;
        }
        const std::size_t pair = at++;
        const double distance = distance_between(other.coordinates[i], shown.coordinates[pair]);
        if (distance > tolerance) {
            map.nodes_moved.add(raw(id));
            if (distance > map.farthest) {
                map.farthest = distance;
                map.farthest_id = raw(id);
            }
            continue;
        }
        map.nodes[i] = NodeIndex{static_cast<std::uint32_t>(pair)};
        ++map.same_nodes;
    }
    for (; at < shown.node_count(); ++at) map.nodes_only_shown.add(raw(shown.node_ids[at]));
}

using Corners = std::array<std::uint32_t, kMaxElementNodes>;

/// Corners in ascending order; their number.
std::size_t corners_of(const ElementRef& element, std::span<const NodeIndex> map, Corners& out) {
    const std::size_t count = element_row(element.block->type).corner_count;
    const auto nodes = element.nodes();
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = raw(map.empty() ? nodes[i] : map[raw(nodes[i])]);
    }
    std::sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
}

bool same_nodes(const ElementRef& other, const ElementRef& shown, std::span<const NodeIndex> map) {
    return std::ranges::equal(other.nodes(), shown.nodes(), [&](NodeIndex mine, NodeIndex its) {
        return (mine == kNoNode ? kNoNode : map[raw(mine)]) == its;
    });
}

/// The middle of an element's box, and its longest diagonal.
std::pair<Point3, double> extent_of(const Mesh& mesh, const ElementRef& element) {
    const auto corners = element.nodes().first(element_row(element.block->type).corner_count);
    Point3 low = mesh.coordinates[raw(corners.front())], high = low, middle{};
    for (const NodeIndex corner : corners) {
        const Point3& place = mesh.coordinates[raw(corner)];
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], place[i]);
            high[i] = std::max(high[i], place[i]);
        }
    }
    for (std::size_t i = 0; i < 3; ++i) middle[i] = (low[i] + high[i]) / 2;
    return {middle, distance_between(low, high)};
}

class ElementPairs {
public:
    ElementPairs(const Mesh& other, const Mesh& shown, MeshMap& map)
        : other_(other), shown_(shown), map_(map) {
        std::uint32_t index = 0;
        for (const ElementBlock& block : shown.blocks) {
            for (const ElementId id : block.ids) by_id_.emplace_back(id, index++);
        }
        std::ranges::sort(by_id_);
        seen_.resize(by_id_.size());
    }

    void pair_all() {
        map_.elements.assign(other_.element_count(), kNoElement);
        std::uint32_t index = 0;
        for (const ElementBlock& block : other_.blocks) {
            for (std::size_t i = 0; i < block.ids.size(); ++i) pair_one({&block, i}, index++);
        }
        for (std::size_t i = 0; i < by_id_.size(); ++i) {
            if (!seen_[i]) map_.elements_only_shown.add(raw(by_id_[i].first));
        }
    }

private:
    void pair_one(const ElementRef& mine, std::uint32_t index) {
        const auto found = std::ranges::lower_bound(by_id_, std::pair{mine.id(), std::uint32_t{0}});
        if (found == by_id_.end() || found->first != mine.id()) {
            map_.elements_only_other.add(raw(mine.id()));
            return;
        }
        seen_[static_cast<std::size_t>(found - by_id_.begin())] = true;
        const ElementIndex pair{found->second};
        const ElementRef its = element_at(shown_, pair);
        Corners a{}, b{};
        const std::size_t count = corners_of(mine, map_.nodes, a);
        const bool same_corners =
            count == corners_of(its, {}, b) &&
            std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin());
        if (same_corners) {
            map_.elements[index] = pair;
            ++map_.same_elements;
        }
        if (mine.block->type != its.block->type) {
            const ElementRow& one = element_row(mine.block->type);
            const ElementRow& two = element_row(its.block->type);
            if (map_.types.empty()) map_.types = fmt::format("{}, {} in the mesh shown", one.name, two.name);
            if ((one.dimension == 3) != (two.dimension == 3) && stand_together(mine, its)) ++map_.thickened;
            map_.elements_of_other_type.add(raw(mine.id()));
        } else if (!same_nodes(mine, its, map_.nodes)) {
            map_.elements_on_other_nodes.add(raw(mine.id()));
        }
    }

    /// A solid made of a shell or a beam stands round it: their centres are nearer than the larger is long.
    bool stand_together(const ElementRef& mine, const ElementRef& its) const {
        const auto [middle, size] = extent_of(other_, mine);
        const auto [its_middle, its_size] = extent_of(shown_, its);
        return distance_between(middle, its_middle) <= std::max(size, its_size);
    }

    const Mesh& other_;
    const Mesh& shown_;
    MeshMap& map_;
    std::vector<std::pair<ElementId, std::uint32_t>> by_id_;
    std::vector<bool> seen_;
};

std::vector<PartIndex> parts_of_elements(const Mesh& mesh) {
    std::vector<PartIndex> parts;
    for (const ElementBlock& block : mesh.blocks)
        parts.insert(parts.end(), block.parts.begin(), block.parts.end());
    return parts;
}

/// By the elements that both hold; a part without elements by its name.
void pair_parts(const Mesh& other, const Mesh& shown, MeshMap& map) {
    constexpr PartIndex kSeveral{static_cast<std::uint32_t>(-2)};
    map.parts.assign(other.parts.size(), kNoPart);
    const std::vector<PartIndex> mine = parts_of_elements(other), its = parts_of_elements(shown);
    for (std::size_t i = 0; i < mine.size(); ++i) {
        if (map.elements[i] == kNoElement) continue;
        PartIndex& part = map.parts[raw(mine[i])];
        const PartIndex found = its[raw(map.elements[i])];
        part = part == kNoPart || part == found ? found : kSeveral;
    }
    map.is_part_for_part = other.parts.size() <= shown.parts.size();
    for (std::size_t i = 0; i < map.parts.size(); ++i) {
        if (map.parts[i] == kSeveral)
            map.parts[i] = kNoPart;
        else if (map.parts[i] == kNoPart) {
            const auto found = std::ranges::find(shown.parts, other.parts[i].name, &Part::name);
            if (found != shown.parts.end())
                map.parts[i] = PartIndex{static_cast<std::uint32_t>(found - shown.parts.begin())};
        }
        map.is_part_for_part = map.is_part_for_part && raw(map.parts[i]) == i;
    }
}

}  // namespace

void Disagreement::add(std::int64_t id) {
    if (count++ < kMostNamed) first.push_back(id);
}

bool is_same_mesh(const Mesh& a, const Mesh& b) {
    if (a.node_ids != b.node_ids || a.blocks.size() != b.blocks.size()) return false;
    for (std::size_t i = 0; i < a.blocks.size(); ++i) {
        const ElementBlock& mine = a.blocks[i];
        const ElementBlock& its = b.blocks[i];
        if (mine.type != its.type || mine.ids != its.ids || mine.nodes != its.nodes) return false;
    }
    const double tolerance = kPlaceTolerance * largest_coordinate(a);
    return std::ranges::equal(a.coordinates, b.coordinates, [&](const Point3& p, const Point3& q) {
        return same_place(p, q, tolerance);
    });
}

MeshMap map_mesh(const Mesh& other, const Mesh& shown) {
    MeshMap map;
    pair_nodes(other, shown, map);
    ElementPairs(other, shown, map).pair_all();
    pair_parts(other, shown, map);
    return map;
}

bool is_one_model(const MeshMap& map, const Mesh& other, const Mesh& shown) {
    const std::size_t nodes = std::min(other.node_count(), shown.node_count());
    const std::size_t elements = std::min(other.element_count(), shown.element_count());
    return (nodes > 0 && 2 * map.same_nodes > nodes) || (elements > 0 && 2 * map.thickened >= elements);
}

}  // namespace feelem
