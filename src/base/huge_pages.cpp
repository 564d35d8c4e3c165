// SPDX-License-Identifier: Apache-2.0
#include "base/huge_pages.hpp"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace feelem {

void prefer_huge_pages(const void* memory, std::size_t bytes) noexcept {
#if defined(__linux__)
    constexpr std::uintptr_t kHuge = std::uintptr_t{1} << 21U;
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    // Whole ones only: the ends are shared with other memory.
    const std::uintptr_t first = (start + kHuge - 1) / kHuge * kHuge;
    const std::uintptr_t last = (start + bytes) / kHuge * kHuge;
    if (last > first) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
    (void)memory;
    (void)bytes;
#endif
}

}  // namespace feelem
