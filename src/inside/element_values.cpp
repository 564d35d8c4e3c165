// SPDX-License-Identifier: Apache-2.0
#include "inside/element_values.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace feelem {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

const Result& checked(const FieldOf& field) {
    if (field.result == nullptr || field.component >= field.result->component_count()) {
        throw Error(Code::BadOption, "", fmt::format("the result has no component {}", field.component));
    }
    return *field.result;
}

}  // namespace

std::span<const NodeIndex> SolidRef::nodes() const {
    const std::size_t count = element_row(block->type).node_count;
    return std::span(block->nodes).subspan(position * count, count);
}

ElementValues::ElementValues(const Mesh& mesh, const FieldOf& field)
    : result_(checked(field)), component_(field.component), rows_(result_, mesh.node_count()) {}

bool ElementValues::is_elemental() const noexcept {
    return result_.info.location == Location::Elemental;
}

double ElementValues::value_of(NodeIndex node, const ResultPlace& place) const {
    if (node == kNoNode) return kMissing;
    const std::size_t row = rows_.find(node, place);
    if (row == kNoRow) return kMissing;
    return static_cast<double>(result_.values[row * result_.component_count() + component_]);
}

void ElementValues::gather(const SolidRef& solid, std::span<double> out) const {
    const auto nodes = solid.nodes();
    const ResultPlace place{solid.block->parts[solid.position], solid.index};
    for (std::size_t i = 0; i < nodes.size(); ++i) out[i] = value_of(nodes[i], place);
    if (!result_.info.corner_only) return;
    for (const EdgeRow& edge : edges_of(solid.block->type)) {
        if (edge.middle == kNoLocalNode || !std::isnan(out[edge.middle])) continue;
        out[edge.middle] = static_cast<double>(
            middle_value(static_cast<float>(out[edge.first]), static_cast<float>(out[edge.second]))
        );
    }
}

}  // namespace feelem
