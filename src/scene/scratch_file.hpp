// SPDX-License-Identifier: Apache-2.0
// Bytes that wait on disk until the scene's JSON is known, so that memory need not hold them.
#pragma once

#include "base/atomic_file.hpp"
#include "base/behind.hpp"
#include "base/sha256.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

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
    /// The same, and adds them to the digest, on a thread of its own where there is another one. What fails
    /// then is thrown by a later call.
    void write_behind(std::vector<std::byte> bytes, std::shared_ptr<Sha256> digest);
    void settle();  ///< Until all of it is written and in its digest.
    void pad_to(std::uint64_t multiple);
    void copy_to(AtomicFile& file);
    void finish();  ///< Named: everything on disk.
    std::uint64_t size() const noexcept { return size_; }

private:
    void put(std::span<const std::byte> bytes);
    [[noreturn]] void fail(const char* doing) const;
    std::string path_;
    std::FILE* file_ = nullptr;
    std::uint64_t size_ = 0;  ///< With what is still to be written.
    Behind behind_{4};        ///< Ends before what it writes to.
};

}  // namespace feelem
