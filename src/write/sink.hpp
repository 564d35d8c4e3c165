// SPDX-License-Identifier: Apache-2.0
// Formatted text and raw arrays into an AtomicFile, a block at a time.
#pragma once

#include "base/atomic_file.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace feelem {

class Sink {
public:
    explicit Sink(AtomicFile& file) : file_(file) {}

    template <class... Args>
    void text(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
        if (buffer_.size() > kBlock) flush();
    }

    template <class T>
    requires std::is_arithmetic_v<T>
    void raw(T value) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        buffer_.append(bytes, bytes + sizeof(T));
        if (buffer_.size() > kBlock) flush();
    }

    void flush() {
        file_.write(std::string_view(buffer_.data(), buffer_.size()));
        buffer_.clear();
    }

private:
    static constexpr std::size_t kBlock = 1u << 18;
    AtomicFile& file_;
    fmt::memory_buffer buffer_;
};

}  // namespace feelem
