// SPDX-License-Identifier: Apache-2.0
#include "byte_range.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cstdint>

namespace feelem::server {
namespace {

/// Digits only; nothing for anything else.
std::optional<std::size_t> count_in(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const auto value = parse_integer(text);
    return value ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt;
}

}  // namespace

RangeRequest read_range(std::string_view header, std::size_t size) {
    constexpr std::string_view kUnit = "bytes=";
    if (!header.starts_with(kUnit)) return {};
    const std::string_view spec = trim(header.substr(kUnit.size()));
    const std::size_t dash = spec.find('-');
    if (dash == std::string_view::npos || spec.find(',') != std::string_view::npos) return {};
    const auto first = count_in(spec.substr(0, dash));
    const auto last = count_in(spec.substr(dash + 1));
    const bool is_open = dash + 1 == spec.size();
    if ((!first && dash > 0) || (!last && !is_open) || (!first && !last)) return {};
    if (!first) {  // "-500": the last 500 bytes
        if (*last == 0 || size == 0) return {RangeAnswer::NotSatisfiable, {}};
        return {RangeAnswer::Part, {size - std::min(*last, size), size - 1}};
    }
    if (last && *last < *first) return {};
    if (*first >= size) return {RangeAnswer::NotSatisfiable, {}};
    return {RangeAnswer::Part, {*first, last ? std::min(*last, size - 1) : size - 1}};
}

}  // namespace feelem::server
