// SPDX-License-Identifier: Apache-2.0
#include "base/columns.hpp"

#include "base/eight_digits.hpp"

#include <array>
#include <bit>

#if defined(__x86_64__)
#include <immintrin.h>
#define FEELEM_AVX2 __attribute__((target("avx2")))
#endif

namespace feelem {
namespace {

/// Something but blanks before the last eight characters of a column.
std::uint64_t foreign_before(const char* column, std::size_t width) {
    std::uint64_t bad = 0;
    for (std::size_t i = 0; i + 8 < width; ++i) bad |= static_cast<std::uint64_t>(column[i] != ' ');
    return bad;
}

#if defined(__x86_64__)

/// Bytes that may not stand so are gathered in `bad`.
FEELEM_AVX2 inline void four_columns(
    const char* last_eight, std::size_t width, std::int64_t* out, __m256i& bad
) {
    const __m256i text = _mm256_set_epi64x(
        static_cast<long long>(load8(last_eight + 3 * width)),
        static_cast<long long>(load8(last_eight + 2 * width)),
        static_cast<long long>(load8(last_eight + width)),
        static_cast<long long>(load8(last_eight))
    );
    const __m256i blank = _mm256_cmpeq_epi8(text, _mm256_set1_epi8(' '));
    const __m256i digit = _mm256_sub_epi8(text, _mm256_set1_epi8('0'));
    const __m256i is_digit = _mm256_cmpeq_epi8(_mm256_min_epu8(digit, _mm256_set1_epi8(9)), digit);
    const __m256i all = _mm256_set1_epi8(-1);
    bad = _mm256_or_si256(bad, _mm256_andnot_si256(_mm256_or_si256(blank, is_digit), all));
    // Blanks that only lead are ones from the low end: one more carries out of them; of a blank column
    // nothing is left.
    const __m256i more = _mm256_add_epi64(blank, _mm256_set1_epi64x(1));
    bad = _mm256_or_si256(bad, _mm256_and_si256(blank, more));
    bad = _mm256_or_si256(bad, _mm256_cmpeq_epi64(more, _mm256_setzero_si256()));
    const __m256i two = _mm256_maddubs_epi16(_mm256_andnot_si256(blank, digit), _mm256_set1_epi16(0x010A));
    const __m256i four = _mm256_madd_epi16(two, _mm256_set1_epi32(0x00010064));
    const __m256i eight = _mm256_madd_epi16(_mm256_packus_epi32(four, four), _mm256_set1_epi32(0x00012710));
    const __m128i values = _mm256_castsi256_si128(_mm256_permute4x64_epi64(eight, 0x08));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_cvtepu32_epi64(values));
}

FEELEM_AVX2 bool columns_by_fours(const char* at, std::size_t width, std::size_t count, std::int64_t* out) {
    __m256i bad = _mm256_setzero_si256();
    const char* last_eight = at + width - 8;
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) four_columns(last_eight + i * width, width, out + i, bad);
    // The last four once more, where their number is no multiple of four.
    if (i < count) four_columns(last_eight + (count - 4) * width, width, out + count - 4, bad);
    std::uint64_t foreign = 0;
    if (width == 9) {
        for (std::size_t c = 0; c < count; ++c) foreign |= static_cast<std::uint64_t>(at[c * width] != ' ');
    } else if (width > 9) {
        for (std::size_t c = 0; c < count; ++c) foreign |= foreign_before(at + c * width, width);
    }
    return foreign == 0 && _mm256_testz_si256(bad, bad) != 0;
}

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
#endif

}  // namespace

bool columns_of_integers_portable(const char* at, std::size_t width, std::size_t count, std::int64_t* out) {
    std::uint64_t bad = 0;
    for (std::size_t i = 0; i < count; ++i, at += width) {
        bad |= foreign_before(at, width);
        out[i] = eight_columns(load8(at + width - 8), bad);
    }
    return bad == 0;
}

#if defined(__x86_64__)

bool has_fast_columns() {
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
}

bool columns_of_integers(const char* at, std::size_t width, std::size_t count, std::int64_t* out) {
    return count >= 4 && has_fast_columns() ? columns_by_fours(at, width, count, out)
                                            : columns_of_integers_portable(at, width, count, out);
}

bool three_reals_of_21(const char* at, double* out) {
    return has_fast_columns() && three_reals(at, out);
}

#else

bool has_fast_columns() {
    return false;
}

bool columns_of_integers(const char* at, std::size_t width, std::size_t count, std::int64_t* out) {
    return columns_of_integers_portable(at, width, count, out);
}

bool three_reals_of_21(const char*, double*) {
    return false;
}

#endif

}  // namespace feelem
