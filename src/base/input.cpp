// SPDX-License-Identifier: Apache-2.0
#include "base/input.hpp"

#include "feelem/error.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace feelem {

struct Input::Storage {
    std::string name;
    std::string memory;
    void* map = nullptr;
    std::size_t map_size = 0;

    Storage() = default;
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;
    ~Storage() {
        if (map != nullptr) munmap(map, map_size);
    }
    std::string_view view() const {
        return map != nullptr ? std::string_view(static_cast<const char*>(map), map_size) : memory;
    }
};

namespace {

/// Closes a file descriptor at the end of a scope.
struct Descriptor {
    int fd;
    ~Descriptor() {
        if (fd >= 0) close(fd);
    }
};

}  // namespace

Input Input::from_file(const std::string& path) {
    const Descriptor file{open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.fd < 0) {
        const int error = errno;
        const Code code = error == ENOENT ? Code::FileNotFound : Code::FileUnreadable;
        throw Error(code, path, std::string("cannot open the file: ") + std::strerror(error));
    }
    struct stat status {};
    if (fstat(file.fd, &status) != 0 || !S_ISREG(status.st_mode)) {
        throw Error(Code::FileUnreadable, path, "not a regular file");
    }
    auto storage = std::make_shared<Storage>();
    storage->name = path;
    if (status.st_size > 0) {
        storage->map_size = static_cast<std::size_t>(status.st_size);
        void* map = mmap(nullptr, storage->map_size, PROT_READ, MAP_PRIVATE, file.fd, 0);
        if (map == MAP_FAILED) {
            throw Error(
                Code::FileUnreadable, path, std::string("cannot map the file: ") + std::strerror(errno)
            );
        }
        storage->map = map;
        madvise(map, storage->map_size, MADV_SEQUENTIAL);
    }
    return Input(std::move(storage));
}

Input Input::from_memory(std::string name, std::string bytes) {
    auto storage = std::make_shared<Storage>();
    storage->name = std::move(name);
    storage->memory = std::move(bytes);
    return Input(std::move(storage));
}

const std::string& Input::name() const noexcept {
    return storage_->name;
}

std::string_view Input::text() const noexcept {
    return storage_->view();
}

std::span<const std::byte> Input::bytes() const noexcept {
    return std::as_bytes(std::span(text()));
}

std::string Input::where_line(std::size_t offset) const {
    const std::string_view before = text().substr(0, std::min(offset, size()));
    return name() + ":" + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
}

std::string Input::where_byte(std::size_t offset) const {
    return name() + ":byte " + std::to_string(offset);
}

void Input::release(std::size_t first, std::size_t last) const noexcept {
    if (storage_->map == nullptr) return;
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    first = (first + page - 1) / page * page;
    last = std::min(last, storage_->map_size) / page * page;
    if (first < last) madvise(static_cast<char*>(storage_->map) + first, last - first, MADV_DONTNEED);
}

void Input::expect_jumps() const noexcept {
    if (storage_->map != nullptr) madvise(storage_->map, storage_->map_size, MADV_RANDOM);
}

void Input::expect_run() const noexcept {
    if (storage_->map != nullptr) madvise(storage_->map, storage_->map_size, MADV_SEQUENTIAL);
}

}  // namespace feelem
