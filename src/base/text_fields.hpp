// SPDX-License-Identifier: Apache-2.0
// Fields that end at commas and line ends: where they end, many at once, and the whole numbers in them.
#pragma once

#include "base/columns.hpp"
#include "base/eight_digits.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace feelem {

/// So many bytes before a field must be readable where it is read here, and so many are left behind one.
inline constexpr std::ptrdiff_t kFieldReach = 32;
/// Digits of a whole number that is read here.
inline constexpr std::size_t kMostFieldDigits = 8;

/// Which of 64 characters are a comma or a line end: bit i for at[i].
inline std::uint64_t field_ends_portable(const char* at) {
    std::uint64_t ends = 0;
    for (unsigned i = 0; i < 64; ++i)
        ends |= static_cast<std::uint64_t>(
                    static_cast<unsigned>(at[i] == ',') | static_cast<unsigned>(at[i] == '\n')
                )
                << i;
    return ends;
}

#if defined(__SSE2__)
inline std::uint64_t field_ends(const char* at) {
    std::uint64_t ends = 0;
    for (unsigned i = 0; i < 4; ++i) {
        const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + 16 * i));
        const __m128i is_end =
            _mm_or_si128(_mm_cmpeq_epi8(some, _mm_set1_epi8(',')), _mm_cmpeq_epi8(some, _mm_set1_epi8('\n')));
        ends |= static_cast<std::uint64_t>(_mm_movemask_epi8(is_end)) << (16 * i);
    }
    return ends;
}
#else
inline std::uint64_t field_ends(const char* at) {
    return field_ends_portable(at);
}
#endif

/// Walks the commas and line ends of a text, each character looked at once whatever is made of it.
class FieldEnds {
public:
    FieldEnds(const char* at, const char* end)
        : block_(at), end_(end), ends_(has_block() ? field_ends(at) : 0) {}

    /// The next comma or line end; null when too few characters are left: kFieldReach stand behind it.
    const char* next() {
        while (ends_ == 0) {
            if (!has_block()) return nullptr;
            block_ += 64;
            if (!has_block()) return nullptr;
            ends_ = field_ends(block_);
        }
        const char* const found = block_ + std::countr_zero(ends_);
        ends_ &= ends_ - 1;
        return found;
    }

private:
    bool has_block() const { return end_ - block_ >= 64 + kFieldReach; }

    const char* block_;
    const char* end_;
    std::uint64_t ends_ = 0;
};

/// Fields of blanks and one to eight digits up to the last character. False: something else stands in one of
/// them, and `out` holds nothing. kFieldReach bytes before the end of each must be readable.
bool whole_numbers_between(std::span<const TextField> fields, std::uint32_t* out);
/// The same on any processor.
bool whole_numbers_between_portable(std::span<const TextField> fields, std::uint32_t* out);

}  // namespace feelem
