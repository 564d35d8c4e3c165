// SPDX-License-Identifier: Apache-2.0
// Must: read columns as Fortran's G prints reals, each rounded once, or refuse the row.
// Assumes: nothing; every character of a column is looked at.
// Algorithm: four columns in one register (of 12 characters), or two and two (of 13 to 20), without a branch
// on sign, point or exponent. The characters before the point move one place to the right onto it, so that
// the mantissa is one whole number; at most fifteen digits and a power of ten up to 22 make one exactly
// rounded division or product (Clinger). Data: none. What is odd is gathered as bits and asked for once a
// row.
#include "base/columns.hpp"

#if defined(__x86_64__)

#include "base/eight_digits.hpp"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#define FEELEM_AVX2 __attribute__((target("avx2")))
#define FEELEM_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline

namespace feelem {
namespace {

constexpr std::size_t kExponentWidth = 4;  ///< E-02, or blanks.
constexpr std::size_t kShortWidth = 12, kMostWidth = 20;

FEELEM_AVX2_INLINE __m256i either(__m256i a, __m256i b) {
    return _mm256_or_si256(a, b);
}

/// Mantissas of eight characters, one a lane of 64 bits.
struct EightWide {
    static constexpr int kLast = 7;
    FEELEM_AVX2_INLINE static __m256i up(__m256i x) { return _mm256_slli_epi64(x, 8); }
    FEELEM_AVX2_INLINE static __m256i down(__m256i x) { return _mm256_srli_epi64(x, 8); }
    FEELEM_AVX2_INLINE static __m256i increment(__m256i x) {
        return _mm256_add_epi64(x, _mm256_set1_epi64x(1));
    }
    FEELEM_AVX2_INLINE static __m256i decrement(__m256i x) {
        return _mm256_sub_epi64(x, _mm256_set1_epi64x(1));
    }
    FEELEM_AVX2_INLINE static __m256i byte_at(int place) {
        return _mm256_set1_epi64x(static_cast<long long>(std::uint64_t{0xFF} << (8 * place)));
    }
};

/// Of sixteen, one a lane of 128 bits: what the lower half carries over goes by hand.
struct SixteenWide {
    static constexpr int kLast = 15;
    FEELEM_AVX2_INLINE static __m256i up(__m256i x) { return _mm256_slli_si256(x, 1); }
    FEELEM_AVX2_INLINE static __m256i down(__m256i x) { return _mm256_srli_si256(x, 1); }
    FEELEM_AVX2_INLINE static __m256i increment(__m256i x) {
        const __m256i carry = _mm256_slli_si256(_mm256_cmpeq_epi64(x, _mm256_set1_epi64x(-1)), 8);
        return _mm256_sub_epi64(_mm256_add_epi64(x, _mm256_set_epi64x(0, 1, 0, 1)), carry);
    }
    FEELEM_AVX2_INLINE static __m256i decrement(__m256i x) {
        const __m256i borrow = _mm256_slli_si256(_mm256_cmpeq_epi64(x, _mm256_setzero_si256()), 8);
        return _mm256_add_epi64(_mm256_sub_epi64(x, _mm256_set_epi64x(0, 1, 0, 1)), borrow);
    }
    FEELEM_AVX2_INLINE static __m256i byte_at(int place) {
        alignas(16) std::array<char, 16> bytes{};
        bytes[static_cast<std::size_t>(place)] = -1;
        return _mm256_broadcastsi128_si256(_mm_load_si128(reinterpret_cast<const __m128i*>(bytes.data())));
    }
};

/// Mantissas taken apart, a lane each. Characters are bytes of ones or zeros, the first the lowest.
struct Mantissas {
    __m256i fours;         ///< Four digits each in 32 bits, the most significant first.
    __m256i before_point;  ///< All characters before the point.
    __m256i minus;
};

/// Blanks, perhaps a minus, then digits with one point up to the last; `first`: the character that must be a
/// blank or a minus. Bits of `odd` are set by all else.
template <class Wide>
FEELEM_AVX2_INLINE Mantissas take_apart(__m256i text, __m256i first, __m256i& odd) {
    const __m256i digit = _mm256_sub_epi8(text, _mm256_set1_epi8('0'));
    const __m256i is_digit = _mm256_cmpeq_epi8(_mm256_min_epu8(digit, _mm256_set1_epi8(9)), digit);
    const __m256i point = _mm256_cmpeq_epi8(text, _mm256_set1_epi8('.'));
    const __m256i minus = _mm256_cmpeq_epi8(text, _mm256_set1_epi8('-'));
    const __m256i blank = _mm256_cmpeq_epi8(text, _mm256_set1_epi8(' '));
    const __m256i last = Wide::byte_at(Wide::kLast);
    const __m256i before = _mm256_xor_si256(either(is_digit, point), _mm256_set1_epi8(-1));
    // From the first character on without a hole: one more carries out of them.
    odd = either(odd, _mm256_and_si256(before, Wide::increment(before)));
    odd = either(odd, _mm256_xor_si256(before, either(minus, blank)));
    odd = either(odd, _mm256_and_si256(minus, Wide::down(before)));  // Only the last of them.
    odd = either(odd, _mm256_andnot_si256(before, first));
    const __m256i to_point = _mm256_andnot_si256(point, Wide::decrement(point));
    odd = either(odd, _mm256_and_si256(to_point, last));  // No point.
    const __m256i one_point = _mm256_andnot_si256(to_point, either(Wide::up(to_point), Wide::byte_at(0)));
    odd = either(odd, _mm256_xor_si256(point, one_point));
    odd = either(odd, _mm256_and_si256(_mm256_and_si256(Wide::up(before), point), last));  // Nothing but it.
    const __m256i digits = _mm256_and_si256(digit, is_digit);
    const __m256i closed =
        either(Wide::up(_mm256_and_si256(digits, to_point)), _mm256_andnot_si256(to_point, digits));
    const __m256i two = _mm256_maddubs_epi16(closed, _mm256_set1_epi16(0x010A));
    return {_mm256_madd_epi16(two, _mm256_set1_epi32(0x00010064)), to_point, minus};
}

/// Of four columns, one a lane of 64 bits.
struct FourNumbers {
    __m256i whole;   ///< The digits without the point.
    __m256i behind;  ///< How many of them stand behind the point, at least.
    __m256i minus;   ///< Not zero for a negative one.
};

FEELEM_AVX2_INLINE __m256i count_bytes(__m256i bytes) {
    return _mm256_sad_epu8(_mm256_and_si256(bytes, _mm256_set1_epi8(1)), _mm256_setzero_si256());
}

FEELEM_AVX2_INLINE FourNumbers four_of_12(const std::array<const char*, 4>& at, __m256i& odd) {
    const __m256i text = _mm256_set_epi64x(
        static_cast<long long>(load8(at[3])),
        static_cast<long long>(load8(at[2])),
        static_cast<long long>(load8(at[1])),
        static_cast<long long>(load8(at[0]))
    );
    const Mantissas all = take_apart<EightWide>(text, EightWide::byte_at(0), odd);
    const __m256i high = _mm256_mul_epu32(all.fours, _mm256_set1_epi64x(10'000));
    return {
        _mm256_add_epi64(high, _mm256_srli_epi64(all.fours, 32)),
        _mm256_sub_epi64(_mm256_set1_epi64x(7), count_bytes(all.before_point)),
        all.minus};
}

/// Two mantissas of sixteen characters; those before `keep` belong to another column.
FEELEM_AVX2_INLINE Mantissas
two_of_20(const char* one, const char* two, __m256i keep, __m256i first, __m256i& odd) {
    const __m256i text = _mm256_set_m128i(
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(two)),
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(one))
    );
    return take_apart<SixteenWide>(_mm256_blendv_epi8(_mm256_set1_epi8(' '), text, keep), first, odd);
}

/// The same lanes of both, side by side: columns 0, 2, 1, 3 of 01 and 23.
FEELEM_AVX2_INLINE __m256i side_by_side(__m256i low, __m256i high) {
    return _mm256_permute4x64_epi64(_mm256_unpacklo_epi64(low, high), 0xD8);
}

FEELEM_AVX2_INLINE __m256i both_halves(__m256i x) {
    return _mm256_unpackhi_epi64(x, x);
}

FEELEM_AVX2_INLINE __m256i whole_of_16(__m256i fours) {
    const __m256i eights =
        _mm256_madd_epi16(_mm256_packus_epi32(fours, fours), _mm256_set1_epi32(0x00012710));
    return _mm256_add_epi64(
        _mm256_mul_epu32(eights, _mm256_set1_epi64x(100'000'000)), _mm256_srli_epi64(eights, 32)
    );
}

FEELEM_AVX2_INLINE FourNumbers four_together(const Mantissas& low, const Mantissas& high) {
    const __m256i low_count = count_bytes(low.before_point), high_count = count_bytes(high.before_point);
    const __m256i before = _mm256_add_epi64(
        side_by_side(low_count, high_count), side_by_side(both_halves(low_count), both_halves(high_count))
    );
    return {
        side_by_side(whole_of_16(low.fours), whole_of_16(high.fours)),
        _mm256_sub_epi64(_mm256_set1_epi64x(15), before),
        either(
            side_by_side(low.minus, high.minus), side_by_side(both_halves(low.minus), both_halves(high.minus))
        )};
}

FEELEM_AVX2_INLINE FourNumbers
four_of_20(const std::array<const char*, 4>& at, __m256i keep, __m256i first, __m256i& odd) {
    return four_together(
        two_of_20(at[0], at[1], keep, first, odd), two_of_20(at[2], at[3], keep, first, odd)
    );
}

inline std::int32_t load4(const char* at) {
    std::int32_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return word;
}

/// Four blanks (0) or E-02, of four columns; 64 bits each.
FEELEM_AVX2_INLINE __m256i four_exponents(const std::array<const char*, 4>& at, __m256i& odd) {
    const __m128i word = _mm_setr_epi32(load4(at[0]), load4(at[1]), load4(at[2]), load4(at[3]));
    const __m128i none = _mm_cmpeq_epi32(word, _mm_set1_epi8(' '));
    // E+00 is what is taken off: then the characters are 0, 0 or 2 for the sign, and two digits.
    const __m128i rest = _mm_sub_epi8(word, _mm_set1_epi32(0x30302B45));
    const __m128i most = _mm_set1_epi32(0x09090200);
    __m128i bad = _mm_xor_si128(_mm_min_epu8(rest, most), rest);
    bad = _mm_or_si128(bad, _mm_and_si128(rest, _mm_set1_epi32(0x00000100)));  // A comma is 1.
    const __m128i ten = _mm_maddubs_epi16(rest, _mm_set1_epi32(0x010A0000));   // Above the sign's 16 bits.
    const __m128i size = _mm_srli_epi32(ten, 16);
    const __m128i shrinks =
        _mm_cmpeq_epi32(_mm_and_si128(rest, _mm_set1_epi32(0x00000200)), _mm_set1_epi32(0x200));
    const __m128i written = _mm_sub_epi32(_mm_xor_si128(size, shrinks), shrinks);
    odd = either(odd, _mm256_cvtepi32_epi64(_mm_andnot_si128(none, bad)));
    return _mm256_cvtepi32_epi64(_mm_andnot_si128(none, written));
}

/// Fifteen digits and powers of ten up to 22 are exact in a double: one rounded operation.
FEELEM_AVX2_INLINE __m256d scaled(const FourNumbers& numbers, __m256i exponents, __m256i& odd) {
    constexpr long long kMostPower = 22;
    const __m256i power = _mm256_sub_epi64(exponents, numbers.behind);
    const __m256i shrinks = _mm256_cmpgt_epi64(_mm256_setzero_si256(), power);
    const __m256i size = _mm256_sub_epi64(_mm256_xor_si256(power, shrinks), shrinks);
    odd = either(odd, _mm256_cmpgt_epi64(size, _mm256_set1_epi64x(kMostPower)));
    alignas(32) std::array<std::uint64_t, 4> places{};
    _mm256_store_si256(reinterpret_cast<__m256i*>(places.data()), size);
    const auto ten_to = [&](std::size_t i) {
        return kPowersOfTen[std::min<std::uint64_t>(places[i], kMostPower)];
    };
    const __m256d tens = _mm256_set_pd(ten_to(3), ten_to(2), ten_to(1), ten_to(0));
    // Below 2^52: as the digits of a double with that exponent.
    const __m256i magic = _mm256_set1_epi64x(0x4330000000000000);
    const __m256d whole =
        _mm256_sub_pd(_mm256_castsi256_pd(either(numbers.whole, magic)), _mm256_castsi256_pd(magic));
    const __m256d value = _mm256_blendv_pd(
        _mm256_mul_pd(whole, tens), _mm256_div_pd(whole, tens), _mm256_castsi256_pd(shrinks)
    );
    const __m256i plus = _mm256_cmpeq_epi64(numbers.minus, _mm256_setzero_si256());
    const __m256i sign = _mm256_andnot_si256(plus, _mm256_set1_epi64x(std::numeric_limits<long long>::min()));
    return _mm256_or_pd(value, _mm256_castsi256_pd(sign));
}

FEELEM_AVX2_INLINE void put(__m256d values, double* out, __m256i&) {
    _mm256_storeu_pd(out, values);
}

/// As to_float of plain_real.hpp: in the middle between two floats, and out of their usual range, the double
/// does not tell which is nearest.
FEELEM_AVX2_INLINE void put(__m256d values, float* out, __m256i& odd) {
    const __m256i behind = _mm256_and_si256(_mm256_castpd_si256(values), _mm256_set1_epi64x((1LL << 29) - 1));
    const __m256d size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), values);
    const __m256d large = _mm256_cmp_pd(
        size, _mm256_set1_pd(static_cast<double>(std::numeric_limits<float>::max())), _CMP_GE_OQ
    );
    const __m256d small = _mm256_cmp_pd(
        size, _mm256_set1_pd(static_cast<double>(std::numeric_limits<float>::min())), _CMP_LT_OQ
    );
    const __m256d some = _mm256_cmp_pd(size, _mm256_setzero_pd(), _CMP_NEQ_OQ);
    odd = either(odd, _mm256_cmpeq_epi64(behind, _mm256_set1_epi64x(1LL << 28)));
    odd = either(odd, _mm256_castpd_si256(_mm256_or_pd(large, _mm256_and_pd(small, some))));
    _mm_storeu_ps(out, _mm256_cvtpd_ps(values));
}

