// SPDX-License-Identifier: Apache-2.0
#include "base/huge_pages.hpp"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace feelem {
#if defined(__linux__)
namespace {

/// Whole big pages only: the ends are shared with other memory.
void advise_on_whole_pages(const void* memory, std::size_t bytes, int advice) noexcept {
    constexpr std::uintptr_t kHuge = std::uintptr_t{1} << 21U;
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (start + kHuge - 1) / kHuge * kHuge;
    const std::uintptr_t last = (start + bytes) / kHuge * kHuge;
    if (last > first) madvise(reinterpret_cast<void*>(first), last - first, advice);
}

}  // namespace

void prefer_huge_pages(const void* memory, std::size_t bytes) noexcept {
    advise_on_whole_pages(memory, bytes, MADV_HUGEPAGE);
}

void drop_pages(void* memory, std::size_t bytes) noexcept {
    advise_on_whole_pages(memory, bytes, MADV_DONTNEED);
}

#else

void prefer_huge_pages(const void*, std::size_t) noexcept {}

void drop_pages(void*, std::size_t) noexcept {}

#endif
}  // namespace feelem
