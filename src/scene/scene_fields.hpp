// SPDX-License-Identifier: Apache-2.0
// Results as accessors: values bit for bit, masks, texture coordinates, displacements of the shape.
#pragma once

#include "scene/scene_build.hpp"

#include <string>
#include <vector>

namespace feelem {

/// `_TEMPERATURE` for each result: unique whatever the case, never a name with a meaning of its own.
std::vector<std::string> name_attributes(const std::vector<SceneResult>& results);

/// Names of a result's accessors without part and step, and the components that each of them takes.
struct AttributeSlot {
    std::string name;    ///< "_STRESS_NORMAL"
    unsigned first = 0;  ///< Component.
    unsigned count = 1;
};
std::vector<AttributeSlot> attribute_slots(const SceneResult& result, const std::string& attribute);

/// Id of a step in the scene: from 1.
inline std::size_t step_id(const SceneValues& values) {
    return values.step + 1;
}

/// Asks for each field once and writes all that the scene makes of it. Fields of the side files go there.
void write_fields(SceneBuild& build, SceneFiles& files);

}  // namespace feelem
