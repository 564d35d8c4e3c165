// SPDX-License-Identifier: Apache-2.0
// Big arrays on big pages, where the system has them: their first touch costs a fraction, and places far
// apart are found faster.
#pragma once

#include <cstddef>
#include <vector>

namespace feelem {

/// A wish, for memory that has not been touched yet. Does nothing for less than a few pages.
void prefer_huge_pages(const void* memory, std::size_t bytes) noexcept;

/// An empty vector with room for `count`.
template <class T>
void reserve_big(std::vector<T>& values, std::size_t count) {
    values.reserve(count);
    prefer_huge_pages(values.data(), count * sizeof(T));
}

/// `count` zeros.
template <class T>
std::vector<T> big_zeros(std::size_t count) {
    std::vector<T> values;
    reserve_big(values, count);
    values.resize(count);
    return values;
}

}  // namespace feelem
