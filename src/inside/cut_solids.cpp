// SPDX-License-Identifier: Apache-2.0
#include "inside/cut_solids.hpp"

#include "base/parallel.hpp"
#include "inside/tetrahedra.hpp"
#include "model/vector.hpp"
#include "skin/element_checks.hpp"
#include "skin/outline.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem {
namespace {

constexpr std::size_t kElementsAtOnce = 4096;
/// No element has points farther beyond its nodes: a brick of 20 nodes has 2 at its centre.
constexpr double kMostOvershoot = 2.5;

/// How a tetrahedron is cut, by which of its corners (bit i: corner i) are on the positive side: an even
/// order of its corners, so that its orientation is kept. One corner apart is last, two come first.
constexpr std::array<std::array<std::uint8_t, 4>, 16> kOrder{{
    {0, 1, 2, 3},
    {1, 3, 2, 0},
    {0, 2, 3, 1},
    {0, 1, 2, 3},
    {0, 3, 1, 2},
    {0, 2, 3, 1},
    {1, 2, 0, 3},
    {0, 1, 2, 3},
    {0, 1, 2, 3},
    {0, 3, 1, 2},
    {1, 3, 2, 0},
    {0, 3, 1, 2},
    {2, 3, 0, 1},
    {0, 2, 3, 1},
    {1, 3, 2, 0},
    {0, 1, 2, 3},
}};

struct Stretch {
    const ElementBlock* block = nullptr;
    std::size_t first = 0, last = 0;
    std::uint32_t first_index = 0;  ///< Of the block's first element.
};

std::vector<Stretch> stretches_of(const Mesh& mesh) {
    std::vector<Stretch> out;
    std::uint32_t before = 0;
    for (const ElementBlock& block : mesh.blocks) {
        const std::size_t count = block.ids.size();
        const bool is_solid = element_row(block.type).dimension == 3;
        for (std::size_t first = 0; is_solid && first < count; first += kElementsAtOnce)
            out.push_back({&block, first, std::min(first + kElementsAtOnce, count), before});
        before += static_cast<std::uint32_t>(count);
    }
    return out;
}

/// Cuts the elements of one stretch.
class Cutter {
public:
    Cutter(const Solids& solids, const CutJob& job) : solids_(solids), places_(solids.places()), job_(job) {}

    void cut(const SolidRef& solid) {
        solid_ = solid;
        nodes_ = solid.nodes();
        if (!is_placed()) {
            ++made_.elements_without_place;
            return;
        }
        const auto count = nodes_.size();
        job_.level(solid, std::span(level_).first(count));
        if (!may_pass_zero(kMostOvershoot)) return;
        const Tetrahedra* pieces = &whole_tetrahedra(solid.block->type);
        Tetrahedra of_this;
        if (!is_whole()) {
            of_this = tetrahedra_of(solid.block->type, std::span(local_).first(count));
            pieces = &of_this;
        }
        if (!may_pass_zero(pieces->overshoot)) return;
        fill_points(*pieces);
        const std::size_t before = made_.triangles.size();
        known_.clear();
        is_inverted_ = is_inverted(*solids_.mesh, *solid.block, solid.position);
        for (const auto& corners : pieces->corners) cut(corners);
        if (made_.triangles.size() > before) ++made_.elements;
    }

    Section& made() { return made_; }

private:
    bool has_place_at(NodeIndex node) const {
        return std::ranges::all_of(places_[raw(node)], [](double v) { return std::isfinite(v); });
    }

    bool is_placed() const {
        const auto corners = nodes_.first(element_row(solid_.block->type).corner_count);
        return std::ranges::all_of(corners, [&](NodeIndex node) { return has_place_at(node); });
    }

    /// All nodes there and different; else `local_` says which there are.
    bool is_whole() {
        bool is_plain = true;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const auto same = static_cast<std::size_t>(std::ranges::find(nodes_, nodes_[i]) - nodes_.begin());
            const bool is_there = nodes_[i] != kNoNode && has_place_at(nodes_[i]);
            local_[i] = is_there ? NodeIndex{static_cast<std::uint32_t>(same)} : kNoNode;
            is_plain = is_plain && is_there && same == i;
        }
        return is_plain;
    }

