// SPDX-License-Identifier: Apache-2.0
// Numbers from binary files: bounds always checked, either byte order.
#pragma once

#include "base/input.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace feelem {

/// A position in an Input. Reading beyond the end throws Error(Truncated) with the place.
class ByteReader {
public:
    ByteReader(const Input& input, std::size_t offset, bool swap = false)
        : input_(&input), offset_(offset), swap_(swap) {}

    template <class T>
    requires std::is_arithmetic_v<T> T read() {
        std::byte raw[sizeof(T)];
        std::memcpy(raw, take(sizeof(T)).data(), sizeof(T));
        if (swap_) reverse(raw);
        T value;
        std::memcpy(&value, raw, sizeof(T));
        return value;
    }
    std::span<const std::byte> take(std::size_t count);
    std::size_t offset() const noexcept { return offset_; }
    std::size_t remaining() const noexcept { return input_->size() - offset_; }

private:
    static void reverse(std::span<std::byte> bytes);
    const Input* input_;
    std::size_t offset_;
    bool swap_;
};

}  // namespace feelem
