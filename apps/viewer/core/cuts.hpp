// SPDX-License-Identifier: Apache-2.0
// What planes leave of a model and of a ray through it.
#pragma once

#include "viewer/core/look.hpp"

#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace feelem::viewer {

/// Model units minus the scene's origin.
bool is_cut_away(std::span<const CutPlane> cuts, const glm::dvec3& place);

struct KeptRange {
    double enters = 0, leaves = 0;
};
/// Where a ray is in what the planes leave; empty where it never is.
std::optional<KeptRange> kept_range(
    std::span<const CutPlane> cuts, const glm::dvec3& origin, const glm::dvec3& direction
);

}  // namespace feelem::viewer
