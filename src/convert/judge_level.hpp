// SPDX-License-Identifier: Apache-2.0
// A level of detail against every result and step that it serves, by the independent checker: the same when
// the level is made and when a scene is checked.
#pragma once

#include "feelem/lod.hpp"
#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace feelem {

/// Values of one result at one step, component by component, per vertex; NaN = missing.
using ComponentValues = std::vector<std::vector<float>>;

struct LevelJudgement {
    struct Value {
        std::vector<double> shown;   ///< Per component: the largest difference at any original vertex.
        bool keeps_extremes = true;  ///< Lowest and highest value of every component are drawn as they are.
    };
    std::vector<Value> values;
    double max_distance =
        0;  ///< Of any original vertex to the level, of any triangle's middle to the original.
    std::uint64_t without_place = 0;
    std::uint64_t invented = 0, lost = 0;  ///< Values where there are none, and the other way round.
};

/// Looks at `count` results and steps; `load(i)` is asked for each once, in order.
LevelJudgement judge_level(
    const LodSurface& surface,
    std::span<const std::array<VertexIndex, 3>> level,
    double distance,
    std::size_t count,
    const std::function<ComponentValues(std::size_t)>& load
);

/// The error of a whole value: of vectors the length of the difference at most, else the largest component's.
double error_of_value(Shape shape, std::span<const double> components);

}  // namespace feelem
