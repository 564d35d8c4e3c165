// SPDX-License-Identifier: Apache-2.0
// What the generators of inputs share: a file written in large pieces, and the block of nodes that stands in
// it.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace bench {

/// A file that is written in large pieces and whose failure is noticed.
class Writer {
public:
    explicit Writer(const char* path) : file_(std::fopen(path, "wb")) {
        if (file_ == nullptr) fail();
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        flush();
        if (std::fclose(file_) != 0) fail();
    }

    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
        buffer_.push_back('\n');
        if (buffer_.size() > kPiece) flush();
    }

    void bytes(const void* from, std::size_t count) {
        const char* const first = static_cast<const char*>(from);
        buffer_.append(first, first + count);
        if (buffer_.size() > kPiece) flush();
    }

private:
    static constexpr std::size_t kPiece = 1u << 20;

    void flush() {
        if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) fail();
        buffer_.clear();
    }
    [[noreturn]] static void fail() {
        std::perror("bench");
        std::exit(1);
    }

    std::FILE* file_;
    fmt::memory_buffer buffer_;
};

/// The block: nodes are numbered x first, then y, then z, from 1; 10 mm between neighbours.
struct Block {
    int side;

    int node_count() const { return side * side * side; }
    int element_count() const { return (side - 1) * (side - 1) * (side - 1); }
    int node(int x, int y, int z) const { return 1 + x + side * (y + side * z); }
    std::array<double, 3> position(int id) const {
        const int i = id - 1;
        return {10.0 * (i % side), 10.0 * (i / side % side), 10.0 * (i / side / side)};
    }
    /// A little beside it: no round numbers, a real mesh has none.
    std::array<double, 3> archived(int id) const {
        const auto p = position(id);
        return {p[0] + std::sin(0.37 * id), p[1] + std::sin(0.59 * id), p[2] + std::sin(0.83 * id)};
    }
    /// use(id, place) for each node.
    template <class Use>
    void for_each_node(const Use& use) const {
        for (int id = 1; id <= node_count(); ++id) use(id, archived(id));
    }
    /// use(id, nodes) for each hex8, along x first.
    template <class Use>
    void for_each_element(const Use& use) const {
        int id = 0;
        for (int z = 0; z + 1 < side; ++z) {
            for (int y = 0; y + 1 < side; ++y) {
                for (int x = 0; x + 1 < side; ++x) {
                    use(++id,
                        std::array<int, 8>{
                            node(x, y, z),
                            node(x + 1, y, z),
                            node(x + 1, y + 1, z),
                            node(x, y + 1, z),
                            node(x, y, z + 1),
                            node(x + 1, y, z + 1),
                            node(x + 1, y + 1, z + 1),
                            node(x, y + 1, z + 1)});
                }
            }
        }
    }
};

}  // namespace bench
