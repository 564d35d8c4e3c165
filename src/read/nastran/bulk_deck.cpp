// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/bulk_deck.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace feelem::nastran {
namespace {

constexpr std::size_t kLongestName = 1024;

/// The line's first word is `word` (in capitals), in any case.
bool starts_with_word(std::string_view line, std::string_view word) {
    line = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (to_capital(line[i]) != word[i]) return false;
    }
    return line.size() == word.size() || line[word.size()] == ' ' || line[word.size()] == '\t' ||
           line[word.size()] == '=' || line[word.size()] == '\'' || line[word.size()] == '"' ||
           line[word.size()] == ',';
}

/// What follows the line's first word.
std::string_view behind_word(std::string_view line, std::size_t length) {
    line = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    return trim(line.substr(std::min(length, line.size())));
}

bool begins_bulk(std::string_view line) {
    return starts_with_word(line, "BEGIN") && starts_with_word(behind_word(line, 5), "BULK");
}

bool begins_superelement(std::string_view line) {
    if (!starts_with_word(line, "BEGIN")) return false;
    std::string_view rest = behind_word(line, 5);
    if (starts_with_word(rest, "BULK")) rest = behind_word(rest, 4);
    return starts_with_word(rest, "SUPER") || starts_with_word(rest, "AUXMODEL") ||
           starts_with_word(rest, "MODULE") || starts_with_word(rest, "MASSID") ||
           starts_with_word(rest, "TRMC") || starts_with_word(rest, "FLXBDY");
}

}  // namespace

std::optional<Include> include_at(std::string_view text, std::size_t offset) {
    BulkLines lines(text, offset);
    if (!lines.advance() || !starts_with_word(lines.line(), "INCLUDE")) return {};
    std::string_view rest = behind_word(lines.line(), 7);
    if (rest.starts_with(',') || rest.starts_with('=')) rest = trim(rest.substr(1));
    const char quote = rest.empty() ? '\0' : rest[0];
    Include include;
    if (quote != '\'' && quote != '"') {
        include.name = rest;
        include.next = lines.next_offset();
        return include;
    }
    rest.remove_prefix(1);
    while (true) {
        const std::size_t end = rest.find(quote);
        include.name += trim(rest.substr(0, end));
        include.next = lines.next_offset();
        if (end != std::string_view::npos || include.name.size() > kLongestName || !lines.advance()) break;
        rest = lines.line();
    }
    return include;
}

bool has_begin_bulk(std::string_view text) {
    // By its first letter: whole meshes may follow without it.
    for (std::size_t at = 0; at < text.size();) {
        std::size_t first = at;
        while (first < text.size() && (text[first] == ' ' || text[first] == '\t')) ++first;
        if (first < text.size() && to_capital(text[first]) == 'B') {
            BulkLines lines(text, at);
            if (lines.advance() && (begins_bulk(lines.line()) || begins_superelement(lines.line())))
                return true;
        }
        const void* end = std::memchr(text.data() + first, '\n', text.size() - first);
        if (end == nullptr) break;
        at = static_cast<std::size_t>(static_cast<const char*>(end) - text.data()) + 1;
    }
    return false;
}

BulkDeck::BulkDeck(std::vector<Input> roots, IncludeFiles* includes, Diagnostics& diagnostics)
    : roots_(std::move(roots)), includes_(includes), diagnostics_(diagnostics) {}

void BulkDeck::push(Input input) {
    files_.push_back(std::move(input));
    const auto file = static_cast<std::uint32_t>(files_.size() - 1);
    frames_.push_back({file, BulkLines(files_.back().text())});
}

void BulkDeck::open_root() {
    Input root = roots_[next_root_++];
    skips_ = false;
    // Pieces have no control sections. CEND without BEGIN BULK: that may stand in an included file.
    in_bulk_ = !has_begin_bulk(root.text());
    BulkLines lines(root.text());
    while (in_bulk_ && lines.advance()) {
        if (starts_with_word(lines.line(), "CEND")) in_bulk_ = false;
    }
    push(std::move(root));
}

