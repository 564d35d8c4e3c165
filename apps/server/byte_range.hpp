// SPDX-License-Identifier: Apache-2.0
// The Range header (RFC 9110, 14): which bytes of a file are asked for.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace feelem::server {

struct ByteRange {
    std::size_t first = 0;
    std::size_t last = 0;  ///< Inclusive.
};
enum class RangeAnswer {
    Whole,          ///< No range, several, or none that can be read: the whole file (200).
    Part,           ///< 206
    NotSatisfiable  ///< 416
};
struct RangeRequest {
    RangeAnswer answer = RangeAnswer::Whole;
    ByteRange range;
};
RangeRequest read_range(std::string_view header, std::size_t size);

}  // namespace feelem::server
