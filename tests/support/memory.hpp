// SPDX-License-Identifier: Apache-2.0
// How much memory a piece of a test held at its height, mapped files and all (Linux).
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

namespace feelem::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FEELEM_SANITIZED
#endif
#endif
#if defined(FEELEM_SANITIZED) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;  ///< Memory means nothing and time little.
#else
inline constexpr bool kSanitized = false;
#endif

/// Peak of resident memory since the last reset, in bytes.
inline std::uint64_t peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
    }
    return 0;
}

inline void reset_peak_memory() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace feelem::test
