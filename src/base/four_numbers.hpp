// SPDX-License-Identifier: Apache-2.0
// Four whole numbers of eight characters each in one register, for columns.cpp and text_fields.cpp.
#pragma once

#if defined(__x86_64__)

#include <immintrin.h>

namespace feelem {

/// A number is blanks, then digits to its last character; `bad` gathers bytes that may not stand so.
__attribute__((target("avx2"))) inline __m128i four_numbers(__m256i text, __m256i& bad) {
    const __m256i blank = _mm256_cmpeq_epi8(text, _mm256_set1_epi8(' '));
    const __m256i digit = _mm256_sub_epi8(text, _mm256_set1_epi8('0'));
    const __m256i is_digit = _mm256_cmpeq_epi8(_mm256_min_epu8(digit, _mm256_set1_epi8(9)), digit);
    bad = _mm256_or_si256(bad, _mm256_andnot_si256(_mm256_or_si256(blank, is_digit), _mm256_set1_epi8(-1)));
    // Blanks that only lead are ones from the low end: one more carries out of them; where all are blank
    // nothing is left.
    const __m256i more = _mm256_add_epi64(blank, _mm256_set1_epi64x(1));
    bad = _mm256_or_si256(bad, _mm256_and_si256(blank, more));
    bad = _mm256_or_si256(bad, _mm256_cmpeq_epi64(more, _mm256_setzero_si256()));
    const __m256i two = _mm256_maddubs_epi16(_mm256_andnot_si256(blank, digit), _mm256_set1_epi16(0x010A));
    const __m256i four = _mm256_madd_epi16(two, _mm256_set1_epi32(0x00010064));
    const __m256i eight = _mm256_madd_epi16(_mm256_packus_epi32(four, four), _mm256_set1_epi32(0x00012710));
    return _mm256_castsi256_si128(_mm256_permute4x64_epi64(eight, 0x08));
}

}  // namespace feelem

#endif
