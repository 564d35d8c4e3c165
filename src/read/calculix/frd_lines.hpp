// SPDX-License-Identifier: Apache-2.0
// The lines of a text body of an .frd file: taken one by one, their fields, and the pages behind them.
#pragma once

#include "base/input.hpp"
#include "base/number.hpp"
#include "read/calculix/frd_blocks.hpp"
#include "read/calculix/frd_fields.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace feelem::frd {

inline constexpr std::size_t kMark = 3;  ///< " -1" or " -2" before each line.
inline constexpr std::size_t kRealWidth = 12;

/// Lets go of what was read, a window at a time.
class Trail {
public:
    Trail(const Input& input, std::size_t first) : input_(input), released_(first) {}
    void at(std::size_t offset) {
        constexpr std::size_t kWindow = 4u << 20;
        if (offset - released_ < kWindow) return;
        input_.release(released_, offset);
        released_ = offset;
    }
    void end(std::size_t offset) const { input_.release(released_, offset); }

private:
    const Input& input_;
    std::size_t released_;
};

/// Lines of a text body.
struct Lines {
    std::string_view text;
    std::size_t at = 0;
    std::size_t last = 0;

    bool done() const { return at >= last; }
    std::string_view take() {
        const std::size_t end = std::min(text.find('\n', at), last);
        std::string_view line = text.substr(at, end - at);
        at = std::min(end + 1, last);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }
};

inline std::int64_t integer_field(std::string_view line, std::size_t first, std::size_t width, bool& ok) {
    std::int64_t value = 0;
    if (first + width <= line.size() && fast_integer(line.data() + first, width, value)) return value;
    const auto general = parse_integer(first < line.size() ? line.substr(first, width) : std::string_view{});
    if (!general) ok = false;
    return general.value_or(0);
}

inline double real_field(std::string_view line, std::size_t first, bool& ok) {
    double value = 0;
    if (first + 12 <= line.size() && fast_real12(line.data() + first, value)) return value;
    const auto general = parse_double(first < line.size() ? line.substr(first, 12) : std::string_view{});
    if (!general) ok = false;
    return general.value_or(0);
}

inline bool has_mark(const char* at, const char* mark) {
    return at[0] == mark[0] && at[1] == mark[1] && at[2] == mark[2];
}

/// Where a record of the mesh stands, for messages.
inline std::string place_in_mesh(const Input& input, const Layout& layout, std::size_t offset) {
    return is_text(layout.nodes.coding) ? input.where_line(offset) : input.where_byte(offset);
}

[[noreturn]] inline void bad_mesh_record(
    const std::string& place, std::string_view what, std::string_view line
) {
    throw Error(
        Code::BadNumber, place, fmt::format("this is no record of {}: \"{}\"", what, line.substr(0, 80))
    );
}

}  // namespace feelem::frd
