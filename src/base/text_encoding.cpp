// SPDX-License-Identifier: Apache-2.0
#include "base/text_encoding.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace feelem {
namespace {

void append_utf8(std::string& out, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | (code >> 6));
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | (code >> 12));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | (code >> 18));
        put(0x80 | ((code >> 12) & 0x3F));
        put(0x80 | ((code >> 6) & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

std::string utf8_of_utf16(std::string_view text, bool big_endian) {
    constexpr std::uint32_t kReplacement = 0xFFFD;
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<std::uint32_t>(static_cast<unsigned char>(text[at]));
        const auto second = static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + 1]));
        return big_endian ? first << 8 | second : second << 8 | first;
    };
    std::string out;
    out.reserve(text.size() / 2 + text.size() / 8);
    for (std::size_t at = 0; at + 1 < text.size(); at += 2) {
        const std::uint32_t code = unit(at);
        if (code < 0xD800 || code > 0xDFFF) {
            append_utf8(out, code);
            continue;
        }
        const bool leads = code < 0xDC00 && at + 3 < text.size();
        const std::uint32_t next = leads ? unit(at + 2) : 0;
        if (next >= 0xDC00 && next <= 0xDFFF) {
            append_utf8(out, 0x10000 + ((code - 0xD800) << 10) + (next - 0xDC00));
            at += 2;
        } else {
            append_utf8(out, kReplacement);
        }
    }
    return out;
}

}  // namespace

Input without_encoding(const Input& input) {
    using namespace std::string_view_literals;
    const std::string_view text = input.text();
    if (text.starts_with("\xEF\xBB\xBF"sv)) {
        return Input::from_memory(input.name(), std::string(text.substr(3)));
    }
    if (text.starts_with("\xFF\xFE"sv)) {
        return Input::from_memory(input.name(), utf8_of_utf16(text.substr(2), false));
    }
    if (text.starts_with("\xFE\xFF"sv)) {
        return Input::from_memory(input.name(), utf8_of_utf16(text.substr(2), true));
    }
    return input;
}

}  // namespace feelem
