// SPDX-License-Identifier: Apache-2.0
// Big arrays on big pages, where the system has them: their first touch costs a fraction, and places far
// apart are found faster.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

namespace feelem {

/// A wish, for memory that has not been touched yet. Does nothing for less than a few pages.
void prefer_huge_pages(const void* memory, std::size_t bytes) noexcept;

/// What stands there is not needed any more: the system may take whole pages of it back, whose bytes are then
/// undefined.
void drop_pages(void* memory, std::size_t bytes) noexcept;

/// Room for `count`.
template <class T>
void reserve_big(std::vector<T>& values, std::size_t count) {
    if (count <= values.capacity()) return;
    values.reserve(count);
    prefer_huge_pages(values.data(), values.capacity() * sizeof(T));
}

/// Before `count` more are added to a vector that has no room for them: room for as many as `left` bytes of
/// text hold, if each takes `each` of them, as the last one did.
template <class T>
void grow_by_text(std::vector<T>& values, std::size_t left, std::size_t each, std::size_t count = 1) {
    constexpr std::size_t kShortest = 8;
    if (values.size() + count <= values.capacity()) return;
    const std::size_t more = left / std::max(each, kShortest);
    reserve_big(values, values.size() + values.size() / 2 + more + count);
}

/// `count` elements of value zero.
template <class T>
std::vector<T> big_zeros(std::size_t count) {
    std::vector<T> values;
    reserve_big(values, count);
    values.resize(count);
    return values;
}

/// The same, not written before they are used: the system gives memory as zeros. For types of which a value
/// is bits that are all zero, and nothing has to be done when it ends.
template <class T>
class ZeroedArray {
    static_assert(std::is_trivially_destructible_v<T> && std::is_trivially_copyable_v<T>);

public:
    explicit ZeroedArray(std::size_t count)
        : memory_(std::calloc(count + 1, std::max(sizeof(T), alignof(T))), &std::free), size_(count) {
        if (memory_ == nullptr) throw std::bad_alloc();
        const auto start = reinterpret_cast<std::uintptr_t>(memory_.get());
        data_ = reinterpret_cast<T*>((start + alignof(T) - 1) / alignof(T) * alignof(T));
        prefer_huge_pages(data_, count * sizeof(T));
    }

    T* data() noexcept { return data_; }
    const T* data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    std::span<const T> span() const noexcept { return {data_, size_}; }

private:
    std::unique_ptr<void, void (*)(void*)> memory_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace feelem
