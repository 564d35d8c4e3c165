// SPDX-License-Identifier: Apache-2.0
// Bytes that wait on disk until the scene's JSON is known, so that memory need not hold them.
#pragma once

#include "base/atomic_file.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

namespace feelem {

/// Without a name it stands beside `path` and vanishes with the program, however that ends.
class ScratchFile {
public:
    enum class Kind : std::uint8_t {
        Unnamed,
        Named
    };
    ScratchFile(std::string path, Kind kind);
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    /// Each throws Error(WriteFailed) with the system's reason.
    void write(std::span<const std::byte> bytes);
    void pad_to(std::uint64_t multiple);
    void copy_to(AtomicFile& file);
    void finish();  ///< Named: everything on disk.
    std::uint64_t size() const noexcept { return size_; }

private:
    [[noreturn]] void fail(const char* doing) const;
    std::string path_;
    std::FILE* file_ = nullptr;
    std::uint64_t size_ = 0;
};

}  // namespace feelem
