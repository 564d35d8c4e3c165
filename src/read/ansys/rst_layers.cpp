// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_layers.hpp"

#include <algorithm>
#include <cstdint>

namespace feelem::rst {
namespace {

/// The order of a shell's surfaces, proved on real files by the curvature of their solutions. Other shells,
/// all of them old, were not to be had.
enum class SurfaceOrder : std::uint8_t {
    Unknown,
    BottomFirst,
    TopFirst
};
SurfaceOrder surface_order(std::int32_t routine) {
    if (routine == 181 || routine == 281) return SurfaceOrder::BottomFirst;
    return routine == 63 ? SurfaceOrder::TopFirst : SurfaceOrder::Unknown;
}

}  // namespace

std::optional<RowPlan> plan_shell(const ElementKindOfFile& kind, std::size_t rows, Layer layer) {
    const std::size_t n = kind.result_nodes;
    const SurfaceOrder order = surface_order(kind.routine);
    if (rows == 0 || rows % n != 0 || order == SurfaceOrder::Unknown) return std::nullopt;
    const std::size_t surfaces = rows / n;
    RowPlan plan;
    std::size_t surface = 0;
    if (surfaces > 1) {
        const bool has_middles = surfaces != 2 && kind.keyopt(8) == 2 && order == SurfaceOrder::BottomFirst;
        const std::size_t in_layer = has_middles ? 3 : 2;
        if (surfaces % in_layer != 0 || (surfaces > 2 && order == SurfaceOrder::TopFirst))
            return std::nullopt;
        plan.layers = surfaces / in_layer;
        const bool top_first = order == SurfaceOrder::TopFirst;
        switch (layer) {
        case Layer::Bottom: surface = top_first ? 1 : 0; break;
        case Layer::Top: surface = top_first ? 0 : (plan.layers - 1) * in_layer + 1; break;
        default:
            // The middle of several layers is none of theirs.
            if (!has_middles || plan.layers != 1) return RowPlan{};
            surface = 2;
        }
    }
    for (std::size_t k = 0; k < n; ++k) plan.corners.push_back({surface * n + k, layer == Layer::Top});
    return plan;
}

std::optional<RowPlan> plan_solid(const ElementKindOfFile& kind, std::size_t rows) {
    const std::size_t n = kind.result_nodes;
    if (rows == 0 || rows % n != 0) return std::nullopt;
    RowPlan plan;
    plan.layers = rows / n;
    if (plan.layers > 1 && n != 8) return std::nullopt;
    for (std::size_t k = 0; k < n; ++k) {
        const bool top = k >= n / 2;
        plan.corners.push_back({(top ? plan.layers - 1 : 0) * n + k, top});
    }
    return plan;
}

bool ElementAxes::read(
    std::span<const double> angles, std::span<const NodeIndex> corners, std::size_t layers
) {
    angles_ = angles;
    rows_.clear();
    layers_first_ = 0;
    is_global_ = std::ranges::all_of(angles, [](double angle) { return angle == 0; });
    if (is_global_) return true;
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
        const auto first = std::ranges::find(corners.first(k), corners[k]);
        const auto at = static_cast<std::size_t>(first - corners.begin());
        rows_.push_back(at < k ? rows_[at] : distinct());
    }
    const std::size_t distinct_corners = distinct();
    if (angles.size() == 3) {
        std::ranges::fill(rows_, 0);
        return true;
    }
    // Rows of the outer surfaces alone (KEYOPT(8)=0) still have the angles of all layers.
    const auto fits = [&](std::size_t nodes) {
        const std::size_t further = angles.size() - std::min(angles.size(), 3 * nodes);
        return angles.size() >= 3 * nodes && (further == 0 || layers == 1 || further == layers);
    };
    const bool of_distinct = layers > 1 && angles.size() == 3 * distinct_corners + layers;
    if (fits(n) && !of_distinct) {
        for (std::size_t k = 0; k < n; ++k) rows_[k] = k;
        layers_first_ = 3 * n;
        return true;
    }
    layers_first_ = 3 * distinct_corners;
    return fits(distinct_corners);
}

Matrix3 ElementAxes::axes(std::size_t corner, bool in_last_layer) const {
    const std::size_t at = 3 * rows_[corner];
    const Matrix3 element = nodal_axes({angles_[at], angles_[at + 1], angles_[at + 2]});
    if (layers_first_ == 0 || layers_first_ >= angles_.size()) return element;
    const double turn = in_last_layer ? angles_.back() : angles_[layers_first_];
    return turn == 0 ? element : product(element, nodal_axes({turn, 0, 0}));
}

std::size_t ElementAxes::distinct() const {
    return rows_.empty() ? 0 : *std::ranges::max_element(rows_) + 1;
}

}  // namespace feelem::rst
