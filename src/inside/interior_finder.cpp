// SPDX-License-Identifier: Apache-2.0
// Which element a place is in: boxes of eight elements, of eight boxes, and so on; then Newton's method.
#include "base/parallel.hpp"
#include "inside/element_values.hpp"
#include "model/shape_functions.hpp"
#include "model/vector.hpp"

#include "feelem/inside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem {
struct PlaceBox {
    std::array<float, 3> low, high;

    static PlaceBox empty() {
        constexpr float kFar = std::numeric_limits<float>::infinity();
        return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    }
    void add(const PlaceBox& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], other.low[axis]);
            high[axis] = std::max(high[axis], other.high[axis]);
        }
    }
    bool has(const Point3& place) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (place[axis] < static_cast<double>(low[axis]) || place[axis] > static_cast<double>(high[axis]))
                return false;
        }
        return true;
    }
};

namespace {

/// Of the reference element, whose edges have length 1: so far outside a place still belongs to it.
constexpr double kTolerance = 1e-6;
constexpr std::size_t kFan = 8;

/// Weights of the corners at the place where each further node of the reference element is.
const std::vector<ShapeWeights>& straight_weights(ElementType type) {
    static const auto all = [] {
        std::array<std::vector<ShapeWeights>, kElementTypeCount> made;
        for (std::size_t t = 0; t < made.size(); ++t) {
            const ElementRow& row = element_row(static_cast<ElementType>(t));
            for (std::size_t i = row.corner_count; i < row.node_count; ++i) {
                const auto& at = row.reference[i];
                made[t].push_back(shape_at(row.linear, {at[0], at[1], at[2]}));
            }
        }
        return made;
    }();
    return all[static_cast<std::size_t>(type)];
}

/// Holds the whole element however it is bent: its places are those of its corners' element, and each further
/// node takes them at most as far from there as it is itself.
std::optional<PlaceBox> box_of(
    ElementType type, std::span<const NodeIndex> nodes, std::span<const Point3> places
) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Point3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar}, beyond{};
    const std::size_t corners = element_row(type).corner_count;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i] == kNoNode) continue;
        const Point3& place = places[raw(nodes[i])];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(place[axis])) return std::nullopt;
            if (i < corners) {
                low[axis] = std::min(low[axis], place[axis]);
                high[axis] = std::max(high[axis], place[axis]);
                continue;
            }
            double off = place[axis];
            for (std::size_t c = 0; c < corners; ++c)
                off -= straight_weights(type)[i - corners][c] * places[raw(nodes[c])][axis];
            beyond[axis] += std::abs(off);
        }
    }
    PlaceBox box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double more = beyond[axis] + 1e-5 * (high[axis] - low[axis]);
        box.low[axis] = std::nextafterf(static_cast<float>(low[axis] - more), -kFar);
        box.high[axis] = std::nextafterf(static_cast<float>(high[axis] + more), kFar);
    }
    return box;
}

/// Bits of the three numbers below 2^21 between each other.
std::uint64_t interleaved(const std::array<std::uint32_t, 3>& numbers) {
    std::uint64_t code = 0;
    for (unsigned bit = 0; bit < 21; ++bit) {
        for (unsigned axis = 0; axis < 3; ++axis)
            code |= static_cast<std::uint64_t>((numbers[axis] >> bit) & 1U) << (3 * bit + axis);
    }
    return code;
}

}  // namespace

struct InteriorFinder::Tree {
    explicit Tree(const Solids& from) : solids(from) {}

    const Solids& solids;
    std::vector<std::uint32_t> first_of_block;
    std::vector<std::uint32_t> elements;  ///< Along a curve that keeps neighbours together.
    std::vector<std::vector<PlaceBox>>
        levels;  ///< The first has a box for eight elements each, the last has one box.

    SolidRef solid(std::uint32_t element) const {
        const auto after = std::upper_bound(first_of_block.begin(), first_of_block.end(), element);
        const auto block = static_cast<std::size_t>(after - first_of_block.begin()) - 1;
        return {&solids.mesh->blocks[block], element - first_of_block[block], ElementIndex{element}};
    }

    void build();
    std::vector<std::pair<std::uint32_t, PlaceBox>> boxed_elements() const;
    /// Elements whose boxes have the place, in no order.
    std::vector<std::uint32_t> candidates(const Point3& place) const;
};

std::vector<std::pair<std::uint32_t, PlaceBox>> InteriorFinder::Tree::boxed_elements() const {
    std::vector<std::pair<std::uint32_t, PlaceBox>> out;
    out.reserve(solids.count);
    for (std::size_t b = 0; b < solids.mesh->blocks.size(); ++b) {
        const ElementBlock& block = solids.mesh->blocks[b];
        if (element_row(block.type).dimension != 3) continue;
        for (std::size_t i = 0; i < block.ids.size(); ++i) {
            const auto element = first_of_block[b] + static_cast<std::uint32_t>(i);
            if (solids.set_aside[element]) continue;
            const SolidRef ref{&block, i, ElementIndex{element}};
            if (const auto box = box_of(block.type, ref.nodes(), solids.places()))
                out.emplace_back(element, *box);
        }
    }
    return out;
}

