// SPDX-License-Identifier: Apache-2.0
// One conversion while it is made, and the kinds of output it may have.
#pragma once

#include "convert/scene_plan.hpp"

#include "feelem/convert.hpp"
#include "feelem/surface.hpp"

#include <cstdint>

namespace feelem {

/// A model opened for one output, with what was chosen of it.
struct Work {
    const Job& job;
    Diagnostics& diagnostics;
    const Progress& progress;
    ModelSource& source;
    ScenePlan plan;
    const EarlyShape& early;
};

/// The skin that the plan needs.
Surface skin_of(const Work& work);

/// Says how many mid-side values are means of their edge's corners.
void report_interpolation(const Work& work, std::uint64_t interpolated);

void write_as_scene(Work& work);
void write_as_ply(Work& work);
void write_as_vtu(Work& work);

}  // namespace feelem
