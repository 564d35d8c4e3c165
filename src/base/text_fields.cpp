// SPDX-License-Identifier: Apache-2.0
// Must: give the whole numbers of fields, or refuse them all.
// Assumes: the bytes before a field are readable.
// Algorithm: the last eight characters of four fields lie in one register, what stands before a field taken
// for blanks; the digits become numbers by three products of neighbours. Data: none.
#include "base/text_fields.hpp"

#include "base/four_numbers.hpp"

#include <algorithm>
#include <array>

#if defined(__x86_64__)
#include <immintrin.h>
#define FEELEM_AVX2 __attribute__((target("avx2")))
#endif

namespace feelem {
namespace {

constexpr std::uint64_t kBlankWord = 0x2020202020202020;

/// By the length of a field: which of eight characters before its end are its own, and blanks for the others.
constexpr std::array<std::uint64_t, 9> kOwnBytes = [] {
    std::array<std::uint64_t, 9> masks{};
    for (std::size_t i = 1; i < 9; ++i) masks[i] = ~std::uint64_t{0} << (64 - 8 * i);
    return masks;
}();

/// The last eight characters of a field, blanks before them.
inline std::uint64_t last_eight_of(const TextField& field, std::uint64_t& foreign) {
    const auto width = static_cast<std::size_t>(field.last - field.first);
    const std::uint64_t own = kOwnBytes[std::min<std::size_t>(width, 8)];
    for (const char* p = field.first; p < field.last - 8; ++p)
        foreign |= static_cast<std::uint64_t>(*p ^ ' ');
    return (load8(field.last - 8) & own) | (kBlankWord & ~own);
}

#if defined(__x86_64__)

/// Bytes that may not stand so are gathered in `bad`.
FEELEM_AVX2 inline __m128i four_fields(const TextField* fields, __m256i& bad, std::uint64_t& foreign) {
    const __m256i text = _mm256_set_epi64x(
        static_cast<long long>(last_eight_of(fields[3], foreign)),
        static_cast<long long>(last_eight_of(fields[2], foreign)),
        static_cast<long long>(last_eight_of(fields[1], foreign)),
        static_cast<long long>(last_eight_of(fields[0], foreign))
    );
    return four_numbers(text, bad);
}

FEELEM_AVX2 bool numbers_by_fours(std::span<const TextField> fields, std::uint32_t* out) {
    __m256i bad = _mm256_setzero_si256();
    std::uint64_t foreign = 0;
    for (std::size_t i = 0; i < fields.size(); i += 4) {
        // The last four once more, where their number is no multiple of four.
        const std::size_t from = std::min(i, fields.size() - 4);
        const __m128i values = four_fields(&fields[from], bad, foreign);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(out + from), values);
    }
    return foreign == 0 && _mm256_testz_si256(bad, bad) != 0;
}

#endif

}  // namespace

bool whole_numbers_between_portable(std::span<const TextField> fields, std::uint32_t* out) {
    std::uint64_t bad = 0;
    for (const TextField& field : fields) {
        const std::uint64_t word = last_eight_of(field, bad);
        *out++ = eight_columns(word, bad);
    }
    return bad == 0;
}

#if defined(__x86_64__)

bool whole_numbers_between(std::span<const TextField> fields, std::uint32_t* out) {
    return fields.size() >= 4 && has_fast_columns() ? numbers_by_fours(fields, out)
                                                    : whole_numbers_between_portable(fields, out);
}

#else

bool whole_numbers_between(std::span<const TextField> fields, std::uint32_t* out) {
    return whole_numbers_between_portable(fields, out);
}

#endif

}  // namespace feelem
