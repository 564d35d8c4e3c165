// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/scene_source.hpp"

namespace feelem::viewer {

ModelSource source_of(LoadedScene& scene) {
    const Geometry& geometry = scene.geometry();
    ModelSource source;
    source.about = &scene.about();
    ModelArrays& arrays = source.arrays;
    for (const PartRange& part : geometry.parts)
        arrays.parts.push_back({part.first_vertex, part.vertices, part.first_triangle, part.triangles});
    arrays.positions = geometry.positions;
    arrays.triangles = geometry.triangles;
    arrays.node_ids = geometry.node_ids;
    arrays.element_ids = geometry.element_ids;
    arrays.low = geometry.low;
    arrays.high = geometry.high;
    arrays.to_metres = scene.to_metres();
    source.values = [&scene](std::size_t result, std::size_t values) {
        const FieldValues& field = scene.values(result, values);
        return FieldSpan{field.components, field.values, field.validity};
    };
    return source;
}

}  // namespace feelem::viewer
