// SPDX-License-Identifier: Apache-2.0
#include "lod/fan.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::lod {
namespace {

/// Cosine: no triangle may turn further from the patch's mean normal.
constexpr float kUpright = 0.5F;
/// Weights this little below zero are zero: places on an edge belong to both triangles.
constexpr float kOnEdge = 1e-6F;

struct OnSegment {
    float share;
    float square;
};

/// Closest place to (px, py, pz) on the segment from 0 to (dx, dy, dz).
OnSegment closest(float px, float py, float pz, float dx, float dy, float dz) {
    const float length = dx * dx + dy * dy + dz * dz;
    const float along = px * dx + py * dy + pz * dz;
    const float share = length > 0 ? std::clamp(along / length, 0.0F, 1.0F) : 0.0F;
    const float x = px - share * dx, y = py - share * dy, z = pz - share * dz;
    return {share, x * x + y * y + z * z};
}

}  // namespace

bool Fan::build(const Patch& patch, std::uint32_t from) {
    count_ = patch.corners - 2;
    const Sample& shared = model_.samples[patch.link[from]];
    vx_ = shared.x;
    vy_ = shared.y;
    vz_ = shared.z;
    vertex_[0] = patch.link[from];
    std::uint32_t k = from;
    const auto step = [&] { k = k + 1 == patch.corners ? 0 : k + 1; };
    step();
    float ax = patch.x[k] - patch.x[from], ay = patch.y[k] - patch.y[from], az = patch.z[k] - patch.z[from];
    vertex_[1] = patch.link[k];
    for (std::uint32_t m = 0; m < count_; ++m) {
        step();
        vertex_[m + 2] = patch.link[k];
        const float bx = patch.x[k] - patch.x[from], by = patch.y[k] - patch.y[from],
                    bz = patch.z[k] - patch.z[from];
        const float nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
        const float square = nx * nx + ny * ny + nz * nz;
        const float length = std::sqrt(square);
        if (!(nx * patch.nx + ny * patch.ny + nz * patch.nz > kUpright * length) || !(square > 0))
            return false;
        const float inverse = 1 / square;
        ax_[m] = ax;
        ay_[m] = ay;
        az_[m] = az;
        bx_[m] = bx;
        by_[m] = by;
        bz_[m] = bz;
        gx_[m] = (by * nz - bz * ny) * inverse;
        gy_[m] = (bz * nx - bx * nz) * inverse;
        gz_[m] = (bx * ny - by * nx) * inverse;
        hx_[m] = (ny * az - nz * ay) * inverse;
        hy_[m] = (nz * ax - nx * az) * inverse;
        hz_[m] = (nx * ay - ny * ax) * inverse;
        nx_[m] = nx / length;
        ny_[m] = ny / length;
        nz_[m] = nz / length;
        ax = bx;
        ay = by;
        az = bz;
    }
    missing_ = 0;
    if (model_.missing.empty()) return true;
    missing_ = model_.missing_in(model_.faces[patch.face[0]].vertex);
    for (std::uint32_t m = 0; m < count_; ++m) {
        if (model_.missing_in({vertex_[0], vertex_[m + 1], vertex_[m + 2]}) != missing_) return false;
    }
    return true;
}

float Fan::error_at(std::uint32_t sample, std::uint32_t m, float b1, float b2, float distance) const {
    float worst = distance * model_.samples[sample].inverse_distance;
    const std::size_t width = model_.field_count;
    const float* f = model_.values.data();
    const float *at = f + sample * width, *v = f + vertex_[0] * width, *a = f + vertex_[m + 1] * width,
                *b = f + vertex_[m + 2] * width;
    for (std::size_t k = 0; k < width; ++k) {
        if (missing_ != 0 && model_.is_missing(missing_, k)) continue;
        const float shown = v[k] + b1 * (a[k] - v[k]) + b2 * (b[k] - v[k]);
        worst = std::max(worst, std::abs(at[k] - shown));
    }
    return worst;
}

float Fan::error_of(std::uint32_t sample, const Limits& limits, std::uint8_t& where) const {
    const Sample& s = model_.samples[sample];
    const float x = s.x - vx_, y = s.y - vy_, z = s.z - vz_;
    float least = kRefused;
    bool is_inside = false;
    for (std::uint32_t m = 0; m < count_; ++m) {
        const float b1 = gx_[m] * x + gy_[m] * y + gz_[m] * z;
        if (b1 < -kOnEdge) continue;
        const float b2 = hx_[m] * x + hy_[m] * y + hz_[m] * z;
        if (b2 < -kOnEdge || b1 + b2 > 1 + kOnEdge) continue;
        is_inside = true;
        const bool has_normal = s.nx != 0 || s.ny != 0 || s.nz != 0;
        if (has_normal && s.nx * nx_[m] + s.ny * ny_[m] + s.nz * nz_[m] < limits.least_cosine) continue;
        const float distance = std::abs(nx_[m] * x + ny_[m] * y + nz_[m] * z);
        const float error = error_at(sample, m, std::max(b1, 0.0F), std::max(b2, 0.0F), distance);
        if (error >= least) continue;
        least = error;
        where = static_cast<std::uint8_t>(m);
        if (error <= limits.error) return error;
    }
    return is_inside ? least : error_outside(sample, limits, where);
}

float Fan::error_outside(std::uint32_t sample, const Limits& limits, std::uint8_t& where) const {
    const Sample& s = model_.samples[sample];
    const float x = s.x - vx_, y = s.y - vy_, z = s.z - vz_;
    float nearest = kRefused, best1 = 0, best2 = 0;
    std::uint32_t best = 0;
    const auto consider = [&](std::uint32_t m, float square, float b1, float b2) {
        if (square >= nearest) return;
        nearest = square;
        best = m;
        best1 = b1;
        best2 = b2;
    };
    for (std::uint32_t m = 0; m < count_; ++m) {
        const OnSegment on_a = closest(x, y, z, ax_[m], ay_[m], az_[m]);
        consider(m, on_a.square, on_a.share, 0);
        const OnSegment on_b = closest(x, y, z, bx_[m], by_[m], bz_[m]);
        consider(m, on_b.square, 0, on_b.share);
        const OnSegment on_ab =
            closest(x - ax_[m], y - ay_[m], z - az_[m], bx_[m] - ax_[m], by_[m] - ay_[m], bz_[m] - az_[m]);
        consider(m, on_ab.square, 1 - on_ab.share, on_ab.share);
    }
    where = static_cast<std::uint8_t>(best);
    const bool has_normal = s.nx != 0 || s.ny != 0 || s.nz != 0;
    if (has_normal && s.nx * nx_[best] + s.ny * ny_[best] + s.nz * nz_[best] < limits.least_cosine)
        return kRefused;
    return error_at(sample, best, best1, best2, std::sqrt(nearest));
}

}  // namespace feelem::lod
