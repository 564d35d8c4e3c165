// SPDX-License-Identifier: Apache-2.0
// Must: say what the narrow ways of columns.cpp and scientific_columns.cpp say, byte for byte.
// Algorithm: one permutation of bytes brings all columns of a row together; marks of bytes that may stand
// there are bits of a mask, so that the form of the whole row is a few operations on 64 bits.
#include "base/wide_columns.hpp"

#if defined(__x86_64__)

#include "base/eight_digits.hpp"

#include <immintrin.h>

#include <array>

#define FEELEM_AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,avx512vbmi")))

namespace feelem {
namespace {

using Bytes64 = std::array<std::uint8_t, 64>;

constexpr std::uint64_t low_bits(std::size_t count) {
    return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// Eight columns of one width: where their last eight characters stand, and which bytes are before those.
struct ColumnPattern {
    Bytes64 last_eight{};
    std::array<std::uint64_t, 2> before{};
};

constexpr ColumnPattern column_pattern(std::size_t width) {
    ColumnPattern pattern;
    for (std::size_t c = 0; c < kWideColumns; ++c) {
        for (std::size_t i = 0; i < width; ++i) {
            const std::size_t at = c * width + i;
            const std::size_t lead = width - 8;
            if (i < lead)
                pattern.before[at / 64] |= std::uint64_t{1} << (at % 64);
            else
                pattern.last_eight[8 * c + i - lead] = static_cast<std::uint8_t>(at);
        }
    }
    return pattern;
}

constexpr std::size_t kWidths = kWidestColumn - 8 + 1;
constexpr auto kColumnPatterns = [] {
    std::array<ColumnPattern, kWidths> patterns;
    for (std::size_t i = 0; i < kWidths; ++i) patterns[i] = column_pattern(8 + i);
    return patterns;
}();

/// Sixteen digits a lane of 128 bits, or eight a half: their values in 32 bits, hundreds of millions first,
/// in the low half of each lane.
FEELEM_AVX512 inline __m512i numbers_of(__m512i digits) {
    const __m512i two = _mm512_maddubs_epi16(digits, _mm512_set1_epi16(0x010A));
    const __m512i four = _mm512_madd_epi16(two, _mm512_set1_epi32(0x00010064));
    return _mm512_madd_epi16(_mm512_packus_epi32(four, four), _mm512_set1_epi32(0x00012710));
}

FEELEM_AVX512 inline __m256i low_halves(__m512i lanes) {
    // With masks of all: the plain forms make GCC 12 warn of its own header.
    constexpr __mmask8 kAll = 0xFF;
    const __m512i order = _mm512_setr_epi64(0, 2, 4, 6, 0, 0, 0, 0);
    return _mm512_maskz_extracti64x4_epi64(kAll, _mm512_maskz_permutexvar_epi64(kAll, order, lanes), 0);
}

FEELEM_AVX512 inline std::uint64_t where(__m512i text, char character) {
    return _mm512_cmpeq_epi8_mask(text, _mm512_set1_epi8(character));
}

/// Three reals as E21.13E3 prints them, 63 bytes: "s d . 13 digits E s 0 d d".
constexpr std::size_t kReal = 21;
constexpr std::uint64_t at_each_real(std::size_t first, std::size_t count) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) bits |= low_bits(count) << (i * kReal + first);
    return bits;
}
constexpr std::uint64_t kSigns = at_each_real(0, 1), kPoints = at_each_real(2, 1);
constexpr std::uint64_t kMarks = at_each_real(16, 1), kExponentSigns = at_each_real(17, 1);
constexpr std::uint64_t kHundreds = at_each_real(18, 1);
constexpr std::uint64_t kDigits = at_each_real(1, 1) | at_each_real(3, 13) | at_each_real(19, 2);

/// Where the sixteen digits of each number stand; the first two are none.
constexpr auto kMantissas = [] {
    Bytes64 from{};
    for (std::size_t i = 0; i < 3; ++i) {
        from[16 * i + 2] = static_cast<std::uint8_t>(kReal * i + 1);
        for (std::size_t d = 0; d < 13; ++d)
            from[16 * i + 3 + d] = static_cast<std::uint8_t>(kReal * i + 3 + d);
    }
    return from;
}();
constexpr std::uint64_t kMantissaBytes = 0x0000'FFFC'FFFC'FFFC;

/// Where the last two digits of each exponent stand.
constexpr Bytes64 kExponents{19, 20, 0, 0, kReal + 19, kReal + 20, 0, 0, 2 * kReal + 19, 2 * kReal + 20};
constexpr std::uint64_t kExponentBytes = 0x0333;

FEELEM_AVX512 inline __m128i first_lane(__m512i lanes) {
    return _mm512_maskz_extracti32x4_epi32(0xF, lanes, 0);
}

}  // namespace

bool has_wide_columns() {
    static const bool has =
        __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
        __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
        __builtin_cpu_supports("avx512vbmi") != 0;
    return has;
}

