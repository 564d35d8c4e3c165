// SPDX-License-Identifier: Apache-2.0
// Must: never let a sample out of its bounds, keep the surface as connected as it is, and give the same
// result everywhere. Assumes: connect() and fill_samples(). Algorithm: half-edge collapse onto a neighbour;
// the lists of the triangles round the point hold all samples that they stand for, so each is tested against
// the new triangles themselves; points that changed are left alone until the next sweep; a point that was
// refused is remembered with the least error that refused it. One thread, in the order of the places. Data: 5
// bytes a place.
#include "lod/collapser.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {
namespace {

constexpr std::size_t kMostTries = 3;
/// longest edge^2 / (2 area): worse triangles are made only where they were worse already.
constexpr float kWorstShape = 50;
constexpr float kShapeWeight = 0.01F;

float crossed2(float ax, float ay, float bx, float by) {
    return ax * by - ay * bx;
}

float shape(float ux, float uy, float vx, float vy, float twice_area) {
    const float wx = ux - vx, wy = uy - vy;
    return std::max({ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy}) / twice_area;
}

}  // namespace

Collapser::Collapser(Model& model, float least_cosine) : model_(model), fan_(model) {
    limits_.least_cosine = least_cosine;
    cost_.assign(model.place_count, 0);
    stamp_.assign(model.place_count, 0);
    triangles_ = model.faces.size();
    points_ = model.report.points;
}

std::uint64_t Collapser::sweep(float error, std::uint64_t target) {
    limits_.error = error;
    std::fill(stamp_.begin(), stamp_.end(), std::uint8_t{0});
    std::uint64_t gone = 0;
    for (std::uint32_t p = 0; p < model_.place_count && triangles_ > target; ++p) {
        const Role role = model_.role[p];
        if ((role != Role::Free && role != Role::Crease) || stamp_[p] != 0 || cost_[p] > error) continue;
        if (model_.out[p] == kNone) continue;
        if (visit(p)) ++gone;
    }
    points_ -= gone;
    return gone;
}

bool Collapser::visit(std::uint32_t place) {
    blocked_ = Fan::kRefused;
    const bool went = model_.role[place] == Role::Free ? visit_free(place) : visit_crease(place);
    if (!went) cost_[place] = blocked_;
    return went;
}

bool Collapser::visit_free(std::uint32_t place) {
    Patch& patch = patches_[0];
    if (!collect_closed(model_.out[place], patch) || !flatten(patch)) return false;
    choose(patch);
    bool is_gathered = false;
    for (std::size_t i = 0; i < std::min(choices_.size(), kMostTries); ++i) {
        const std::uint32_t from = choices_[i].corner;
        if (!fan_.build(patch, from)) continue;
        if (!is_gathered) {
            pending_.clear();
            gather(patch, patch.centre);
            is_gathered = true;
        }
        const float error = test(0, pending_.size());
        if (error > limits_.error) {
            blocked_ = std::min(blocked_, error);
            continue;
        }
        if (!keeps_corners(patch, from) || !keeps_topology(place, 1, from)) continue;
        apply(patch, from, 0, pending_.size());
        finish(place, 1);
        return true;
    }
    return false;
}

bool Collapser::visit_crease(std::uint32_t place) {
    const std::uint32_t count = collect_open(model_.out[place]);
    if (count == 0) return false;
    CreasePoint& point = model_.creases[model_.crease[place]];
    for (std::uint32_t i = 0; i < count; ++i) {
        if (patches_[i].count < 2 || !flatten(patches_[i])) return false;
    }
    pending_.clear();
    std::array<std::size_t, 3> first{};
    for (std::uint32_t i = 0; i < count; ++i) {
        gather(patches_[i], i == 1 && point.alias != kNone ? point.alias : patches_[i].centre);
        first[i + 1] = pending_.size();
    }
    for (const bool to_last : {false, true}) {
        // Corner 0 of one patch is the last corner of the other.
        std::array<std::uint32_t, 2> from{};
        from[0] = to_last ? patches_[0].count : 0;
        from[1] = to_last ? 0 : patches_[1].count;
        const std::uint32_t target = model_.place[patches_[0].link[from[0]]];
        if (model_.role[target] == Role::Pinned) continue;
        float error = curve_error(point, patches_[0]);
        for (std::uint32_t i = 0; i < count && error <= limits_.error; ++i) {
            std::uint32_t over = 0;
            if (shape_of(patches_[i], from[i], over) < 0 || !fan_.build(patches_[i], from[i])) {
                error = Fan::kRefused;
            } else {
                error = std::max(error, test(first[i], first[i + 1]));
            }
        }
        if (error > limits_.error) {
            blocked_ = std::min(blocked_, error);
            continue;
        }
        bool is_good = keeps_topology(place, count, from[0]);
        for (std::uint32_t i = 0; i < count; ++i) is_good = is_good && keeps_corners(patches_[i], from[i]);
        if (!is_good) continue;
        for (std::uint32_t i = 0; i < count; ++i) apply(patches_[i], from[i], first[i], first[i + 1]);
        join_curve(place, target);
        finish(place, count);
        return true;
    }
    return false;
}

