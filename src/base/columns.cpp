// SPDX-License-Identifier: Apache-2.0
#include "base/columns.hpp"

#include "base/eight_digits.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#define FEELEM_AVX2 __attribute__((target("avx2")))
#define FEELEM_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline
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

/// Each character behind the point stays, each before it moves one to the right into its place.
using Closing = std::array<std::uint8_t, 16>;
constexpr auto kClosings = [] {
    std::array<Closing, 16> all{};
    for (std::size_t point = 0; point < 16; ++point) {
        for (std::size_t i = 0; i < 16; ++i)
            all[point][i] = static_cast<std::uint8_t>(i > point ? i : i == 0 ? 0x80 : i - 1);
    }
    return all;
}();

/// The characters of mantissas as bits, the first the lowest.
struct Mantissas {
    __m128i digits;  ///< 0 to 9; 0 for all others.
    unsigned digit = 0, point = 0, minus = 0, blank = 0;
};

FEELEM_AVX2_INLINE Mantissas look_at_mantissas(__m128i text) {
    const auto bits = [](__m128i bytes) __attribute__((target("avx2"))) {
        return static_cast<unsigned>(_mm_movemask_epi8(bytes));
    };
    Mantissas out;
    const __m128i digit = _mm_sub_epi8(text, _mm_set1_epi8('0'));
    const __m128i is_digit = _mm_cmpeq_epi8(_mm_min_epu8(digit, _mm_set1_epi8(9)), digit);
    out.digits = _mm_and_si128(digit, is_digit);
    out.digit = bits(is_digit);
    out.point = bits(_mm_cmpeq_epi8(text, _mm_set1_epi8('.')));
    out.minus = bits(_mm_cmpeq_epi8(text, _mm_set1_epi8('-')));
    out.blank = bits(_mm_cmpeq_epi8(text, _mm_set1_epi8(' ')));
    return out;
}

/// Whether the `size` characters from `first` on are anything but blanks, perhaps a minus, and then digits
/// with a point up to the last.
__attribute__((always_inline)) inline unsigned is_odd(const Mantissas& all, unsigned first, unsigned size) {
    const unsigned mask = (1U << size) - 1;
    const unsigned digit = all.digit >> first & mask, point = all.point >> first & mask;
    const unsigned minus = all.minus >> first & mask, blank = all.blank >> first & mask;
    const unsigned before = ~(digit | point) & mask;
    unsigned odd = before & (before + 1);
    odd |= (minus | blank) ^ before;
    odd |= minus & ~((before + 1) >> 1U);
    odd |= point & (point - 1);
    return odd | static_cast<unsigned>(before == 0) | static_cast<unsigned>(point == 0) |
           static_cast<unsigned>(digit == 0);
}

FEELEM_AVX2_INLINE std::uint64_t two_values(__m128i digits) {
    const __m128i two = _mm_maddubs_epi16(digits, _mm_set1_epi16(0x010A));
    const __m128i four = _mm_madd_epi16(two, _mm_set1_epi32(0x00010064));
    return static_cast<std::uint64_t>(
        _mm_cvtsi128_si64(_mm_madd_epi16(_mm_packus_epi32(four, four), _mm_set1_epi32(0x00012710)))
    );
}

/// Four blanks (0) or E-02.
__attribute__((always_inline)) inline int exponent_of(const char* at, unsigned& odd) {
    std::uint32_t word = 0;
    std::memcpy(&word, at, sizeof word);
    const auto some = static_cast<unsigned>(word != 0x20202020U);
    const unsigned sign = word >> 8U & 0xFFU;
    const unsigned tens = (word >> 16U & 0xFFU) - '0', units = (word >> 24U) - '0';
    odd |= some & (static_cast<unsigned>((word & 0xFFU) != 'E') |
                   (static_cast<unsigned>(sign != '+') & static_cast<unsigned>(sign != '-')) |
                   static_cast<unsigned>(tens > 9) | static_cast<unsigned>(units > 9));
    const auto direction = 1 - 2 * static_cast<int>(sign == '-');  // No branches: exponents come and go.
    return static_cast<int>(some) * direction * static_cast<int>(10 * tens + units);
}

/// Powers of ten and behind them the same negative; those above 22 are never used, their place is what an
/// index is kept within.
constexpr auto kSignedPowers = [] {
    std::array<double, 64> all{};
    for (std::size_t i = 0; i < 32; ++i) {
        all[i] = i < kPowersOfTen.size() ? kPowersOfTen[i] : 1;
        all[32 + i] = -all[i];
    }
    return all;
}();

/// Fifteen digits and powers of ten up to 22 are exact in a double: one rounded operation.
__attribute__((always_inline)) inline double scaled(
    std::uint64_t digits, bool negative, int exponent, unsigned& odd
) {
    const int below = exponent >> 31;  // All bits when it is negative: signs come and go, no branches.
    const auto up = static_cast<unsigned>(exponent & ~below), down = static_cast<unsigned>(-exponent & below);
    odd |= static_cast<unsigned>(up > 22) | static_cast<unsigned>(down > 22);
    const auto whole = static_cast<double>(static_cast<std::int64_t>(digits));
    const std::size_t signed_up = up % 32 + 32 * static_cast<std::size_t>(negative);
    return whole * kSignedPowers[signed_up] / kSignedPowers[down % 32];  // One of them is 1 or -1.
}