void BulkDeck::follow(const Include& include) {
    const Frame& frame = frames_.back();
    const auto where = [&, file = frame.file, at = frame.lines.offset()] {
        return files_[file].where_line(at);
    };
    const auto found =
        includes_ != nullptr ? includes_->find(include.name, files_[frame.file]) : std::nullopt;
    if (!found) {
        missed_include_ = true;
        diagnostics_.add(
            Code::FileNotFound,
            where,
            fmt::format(
                "INCLUDE '{}' is not beside the deck: what it holds is missing. Give that file too, by its "
                "name.",
                include.name
            )
        );
        return;
    }
    const auto same = [&](const Input& input) { return input.name() == found->name(); };
    if (std::ranges::any_of(files_, same)) {
        diagnostics_.add(
            Code::UnknownBlock, where, fmt::format("{} is included again; it is read once", include.name)
        );
        return;
    }
    push(*found);
}

/// A line of the executive or case control section; true when bulk data begins after it.
bool BulkDeck::read_control(std::string_view line) {
    if (begins_superelement(line)) {
        skip_section(line);
        return true;
    }
    if (begins_bulk(line)) return true;
    if (title_.empty() && starts_with_word(line, "TITLE")) {
        std::string_view text = behind_word(line, 5);
        if (text.starts_with('=')) text.remove_prefix(1);
        title_ = trim(text);
    }
    return false;
}

void BulkDeck::skip_section(std::string_view line) {
    skips_ = true;
    diagnostics_.add(
        Code::UnknownBlock,
        [&] { return files_[frames_.back().file].where_line(frames_.back().lines.offset()); },
        fmt::format(
            "the section \"{}\" is left out: of a deck with superelements Feelem reads the residual "
            "structure",
            trim(line)
        )
    );
}

bool BulkDeck::next(CardHead& head) {
    while (true) {
        if (frames_.empty()) {
            if (next_root_ == roots_.size()) return false;
            open_root();
        }
        BulkLines& lines = frames_.back().lines;
        lines.names = &names_;
        if (!lines.advance()) {
            frames_.pop_back();
            continue;
        }
        const std::string_view line = lines.line();
        if (starts_with_word(line, "INCLUDE")) {
            if (const auto include = include_at(files_[frames_.back().file].text(), lines.offset())) {
                lines.go_to(include->next);
                follow(*include);
            }
        } else if (!in_bulk_) {
            in_bulk_ = read_control(line);
        } else if (is_continuation(line)) {
            continue;
        } else if (begins_bulk(line) || begins_superelement(line)) {
            skips_ = false;
            if (begins_superelement(line)) skip_section(line);
        } else {
            head = card_head(line, lines.offset());
            const bool ends = head.name() == "ENDDATA";
            if (skips_ && !ends) continue;
            ++card_count_;
            if (!ends) return true;
            frames_.clear();
        }
    }
}

std::optional<BulkDeck::Ahead> BulkDeck::ahead() const {
    if (frames_.empty() || !in_bulk_ || skips_) return {};
    const Frame& frame = frames_.back();
    Ahead ahead{files_[frame.file].text(), frame.lines.next_offset()};
    // Lines that the card before goes on with.
    while (ahead.offset < ahead.text.size()) {
        BulkLines lines(ahead.text, ahead.offset);
        if (!lines.advance() || lines.offset() != ahead.offset || !is_continuation(lines.line())) break;
        ahead.offset = lines.next_offset();
    }
    return ahead;
}

void BulkDeck::go_on_at(std::size_t offset, std::uint64_t cards_read) {
    frames_.back().lines.go_to(offset);
    card_count_ += cards_read;
}

std::vector<std::string_view> BulkDeck::take_names() {
    return std::exchange(names_, {});
}

}  // namespace feelem::nastran