/// Worst shape of the fan from a corner, -1 when a triangle is turned over or too thin; `over_centre`: the
/// triangle of the fan that lies over the centre, 0 when none does.
float Collapser::shape_of(const Patch& patch, std::uint32_t from, std::uint32_t& over_centre) const {
    const float pu = patch.u[from], pv = patch.v[from];
    over_centre = 0;
    float worst = 0;
    std::uint32_t k = from + 1 == patch.corners ? 0 : from + 1;
    float au = patch.u[k] - pu, av = patch.v[k] - pv;
    float side = crossed2(au, av, -pu, -pv);
    for (std::uint32_t m = 1; m + 1 < patch.corners; ++m) {
        k = k + 1 == patch.corners ? 0 : k + 1;
        const float bu = patch.u[k] - pu, bv = patch.v[k] - pv;
        const float area = crossed2(au, av, bu, bv);
        if (!(area > 0)) return -1;
        worst = std::max(worst, shape(au, av, bu, bv, area));
        const float next_side = crossed2(bu, bv, -pu, -pv);
        if (side >= 0 && next_side <= 0) over_centre = m;
        side = next_side;
        au = bu;
        av = bv;
    }
    if (worst <= kWorstShape) return worst;
    for (std::uint32_t i = 0; i < patch.count; ++i) {
        const std::uint32_t j = i + 1 == patch.corners ? 0 : i + 1;
        const float area = crossed2(patch.u[i], patch.v[i], patch.u[j], patch.v[j]);
        if (!(area > 0) || shape(patch.u[i], patch.v[i], patch.u[j], patch.v[j], area) >= worst) return worst;
    }
    return -1;
}

/// Error of the centre on the triangle of the fan that lies over it, without the whole fan.
float Collapser::guess(const Patch& patch, std::uint32_t from, std::uint32_t m) const {
    const std::uint32_t i = (from + m) % patch.corners, j = (from + m + 1) % patch.corners;
    const float vx = patch.x[from], vy = patch.y[from], vz = patch.z[from];
    const float ax = patch.x[i] - vx, ay = patch.y[i] - vy, az = patch.z[i] - vz;
    const float bx = patch.x[j] - vx, by = patch.y[j] - vy, bz = patch.z[j] - vz;
    const float nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
    const float square = nx * nx + ny * ny + nz * nz;
    if (!(square > 0)) return Fan::kRefused;
    const float height = nx * vx + ny * vy + nz * vz;
    const Sample& c = model_.samples[patch.centre];
    float worst = std::abs(height) * c.inverse_distance / std::sqrt(square);
    if (worst > limits_.error) return worst;
    const float cx = vy * nz - vz * ny, cy = vz * nx - vx * nz, cz = vx * ny - vy * nx;
    const float b1 = (bx * cx + by * cy + bz * cz) / square;
    const float b2 = -(ax * cx + ay * cy + az * cz) / square;
    const std::size_t width = model_.field_count;
    const float* f = model_.values.data();
    const float *at = f + patch.centre * width, *v = f + patch.link[from] * width,
                *a = f + patch.link[i] * width, *b = f + patch.link[j] * width;
    const std::uint64_t missing =
        model_.missing.empty() ? 0 : model_.missing_in(model_.faces[patch.face[0]].vertex);
    for (std::size_t k = 0; k < width; ++k) {
        if (model_.is_missing(missing, k)) continue;
        worst = std::max(worst, std::abs(at[k] - v[k] - b1 * (a[k] - v[k]) - b2 * (b[k] - v[k])));
    }
    return worst;
}

void Collapser::choose(const Patch& patch) {
    choices_.clear();
    for (std::uint32_t from = 0; from < patch.corners; ++from) {
        if (model_.role[model_.place[patch.link[from]]] == Role::Pinned) continue;
        std::uint32_t over = 0;
        const float worst = shape_of(patch, from, over);
        if (worst < 0) continue;
        const float error = over == 0 ? 0 : guess(patch, from, over);
        if (error > limits_.error) {
            blocked_ = std::min(blocked_, error);
            continue;
        }
        choices_.push_back({error + kShapeWeight * limits_.error * worst, error, from});
    }
    std::ranges::sort(choices_, [](const Choice& a, const Choice& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.corner < b.corner;
    });
}

void Collapser::gather(const Patch& patch, std::uint32_t own) {
    pending_.push_back(own);
    for (std::uint32_t i = 0; i < patch.count; ++i) {
        for (std::uint32_t s = model_.faces[patch.face[i]].list; s != kNone; s = model_.samples[s].next)
            pending_.push_back(s);
    }
    if (where_.size() < pending_.size()) where_.resize(2 * pending_.size());
}

float Collapser::test(std::size_t first, std::size_t last) {
    float worst = 0;
    for (std::size_t i = first; i < last; ++i) {
        const float error = fan_.error_of(pending_[i], limits_, where_[i]);
        if (error > limits_.error) return error;
        worst = std::max(worst, error);
    }
    return worst;
}

void Collapser::finish(std::uint32_t place, std::uint32_t patches) {
    model_.role[place] = Role::Dead;
    for (std::uint32_t i = 0; i < patches; ++i) {
        for (std::uint32_t k = 0; k < patches_[i].corners; ++k) {
            const std::uint32_t p = model_.place[patches_[i].link[k]];
            stamp_[p] = 1;
            cost_[p] = 0;
        }
    }
}

}  // namespace feelem::lod