__attribute__((always_inline)) inline void put(double value, double& out, unsigned&) {
    out = value;
}

/// As to_float of plain_real.hpp: in the middle between two floats, and out of their usual range, the double
/// does not tell which is nearest.
__attribute__((always_inline)) inline void put(double value, float& out, unsigned& odd) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
    const double size = std::abs(value);
    odd |= static_cast<unsigned>((bits & ((std::uint64_t{1} << 29U) - 1)) == std::uint64_t{1} << 28U);
    odd |= static_cast<unsigned>(size >= static_cast<double>(std::numeric_limits<float>::max()));
    odd |= static_cast<unsigned>(size < static_cast<double>(std::numeric_limits<float>::min())) &
           static_cast<unsigned>(size != 0);
    out = static_cast<float>(value);
}

/// Two columns of twelve characters.
template <class Real>
FEELEM_AVX2_INLINE void two_reals_of_12(const char* one, const char* two, Real* out, unsigned& odd) {
    const Mantissas all = look_at_mantissas(
        _mm_set_epi64x(static_cast<long long>(load8(two)), static_cast<long long>(load8(one)))
    );
    odd |= is_odd(all, 0, 8) | is_odd(all, 8, 8);
    const auto first = static_cast<unsigned>(std::countr_zero(all.point | 0x80U));
    const auto second = static_cast<unsigned>(std::countr_zero(all.point >> 8U | 0x80U));
    const __m128i order = _mm_unpacklo_epi64(
        _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kClosings[first].data())),
        _mm_or_si128(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kClosings[second].data())), _mm_set1_epi8(8)
        )
    );
    const std::uint64_t values = two_values(_mm_shuffle_epi8(all.digits, order));
    const int behind = exponent_of(one + 8, odd) - 7 + static_cast<int>(first);
    const int behind_two = exponent_of(two + 8, odd) - 7 + static_cast<int>(second);
    put(scaled(values & 0xFFFFFFFFU, (all.minus & 0xFFU) != 0, behind, odd), out[0], odd);
    put(scaled(values >> 32U, all.minus >> 8U != 0, behind_two, odd), out[1], odd);
}

/// A column of thirteen to twenty characters, `keep` 0 where characters before it are looked at.
template <class Real>
FEELEM_AVX2_INLINE void real_of_20(const char* mantissa, __m128i keep, Real& out, unsigned& odd) {
    const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(mantissa));
    const Mantissas all = look_at_mantissas(_mm_blendv_epi8(_mm_set1_epi8(' '), text, keep));
    odd |= is_odd(all, 0, 16);
    const auto point = static_cast<unsigned>(std::countr_zero(all.point | 0x8000U));
    const __m128i order = _mm_loadu_si128(reinterpret_cast<const __m128i*>(kClosings[point].data()));
    const std::uint64_t halves = two_values(_mm_shuffle_epi8(all.digits, order));
    const std::uint64_t digits = (halves & 0xFFFFFFFFU) * 100'000'000U + (halves >> 32U);
    const int exponent = exponent_of(mantissa + 16, odd) - 15 + static_cast<int>(point);
    put(scaled(digits, all.minus != 0, exponent, odd), out, odd);
}

template <class Real>
FEELEM_AVX2 bool general_reals(const char* at, std::size_t width, std::size_t count, Real* out) {
    unsigned odd = 0;
    if (width == 12) {
        std::size_t i = 0;
        for (; i + 2 <= count; i += 2) two_reals_of_12(at + i * 12, at + (i + 1) * 12, out + i, odd);
        std::array<Real, 2> twice{};
        if (i == count) return odd == 0;
        two_reals_of_12(at + i * 12, at + i * 12, twice.data(), odd);
        out[i] = twice[0];
        return odd == 0;
    }
    const std::size_t foreign = 20 - width;
    const __m128i places = _mm_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m128i keep =
        _mm_cmpgt_epi8(places, _mm_set1_epi8(static_cast<char>(static_cast<int>(foreign) - 1)));
    // A number must not go on with digits of the one before.
    for (std::size_t i = 0; i < count; ++i) {
        const char* column = at + i * width;
        odd |= static_cast<unsigned>(*column != ' ' && *column != '-');
        real_of_20(column - foreign, keep, out[i], odd);
    }
    return odd == 0;
}

#undef FEELEM_AVX2
#undef FEELEM_AVX2_INLINE
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

bool columns_of_reals(const char* at, std::size_t width, std::size_t count, double* out) {
    return has_fast_columns() && width >= 12 && width <= 20 && general_reals(at, width, count, out);
}

bool columns_of_reals(const char* at, std::size_t width, std::size_t count, float* out) {
    return has_fast_columns() && width >= 12 && width <= 20 && general_reals(at, width, count, out);
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

bool columns_of_reals(const char*, std::size_t, std::size_t, double*) {
    return false;
}

bool columns_of_reals(const char*, std::size_t, std::size_t, float*) {
    return false;
}

#endif

}  // namespace feelem
