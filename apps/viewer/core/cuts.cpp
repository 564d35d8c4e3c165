// SPDX-License-Identifier: Apache-2.0
#include "viewer/core/cuts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace feelem::viewer {

bool is_cut_away(std::span<const CutPlane> cuts, const glm::dvec3& place) {
    return std::any_of(cuts.begin(), cuts.end(), [&](const CutPlane& cut) {
        return glm::dot(glm::dvec3(cut.normal), place) > static_cast<double>(cut.offset);
    });
}

std::optional<KeptRange> kept_range(
    std::span<const CutPlane> cuts, const glm::dvec3& origin, const glm::dvec3& direction
) {
    KeptRange range{0, std::numeric_limits<double>::infinity()};
    for (const CutPlane& cut : cuts) {
        const glm::dvec3 normal(cut.normal);
        const double rise = glm::dot(normal, direction);
        const double room = static_cast<double>(cut.offset) - glm::dot(normal, origin);
        if (rise == 0) {
            if (room < 0) return std::nullopt;
        } else if (rise > 0) {
            range.leaves = std::min(range.leaves, room / rise);
        } else {
            range.enters = std::max(range.enters, room / rise);
        }
    }
    if (range.enters < range.leaves) return range;
    return std::nullopt;
}

}  // namespace feelem::viewer
