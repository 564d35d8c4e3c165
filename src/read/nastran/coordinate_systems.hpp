// SPDX-License-Identifier: Apache-2.0
// Nastran's coordinate systems (CORD1R ... CORD2S): where grids are, and along which axes they move.
#pragma once

#include "model/rotation.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace feelem::nastran {

enum class SystemKind : std::uint8_t {
    Rectangular,
    Cylindrical,  ///< r, angle in degrees, z.
    Spherical,    ///< r, angle from the z axis, angle round it, in degrees.
};

/// As the CORD card says it: by three points (origin A, B on the z axis, C in the xz plane) or three grids.
struct SystemCard {
    std::int64_t id = 0;
    SystemKind kind = SystemKind::Rectangular;
    std::int64_t reference = 0;           ///< RID of CORD2x: the system of the points.
    std::array<Point3, 3> points{};       ///< CORD2x
    std::array<std::int64_t, 3> grids{};  ///< CORD1x
    bool by_grids = false;
    std::function<std::string()> where;  ///< For messages; may be empty.
};

/// A grid as it stands in its card: in system `system`.
struct GridPlace {
    std::int64_t system = 0;
    Point3 place{};
};

/// All systems of a model, resolved down to the basic one (id 0).
class CoordinateSystems {
public:
    using FindGrid = std::function<std::optional<GridPlace>(std::int64_t id)>;

    /// A repeated id keeps the first definition (reported unless it is the same).
    void add(SystemCard card);
    std::size_t count() const noexcept { return cards_.size(); }
    /// Follows all chains. What cannot be resolved (loops, missing systems or grids, points in one line) is
    /// reported as CoordinateSystem and known() no longer.
    void resolve(const FindGrid& find_grid, Diagnostics& diagnostics);

    bool known(std::int64_t id) const;
    /// Into the basic system; NaN when the system is not known.
    Point3 to_basic(std::int64_t id, const Point3& local) const;
    /// Axes of the system at a place (basic): they turn with it in cylindrical and spherical ones. On the
    /// polar axis those of the angle 0. Basic ones when the system is not known.
    Matrix3 axes_at(std::int64_t id, const Point3& basic) const;
    NodalAngles angles_at(std::int64_t id, const Point3& basic) const;

private:
    struct Frame {
        SystemKind kind = SystemKind::Rectangular;
        Point3 origin{};
        Matrix3 axes{};
    };
    struct Trial;
    bool try_one(const SystemCard& card, const FindGrid& find_grid, Trial& trial) const;
    static std::optional<Frame> frame_of(SystemKind kind, const std::array<Point3, 3>& points);
    void give_up(const SystemCard& card, const std::string& why, Diagnostics& diagnostics);

    std::map<std::int64_t, SystemCard> cards_;
    std::vector<std::int64_t> repeated_;
    std::map<std::int64_t, Frame> frames_;
};

}  // namespace feelem::nastran
