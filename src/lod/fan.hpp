// SPDX-License-Identifier: Apache-2.0
// The triangles that would replace the star of a point, and the one definition of what stands for a sample on
// them: the closest place of the triangle whose list holds it.
#pragma once

#include "lod/lod_mesh.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace feelem::lod {

inline constexpr std::uint32_t kMostValence = 32;

/// Triangles round a point between two feature edges, or all of them. Their outer edges make a polygon:
/// corner i and i + 1 belong to triangle i.
struct Patch {
    std::uint32_t count = 0;    ///< Triangles.
    std::uint32_t corners = 0;  ///< count when closed, else count + 1.
    bool is_closed = false;
    std::uint32_t centre = kNone;  ///< The vertex at the point, of these triangles.
    std::array<std::uint32_t, kMostValence> face;
    std::array<std::uint8_t, kMostValence> slot;  ///< Of the centre.
    std::array<std::uint32_t, kMostValence + 1> link;
    std::array<float, kMostValence + 1> x, y, z;  ///< Corners, from the centre.
    std::array<float, kMostValence + 1> u, v;     ///< In the plane of the mean normal.
    float nx = 0, ny = 0, nz = 0;
};

struct Limits {
    float error = 1;         ///< Fraction of the bounds.
    float least_cosine = 0;  ///< Between the normals of a sample and its triangle.
};

/// The triangles (corner `from`, corner from + m, corner from + m + 1) of a patch, m = 1 .. corners - 2.
class Fan {
public:
    static constexpr float kRefused = std::numeric_limits<float>::max();

    explicit Fan(const Model& model) : model_(model) {}

    /// False when a triangle has no area, turns away from the patch, or would show what is missing.
    bool build(const Patch& patch, std::uint32_t from);
    /// Error of a sample as a fraction of its bounds, kRefused when the normals disagree; `where`: the
    /// triangle that stands for it, m - 1.
    float error_of(std::uint32_t sample, const Limits& limits, std::uint8_t& where) const;

private:
    float error_at(std::uint32_t sample, std::uint32_t m, float b1, float b2, float distance) const;
    float error_outside(std::uint32_t sample, const Limits& limits, std::uint8_t& where) const;

    using Row = std::array<float, kMostValence>;
    const Model& model_;
    std::uint32_t count_ = 0;
    float vx_ = 0, vy_ = 0, vz_ = 0;   ///< The corner that all triangles share.
    std::uint64_t missing_ = 0;        ///< Fields that these triangles do not show.
    Row ax_, ay_, az_, bx_, by_, bz_;  ///< The other two, from it.
    Row gx_, gy_, gz_, hx_, hy_, hz_;  ///< Gradients of the weights of these two.
    Row nx_, ny_, nz_;
    std::array<std::uint32_t, kMostValence + 1> vertex_;
};

}  // namespace feelem::lod
