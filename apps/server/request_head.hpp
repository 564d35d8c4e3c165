// SPDX-License-Identifier: Apache-2.0
// The head of a request, read strictly before any other code sees it: what is not plain HTTP/1.1 without a
// body is refused here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem::server {

inline constexpr std::size_t kLongestHead = 16 << 10;
inline constexpr std::size_t kLongestTarget = 2048;
inline constexpr std::size_t kMostHeaders = 64;

struct RequestHead {
    std::string method, target, version;
    std::vector<std::pair<std::string, std::string>> headers;  ///< Names in lower case.

    std::string_view header(std::string_view name) const;  ///< The first of that name; empty when absent.
    std::size_t count(std::string_view name) const;
};

enum class HeadState {
    Incomplete,
    Good,
    Refused
};
struct HeadAnswer {
    HeadState state = HeadState::Incomplete;
    RequestHead head;
    std::size_t size = 0;  ///< Bytes of the head, its empty line included, when it is good.
    int status = 0;        ///< When it is refused: what to answer before closing.
};
/// `bytes` is what has come so far.
HeadAnswer read_head(std::string_view bytes);

}  // namespace feelem::server
