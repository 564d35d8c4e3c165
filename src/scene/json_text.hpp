// SPDX-License-Identifier: Apache-2.0
// JSON written in one pass: keys in the order given, numbers as the shortest text that reads back the same.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace feelem {

/// begin/end must balance; commas are set by itself. Text that is not UTF-8 gets U+FFFD for each wrong byte.
class JsonText {
public:
    JsonText& begin_object() { return open('{'); }
    JsonText& end_object() { return close('}'); }
    JsonText& begin_array() { return open('['); }
    JsonText& end_array() { return close(']'); }
    JsonText& key(std::string_view name);

    JsonText& value(std::string_view text);
    JsonText& value(const char* text) { return value(std::string_view(text)); }
    JsonText& value(double number);  ///< Null when it is not finite: JSON has no such numbers.
    JsonText& value(bool truth) { return raw(truth ? "true" : "false"); }
    template <std::integral T>
    requires(!std::same_as<T, bool>) JsonText& value(T number) { return raw(std::to_string(number)); }
    JsonText& null() { return raw("null"); }
    JsonText& raw(std::string_view json);  ///< A finished value.
    /// The text, or null when it is empty.
    JsonText& text_or_null(std::string_view text) { return text.empty() ? null() : value(text); }

    template <class T>
    JsonText& member(std::string_view name, const T& of) {
        key(name);
        return value(of);
    }
    const std::string& text() const noexcept { return text_; }

private:
    JsonText& open(char bracket);
    JsonText& close(char bracket);
    void separate();
    std::string text_;
    bool comma_ = false;
};

}  // namespace feelem
