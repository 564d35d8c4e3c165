// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/print_steps.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"
#include "read/abaqus/print_tables.hpp"
#include "read/text_lines.hpp"

#include <cmath>
#include <optional>
#include <string>

namespace feelem::printed {
namespace {

/// "S T E P       1     S T A T I C" -> "STEP1STATIC".
std::string without_blanks(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c != ' ' && c != '\t') out.push_back(c);
    }
    return out;
}

/// "1     S T A T I C   A N A L Y S I S" -> "static analysis": words are two blanks and more apart.
std::string spaced_words(std::string_view text) {
    std::string out;
    std::size_t blanks = 0;
    for (const char c : text) {
        blanks = c == ' ' ? blanks + 1 : 0;
        if (c == ' ' || (c >= '0' && c <= '9')) {
            if (blanks == 2 && !out.empty()) out.push_back(' ');
        } else {
            out.push_back(to_small(c));
        }
    }
    return std::string(trim(out).substr(0, 80));
}

/// The number that the text starts with, taken off its front.
std::optional<std::int32_t> take_leading_number(std::string_view& text) {
    std::size_t length = 0;
    while (length < text.size() && length < 9 && text[length] >= '0' && text[length] <= '9') ++length;
    const auto number = parse_integer(text.substr(0, length));
    if (length == 0 || !number) return {};
    text.remove_prefix(length);
    return static_cast<std::int32_t>(*number);
}

/// The real behind some words: "TOTAL TIME COMPLETED         0.00".
std::optional<double> number_after(std::string_view line, std::string_view words) {
    const std::size_t at = line.find(words);
    if (at == std::string_view::npos) return {};
    std::string_view rest = line.substr(at + words.size());
    std::string_view word = take_word(rest);
    if (word.ends_with(',')) word.remove_suffix(1);
    return parse_double(word);
}

}  // namespace

bool StepWalk::use(std::string_view text) {
    if (text.starts_with("S T E P ")) return begin_step(text);
    if (text.starts_with("INCREMENT ") && text.ends_with("SUMMARY")) {
        text.remove_prefix(10);
        step_.substep = static_cast<std::int32_t>(take_integer(text).value_or(0) % 1'000'000'000);
        is_mode_ = false;
        return true;
    }
    if (const auto time = number_after(text, "TOTAL TIME COMPLETED")) {
        step_.value = std::isfinite(*time) ? *time : 0;
        return true;
    }
    if (text.starts_with("E I G E N V A L U E ")) {
        begin_mode(without_blanks(text));
        return true;
    }
    return use_table_of_modes(text);
}

std::uint32_t StepWalk::index(std::vector<Step>& steps) const {
    Step now = step_;
    if (is_mode_) {
        const auto found = modes_.find(step_.substep);
        now.kind = buckling_ ? StepKind::Buckling : StepKind::Mode;
        now.value = found == modes_.end() ? 0 : found->second;
    }
    const auto same = [&](const Step& step) {
        return step.step == now.step && step.substep == now.substep && step.kind == now.kind &&
               step.value == now.value;
    };
    // The newest is the likely one.
    if (!steps.empty() && same(steps.back())) return static_cast<std::uint32_t>(steps.size() - 1);
    steps.push_back(now);
    return static_cast<std::uint32_t>(steps.size() - 1);
}

bool StepWalk::begin_step(std::string_view text) {
    const std::string all = without_blanks(text);
    std::string_view rest = std::string_view(all).substr(4);
    const auto number = take_leading_number(rest);
    if (!number) return false;
    step_ = {};
    step_.step = *number;
    step_.kind = rest.starts_with("STATIC") ? StepKind::Static : StepKind::Time;
    step_.label = spaced_words(text.substr(8));
    complex_ = rest.starts_with("STEADYSTATE") || rest.starts_with("DIRECTSTEADYSTATE");
    is_mode_ = lists_modes_ = buckling_ = false;
    modes_.clear();
    return true;
}

void StepWalk::begin_mode(std::string_view text) {
    text.remove_prefix(std::string_view("EIGENVALUE").size());
    if (!text.starts_with("NUMBER")) return;
    text.remove_prefix(6);
    step_.substep = take_leading_number(text).value_or(0);
    is_mode_ = true;
    lists_modes_ = false;
}

/// "MODE NO  EIGENVALUE  FREQUENCY ..." and its rows: number, eigenvalue, per radian, per cycle.
bool StepWalk::use_table_of_modes(std::string_view text) {
    if (text.starts_with("MODE NO") && text.find("EIGENVALUE") != std::string_view::npos) {
        lists_modes_ = true;
        buckling_ = text.find("FREQUENCY") == std::string_view::npos;
        return true;
    }
    if (!lists_modes_) return false;
    if (text.starts_with('(')) return true;
    const auto words = words_of(text);
    const std::size_t column = buckling_ ? 1 : 3;
    lists_modes_ = false;
    if (words.size() <= column) return false;
    const std::int64_t number = parse_integer(words[0]).value_or(0);
    const auto value = parse_double(words[column]);
    if (number < 1 || number > 1'000'000 || !value || !std::isfinite(*value)) return false;
    modes_[static_cast<std::int32_t>(number)] = *value;
    lists_modes_ = true;
    return lists_modes_;
}

}  // namespace feelem::printed
