// SPDX-License-Identifier: Apache-2.0
#include "base/columns.hpp"

#include "base/eight_digits.hpp"
#include "base/four_numbers.hpp"
#include "base/wide_columns.hpp"

#include <algorithm>

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

FEELEM_AVX2 inline void put_four(__m128i values, std::int64_t* out) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_cvtepu32_epi64(values));
}
FEELEM_AVX2 inline void put_four(__m128i values, std::uint32_t* out) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), values);
}

/// Bytes that may not stand so are gathered in `bad`.
template <class Whole>
FEELEM_AVX2 inline void four_columns(const char* last_eight, std::size_t width, Whole* out, __m256i& bad) {
    const __m256i text = _mm256_set_epi64x(
        static_cast<long long>(load8(last_eight + 3 * width)),
        static_cast<long long>(load8(last_eight + 2 * width)),
        static_cast<long long>(load8(last_eight + width)),
        static_cast<long long>(load8(last_eight))
    );
    put_four(four_numbers(text, bad), out);
}

template <class Whole>
FEELEM_AVX2 bool columns_by_fours(const char* at, std::size_t width, std::size_t count, Whole* out) {
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

#endif

template <class Whole>
bool columns_one_by_one(const char* at, std::size_t width, std::size_t count, Whole* out) {
    std::uint64_t bad = 0;
    for (std::size_t i = 0; i < count; ++i, at += width) {
        bad |= foreign_before(at, width);
        out[i] = eight_columns(load8(at + width - 8), bad);
    }
    return bad == 0;
}

template <class Whole>
bool columns_of_whole(const char* at, std::size_t width, std::size_t count, Whole* out) {
#if defined(__x86_64__)
    if (count >= 4 && has_fast_columns()) return columns_by_fours(at, width, count, out);
#endif
    return columns_one_by_one(at, width, count, out);
}

}  // namespace

bool columns_of_integers_portable(const char* at, std::size_t width, std::size_t count, std::int64_t* out) {
    return columns_one_by_one(at, width, count, out);
}

bool columns_of_integers_portable(const char* at, std::size_t width, std::size_t count, std::uint32_t* out) {
    return columns_one_by_one(at, width, count, out);
}

bool columns_of_integers(const char* at, std::size_t width, std::size_t count, std::int64_t* out) {
    return columns_of_whole(at, width, count, out);
}

bool columns_of_integers(const char* at, std::size_t width, std::size_t count, std::uint32_t* out) {
    if (!has_wide_columns() || width > kWidestColumn) return columns_of_whole(at, width, count, out);
    bool good = true;
    for (std::size_t i = 0; i < count && good; i += kWideColumns)
        good = wide_columns_of_integers(at + i * width, width, std::min(kWideColumns, count - i), out + i);
    return good;
}

bool has_fast_columns() {
#if defined(__x86_64__)
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
#else
    return false;
#endif
}

}  // namespace feelem
