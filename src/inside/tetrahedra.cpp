// SPDX-License-Identifier: Apache-2.0
#include "inside/tetrahedra.hpp"

#include "model/shape_functions.hpp"
#include "skin/outline.hpp"
#include "skin/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace feelem {
namespace {

class Divider {
public:
    Divider(ElementType type, std::span<const NodeIndex> local) : type_(type), local_(local) {
        made_.node_count = local.size();
    }

    Tetrahedra run() {
        const std::uint8_t centre = add(weights_at_centre());
        for (const FacetRow& facet : facets_of(type_)) {
            const Outline outline = outline_of(facet, local_);
            const auto points = points_of(outline);
            if (outline.count == 0) continue;
            for (const FacetTriangle& t : pattern_of(outline))
                made_.corners.push_back({points[t[0]], points[t[1]], points[t[2]], centre});
        }
        return std::move(made_);
    }

private:
    BetweenNodes weights_at_centre() const {
        const ShapeWeights weights = shape_at(type_, local_, reference_centre(type_));
        BetweenNodes point;
        for (std::size_t i = 0; i < local_.size(); ++i) {
            if (weights[i] == 0) continue;
            point.nodes.push_back(static_cast<std::uint8_t>(i));
            point.weights.push_back(weights[i]);
        }
        return point;
    }

    std::uint8_t add(BetweenNodes point) {
        double sum = 0;
        for (const double weight : point.weights) sum += std::abs(weight);
        made_.overshoot = std::max(made_.overshoot, (sum - 1) / 2);
        made_.between.push_back(std::move(point));
        return static_cast<std::uint8_t>(made_.node_count + made_.between.size() - 1);
    }

    /// A side without a middle of its own, which has one where its facet is cut through the others.
    std::uint8_t half(const Outline& outline, std::size_t side) {
        const NodeIndex a = outline.corners[side], b = outline.corners[outline.after(side)];
        const auto [found, is_new] = halves_.try_emplace(std::minmax(a, b), std::uint8_t{0});
        if (is_new) found->second = add({{local(a), local(b)}, {0.5, 0.5}});
        return found->second;
    }

    static std::uint8_t local(NodeIndex node) { return static_cast<std::uint8_t>(raw(node)); }

    std::array<std::uint8_t, kFacetPoints> points_of(const Outline& outline) {
        std::array<std::uint8_t, kFacetPoints> points{};
        for (std::size_t i = 0; i < outline.corners.size() && i < outline.count; ++i) {
            points[i] = local(outline.corners[i]);
            if (!outline.has_middles()) continue;
            const NodeIndex middle = outline.middles[i];
            points[kFirstMiddle + i] = middle == kNoNode ? half(outline, i) : local(middle);
        }
        if (outline.count != 4) return points;
        if (outline.centre != kNoNode) {
            points[kCentre] = local(outline.centre);
            return points;
        }
        const WeightedPoints blend = blend_of_centre(outline);
        BetweenNodes between;
        for (std::size_t i = 0; i < blend.count; ++i) {
            between.nodes.push_back(points[blend.points[i]]);
            between.weights.push_back(blend.weights[i]);
        }
        points[kCentre] = add(std::move(between));
        return points;
    }

    ElementType type_;
    std::span<const NodeIndex> local_;
    Tetrahedra made_;
    std::map<std::pair<NodeIndex, NodeIndex>, std::uint8_t> halves_;
};

}  // namespace

Tetrahedra tetrahedra_of(ElementType type, std::span<const NodeIndex> local) {
    return Divider(type, local).run();
}

const Tetrahedra& whole_tetrahedra(ElementType type) {
    static const auto all = [] {
        std::array<Tetrahedra, kElementTypeCount> made;
        for (std::size_t i = 0; i < made.size(); ++i) {
            const auto each = static_cast<ElementType>(i);
            std::array<NodeIndex, kMaxElementNodes> local{};
            for (std::uint32_t k = 0; k < local.size(); ++k) local[k] = NodeIndex{k};
            if (element_row(each).dimension == 3)
                made[i] = tetrahedra_of(each, std::span(local).first(element_row(each).node_count));
        }
        return made;
    }();
    return all[static_cast<std::size_t>(type)];
}

}  // namespace feelem
