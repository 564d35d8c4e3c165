// SPDX-License-Identifier: Apache-2.0
// The least that any reader of text does: maps a file and looks for the ends of its lines.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
    const int file = argc == 2 ? open(argv[1], O_RDONLY) : -1;
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0 || status.st_size == 0) {
        std::fputs("usage: bench_scan_lines FILE\n", stderr);
        return 2;
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    void* map = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (map == MAP_FAILED) return 1;
    const char* at = static_cast<const char*>(map);
    const char* end = at + size;
    std::size_t lines = 0;
    while (at != end) {
        const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
        if (found == nullptr) break;
        at = static_cast<const char*>(found) + 1;
        ++lines;
    }
    std::printf("%zu\n", lines);
}
