// SPDX-License-Identifier: Apache-2.0
// What is said of a place inside.
#pragma once

#include "feelem/inside.hpp"

#include <optional>
#include <span>
#include <string>

namespace feelem {

struct InteriorReading {
    std::string result, component, unit;
    bool is_elemental = false;
    InteriorValue value;  ///< Nothing where there is no solid.
};

std::string interior_json(
    const Mesh& mesh,
    const Point3& place,
    const std::optional<InteriorPlace>& found,
    std::span<const InteriorReading> readings
);

}  // namespace feelem
