// SPDX-License-Identifier: Apache-2.0
// Must: place every grid exactly where the solver does, whatever chain of systems its card hangs on.
// Assumes: nothing about order, loops or missing cards.
// Algorithm: depth-first over "needs the system ...", with an explicit stack, so that a chain of a million
// cards is no deeper than its memory.
// Data: a frame (origin, axes) in the basic system a card.
#include "read/nastran/coordinate_systems.hpp"

#include "model/vector.hpp"
#include "read/nodal_angles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

namespace feelem::nastran {
namespace {

constexpr Matrix3 kBasicAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Point3 column(const Matrix3& axes, std::size_t j) {
    return {axes[0][j], axes[1][j], axes[2][j]};
}

/// Local coordinates of any kind as local Cartesian ones.
Point3 cartesian(SystemKind kind, const Point3& q) {
    if (kind == SystemKind::Rectangular) return q;
    const auto [sine, cosine] = sine_and_cosine(q[1]);
    if (kind == SystemKind::Cylindrical) return {q[0] * cosine, q[0] * sine, q[2]};
    const auto [sine_round, cosine_round] = sine_and_cosine(q[2]);
    return {q[0] * sine * cosine_round, q[0] * sine * sine_round, q[0] * cosine};
}

bool same_card(const SystemCard& a, const SystemCard& b) {
    return a.kind == b.kind && a.reference == b.reference && a.by_grids == b.by_grids &&
           a.points == b.points && a.grids == b.grids;
}

}  // namespace

/// What came of looking at one card.
struct CoordinateSystems::Trial {
    std::optional<Frame> frame;
    std::optional<std::int64_t> needs;  ///< A system that is to be resolved first.
    std::string why;                    ///< Why there is no frame.
};

void CoordinateSystems::add(SystemCard card) {
    const auto [at, is_new] = cards_.emplace(card.id, card);
    if (!is_new && !same_card(at->second, card)) repeated_.push_back(card.id);
}

bool CoordinateSystems::known(std::int64_t id) const {
    return id == 0 || frames_.contains(id);
}

std::optional<CoordinateSystems::Frame> CoordinateSystems::frame_of(
    SystemKind kind, const std::array<Point3, 3>& points
) {
    const Point3 along = minus(points[1], points[0]);
    const Point3 aside = minus(points[2], points[0]);
    const auto z = direction(along, 0);
    if (!z) return {};
    const auto y = direction(cross(*z, aside), length(aside));
    if (!y) return {};
    return Frame{kind, points[0], from_columns(cross(*y, *z), *y, *z)};
}

bool CoordinateSystems::try_one(const SystemCard& card, const FindGrid& find_grid, Trial& trial) const {
    std::array<Point3, 3> points{};
    for (std::size_t i = 0; i < 3; ++i) {
        GridPlace place{card.reference, card.points[i]};
        if (card.by_grids) {
            const auto grid = find_grid(card.grids[i]);
            if (!grid) {
                trial.why = fmt::format("its grid {} is missing", card.grids[i]);
                return false;
            }
            place = *grid;
        }
        if (!known(place.system)) {
            trial.needs = place.system;
            return false;
        }
        points[i] = to_basic(place.system, place.place);
    }
    trial.frame = frame_of(card.kind, points);
    if (!trial.frame) trial.why = "its three points are in one line";
    return trial.frame.has_value();
}

void CoordinateSystems::give_up(const SystemCard& card, const std::string& why, Diagnostics& diagnostics) {
    diagnostics.add(
        Code::CoordinateSystem,
        card.where ? card.where : [] { return std::string(); },
        fmt::format(
            "coordinate system {} cannot be used: {}. Grids placed in it have no place, values along it stay "
            "as they are",
            card.id,
            why
        )
    );
}

void CoordinateSystems::resolve(const FindGrid& find_grid, Diagnostics& diagnostics) {
    std::set<std::int64_t> waiting, hopeless;
    for (const std::int64_t id : repeated_) {
        diagnostics.add(
            Code::CoordinateSystem,
            std::string(),
            fmt::format("coordinate system {} is defined twice, differently; the first counts", id)
        );
    }
    for (const auto& [first, unused] : cards_) {
        std::vector<std::int64_t> stack{first};
        while (!stack.empty()) {
            const std::int64_t id = stack.back();
            const SystemCard& card = cards_.at(id);
            Trial trial;
            if (known(id) || hopeless.contains(id)) {
                // Resolved on the way to another one.
            } else if (try_one(card, find_grid, trial)) {
                frames_.emplace(id, *trial.frame);
            } else if (trial.needs && cards_.contains(*trial.needs) && !waiting.contains(*trial.needs) &&
                       !hopeless.contains(*trial.needs) && *trial.needs != id) {
                waiting.insert(id);
                stack.push_back(*trial.needs);
                continue;
            } else {
                if (trial.needs) {
                    const bool missing = !cards_.contains(*trial.needs);
                    const bool loop = !missing && !hopeless.contains(*trial.needs);
                    trial.why = fmt::format(
                        "it refers to system {}, which {}",
                        *trial.needs,
                        missing ? "is missing" : (loop ? "refers back to it" : "cannot be used")
                    );
                }
                hopeless.insert(id);
                give_up(card, trial.why, diagnostics);
            }
            waiting.erase(id);
            stack.pop_back();
        }
    }
}

Point3 CoordinateSystems::to_basic(std::int64_t id, const Point3& local) const {
    if (id == 0) return local;
    const auto found = frames_.find(id);
    if (found == frames_.end()) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        return {kNone, kNone, kNone};
    }
    const Frame& frame = found->second;
    const Point3 p = to_global(frame.axes, cartesian(frame.kind, local));
    return {p[0] + frame.origin[0], p[1] + frame.origin[1], p[2] + frame.origin[2]};
}

Matrix3 CoordinateSystems::axes_at(std::int64_t id, const Point3& basic) const {
    const auto found = frames_.find(id);
    if (found == frames_.end()) return kBasicAxes;
    const Frame& frame = found->second;
    if (frame.kind == SystemKind::Rectangular) return frame.axes;
    const Point3 from = minus(basic, frame.origin);
    const Point3 x = column(frame.axes, 0), y = column(frame.axes, 1), z = column(frame.axes, 2);
    const double scale = std::sqrt(dot(from, from));
    const double along = dot(from, z);
    const Point3 across{from[0] - along * z[0], from[1] - along * z[1], from[2] - along * z[2]};
    const Point3 radial = direction(across, 1e3 * scale).value_or(x);
    const Point3 round = cross(z, radial);
    if (frame.kind == SystemKind::Cylindrical) return from_columns(radial, round, z);
    const auto outward = direction(from, 0);
    if (!outward) return from_columns(z, x, y);
    // r, then along the meridian away from the z axis, then round it.
    return from_columns(*outward, cross(round, *outward), round);
}

NodalAngles CoordinateSystems::angles_at(std::int64_t id, const Point3& basic) const {
    if (id == 0 || !frames_.contains(id)) return {};
    return nodal_angles_of(axes_at(id, basic));
}

}  // namespace feelem::nastran
