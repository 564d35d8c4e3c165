// SPDX-License-Identifier: Apache-2.0
// Three columns as Fortran's E21.13E3 prints reals: archives of Ansys hold most of their bytes so.
#include "base/columns.hpp"

#if defined(__x86_64__)

#include "base/eight_digits.hpp"
#include "base/wide_columns.hpp"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>

#define FEELEM_AVX2 __attribute__((target("avx2")))

namespace feelem {
namespace {

FEELEM_AVX2 inline __m256i two_numbers(__m256i digits) {
    const __m256i two = _mm256_maddubs_epi16(digits, _mm256_set1_epi16(0x010A));
    const __m256i four = _mm256_madd_epi16(two, _mm256_set1_epi32(0x00010064));
    return _mm256_madd_epi16(_mm256_packus_epi32(four, four), _mm256_set1_epi32(0x00012710));
}

/// What is not as it should be in sign, point and exponent; the power of ten to divide by.
inline unsigned look_at_rest(const char* field, bool& negative, int& power) {
    const std::uint64_t tail = load8(field + 13);  // d d d E + 0 0 1
    const auto sign = static_cast<unsigned>(tail >> 32U & 0xFFU);
    const bool shrinks = sign == '-';
    const auto tens = static_cast<unsigned>(tail >> 48U & 0xFFU) - '0';
    const auto units = static_cast<unsigned>(tail >> 56U) - '0';
    negative = field[0] == '-';
    const int written = static_cast<int>(10 * tens + units);
    power = 13 - (shrinks ? -written : written);
    unsigned odd = static_cast<unsigned>(field[0] != (negative ? '-' : ' '));
    odd += static_cast<unsigned>(field[2] != '.');
    odd += static_cast<unsigned>((tail & 0x0000FF00FF000000U) != 0x0000300045000000U);
    odd += static_cast<unsigned>(sign != (shrinks ? '-' : '+'));
    odd += static_cast<unsigned>(tens > 9);
    odd += static_cast<unsigned>(units > 9);
    odd += static_cast<unsigned>(power < 0 || power > 22);
    return odd;
}

FEELEM_AVX2 bool three_reals(const char* at, double* out) {
    constexpr std::size_t kWidth = 21;
    // s d . d d d d d d d d d d d d d  ->  0 0 d d d d d d  d d d d d d d d
    const __m256i order =
        _mm256_broadcastsi128_si256(_mm_setr_epi8(-128, -128, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15)
        );
    const __m128i first = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
    const __m128i second = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + kWidth));
    const __m128i third = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + 2 * kWidth));
    const __m256i zero = _mm256_set1_epi8('0');
    const __m256i two = _mm256_shuffle_epi8(_mm256_sub_epi8(_mm256_set_m128i(second, first), zero), order);
    const __m256i one = _mm256_shuffle_epi8(_mm256_sub_epi8(_mm256_set_m128i(third, third), zero), order);
    const __m256i most = _mm256_max_epu8(two, one);
    const __m256i is_digit = _mm256_cmpeq_epi8(_mm256_min_epu8(most, _mm256_set1_epi8(9)), most);
    unsigned odd = static_cast<unsigned>(_mm256_movemask_epi8(is_digit)) != 0xFFFFFFFFU ? 1 : 0;
    const __m256i of_two = two_numbers(two);
    const __m256i of_one = two_numbers(one);
    const std::array<std::uint64_t, 3> halves{
        static_cast<std::uint64_t>(_mm256_extract_epi64(of_two, 0)),
        static_cast<std::uint64_t>(_mm256_extract_epi64(of_two, 2)),
        static_cast<std::uint64_t>(_mm256_extract_epi64(of_one, 0))};
    for (std::size_t i = 0; i < 3; ++i) {
        bool negative = false;
        int power = 0;
        odd += look_at_rest(at + i * kWidth, negative, power);
        const std::uint64_t digits = (halves[i] & 0xFFFFFFFFU) * 100'000'000U + (halves[i] >> 32U);
        const double value = static_cast<double>(static_cast<std::int64_t>(digits)) /
                             kPowersOfTen[static_cast<std::size_t>(power) % kPowersOfTen.size()];
        out[i] =
            std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) | (std::uint64_t{negative} << 63U));
    }
    return odd == 0;
}

#undef FEELEM_AVX2

}  // namespace

bool narrow_three_reals_of_21(const char* at, double* out) {
    return has_fast_columns() && three_reals(at, out);
}

bool three_reals_of_21(const char* at, double* out) {
    return has_wide_columns() ? wide_three_reals_of_21(at, out) : narrow_three_reals_of_21(at, out);
}

}  // namespace feelem

#else

namespace feelem {

bool narrow_three_reals_of_21(const char*, double*) {
    return false;
}

bool three_reals_of_21(const char*, double*) {
    return false;
}

}  // namespace feelem

#endif
