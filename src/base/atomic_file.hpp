// SPDX-License-Identifier: Apache-2.0
// Output that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace feelem {

/// Writes to a temporary file beside the target; commit() renames it over the target. Without commit nothing
/// is left behind (a killed process leaves only the temporary file, "NAME.tmp-PID", never a half target).
class AtomicFile {
public:
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Each throws Error(WriteFailed) with the system's reason.
    void write(std::string_view bytes);
    void write(std::span<const std::byte> bytes);
    void seek(std::size_t offset);
    void commit();

private:
    [[noreturn]] void fail(const char* doing) const;
    std::string path_;
    std::string temporary_;
    std::FILE* file_ = nullptr;
};

}  // namespace feelem