template <bool kIsShort, class Real>
FEELEM_AVX2 bool general_reals(
    const char* at, std::span<const std::uint32_t> offsets, std::size_t width, Real* out
) {
    __m256i odd = _mm256_setzero_si256();
    const std::size_t foreign = kIsShort ? 0 : kMostWidth - width;
    const std::size_t to_exponent = width - kExponentWidth;
    const __m256i places =
        _mm256_broadcastsi128_si256(_mm_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    const __m256i edge = _mm256_set1_epi8(static_cast<char>(foreign));
    const __m256i first = _mm256_cmpeq_epi8(places, edge);
    const __m256i keep = either(first, _mm256_cmpgt_epi8(places, edge));
    const auto four = [&](const std::uint32_t* four_offsets) FEELEM_AVX2 {
        std::array<const char*, 4> mantissas{}, exponents{};
        for (std::size_t i = 0; i < 4; ++i) {
            mantissas[i] = at + four_offsets[i] - foreign;
            exponents[i] = at + four_offsets[i] + to_exponent;
        }
        const FourNumbers numbers =
            kIsShort ? four_of_12(mantissas, odd) : four_of_20(mantissas, keep, first, odd);
        return scaled(numbers, four_exponents(exponents, odd), odd);
    };
    const std::size_t count = offsets.size();
    if (count < 4) {
        std::array<std::uint32_t, 4> again{};  // The last one again.
        for (std::size_t i = 0; i < 4; ++i) again[i] = offsets[std::min(i, count - 1)];
        std::array<Real, 4> some{};
        put(four(again.data()), some.data(), odd);
        std::copy_n(some.begin(), count, out);
        return _mm256_testz_si256(odd, odd) != 0;
    }
    for (std::size_t done = 0; done < count; done += 4) {
        // The last four once more, where their number is no multiple of four.
        const std::size_t from = std::min(done, count - 4);
        put(four(offsets.data() + from), out + from, odd);
    }
    return _mm256_testz_si256(odd, odd) != 0;
}

template <class Real>
bool general_columns(const char* at, std::span<const std::uint32_t> offsets, std::size_t width, Real* out) {
    if (!has_fast_columns() || width < kShortWidth || width > kMostWidth || offsets.empty()) return false;
    return width == kShortWidth ? general_reals<true>(at, offsets, width, out)
                                : general_reals<false>(at, offsets, width, out);
}

constexpr std::ptrdiff_t kLongestField = 15;

/// Right-aligned in sixteen characters.
FEELEM_AVX2_INLINE __m128i text_of(const TextField& field) {
    const __m128i places = _mm_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(field.last - 16));
    const auto before = static_cast<char>(kLongestField - (field.last - field.first));
    return _mm_blendv_epi8(_mm_set1_epi8(' '), text, _mm_cmpgt_epi8(places, _mm_set1_epi8(before)));
}

