// SPDX-License-Identifier: Apache-2.0
// Coordinate systems of universal files (dataset 2420).
#pragma once

#include "base/input.hpp"
#include "read/unv/unv_datasets.hpp"

#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <map>

namespace feelem::unv {

/// Rows 0 to 2: the axes, row 3: the origin, in the part's system.
struct System {
    std::int64_t type = 0;  ///< 0 Cartesian, 1 cylindrical, 2 spherical (angles in degrees).
    std::array<Point3, 4> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

    bool is_global() const { return type == 0 && rows == System{}.rows; }
    /// Coordinates in this system -> in the part's.
    Point3 to_part(const Point3& local) const;
};

/// By number. Throws Error on damaged records.
std::map<std::int64_t, System> read_systems(const Input& input, const Dataset& dataset);

}  // namespace feelem::unv
