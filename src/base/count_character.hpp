// SPDX-License-Identifier: Apache-2.0
// How often a character stands in a text, sixteen places at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace feelem {

inline std::size_t count_character(std::string_view text, char wanted) {
    using Sixteen __attribute__((vector_size(16))) = std::uint8_t;
    constexpr std::size_t kMostRounds = 255;  // A counter is a byte.
    const Sixteen all = Sixteen{} + static_cast<std::uint8_t>(wanted);
    std::size_t count = 0, at = 0;
    while (text.size() - at >= sizeof(Sixteen)) {
        Sixteen counters{};
        const std::size_t rounds = std::min(kMostRounds, (text.size() - at) / sizeof(Sixteen));
        for (std::size_t i = 0; i < rounds; ++i, at += sizeof(Sixteen)) {
            Sixteen some;
            std::memcpy(&some, text.data() + at, sizeof some);
            counters -= reinterpret_cast<Sixteen>(some == all);
        }
        for (std::size_t lane = 0; lane < sizeof(Sixteen); ++lane) count += counters[lane];
    }
    for (; at < text.size(); ++at) count += static_cast<std::size_t>(text[at] == wanted);
    return count;
}

}  // namespace feelem
