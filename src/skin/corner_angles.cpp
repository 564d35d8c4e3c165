// SPDX-License-Identifier: Apache-2.0
// Must: give the same bits on every processor, so nothing here is fused or reordered. Algorithm: the arc
// tangent of the lengths of cross and dot product, by S. Moshier's rational approximation up to tan(pi / 8)
// (Cephes, atan.c), to 3e-16 of it and without a call; eight at once take both sides of each branch.
#include "skin/corner_angles.hpp"

#include "model/vector.hpp"

#include <cmath>
#include <cstring>
#include <numbers>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

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

/// The lines of angle_between and arc_tangent, as many at once as `Lanes` (vectors of the compiler) hold. In
/// one function: wide registers are not passed.
template <class Lanes>
[[gnu::always_inline]] inline void angles_of(
    const EightPairs& pairs, EightAngles& out, std::size_t first
) noexcept {
    Lanes a[3], b[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(&a[axis], &pairs.a[axis][first], sizeof(Lanes));
        std::memcpy(&b[axis], &pairs.b[axis][first], sizeof(Lanes));
    }
    const Lanes c0 = a[1] * b[2] - a[2] * b[1], c1 = a[2] * b[0] - a[0] * b[2],
                c2 = a[0] * b[1] - a[1] * b[0];
    const Lanes squared = c0 * c0 + c1 * c1 + c2 * c2;
    const Lanes x = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    __m128d roots[sizeof(Lanes) / sizeof(__m128d)];
    std::memcpy(&roots, &squared, sizeof(Lanes));
    for (__m128d& root : roots) root = _mm_sqrt_pd(root);
    Lanes y;
    std::memcpy(&y, &roots, sizeof(Lanes));
    const Lanes zero{};
    const Lanes side = x < zero ? -x : x;
    const auto steep = y > side;
    const Lanes low = steep ? side : y, high = steep ? y : side;
    const auto wide = low > kTanEighth * high;
    const Lanes above = wide ? low - high : low, below = wide ? low + high : high;
    const Lanes t = above / below;
    const Lanes z = t * t;
    const Lanes p =
        (((-8.750608600031904122785E-1 * z - 1.615753718733365076637E1) * z - 7.500855792314704667340E1) * z -
         1.228866684490136173410E2) *
            z -
        6.485021904942025371773E1;
    const Lanes q =
        ((((z + 2.485846490142306297962E1) * z + 1.650270098316988542046E2) * z + 4.328810604912902668951E2) *
             z +
         4.853903996359136964868E2) *
            z +
        1.945506571482613964425E2;
    Lanes angle = t + t * (z * p / q);
    angle = wide ? std::numbers::pi / 4 + angle : angle;
    angle = steep ? std::numbers::pi / 2 - angle : angle;
    angle = x < zero ? std::numbers::pi - angle : angle;
    angle = high > zero ? angle : zero;
    std::memcpy(&out[first], &angle, sizeof(Lanes));
}

using Four = double __attribute__((vector_size(32)));
__attribute__((target("avx2"))) void find_with_avx2(const EightPairs& pairs, EightAngles& out) noexcept {
    angles_of<Four>(pairs, out, 0);
    angles_of<Four>(pairs, out, 4);
}
using Eight = double __attribute__((vector_size(64)));
__attribute__((target("avx512f"))) void find_with_avx512(const EightPairs& pairs, EightAngles& out) noexcept {
    angles_of<Eight>(pairs, out, 0);
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
    find_with_avx2(pairs, out);
    return true;
}

bool angles_between_with_avx512(const EightPairs& pairs, EightAngles& out) noexcept {
    if (!__builtin_cpu_supports("avx512f")) return false;
    find_with_avx512(pairs, out);
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
