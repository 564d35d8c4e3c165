// SPDX-License-Identifier: Apache-2.0
#include "request_head.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"

#include <algorithm>

namespace feelem::server {
namespace {

constexpr std::string_view kEnd = "\r\n\r\n";

/// RFC 9110, 5.6.2.
bool is_token(std::string_view text) {
    constexpr std::string_view kMarks = "!#$%&'*+-.^_`|~";
    return !text.empty() && std::ranges::all_of(text, [&](char c) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        return is_letter || (c >= '0' && c <= '9') || kMarks.find(c) != std::string_view::npos;
    });
}

bool is_visible(char c) {
    return c > 0x20 && c < 0x7f;
}

HeadAnswer refuse(int status) {
    HeadAnswer answer;
    answer.state = HeadState::Refused;
    answer.status = status;
    return answer;
}

/// Status to refuse it with, or 0.
int read_request_line(std::string_view line, RequestHead& head) {
    const std::size_t first = line.find(' ');
    const std::size_t last = line.rfind(' ');
    if (first == std::string_view::npos || last == first) return 400;
    head.method = line.substr(0, first);
    head.target = line.substr(first + 1, last - first - 1);
    head.version = line.substr(last + 1);
    if (!is_token(head.method)) return 400;
    if (head.target.size() > kLongestTarget) return 414;
    // Neither "http://…" nor "*": those are for proxies.
    if (!head.target.starts_with('/') || !std::ranges::all_of(head.target, is_visible)) return 400;
    if (head.version == "HTTP/1.1" || head.version == "HTTP/1.0") return 0;
    return head.version.starts_with("HTTP/") ? 505 : 400;
}

int read_header_line(std::string_view line, RequestHead& head) {
    const std::size_t colon = line.find(':');
    // A folded line begins with a blank: no name either.
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return 400;
    if (head.headers.size() == kMostHeaders) return 431;
    const std::string_view value = trim(line.substr(colon + 1));
    const auto is_allowed = [](char c) {
        return c == '\t' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
    };
    if (!std::ranges::all_of(value, is_allowed)) return 400;
    head.headers.emplace_back(lower_case(line.substr(0, colon)), value);
    return 0;
}

/// Nothing here takes a body, so that no two readers can disagree where a request ends.
int refuse_body(const RequestHead& head) {
    if (head.count("transfer-encoding") > 0) return 400;
    const std::size_t lengths = head.count("content-length");
    if (lengths > 1) return 400;
    if (lengths == 0 || head.header("content-length") == "0") return 0;
    const std::string_view length = head.header("content-length");
    return length.find_first_not_of("0123456789") == std::string_view::npos && !length.empty() ? 413 : 400;
}

}  // namespace

std::string_view RequestHead::header(std::string_view name) const {
    const auto found = std::ranges::find(headers, name, &std::pair<std::string, std::string>::first);
    return found == headers.end() ? std::string_view() : found->second;
}

std::size_t RequestHead::count(std::string_view name) const {
    return static_cast<std::size_t>(
        std::ranges::count(headers, name, &std::pair<std::string, std::string>::first)
    );
}

HeadAnswer read_head(std::string_view bytes) {
    const std::size_t end = bytes.find(kEnd);
    const std::string_view text = bytes.substr(0, end == std::string_view::npos ? end : end + 2);
    // Said before the end has come, so that nobody can make us wait for it.
    if (text.size() > kLongestHead) return refuse(431);
    if (text.find('\0') != std::string_view::npos) return refuse(400);
    if (text.find("\r\n") == std::string_view::npos && text.size() > kLongestTarget + 64) return refuse(414);
    if (end == std::string_view::npos) {
        // A bare line feed never becomes a line end.
        const std::size_t feed = text.find('\n');
        const bool is_bare = feed != std::string_view::npos && (feed == 0 || text[feed - 1] != '\r');
        return is_bare ? refuse(400) : HeadAnswer{};
    }
    HeadAnswer answer;
    bool is_first = true;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t at = rest.find("\r\n");
        const std::string_view line = rest.substr(0, at);
        rest.remove_prefix(at + 2);
        if (line.find_first_of("\r\n") != std::string_view::npos) return refuse(400);
        const int status =
            is_first ? read_request_line(line, answer.head) : read_header_line(line, answer.head);
        if (status != 0) return refuse(status);
        is_first = false;
    }
    const bool is_reading = answer.head.method == "GET" || answer.head.method == "HEAD";
    if (const int status = refuse_body(answer.head); status != 0) return refuse(is_reading ? status : 405);
    answer.state = HeadState::Good;
    answer.size = end + kEnd.size();
    return answer;
}

}  // namespace feelem::server
