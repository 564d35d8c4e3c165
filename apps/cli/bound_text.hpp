// SPDX-License-Identifier: Apache-2.0
// Bounds as people read them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace feelem::cli {

/// To three digits, never to less than it is.
inline std::string bound_text(double bound) {
    if (!(bound > 0)) return "0";
    const double place = std::pow(10.0, std::floor(std::log10(bound)) - 2);
    return fmt::format("{:.3g}", std::ceil(bound / place - 1e-9) * place);
}

}  // namespace feelem::cli
