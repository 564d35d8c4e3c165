// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/print_tables.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"
#include "read/abaqus/print_steps.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace feelem::printed {
namespace {

constexpr std::size_t kMostPrintedColumns = 64;
constexpr std::size_t kMostSections = 256;
constexpr std::string_view kTitle = "TABLE IS PRINTED";

std::optional<Place> place_of(const PrintedTable& table, std::string_view first_key) {
    // Names of sets stand behind, and could be anything.
    const std::string_view title = std::string_view(table.title).substr(0, table.title.find(" SET "));
    const auto says = [&](std::string_view words) { return title.find(words) != std::string_view::npos; };
    if (says("REBAR") || says("SURFACE") || says("CONTACT")) return {};
    if (says("AVERAGED AT")) return first_key == "NODE" ? std::optional(Place::Averaged) : std::nullopt;
    if (first_key == "NODE") return Place::Node;
    if (first_key != "ELEMENT") return {};
    if (says("INTEGRATION POINT")) return table.point_key > 0 ? std::optional(Place::Point) : std::nullopt;
    if (says("CENTROID")) return Place::Element;
    if (says("AT THE NODE")) return table.point_key > 0 ? std::optional(Place::ElementNodes) : std::nullopt;
    return table.point_key == 0 ? std::optional(Place::Element) : std::nullopt;
}

class PrintScanner {
public:
    PrintScanner(const Input& input, Diagnostics& diagnostics)
        : lines_(input, 0, input.size()), diagnostics_(diagnostics) {}

    PrintedFile scan() {
        while (const auto line = lines_.next()) {
            const std::string_view text = trim(*line);
            if (text.empty()) {
                after_blank_ = true;
                continue;
            }
            if (!use_row(*line)) use(text);
            after_blank_ = false;
        }
        std::erase_if(file_.tables, [](const PrintedTable& table) { return table.rows == 0; });
        return std::move(file_);
    }

private:
    bool use_row(std::string_view line) {
        if (!inside_) return false;
        PrintedTable& table = file_.tables.back();
        if (!read_printed_row(table, line, row_)) return false;
        if (table.rows++ == 0) table.begin = lines_.line_start();
        table.end = lines_.offset();
        table.has_marks = table.has_marks || row_.has_mark;
        if (table.section_key > 0 && table.sections.size() < kMostSections)
            table.sections.insert(row_.keys[table.section_key]);
        return true;
    }

    void use(std::string_view text) {
        if (text.find(kTitle) != std::string_view::npos) {
            begin_title(text);
        } else if (!title_.empty()) {
            use_behind_title(text);
        } else if (has_table_ && use_summary(text)) {
            inside_ = false;
        } else if (inside_ && is_part_of_head(text)) {
            return;
        } else {
            end_table(text);
            steps_.use(text);
            if (file_.solver.name.empty()) find_version(text);
        }
    }

    void begin_title(std::string_view text) {
        end_table(text);
        has_table_ = false;
        title_ = std::string(text.substr(text.find(kTitle) + kTitle.size()));
        // What will be printed later, in the echo of the input.
        if (title_.find("AT EVERY") != std::string::npos) title_.clear();
    }

    /// The title goes on, or the head comes: "ELEMENT  PT SEC FOOT-  S11 ...".
    void use_behind_title(std::string_view text) {
        if (text.find("FOOT-") == std::string_view::npos) {
            if (after_blank_ || title_.size() > 400) {
                title_.clear();
            } else {
                title_ += " " + std::string(text);
            }
            return;
        }
        PrintedTable table;
        table.title = std::string(trim(title_));
        title_.clear();
        bool behind = false;
        std::string first_key;
        for (const std::string_view word : words_of(text)) {
            if (word == "FOOT-") {
                behind = true;
            } else if (behind) {
                if (table.columns.size() < kMostPrintedColumns) table.columns.emplace_back(word);
            } else if (first_key.empty()) {
                first_key = std::string(word);
            } else {
                (word == "SEC" ? table.section_key : table.point_key) = table.keys++;
            }
        }
        const auto place = place_of(table, first_key);
        if (!place || table.keys > 3 || table.columns.empty() || steps_.is_complex()) {
            report(fmt::format(
                "the table \"{}\" ({}) is not read{}",
                table.title,
                fmt::join(table.columns, " "),
                steps_.is_complex() ? ": values of a steady-state response are complex" : ""
            ));
            return;
        }
        table.place = *place;
        table.step = steps_.index(file_.steps);
        file_.tables.push_back(std::move(table));
        inside_ = has_table_ = true;
    }

