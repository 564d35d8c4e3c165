// SPDX-License-Identifier: Apache-2.0
#include "scene/scratch_file.hpp"

#include "base/parallel.hpp"

#include "feelem/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

namespace feelem {

namespace {

/// A file that has no name from the start, where the file system can; else one that loses its name at once.
std::FILE* open_unnamed(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    const int descriptor = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor >= 0) return fdopen(descriptor, "w+b");
    const std::string name = path + ".tmp-" + std::to_string(getpid());
    std::FILE* file = std::fopen(name.c_str(), "w+b");
    if (file != nullptr) std::remove(name.c_str());
    return file;
}

}  // namespace

ScratchFile::ScratchFile(std::string path, Kind kind) : path_(std::move(path)) {
    file_ = kind == Kind::Named ? std::fopen(path_.c_str(), "w+b") : open_unnamed(path_);
    if (file_ == nullptr) fail("create");
}

ScratchFile::~ScratchFile() {
    try {
        behind_.wait();
    } catch (...) {
        // Whoever is interested has asked before.
    }
    if (file_ != nullptr) std::fclose(file_);
}

void ScratchFile::put(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("write");
}

void ScratchFile::write(std::span<const std::byte> bytes) {
    settle();
    put(bytes);
    size_ += bytes.size();
}

void ScratchFile::write_behind(std::vector<std::byte> bytes, std::shared_ptr<Sha256> digest) {
    size_ += bytes.size();
    auto task = [this, bytes = std::move(bytes), digest = std::move(digest)] {
        if (digest) digest->add(bytes);
        put(bytes);
    };
    if (thread_count() < 2) {
        settle();  // The number may have been greater before.
        return task();
    }
    behind_.add(std::move(task));
}

void ScratchFile::settle() {
    behind_.wait();
}

void ScratchFile::pad_to(std::uint64_t multiple) {
    constexpr std::array<std::byte, 16> kZeros{};
    const std::uint64_t rest = size_ % multiple;
    if (rest != 0) write_behind({kZeros.begin(), kZeros.begin() + (multiple - rest)}, nullptr);
}

void ScratchFile::copy_to(AtomicFile& file) {
    settle();
    if (std::fseek(file_, 0, SEEK_SET) != 0) fail("read back");
    std::vector<std::byte> block(1u << 18);
    std::uint64_t left = size_;
    while (left > 0) {
        const std::size_t got = std::fread(block.data(), 1, block.size(), file_);
        if (got == 0) fail("read back");
        file.write(std::span<const std::byte>(block).first(got));
        left -= got;
    }
}

void ScratchFile::finish() {
    settle();
    if (std::fflush(file_) != 0 || fsync(fileno(file_)) != 0) fail("write");
}

void ScratchFile::fail(const char* doing) const {
    throw Error(
        Code::WriteFailed,
        path_,
        std::string("cannot ") + doing + " the file: " + std::strerror(errno) +
            ". Is the folder there and writable, and the disk not full?"
    );
}

}  // namespace feelem
