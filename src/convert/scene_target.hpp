// SPDX-License-Identifier: Apache-2.0
// From what a presentation names to the scene's result and component.
#pragma once

#include "feelem/scene.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace feelem {

struct SceneTarget {
    std::size_t result = 0;
    std::size_t component = 0;
};

/// The layer that is wanted, if one is. Plain results are preferred to parts of complex ones and to layers,
/// and the averaging that is said; the first one on a tie.
std::optional<SceneTarget> find_presented(
    const std::vector<const SceneResult*>& results, const PresentedResult& wanted
);

}  // namespace feelem
