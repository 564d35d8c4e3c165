// SPDX-License-Identifier: Apache-2.0
#include "convert/scene_target.hpp"

#include <algorithm>

namespace feelem {

std::optional<SceneTarget> find_presented(
    const std::vector<const SceneResult*>& results, const PresentedResult& wanted
) {
    std::optional<SceneTarget> best;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const SceneResult& scene = *results[i];
        const auto component = std::ranges::find(scene.components, wanted.component);
        if (scene.quantity != wanted.name || component == scene.components.end()) continue;
        const bool is_plain = scene.complex == Complex::No && scene.layer == Layer::No;
        if (best && !is_plain) continue;
        best = SceneTarget{i, static_cast<std::size_t>(component - scene.components.begin())};
        if (is_plain) return best;
    }
    return best;
}

}  // namespace feelem