FEELEM_AVX512 bool wide_columns_of_integers(
    const char* at, std::size_t width, std::size_t count, std::uint32_t* out
) {
    const ColumnPattern& pattern = kColumnPatterns[width - 8];
    const std::size_t bytes = width * count;
    const std::uint64_t in_first = low_bits(bytes);
    const std::uint64_t in_second = bytes > 64 ? low_bits(bytes - 64) : 0;
    const __m512i first = _mm512_maskz_loadu_epi8(in_first, at);
    const __m512i second = _mm512_maskz_loadu_epi8(in_second, at + 64);
    const __m512i order = _mm512_loadu_si512(pattern.last_eight.data());
    const __m512i text = _mm512_permutex2var_epi8(first, order, second);

    const __m512i blank = _mm512_set1_epi8(' ');
    const std::uint64_t columns = low_bits(8 * count);
    const std::uint64_t blanks = _mm512_cmpeq_epi8_mask(text, blank) & columns;
    const __m512i digit = _mm512_sub_epi8(text, _mm512_set1_epi8('0'));
    const std::uint64_t digits = _mm512_cmple_epu8_mask(digit, _mm512_set1_epi8(9));
    std::uint64_t bad = columns & ~(blanks | digits);
    // A column is eight bits; blanks only lead, and never reach its last character.
    bad |= blanks & 0x8080808080808080U;
    bad |= blanks & (blanks + 0x0101010101010101U);
    bad |= _mm512_cmpneq_epi8_mask(first, blank) & pattern.before[0] & in_first;
    bad |= _mm512_cmpneq_epi8_mask(second, blank) & pattern.before[1] & in_second;
    if (bad != 0) return false;
    const __m256i values = low_halves(numbers_of(_mm512_maskz_mov_epi8(digits & columns, digit)));
    _mm256_mask_storeu_epi32(out, static_cast<__mmask8>(low_bits(count)), values);
    return true;
}

FEELEM_AVX512 bool wide_three_reals_of_21(const char* at, double* out) {
    const __m512i text = _mm512_maskz_loadu_epi8(low_bits(3 * kReal), at);
    const __m512i digit = _mm512_sub_epi8(text, _mm512_set1_epi8('0'));
    const std::uint64_t digits = _mm512_cmple_epu8_mask(digit, _mm512_set1_epi8(9));
    const std::uint64_t minus = where(text, '-');
    std::uint64_t bad = kDigits & ~digits;
    bad |= kSigns & ~(minus | where(text, ' '));
    bad |= kExponentSigns & ~(minus | where(text, '+'));
    bad |= (kPoints & ~where(text, '.')) | (kMarks & ~where(text, 'E')) | (kHundreds & ~where(text, '0'));
    // Two digits each; a lane of 32 bits is a number's.
    const __m128i written = _mm_maddubs_epi16(
        first_lane(_mm512_maskz_permutexvar_epi8(kExponentBytes, _mm512_loadu_si512(kExponents.data()), digit)
        ),
        _mm_set1_epi16(0x010A)
    );
    const auto shrinks = static_cast<__mmask8>(
        (minus >> 17U & 1U) | (minus >> (kReal + 16U) & 2U) | (minus >> (2 * kReal + 15U) & 4U)
    );
    const __m128i decimals = _mm_set1_epi32(13);
    const __m128i power = _mm_mask_add_epi32(_mm_sub_epi32(decimals, written), shrinks, decimals, written);
    bad |= _mm_mask_cmpgt_epu32_mask(7, power, _mm_set1_epi32(22));
    if (bad != 0) return false;
    const __m256d powers =
        _mm256_mmask_i32gather_pd(_mm256_set1_pd(1), 7, power, kPowersOfTen.data(), sizeof(double));
    const __m512i mantissas =
        _mm512_maskz_permutexvar_epi8(kMantissaBytes, _mm512_loadu_si512(kMantissas.data()), digit);
    const __m256i halves = low_halves(numbers_of(mantissas));
    const __m256i whole = _mm256_add_epi64(
        _mm256_mul_epu32(halves, _mm256_set1_epi64x(100'000'000)), _mm256_srli_epi64(halves, 32)
    );
    // Fourteen digits are exact in a double: one rounding (Clinger).
    const __m256d values = _mm256_div_pd(_mm256_cvtepi64_pd(whole), powers);
    const auto sign = [&](std::size_t i) { return static_cast<long long>(minus >> (i * kReal) << 63U); };
    const __m256d signs = _mm256_castsi256_pd(_mm256_setr_epi64x(sign(0), sign(1), sign(2), 0));
    _mm256_mask_storeu_pd(out, 7, _mm256_or_pd(values, signs));
    return true;
}

}  // namespace feelem

#else

namespace feelem {

bool has_wide_columns() {
    return false;
}

bool wide_columns_of_integers(const char*, std::size_t, std::size_t, std::uint32_t*) {
    return false;
}

bool wide_three_reals_of_21(const char*, double*) {
    return false;
}

}  // namespace feelem

#endif
