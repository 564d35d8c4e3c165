// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/cdb_commands.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::ansys::cdb {
Command::Command(std::string_view text) {
    text = trim(text);
    const std::size_t end = std::min(text.find_first_of(", \t"), text.size());
    name_length_ = std::min(end, name_.size());
    std::transform(
        text.begin(), text.begin() + static_cast<std::ptrdiff_t>(name_length_), name_.begin(), to_capital
    );
    std::string_view fields = text.substr(end);
    // Blanks may stand before the comma: "MAT ,5".
    const std::size_t first = fields.find_first_not_of(" \t");
    fields.remove_prefix(std::min(first, fields.size()));
    const bool has_comma = fields.starts_with(',');
    if (has_comma) fields.remove_prefix(1);
    rest_ = fields;
    while (!fields.empty() && count_ < kMostFields) {
        const std::size_t comma = std::min(fields.find(','), fields.size());
        fields_[count_++] = trim(fields.substr(0, comma));
        fields.remove_prefix(std::min(comma + 1, fields.size()));
    }
}

bool Command::is(std::string_view wanted) const {
    const bool marked = wanted.front() == '/' || wanted.front() == '*';
    const std::size_t letters = marked ? 5 : 4;
    const std::string_view mine = name();
    if (mine.size() < std::min(letters, wanted.size())) return false;
    if (wanted.size() < letters) return mine == wanted;
    return mine.substr(0, letters) == wanted.substr(0, letters);
}

std::string_view Command::operator[](std::size_t field) const {
    return field >= 1 && field <= count_ ? fields_[field - 1] : std::string_view{};
}

std::string_view without_comment(std::string_view line) {
    const std::size_t mark = line.find('!');
    if (mark == std::string_view::npos) return line;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\'') quoted = !quoted;
        if (line[i] == '!' && !quoted) return line.substr(0, i);
    }
    return line.substr(0, quoted ? mark : line.size());
}

bool Parameters::take_assignment(std::string_view text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) return false;
    const std::string_view name = trim(text.substr(0, sign));
    const auto is_of_name = [](char c) {
        const char letter = to_capital(c);
        return (letter >= 'A' && letter <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    if (name.empty() || !std::ranges::all_of(name, is_of_name)) return false;
    set(name, trim(text.substr(sign + 1)));
    return true;
}

void Parameters::set(std::string_view name, std::string_view value) {
    const auto number = value.empty() ? std::nullopt : real(value);
    if (!number) {
        forget(name);
        return;
    }
    values_[upper_case(trim(name))] = *number;
}

void Parameters::forget(std::string_view name) {
    values_.erase(upper_case(trim(name)));
}

std::optional<double> Parameters::real(std::string_view field) const {
    field = trim(field);
    if (field.empty()) return 0.0;
    const char first = field.front();
    const bool is_name = to_capital(first) != first || (first >= 'A' && first <= 'Z') || first == '_';
    if (is_name) {
        const auto found = values_.find(upper_case(field));
        return found == values_.end() ? std::nullopt : std::optional(found->second);
    }
    const auto number = parse_double(field);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> Parameters::integer(std::string_view field) const {
    const auto number = real(field);
    constexpr double kMost = 9e15;
    if (!number || std::abs(*number) > kMost) return std::nullopt;
    return static_cast<std::int64_t>(std::llround(*number));
}

}  // namespace feelem::ansys::cdb
