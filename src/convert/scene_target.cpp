// SPDX-License-Identifier: Apache-2.0
#include "convert/scene_target.hpp"

#include <algorithm>

namespace feelem {

namespace {

/// How well a result is what was meant, beyond its name: the first of the best is taken. 0: it is not.
int fitness(const SceneResult& result, const PresentedResult& wanted) {
    if (!wanted.layer.empty() && word(result.layer) != wanted.layer) return 0;
    int fits = 1;
    if (result.complex == Complex::No) fits += 8;
    if (result.layer == Layer::No || !wanted.layer.empty()) fits += 4;
    if (!wanted.averaging.empty() && word(result.averaging) == wanted.averaging) fits += 2;
    return fits;
}

}  // namespace

std::optional<SceneTarget> find_presented(
    const std::vector<const SceneResult*>& results, const PresentedResult& wanted
) {
    std::optional<SceneTarget> best;
    int most = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const SceneResult& scene = *results[i];
        const auto component = std::ranges::find(scene.components, wanted.component);
        if (scene.quantity != wanted.name || component == scene.components.end()) continue;
        const int fits = fitness(scene, wanted);
        if (fits <= most) continue;
        most = fits;
        best = SceneTarget{i, static_cast<std::size_t>(component - scene.components.begin())};
    }
    return best;
}

}  // namespace feelem
