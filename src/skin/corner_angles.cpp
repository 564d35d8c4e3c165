// SPDX-License-Identifier: Apache-2.0
// Must: give the same bits on every processor, so nothing here is fused or reordered. Algorithm: the arc
// tangent of the lengths of cross and dot product, by S. Moshier's rational approximation up to tan(pi / 8)
// (Cephes, atan.c), to 3e-16 of it and without a call; eight at once take both sides of each branch.
#include "skin/corner_angles.hpp"

#include "model/vector.hpp"

#include <cmath>
#include <cstring>
#include <numbers>

namespace feelem {
namespace {

constexpr double kTanEighth = 0.41421356237309504880;

/// std::atan2(y, x) for y >= 0.
double arc_tangent(double y, double x) noexcept {
    const double side = std::abs(x);
    const bool steep = y > side;
    const double low = steep ? side : y, high = steep ? y : side;
    if (!(high > 0)) return 0;
    const bool wide = low > kTanEighth * high;
    const double t = (wide ? low - high : low) / (wide ? low + high : high);
    const double z = t * t;
    const double p =
        (((-8.750608600031904122785E-1 * z - 1.615753718733365076637E1) * z - 7.500855792314704667340E1) * z -
         1.228866684490136173410E2) *
            z -
        6.485021904942025371773E1;
    const double q =
        ((((z + 2.485846490142306297962E1) * z + 1.650270098316988542046E2) * z + 4.328810604912902668951E2) *
             z +
         4.853903996359136964868E2) *
            z +
        1.945506571482613964425E2;
    double angle = t + t * (z * p / q);
    if (wide) angle = std::numbers::pi / 4 + angle;
    if (steep) angle = std::numbers::pi / 2 - angle;
    return x < 0 ? std::numbers::pi - angle : angle;
}

#if defined(__x86_64__)

/// Of the compiler: as many instructions as it takes.
using Eight = double __attribute__((vector_size(64)));

/// The lines of angle_between and arc_tangent. In one function: registers as wide as this are not passed.
[[gnu::always_inline]] inline void eight_angles(const EightPairs& pairs, EightAngles& out) noexcept {
    Eight a[3], b[3];
    std::memcpy(&a, &pairs.a, sizeof a);
    std::memcpy(&b, &pairs.b, sizeof b);
    const Eight c0 = a[1] * b[2] - a[2] * b[1], c1 = a[2] * b[0] - a[0] * b[2],
                c2 = a[0] * b[1] - a[1] * b[0];
    const Eight squared = c0 * c0 + c1 * c1 + c2 * c2;
    const Eight x = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    Eight y{};
    for (std::size_t i = 0; i < EightPairs::kCount; ++i) y[i] = std::sqrt(squared[i]);
    const Eight zero{};
    const Eight side = x < zero ? -x : x;
    const auto steep = y > side;
    const Eight low = steep ? side : y, high = steep ? y : side;
    const auto wide = low > kTanEighth * high;
    const Eight above = wide ? low - high : low, below = wide ? low + high : high;
    const Eight t = above / below;
    const Eight z = t * t;
    const Eight p =
        (((-8.750608600031904122785E-1 * z - 1.615753718733365076637E1) * z - 7.500855792314704667340E1) * z -
         1.228866684490136173410E2) *
            z -
        6.485021904942025371773E1;
    const Eight q =
        ((((z + 2.485846490142306297962E1) * z + 1.650270098316988542046E2) * z + 4.328810604912902668951E2) *
             z +
         4.853903996359136964868E2) *
            z +
        1.945506571482613964425E2;
    Eight angle = t + t * (z * p / q);
    angle = wide ? std::numbers::pi / 4 + angle : angle;
    angle = steep ? std::numbers::pi / 2 - angle : angle;
    angle = x < zero ? std::numbers::pi - angle : angle;
    angle = high > zero ? angle : zero;
    std::memcpy(&out, &angle, sizeof out);
}

__attribute__((target("avx2"))) void eight_angles_with_avx2(
    const EightPairs& pairs, EightAngles& out
) noexcept {
    eight_angles(pairs, out);
}
__attribute__((target("avx512f"))) void eight_angles_with_avx512(
    const EightPairs& pairs, EightAngles& out
) noexcept {
    eight_angles(pairs, out);
}
#endif

}  // namespace

double angle_between(const Point3& a, const Point3& b) noexcept {
    const Point3 c = cross(a, b);
    return arc_tangent(std::sqrt(dot(c, c)), dot(a, b));
}

EightAngles angles_between_portably(const EightPairs& pairs) noexcept {
    EightAngles out{};
    for (std::size_t i = 0; i < EightPairs::kCount; ++i) {
        out[i] = angle_between(
            {pairs.a[0][i], pairs.a[1][i], pairs.a[2][i]}, {pairs.b[0][i], pairs.b[1][i], pairs.b[2][i]}
        );
    }
    return out;
}

#if defined(__x86_64__)

bool angles_between_with_avx2(const EightPairs& pairs, EightAngles& out) noexcept {
    if (!__builtin_cpu_supports("avx2")) return false;
    eight_angles_with_avx2(pairs, out);
    return true;
}

bool angles_between_with_avx512(const EightPairs& pairs, EightAngles& out) noexcept {
    if (!__builtin_cpu_supports("avx512f")) return false;
    eight_angles_with_avx512(pairs, out);
    return true;
}

#else

bool angles_between_with_avx2(const EightPairs&, EightAngles&) noexcept {
    return false;
}

bool angles_between_with_avx512(const EightPairs&, EightAngles&) noexcept {
    return false;
}

#endif

EightAngles angles_between(const EightPairs& pairs) noexcept {
    EightAngles out;
    if (angles_between_with_avx512(pairs, out) || angles_between_with_avx2(pairs, out)) return out;
    return angles_between_portably(pairs);
}

}  // namespace feelem
