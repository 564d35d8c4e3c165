// SPDX-License-Identifier: Apache-2.0
// Progress and cancelling, as the steps of the pipeline use them.
#pragma once

#include "feelem/convert.hpp"

#include <cstddef>
#include <string_view>

namespace feelem {

/// Thrown when the caller cancels; never leaves the public functions of convert.hpp.
struct Cancelled {};

inline void report_progress(const Progress& progress, std::string_view stage, double fraction) {
    if (progress && !progress(stage, fraction)) throw Cancelled{};
}

inline double fraction_of(std::size_t done, std::size_t all) {
    return all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
}

}  // namespace feelem
