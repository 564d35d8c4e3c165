// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/deck_lines.hpp"

#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <span>

namespace feelem::abaqus {

std::optional<std::string_view> DataLines::next() {
    for (;;) {
        const auto line = next_or_empty();
        if (!line || !line->empty()) return line;
    }
}

bool DataLines::open_range() {
    while (!lines_ || lines_->offset() >= keyword_->data[range_ - 1].end) {
        if (range_ >= keyword_->data.size()) return false;
        const LineRange& range = keyword_->data[range_++];
        lines_.emplace(deck_->files[range.file], range.begin, range.end);
    }
    return true;
}

std::optional<std::string_view> DataLines::next_or_empty() {
    for (;;) {
        if (!open_range()) return {};
        const auto line = lines_->next();
        if (line && !is_comment(*line)) return trim(*line);
    }
}

DataLines::Ahead DataLines::ahead() {
    if (!open_range()) return {};
    const LineRange& range = keyword_->data[range_ - 1];
    return {deck_->files[range.file].text(), lines_->offset(), range.end};
}

void DataLines::go_on_at(std::size_t offset) {
    const LineRange& range = keyword_->data[range_ - 1];
    lines_.emplace(deck_->files[range.file], offset, range.end);
}

std::string DataLines::where() const {
    return lines_ ? lines_->where() : deck_->where(*keyword_);
}

void DataLines::release() const {
    for (const LineRange& range : std::span(keyword_->data).first(range_))
        deck_->files[range.file].release(range.begin, range.end);
}

std::string_view take_field(std::string_view& rest) {
    std::string_view field = trim(take_piece(rest));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"')
        field = field.substr(1, field.size() - 2);
    return field;
}

void throw_bad_number(
    std::string_view field, const char* expected, const Deck& deck, const DataLines& lines
) {
    throw Error(
        Code::BadNumber,
        lines.where(),
        fmt::format(
            "found \"{}\" where {} is expected.{}",
            field.substr(0, 40),
            expected,
            deck.has_parameters ? " The deck uses *PARAMETER, which Feelem does not evaluate: read the "
                                  "NAME.pes that Abaqus writes beside the deck instead."
                                : ""
        )
    );
}

double take_number(std::string_view& rest, double fallback, const Deck& deck, const DataLines& lines) {
    const std::string_view field = take_field(rest);
    if (field.empty()) return fallback;
    const auto value = parse_double(field);
    if (!value) throw_bad_number(field, "a number", deck, lines);
    return *value;
}

std::optional<std::int32_t> label_of(std::string_view field) {
    std::int32_t value = 0;
    if (field.starts_with('+')) field.remove_prefix(1);
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (field.empty() || error != std::errc{} || end != field.data() + field.size() || value < 0) return {};
    return value;
}

std::int32_t take_label(std::string_view& rest, const Deck& deck, const DataLines& lines) {
    // The common case first: digits up to a comma.
    const char* at = rest.data();
    const char* const end = at + rest.size();
    while (at != end && *at == ' ') ++at;
    std::int32_t value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error == std::errc{} && value >= 0 && (stop == end || *stop == ',')) {
        rest.remove_prefix(static_cast<std::size_t>(stop - rest.data()) + (stop == end ? 0 : 1));
        return value;
    }
    const std::string_view field = take_field(rest);
    if (field.empty()) return 0;
    const auto label = label_of(field);
    if (!label) throw_bad_number(field, "the number of a node or element (1 to 2147483647)", deck, lines);
    return *label;
}

}  // namespace feelem::abaqus