void InteriorFinder::Tree::build() {
    std::uint32_t before = 0;
    for (const ElementBlock& block : solids.mesh->blocks) {
        first_of_block.push_back(before);
        before += static_cast<std::uint32_t>(block.ids.size());
    }
    const auto boxed = boxed_elements();
    PlaceBox whole = PlaceBox::empty();
    for (const auto& [element, box] : boxed) whole.add(box);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(boxed.size());  // code, place in `boxed`
    parallel_chunks(boxed.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            std::array<std::uint32_t, 3> cell{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const PlaceBox& box = boxed[i].second;
                const double low = static_cast<double>(whole.low[axis]);
                const double size = static_cast<double>(whole.high[axis]) - low;
                const double middle =
                    (static_cast<double>(box.low[axis]) + static_cast<double>(box.high[axis])) / 2;
                const double share = size > 0 ? std::clamp((middle - low) / size, 0.0, 1.0) : 0;
                cell[axis] = static_cast<std::uint32_t>(share * ((1U << 21U) - 1));
            }
            order[i] = {interleaved(cell), static_cast<std::uint32_t>(i)};
        }
    });
    std::ranges::sort(order);
    elements.reserve(order.size());
    std::vector<PlaceBox>& leaves = levels.emplace_back();
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i % kFan == 0) leaves.push_back(PlaceBox::empty());
        leaves.back().add(boxed[order[i].second].second);
        elements.push_back(boxed[order[i].second].first);
    }
    while (levels.back().size() > 1) {
        std::vector<PlaceBox> above;
        for (std::size_t i = 0; i < levels.back().size(); ++i) {
            if (i % kFan == 0) above.push_back(PlaceBox::empty());
            above.back().add(levels.back()[i]);
        }
        levels.push_back(std::move(above));
    }
}

std::vector<std::uint32_t> InteriorFinder::Tree::candidates(const Point3& place) const {
    std::vector<std::uint32_t> found;
    std::vector<std::pair<std::size_t, std::size_t>> open;  // level, box
    if (!elements.empty()) open.emplace_back(levels.size() - 1, 0);
    while (!open.empty()) {
        const auto [level, number] = open.back();
        open.pop_back();
        if (!levels[level][number].has(place)) continue;
        const std::size_t below = level == 0 ? elements.size() : levels[level - 1].size();
        for (std::size_t i = number * kFan; i < std::min((number + 1) * kFan, below); ++i) {
            if (level > 0) {
                open.emplace_back(level - 1, i);
                continue;
            }
            const SolidRef ref = solid(elements[i]);
            const auto box = box_of(ref.block->type, ref.nodes(), solids.places());
            if (box && box->has(place)) found.push_back(elements[i]);
        }
    }
    return found;
}

InteriorFinder::InteriorFinder(const Solids& solids) {
    auto tree = std::make_unique<Tree>(solids);
    tree->build();
    tree_ = std::move(tree);
}

InteriorFinder::~InteriorFinder() = default;

std::optional<InteriorPlace> InteriorFinder::find(const Point3& place) const {
    std::vector<std::uint32_t> candidates = tree_->candidates(place);
    std::ranges::sort(candidates);
    for (const std::uint32_t element : candidates) {
        const SolidRef solid = tree_->solid(element);
        const auto nodes = solid.nodes();
        const auto natural = find_natural(solid.block->type, nodes, tree_->solids.places(), place);
        if (!natural || depth_inside(solid.block->type, *natural) < -kTolerance) continue;
        const ShapeWeights weights = shape_at(solid.block->type, nodes, *natural);
        InteriorPlace found;
        found.element = solid.index;
        found.natural = *natural;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i] == kNoNode) continue;
            found.nodes.push_back(nodes[i]);
            found.weights.push_back(weights[i]);
        }
        return found;
    }
    return std::nullopt;
}

InteriorValue value_at(const Mesh& mesh, const FieldOf& field, const InteriorPlace& place) {
    const ElementValues values(mesh, field);
    std::size_t before = 0;
    std::size_t block = 0;
    while (raw(place.element) >= before + mesh.blocks[block].ids.size())
        before += mesh.blocks[block++].ids.size();
    const SolidRef solid{&mesh.blocks[block], raw(place.element) - before, place.element};
    std::array<double, kMaxElementNodes> at_nodes{};
    values.gather(solid, at_nodes);
    InteriorValue out;
    double sum = 0;
    const auto nodes = solid.nodes();
    for (std::size_t i = 0, k = 0; i < nodes.size(); ++i) {
        if (nodes[i] == kNoNode) continue;
        out.node_values.push_back(static_cast<float>(at_nodes[i]));
        if (place.weights[k] != 0) sum += place.weights[k] * at_nodes[i];
        ++k;
    }
    out.value = static_cast<float>(values.is_elemental() ? at_nodes[0] : sum);
    return out;
}

}  // namespace feelem
