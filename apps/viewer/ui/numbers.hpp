// SPDX-License-Identifier: Apache-2.0
// Numbers and units as people read them: the twin of web/src/ui/format.ts, bound by
// tests/contract/numbers.json.
#pragma once

#include "feelem/present.hpp"
#include "feelem/result.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

/// The unit as printed: "degC" -> "°C".
std::string unit_text(std::string_view unit);
/// Up to `digits` significant digits; no digit that the number does not have. NaN: "no value".
std::string number_text(double value, int digits = 6);
/// All labels of an axis with the same number of decimals, enough to tell neighbours apart and no more.
std::vector<std::string> axis_texts(std::span<const double> values);
std::string with_unit(double value, std::string_view unit);
/// "Mode 3 · 172.844 Hz", "Step 1.4 · 480 s".
std::string step_text(const Step& step);
/// A bound to two digits, never to less than it is.
std::string bound_text(double bound);

/// The value at position t (0..1) of a range: the inverse of `normalise`.
double value_at_position(double t, const ValueRange& range);
/// Positions of a legend's labels: every band edge while there is room, else evenly spread.
std::vector<double> label_positions(int bands);

}  // namespace feelem::viewer