    /// "NOTE" below FOOT-, and texts of footnotes.
    bool is_part_of_head(std::string_view text) {
        if (text.starts_with("ALL VALUES IN THIS TABLE ARE ZERO")) {
            const PrintedTable& table = file_.tables.back();
            report(fmt::format(
                "the table \"{}\" ({}) says that all its values are zero; it lists none, so none are shown",
                table.title,
                fmt::join(table.columns, " ")
            ));
            inside_ = has_table_ = false;
            return true;
        }
        if (file_.tables.back().rows > 0) return text.starts_with("OR:");
        const auto words = words_of(text);
        return words.size() <= 3 && std::ranges::find(words, "NOTE") != words.end();
    }

    bool use_summary(std::string_view text) {
        PrintedTable& table = file_.tables.back();
        auto words = words_of(text);
        const bool largest = words[0] == "MAXIMUM";
        if (largest || words[0] == "MINIMUM") {
            summary_ = largest ? &table.largest : &table.smallest;
            summary_->values.clear();
            for (const auto word :
                 std::span(words).subspan(1, std::min(words.size() - 1, kMostPrintedColumns)))
                summary_->values.emplace_back(word);
            return true;
        }
        if (words[0] == "AT") words.erase(words.begin());
        if (summary_ != nullptr && !words.empty() && (words[0] == "NODE" || words[0] == "ELEMENT")) {
            for (const auto word :
                 std::span(words).subspan(1, std::min(words.size() - 1, kMostPrintedColumns)))
                summary_->ids.push_back(parse_integer(word).value_or(0));
            summary_ = nullptr;
            return true;
        }
        return words.empty() || words[0] == "TOTAL";
    }

    void end_table(std::string_view text) {
        const bool plain = after_blank_ || text.find("THE ") != std::string_view::npos;
        if (inside_ && file_.tables.back().rows > 0 && !plain) {
            diagnostics_.add(
                Code::UnknownBlock,
                [&] { return lines_.where(); },
                fmt::format(
                    "a printed table ends at a line that is none of its rows: \"{}\"", text.substr(0, 60)
                )
            );
        }
        inside_ = has_table_ = false;
        summary_ = nullptr;
    }

    void find_version(std::string_view text) {
        const std::string small = lower_case(text.substr(0, 40));
        if (!small.starts_with("abaqus ")) return;
        text.remove_prefix(7);
        std::string_view word = take_word(text);
        if (word == "VERSION") word = take_word(text);
        if (!word.empty() && word[0] >= '0' && word[0] <= '9') file_.solver = {"Abaqus", std::string(word)};
    }

    void report(const std::string& text) {
        diagnostics_.add(
            Code::UnknownBlock, [&] { return lines_.where(); }, text
        );
    }

    TextLines lines_;
    Diagnostics& diagnostics_;
    PrintedFile file_;
    StepWalk steps_;
    std::string title_;
    PrintedRow row_;
    Summary* summary_ = nullptr;  ///< Whose ids come next.
    bool inside_ = false;         ///< Rows of the last table may come.
    bool has_table_ = false;      ///< Its summary may come.
    bool after_blank_ = false;
};

}  // namespace

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
        words.push_back(word);
    return words;
}

PrintedFile scan_printed(const Input& input, Diagnostics& diagnostics) {
    return PrintScanner(input, diagnostics).scan();
}

bool is_printed_by_abaqus(std::string_view head) {
    if (head.find("THE FOLLOWING TABLE IS PRINTED ") != std::string_view::npos) return true;
    if (head.find("OPTIONS BEING PROCESSED") != std::string_view::npos) return true;
    // "   Abaqus 2017     Date 12-Jan-2018   Time 10:00:00", near the top.
    const std::string top = lower_case(head.substr(0, 1024));
    const std::size_t name = top.find("abaqus "), date = top.find(" date ", name);
    return name != std::string::npos && date < top.find('\n', name);
}

bool read_printed_row(const PrintedTable& table, std::string_view line, PrintedRow& row) {
    row.keys.clear();
    row.values.clear();
    row.has_mark = false;
    std::string_view rest = line;
    for (std::size_t i = 0; i < table.keys; ++i) {
        const auto number = take_integer(rest);
        if (!number) return false;
        row.keys.push_back(*number);
    }
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        // Marks of footnotes stand before the values: letters.
        const char c = word[0];
        const bool letter = to_small(c) >= 'a' && to_small(c) <= 'z';
        if (row.values.empty() && letter && !parse_double(word)) {
            row.has_mark = true;
        } else if (row.values.size() < table.columns.size()) {
            row.values.push_back(word);
        } else {
            return false;
        }
    }
    return row.values.size() == table.columns.size();
}

}  // namespace feelem::printed
