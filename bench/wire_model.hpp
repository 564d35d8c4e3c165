// SPDX-License-Identifier: Apache-2.0
// What the codecs are compared on: a surface in the order in which scenes pack it, and its result beside it.
#pragma once

#include "lod_models.hpp"

#include "feelem/skin.hpp"

#include <time.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace feelem::bench {

inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of 25: what else the machine does can only add to it.
template <class Work>
double least_time(const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 25; ++round) {
        const double begin = processor_seconds();
        work();
        least = std::min(least, processor_seconds() - begin);
    }
    return least;
}

/// A surface in the order in which scenes pack it, and its result beside it.
struct Drawn {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    std::array<float, 2> range{};
};

inline Drawn drawn(const LodModel& model) {
    Surface surface;
    const auto vertices = static_cast<std::uint32_t>(model.positions.size());
    SurfacePart part;
    part.vertex_count = vertices;
    part.triangle_count = static_cast<std::uint32_t>(model.triangles.size());
    surface.parts.push_back(part);
    surface.positions = model.positions;
    surface.triangles = model.triangles;
    surface.triangle_element.resize(model.triangles.size());
    surface.normals.resize(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) surface.vertex_node.push_back(NodeIndex{v});
    order_for_drawing(surface);
    Drawn out;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const Point3& at = surface.positions[v];
        out.positions.push_back(
            {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])}
        );
        out.values.push_back(model.fields[0][raw(surface.vertex_node[v])]);
    }
    for (const auto& triangle : surface.triangles) {
        for (const VertexIndex corner : triangle) out.indices.push_back(raw(corner));
    }
    const auto [low, high] = std::ranges::minmax_element(out.values);
    out.range = {*low, *high};
    return out;
}

/// "sheet SIDE" or "MODEL.frd"; nothing for anything else.
inline std::optional<Drawn> drawn_model(const std::vector<std::string>& given) {
    if (given.size() == 2 && given[0] == "sheet")
        return drawn(wavy_sheet(static_cast<std::uint32_t>(std::stoul(given[1])), 0.6));
    if (given.size() == 1) return drawn(refined_model(given[0]));
    return std::nullopt;
}

}  // namespace feelem::bench
