// SPDX-License-Identifier: Apache-2.0
// A named, read-only run of bytes: a mapped file or memory. Readers see nothing else of the outside world.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace feelem {

class Input {
public:
    /// Maps the file. Throws Error(FileNotFound | FileUnreadable).
    static Input from_file(const std::string& path);
    static Input from_memory(std::string name, std::string bytes);

    const std::string& name() const noexcept;
    std::string_view text() const noexcept;
    std::span<const std::byte> bytes() const noexcept;
    std::size_t size() const noexcept { return text().size(); }

    /// "name:line" of a byte offset: one pass over the bytes before it.
    std::string where_line(std::size_t offset) const;
    /// "name:byte N", for binary files.
    std::string where_byte(std::size_t offset) const;

    /// Tells the system that [first, last) is not needed for now, so that a mapped file does not count as
    /// used memory. The bytes stay readable: they are fetched again when touched.
    void release(std::size_t first, std::size_t last) const noexcept;

    /// How a mapped file will be touched from now on: here and there, so that nothing is read ahead, or one
    /// byte after the other, as it is assumed at first. Changes no result.
    void expect_jumps() const noexcept;
    void expect_run() const noexcept;

private:
    struct Storage;
    explicit Input(std::shared_ptr<const Storage> storage) : storage_(std::move(storage)) {}
    std::shared_ptr<const Storage> storage_;
};

}  // namespace feelem
