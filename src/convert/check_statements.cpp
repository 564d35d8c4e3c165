// SPDX-License-Identifier: Apache-2.0
// What a scene says of a result, against the inputs: its range over the whole model, its kind.
#include "convert/check_inputs.hpp"
#include "convert/model_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace feelem {
namespace {

std::string text_of(const std::optional<Extreme>& extreme) {
    return extreme ? fmt::format("{} at {}", extreme->value, extreme->id) : "none";
}

bool same(const std::optional<Extreme>& a, const std::optional<Extreme>& b) {
    if (!a || !b) return !a && !b;
    return a->value == b->value && a->id == b->id;
}

/// Scenes know no parts' own nodes: they say that such values are at nodes.
Location as_in_a_scene(Location location) {
    return location == Location::PartNodal ? Location::Nodal : location;
}

}  // namespace

void count_statements(
    const Mesh& mesh, const Result& result, const SceneResult& scene, const SceneValues& values, Tally& tally
) {
    std::uint64_t missing = 0;
    std::optional<Extreme> min, max;
    for (std::size_t c = 0; c < result.component_count(); ++c) {
        const ComponentRange range = range_over_model(mesh, result, c);
        missing = std::max(missing, range.missing);
        if (result.component_count() != 1 || range.valid == 0) continue;
        min = Extreme{range.min, range.min_id};
        max = Extreme{range.max, range.max_id};
    }
    tally.count(same(min, values.min), [&] {
        return fmt::format("minimum over the model: {} instead of {}", text_of(values.min), text_of(min));
    });
    tally.count(same(max, values.max), [&] {
        return fmt::format("maximum over the model: {} instead of {}", text_of(values.max), text_of(max));
    });
    tally.count(missing == values.missing_in_model, [&] {
        return fmt::format("missing over the model: {} instead of {}", values.missing_in_model, missing);
    });
    tally.count(as_in_a_scene(result.info.location) == as_in_a_scene(scene.location), [] {
        return std::string("the inputs have it elsewhere: at nodes, elements or elements' nodes");
    });
    tally.count(result.info.averaging == scene.averaging, [] {
        return std::string("the scene says that it is averaged in another way");
    });
    const bool is_tensor = scene.shape == Shape::SymmetricTensor;
    tally.count(scene.shear == (is_tensor ? result.info.shear : Shear::NotApplicable), [] {
        return std::string("the scene says that its shear is of another kind");
    });
}

}  // namespace feelem
