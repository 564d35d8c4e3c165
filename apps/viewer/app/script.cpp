// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/script.hpp"

#include "base/nearest_name.hpp"
#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

struct DeedRow {
    std::string_view word;
    Deed deed;
    std::string_view arguments;  ///< A letter each: n a number, w a word.
    std::string_view example;
};
constexpr std::array kDeeds{
    DeedRow{"move", Deed::Move, "nn", "1.5 move 0.5 0.5"},
    DeedRow{"glide", Deed::Move, "nnnnn", "1.5 glide 0.4 0.5 0.6 0.5 2"},
    DeedRow{"press", Deed::Press, "w", "1.5 press left"},
    DeedRow{"release", Deed::Release, "w", "1.5 release left"},
    DeedRow{"wheel", Deed::Wheel, "n", "1.5 wheel 3"},
    DeedRow{"key", Deed::Key, "w", "1.5 key F"},
    DeedRow{"hold", Deed::HoldKey, "w", "1.5 hold S"},
    DeedRow{"leave", Deed::LeaveKey, "w", "1.5 leave S"},
    DeedRow{"screenshot", Deed::Screenshot, "w", "1.5 screenshot desk.png"},
    DeedRow{"quit", Deed::Quit, "", "9 quit"},
};
constexpr double kMovesASecond = 60;
constexpr double kLongest = 3600;  // Seconds; also bounds what a glide may become.

struct Line {
    std::string where;
    std::vector<std::string_view> words;
};

[[noreturn]] void bad(const Line& line, const std::string& text) {
    throw Error(Code::BadOption, line.where, text);
}

std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> words;
    text = text.substr(0, text.find('#'));
    while (true) {
        const std::size_t begin = text.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) return words;
        text.remove_prefix(begin);
        words.push_back(text.substr(0, text.find_first_of(" \t\r")));
        text.remove_prefix(words.back().size());
    }
}

double number_of(const Line& line, std::string_view word, double most) {
    const auto value = parse_double(word);
    if (!value || !(std::abs(*value) <= most))
        bad(line, fmt::format("\"{}\" is not a number up to {}", word, most));
    return *value;
}

const DeedRow& row_of(const Line& line) {
    if (line.words.size() < 2) bad(line, "expected SECONDS and a word, as in \"1.5 key F\"");
    const std::string_view wanted = line.words[1];
    const auto row = std::ranges::find(kDeeds, wanted, &DeedRow::word);
    if (row != kDeeds.end()) return *row;
    std::vector<std::string_view> known;
    for (const DeedRow& deed : kDeeds) known.push_back(deed.word);
    bad(line,
        fmt::format(
            "nothing is called \"{}\".{} There are: {}",
            wanted,
            did_you_mean(wanted, known),
            fmt::join(known, ", ")
        ));
}

void append_glide(const std::array<double, 5>& way, double at, std::vector<ScriptedDeed>& out) {
    const auto& [x1, y1, x2, y2, seconds] = way;
    const auto moves = std::max(1L, std::lround(std::abs(seconds) * kMovesASecond));
    for (long i = 0; i <= moves; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(moves);
        out.push_back(
            {at + part * std::abs(seconds), Deed::Move, x1 + part * (x2 - x1), y1 + part * (y2 - y1), {}}
        );
    }
}

void append_line(const Line& line, std::vector<ScriptedDeed>& out) {
    const DeedRow& row = row_of(line);
    if (line.words.size() != row.arguments.size() + 2)
        bad(line, fmt::format("\"{}\" is written \"{}\"", row.word, row.example));
    ScriptedDeed deed{number_of(line, line.words[0], kLongest), row.deed, 0, 0, {}};
    if (deed.at < 0) bad(line, "time begins at 0");
    std::array<double, 5> numbers{};
    for (std::size_t i = 0; i < row.arguments.size(); ++i) {
        const std::string_view word = line.words[i + 2];
        if (row.arguments[i] == 'w')
            deed.word = word;
        else
            numbers.at(i) = number_of(line, word, kLongest);
    }
    constexpr std::array<std::string_view, 3> kButtons{"left", "right", "middle"};
    const bool is_button = deed.deed == Deed::Press || deed.deed == Deed::Release;
    if (is_button && std::ranges::find(kButtons, deed.word) == kButtons.end())
        bad(line, fmt::format("the mouse has no button \"{}\": left, right or middle", deed.word));
    if (row.word == "glide") return append_glide(numbers, deed.at, out);
    deed.x = row.deed == Deed::Move ? numbers[0] : 0;
    deed.y = row.deed == Deed::Move ? numbers[1] : numbers[0];
    out.push_back(std::move(deed));
}

}  // namespace

std::vector<ScriptedDeed> parse_script(std::string_view text, const std::string& name) {
    std::vector<ScriptedDeed> deeds;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const Line line{fmt::format("{}:{}", name, number), split(text.substr(0, end))};
        if (!line.words.empty()) append_line(line, deeds);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    std::ranges::stable_sort(deeds, {}, &ScriptedDeed::at);
    return deeds;
}

std::span<const ScriptedDeed> ScriptPlayer::due(double now) {
    const std::size_t first = next_;
    while (next_ < deeds_.size() && deeds_[next_].at <= now) ++next_;
    return std::span(deeds_).subspan(first, next_ - first);
}

}  // namespace feelem::viewer
