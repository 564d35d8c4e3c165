// SPDX-License-Identifier: Apache-2.0
// Numbers, units and places on a scale as text.
#include "viewer/ui/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

using UnitWord = std::pair<std::string_view, std::string_view>;
constexpr std::array<UnitWord, 4> kUnitWords{
    {{"degC", "°C"}, {"degF", "°F"}, {"um", "µm"}, {"degrees", "°"}}};

/// More digits than two neighbouring doubles can share.
constexpr int kTellingDigits = 30;

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Whether a text of digits ends in 5 000..., so that the value lies right between two roundings.
bool is_tie(std::string_view digits) {
    return digits.front() == '5' && digits.find_first_not_of('0', 1) == std::string_view::npos;
}

/// A value right between two is rounded away from zero, as browsers do.
double untied(double value, std::string_view tail) {
    return is_tie(tail) ? std::nextafter(value, value * 2) : value;
}

struct Decimal {
    std::string digits;  ///< Without zeros at the end; the point is after the first.
    int exponent = 0;
};

Decimal decimal_of(double size, int digits) {
    const std::string exact = fmt::format("{:.{}e}", size, digits - 1 + kTellingDigits);
    const auto tail = std::string_view(exact).substr(static_cast<std::size_t>(digits) + 1, kTellingDigits);
    std::string text = fmt::format("{:.{}e}", untied(size, tail), digits - 1);
    const std::size_t e = text.find('e');
    Decimal out{text.substr(0, e), std::stoi(text.substr(e + 1))};
    std::erase(out.digits, '.');
    out.digits.erase(std::max<std::size_t>(out.digits.find_last_not_of('0') + 1, 1));
    return out;
}

std::string plain(const Decimal& decimal) {
    std::string digits = decimal.digits;
    if (decimal.exponent < 0)
        return "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + digits;
    const auto before = static_cast<std::size_t>(decimal.exponent) + 1;
    if (digits.size() < before) digits.append(before - digits.size(), '0');
    if (digits.size() > before) digits.insert(before, ".");
    return digits;
}

std::string exponential(const Decimal& decimal) {
    std::string digits = decimal.digits;
    if (digits.size() > 1) digits.insert(1, ".");
    return fmt::format("{}e{}", digits, decimal.exponent);
}

std::string fixed(double value, int decimals) {
    const std::string exact = fmt::format("{:.{}f}", value, decimals + kTellingDigits);
    const auto tail = std::string_view(exact).substr(exact.size() - kTellingDigits);
    std::string text = fmt::format("{:.{}f}", untied(value, tail), decimals);
    return text;
}

/// c of docs/effects.md 1.
double symmetric_log_of(double value, double c) {
    return std::copysign(std::log10(1 + std::abs(value) / c), value);
}

std::string_view kind_word(StepKind kind) {
    constexpr std::array<std::string_view, 6> kWords{
        "static", "time", "mode", "frequency", "buckling", "other"};
    return kWords.at(static_cast<std::size_t>(kind));
}

}  // namespace

std::string unit_text(std::string_view unit) {
    for (const auto& [word, text] : kUnitWords)
        if (unit == word) return std::string(text);
    std::string out;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const auto ends_at = [&](std::size_t at) { return at >= unit.size() || !is_word(unit[at]); };
        const bool begins = i == 0 || !is_word(unit[i - 1]);
        const std::size_t digit = unit[i] == '^' ? i + 1 : i;
        if (begins && unit.substr(i, 2) == "um" && ends_at(i + 2)) {
            out += "µm";
            ++i;
        } else if (digit < unit.size() && (unit[digit] == '2' || unit[digit] == '3') && ends_at(digit + 1)) {
            out += unit[digit] == '2' ? "²" : "³";
            i = digit;
        } else {
            out += unit[i];
        }
    }
    return out;
}

std::string number_text(double value, int digits) {
    if (std::isnan(value)) return "no value";
    if (value == 0) return "0";
    const std::string sign = value < 0 ? "-" : "";
    const double size = std::abs(value);
    if (std::isinf(size)) return sign + "∞";
    const Decimal decimal = decimal_of(size, digits);
    return sign + (size >= 1e7 || size < 1e-4 ? exponential(decimal) : plain(decimal));
}

std::vector<std::string> axis_texts(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    double size = 0;
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        size = std::max(size, std::abs(sorted[i]));
        if (i > 0) gap = std::min(gap, sorted[i] - sorted[i - 1]);
    }
    const bool is_exponential = size >= 1e6 || size < 1e-3;
    const double decimals = 2 - std::floor(std::log10(gap));
    const bool is_plain = !(gap > 0) || is_exponential || decimals > 9;
    std::vector<std::string> out;
    for (const double value : values)
        out.push_back(
            is_plain ? number_text(value, 4) : fixed(value, static_cast<int>(std::max(decimals, 0.0)))
        );
    return out;
}

std::string with_unit(double value, std::string_view unit) {
    const std::string printed = unit_text(unit);
    return std::isnan(value) || printed.empty() ? number_text(value) : number_text(value) + " " + printed;
}

std::string step_text(const Step& step) {
    const auto from = step.label.find_first_not_of(" \t");
    const std::string name = from == std::string::npos
                                 ? fmt::format("Step {}.{}", step.step, step.substep)
                                 : step.label.substr(from, step.label.find_last_not_of(" \t") + 1 - from);
    if (step.kind == StepKind::Static || std::isnan(step.value))
        return fmt::format("{} · {}", name, kind_word(step.kind));
    const bool is_frequency = step.kind == StepKind::Mode || step.kind == StepKind::Frequency;
    const std::string_view unit = step.kind == StepKind::Time ? "s" : is_frequency ? "Hz" : "";
    return fmt::format("{} · {}", name, with_unit(step.value, unit));
}

std::string bound_text(double bound) {
    if (!(bound > 0)) return "0";
    const double place = std::pow(10, std::floor(std::log10(bound)) - 1);
    return number_text(std::ceil(bound / place - 1e-9) * place, 2);
}

double value_at_position(double t, const ValueRange& range) {
    const auto [lo, hi, scale] = range;
    const double magnitude = std::max(std::abs(lo), std::abs(hi));
    if (scale == Scale::Signed) return -magnitude + 2 * magnitude * t;
    if (scale == Scale::Linear || magnitude == 0) return lo + (hi - lo) * t;
    if (scale == Scale::Log && lo > 0)
        return std::pow(10, std::log10(lo) + (std::log10(hi) - std::log10(lo)) * t);
    const double c = 1e-3 * magnitude;
    const double from = symmetric_log_of(lo, c);
    const double place = from + (symmetric_log_of(hi, c) - from) * t;
    return std::copysign(c * (std::pow(10, std::abs(place)) - 1), place);
}

std::vector<double> label_positions(int bands) {
    int count = bands > 0 ? bands : 8;
    while (count > 14) {
        if (count % 2 != 0) {
            count = 8;
            break;
        }
        count /= 2;
    }
    std::vector<double> out;
    for (int i = 0; i <= count; ++i) out.push_back(static_cast<double>(i) / count);
    return out;
}

}  // namespace feelem::viewer
