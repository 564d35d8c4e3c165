// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.hpp"

#include "feelem/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace feelem {

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), temporary_(path_ + ".tmp-" + std::to_string(getpid())) {
    file_ = std::fopen(temporary_.c_str(), "wbx");
    if (file_ == nullptr && errno == EEXIST) {
        // Left by a killed process that had our number.
        std::remove(temporary_.c_str());
        file_ = std::fopen(temporary_.c_str(), "wbx");
    }
    if (file_ == nullptr) fail("create");
}

AtomicFile::~AtomicFile() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::remove(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("write");
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("write");
}

void AtomicFile::seek(std::size_t offset) {
    if (std::fseek(file_, static_cast<long>(offset), SEEK_SET) != 0) fail("write");
}

void AtomicFile::commit() {
    if (std::fflush(file_) != 0 || fsync(fileno(file_)) != 0) fail("write");
    const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
    if (!closed || std::rename(temporary_.c_str(), path_.c_str()) != 0) {
        const int error = errno;
        std::remove(temporary_.c_str());
        errno = error;
        fail("finish");
    }
}

void AtomicFile::fail(const char* doing) const {
    throw Error(
        Code::WriteFailed,
        path_,
        std::string("cannot ") + doing + " the file: " + std::strerror(errno) +
            ". Is the folder there and writable?"
    );
}

}  // namespace feelem
