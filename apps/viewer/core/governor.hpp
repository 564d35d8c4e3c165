// SPDX-License-Identifier: Apache-2.0
// How fine the picture is, from the times of frames alone: the twin of web/src/render/governor.ts. It knows
// nothing of values: what is read, heard and felt is the same at every level.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace feelem::viewer {

/// What a level draws.
struct Fineness {
    float resolution = 1;                  ///< Of the pixels along each side.
    bool edges = true;                     ///< Lines of elements.
    std::uint64_t triangles = UINT64_MAX;  ///< Of the skin at most, where the scene has levels of detail.
};
inline constexpr std::array<Fineness, 5> kFineness{
    {{1, true, UINT64_MAX},
     {0.75F, true, 500'000},
     {0.6F, false, 500'000},
     {0.45F, false, 125'000},
     {0.33F, false, 125'000}}};

/// Frames that are looked at together.
inline constexpr std::size_t kGovernorRound = 6;

struct Governor {
    std::size_t level = 0;      ///< Into kFineness; 0: the finest.
    std::vector<double> times;  ///< Of the frames since the level changed, seconds, the latest last.
    int patience =
        1;  ///< Rounds that must be quick before a finer level is tried: more each time it was tried in vain.
    int quick_rounds = 0;
    bool tried = false;  ///< This level was come to from a coarser one.
};

/// After one more frame that took `seconds` to draw, of which there are `budget`.
void govern(Governor& governor, double seconds, double budget);

}  // namespace feelem::viewer
