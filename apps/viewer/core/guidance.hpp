// SPDX-License-Identifier: Apache-2.0
// Finding the largest value by ear: the higher a value ranks among those that can be seen, the faster it
// ticks. The page's rules (web/src/sense/guidance.ts).
#pragma once

#include "viewer/core/viewer_state.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace feelem::viewer {

/// Share of the sorted values that are smaller, 0..1; values that are equal count half. NaN: 0.
double rank_of(std::span<const float> sorted, double value);

/// Ticks a second, 1.5 to 12: most of the way from slow to fast lies in the last tenth.
double guide_rate(double rank);

/// From here on a value is at the top, which is said once.
inline constexpr double kTopRank = 0.99;

/// All values of what is seen at the nodes of visible parts, sorted when what they depend on is another.
class RankList {
public:
    double rank(const ViewerState& state, const ViewedModel& model, const FieldChoice& seen, double value);

private:
    std::optional<FieldChoice> seen_;
    std::vector<PartLook> parts_;
    std::vector<float> sorted_;
};

}  // namespace feelem::viewer
