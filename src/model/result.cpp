// SPDX-License-Identifier: Apache-2.0
#include "feelem/result.hpp"

#include <algorithm>
#include <cmath>

namespace feelem {

std::string_view word(StepKind kind) {
    switch (kind) {
    case StepKind::Static: return "static";
    case StepKind::Time: return "time";
    case StepKind::Mode: return "mode";
    case StepKind::Frequency: return "frequency";
    case StepKind::Buckling: return "buckling";
    case StepKind::Other: return "other";
    }
    return "other";
}

std::string_view word(Location location) {
    switch (location) {
    case Location::Nodal: return "nodal";
    case Location::PartNodal: return "part_nodal";
    case Location::Elemental: return "elemental";
    case Location::ElementNodal: return "element_nodal";
    }
    return "nodal";
}

std::string_view word(Averaging averaging) {
    switch (averaging) {
    case Averaging::NotApplicable: return "";
    case Averaging::Solver: return "solver";
    case Averaging::Part: return "part";
    case Averaging::All: return "all";
    case Averaging::None: return "none";
    }
    return "";
}

std::string_view word(Complex complex) {
    switch (complex) {
    case Complex::No: return "";
    case Complex::Real: return "real";
    case Complex::Imaginary: return "imaginary";
    case Complex::Amplitude: return "amplitude";
    case Complex::Phase: return "phase";
    }
    return "";
}

std::string_view word(Layer layer) {
    switch (layer) {
    case Layer::No: return "";
    case Layer::Top: return "top";
    case Layer::Middle: return "middle";
    case Layer::Bottom: return "bottom";
    }
    return "";
}

std::string_view word(Shear shear) {
    switch (shear) {
    case Shear::NotApplicable: return "";
    case Shear::Engineering: return "engineering";
    case Shear::Tensor: return "tensor";
    }
    return "";
}

int component_index(const ResultInfo& info, std::string_view name) {
    const auto found = std::ranges::find(info.components, name);
    return found == info.components.end() ? -1 : static_cast<int>(found - info.components.begin());
}

Range range_of(const Result& result, std::size_t component) {
    Range range;
    const std::size_t width = result.component_count();
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const float value = result.values[row * width + component];
        if (std::isnan(value)) continue;
        if (range.valid == 0 || value < range.min) {
            range.min = value;
            range.min_row = row;
        }
        if (range.valid == 0 || value > range.max) {
            range.max = value;
            range.max_row = row;
        }
        ++range.valid;
    }
    return range;
}

}  // namespace feelem