/// Of mantissas alone, each as long as it is: what stands before it is taken for blanks.
FEELEM_AVX2 bool reals_between(const std::array<TextField, 3>& fields, double* out) {
    __m256i odd = _mm256_setzero_si256();
    const bool too_long = std::ranges::any_of(fields, [](const TextField& field) {
        return field.last - field.first > kLongestField;
    });
    const __m256i first = SixteenWide::byte_at(0);
    const Mantissas low =
        take_apart<SixteenWide>(_mm256_set_m128i(text_of(fields[1]), text_of(fields[0])), first, odd);
    const Mantissas high =
        take_apart<SixteenWide>(_mm256_set_m128i(text_of(fields[2]), text_of(fields[2])), first, odd);
    alignas(32) std::array<double, 4> values{};
    _mm256_store_pd(values.data(), scaled(four_together(low, high), _mm256_setzero_si256(), odd));
    std::copy_n(values.begin(), 3, out);
    return !too_long && _mm256_testz_si256(odd, odd) != 0;
}

#undef FEELEM_AVX2
#undef FEELEM_AVX2_INLINE

}  // namespace

bool columns_of_reals(
    const char* at, std::span<const std::uint32_t> offsets, std::size_t width, double* out
) {
    return general_columns(at, offsets, width, out);
}

bool columns_of_reals(const char* at, std::span<const std::uint32_t> offsets, std::size_t width, float* out) {
    return general_columns(at, offsets, width, out);
}

bool three_reals_between(const std::array<TextField, 3>& fields, double* out) {
    return has_fast_columns() && reals_between(fields, out);
}

}  // namespace feelem

#else

namespace feelem {

bool columns_of_reals(const char*, std::span<const std::uint32_t>, std::size_t, double*) {
    return false;
}

bool columns_of_reals(const char*, std::span<const std::uint32_t>, std::size_t, float*) {
    return false;
}

bool three_reals_between(const std::array<TextField, 3>&, double*) {
    return false;
}

}  // namespace feelem

#endif