    bool may_pass_zero(double overshoot) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (nodes_[i] == kNoNode || std::isnan(level_[i])) continue;
            low = std::min(low, level_[i]);
            high = std::max(high, level_[i]);
        }
        // A little more for rounding: points between are sums of their own.
        const double beyond = (overshoot + 1e-9) * (high - low);
        return low - beyond < 0 && high + beyond >= 0;
    }

    void fill_points(const Tetrahedra& pieces) {
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            at_[i] = nodes_[i] == kNoNode ? Point3{} : places_[raw(nodes_[i])];
        job_.values(solid_, std::span(value_).first(nodes_.size()));
        std::size_t point = nodes_.size();
        for (const BetweenNodes& between : pieces.between) fill_point(point++, between);
    }

    /// Summed in the order of the mesh's nodes: neighbours get the same number for the point that they share.
    void fill_point(std::size_t point, const BetweenNodes& between) {
        const std::size_t count = between.nodes.size();
        std::array<std::uint8_t, kMaxElementNodes> order{};
        for (std::size_t k = 0; k < count; ++k) order[k] = static_cast<std::uint8_t>(k);
        std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), [&](auto a, auto b) {
            return nodes_[between.nodes[a]] < nodes_[between.nodes[b]];
        });
        Point3 place{};
        double level = 0, value = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint8_t node = between.nodes[order[k]];
            const double weight = between.weights[order[k]];
            for (std::size_t axis = 0; axis < 3; ++axis) place[axis] += weight * at_[node][axis];
            level += weight * level_[node];
            value += weight * value_[node];
        }
        at_[point] = place;
        level_[point] = level;
        value_[point] = value;
    }

    void cut(const std::array<std::uint8_t, 4>& corners) {
        std::size_t positive = 0, count = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const double level = level_[corners[i]];
            if (std::isnan(level)) return;
            if (level < 0) continue;
            positive |= std::size_t{1} << i;
            ++count;
        }
        if (count == 0 || count == 4) return;
        const auto& order = kOrder[positive];
        const std::uint8_t a = corners[order[0]], b = corners[order[1]];
        const std::uint8_t c = corners[order[2]], d = corners[order[3]];
        if (count == 1) {
            add(vertex(d, a), vertex(d, c), vertex(d, b));
        } else if (count == 3) {
            add(vertex(a, d), vertex(b, d), vertex(c, d));
        } else {
            const std::uint32_t first = vertex(a, c), third = vertex(b, d);
            add(first, vertex(a, d), third);
            add(first, third, vertex(b, c));
        }
    }

    std::uint32_t vertex(std::uint8_t positive, std::uint8_t negative) {
        for (const Known& known : known_) {
            if (known.positive == positive && known.negative == negative) return known.vertex;
        }
        const double t = level_[positive] / (level_[positive] - level_[negative]);
        const auto between = [t](double from, double to) { return from + t * (to - from); };
        Point3 place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] = between(at_[positive][axis], at_[negative][axis]);
        const double value = job_.is_flat ? value_[0] : between(value_[positive], value_[negative]);
        const auto number = static_cast<std::uint32_t>(made_.positions.size());
        made_.positions.push_back(place);
        made_.values.push_back(static_cast<float>(value));
        known_.push_back({positive, negative, number});
        return number;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const Point3 &at_a = made_.positions[a], &at_b = made_.positions[b], &at_c = made_.positions[c];
        if (at_a == at_b || at_b == at_c || at_c == at_a) return;
        if (is_inverted_) std::swap(b, c);
        const Point3 twice = cross(minus(made_.positions[b], at_a), minus(made_.positions[c], at_a));
        made_.area += (job_.normal ? dot(twice, *job_.normal) : length(twice)) / 2;
        made_.triangles.push_back({a, b, c});
        made_.triangle_element.push_back(solid_.index);
    }

    struct Known {
        std::uint8_t positive, negative;
        std::uint32_t vertex;
    };
    const Solids& solids_;
    std::span<const Point3> places_;
    const CutJob& job_;
    SolidRef solid_;
    std::span<const NodeIndex> nodes_;
    bool is_inverted_ = false;
    std::array<NodeIndex, kMaxElementNodes> local_{};
    std::array<double, kMostSolidPoints> level_{}, value_{};
    std::array<Point3, kMostSolidPoints> at_{};
    std::vector<Known> known_;
    Section made_;
};

void append(Section& all, Section& more) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), more.positions.begin(), more.positions.end());
    all.values.insert(all.values.end(), more.values.begin(), more.values.end());
    for (const auto& [a, b, c] : more.triangles) all.triangles.push_back({a + first, b + first, c + first});
    all.triangle_element.insert(
        all.triangle_element.end(), more.triangle_element.begin(), more.triangle_element.end()
    );
    all.area += more.area;
    all.elements += more.elements;
    all.elements_without_place += more.elements_without_place;
    more = {};
}

}  // namespace

std::optional<Section> cut_solids(const Solids& solids, const CutJob& job, const SectionLimits& limits) {
    const std::vector<Stretch> stretches = stretches_of(*solids.mesh);
    std::vector<Section> parts(stretches.size());
    std::atomic<std::size_t> triangles = 0;
    std::atomic<bool> is_over = false;
    parallel_chunks(stretches.size(), 1, [&](std::size_t number, std::size_t) {
        if (is_over || (limits.is_cancelled && limits.is_cancelled())) is_over = true;
        if (is_over) return;
        const Stretch& stretch = stretches[number];
        Cutter cutter(solids, job);
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            const ElementIndex index{stretch.first_index + static_cast<std::uint32_t>(i)};
            if (!solids.set_aside[raw(index)]) cutter.cut({stretch.block, i, index});
        }
        parts[number] = std::move(cutter.made());
        if (triangles.fetch_add(parts[number].triangles.size()) + parts[number].triangles.size() >
            limits.most_triangles)
            is_over = true;
    });
    if (triangles > limits.most_triangles) {
        throw Error(
            Code::TooLarge, "", fmt::format("the section has more than {} triangles", limits.most_triangles)
        );
    }
    if (is_over) return std::nullopt;
    Section all;
    for (Section& part : parts) append(all, part);
    return all;
}

}  // namespace feelem
