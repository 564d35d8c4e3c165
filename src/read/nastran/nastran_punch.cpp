// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/nastran_punch.hpp"

#include "base/number.hpp"
#include "read/nastran/element_names.hpp"
#include "read/nastran/printed_tables.hpp"
#include "read/nastran/punch_elements.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace feelem {
namespace {

using namespace nastran;

constexpr PrintedKind kPunchKinds[]{
    {"DISPLACEMENTS", "displacement", "rotation", "temperature"},
    {"EIGENVECTOR", "displacement", "rotation", {}},
    {"VELOCITY", "velocity", "angular_velocity", "temperature_rate"},
    {"ACCELERATION", "acceleration", "angular_acceleration", {}},
    {"SPCF", "reaction_force", "reaction_moment", "reaction_heat_flow"},
    {"MPCF", "mpc_force", "mpc_moment", "mpc_heat_flow"},
    {"OLOADS", "applied_force", "applied_moment", "applied_heat_flow"},
    {"TEMPERATURE", "temperature", {}, "temperature"},
};

std::string_view upto(std::string_view line, std::size_t columns) {
    return line.substr(0, std::min(columns, line.size()));
}

/// What follows `key` up to the first blank after it.
std::optional<double> number_after(std::string_view line, std::string_view key) {
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) return {};
    std::string_view rest = line.substr(at + key.size());
    return parse_double(take_word(rest));
}

bool read_punch_row(
    std::string_view text, std::size_t& at, std::size_t last, const PrintedRows&, PrintedRow& row
) {
    const auto next_line = [&] {
        const std::size_t end = std::min(text.find('\n', at), last);
        const std::string_view line = text.substr(at, end - at);
        at = std::min(end + 1, last);
        return upto(line, kPunchData);
    };
    const auto add_numbers = [&](std::string_view line) {
        for (std::size_t i = kPunchField; i < kPunchData && row.count < row.numbers.size();
             i += kPunchField) {
            const std::string_view field =
                i < line.size() ? trim(line.substr(i, kPunchField)) : std::string_view{};
            const auto value = field.empty() ? std::nullopt : parse_float(field);
            row.numbers[row.count++] = value.value_or(std::numeric_limits<float>::quiet_NaN());
        }
    };
    while (at < last) {
        const std::string_view line = next_line();
        const std::string_view first = trim(upto(line, kPunchField - 1));
        const auto number = parse_double(first);
        row.count = 0;
        if (number && line.size() >= kPunchField) {
            row.step_value = *number;
            row.id = parse_integer(first).value_or(0);
            row.kind = line[kPunchField - 1];
            add_numbers(line);
        }
        while (at < last && text.substr(at, 6) == "-CONT-") {
            const std::string_view more = next_line();
            if (row.count > 0) add_numbers(more);
        }
        if (row.count > 0) return true;
    }
    return false;
}

class PunchScanner {
public:
    PunchScanner(const Input& input, Diagnostics& diagnostics)
        : input_(input), diagnostics_(diagnostics), lines_(input, 0, input.size()) {}

    PrintedTables scan() {
        while (auto line = lines_.next()) {
            if (line->starts_with('$')) {
                end_rows(lines_.line_start());
                read_head(upto(*line, kPunchData));
            } else if (!in_rows_ && !trim(*line).empty()) {
                in_rows_ = true;
                first_row_ = lines_.line_start();
            }
        }
        end_rows(input_.size());
        return std::move(tables_);
    }

private:
    void read_head(std::string_view line) {
        const auto text_of = [&](std::string_view key) { return std::string(trim(line.substr(key.size()))); };
        if (line.starts_with("$TITLE   =")) {
            texts_.title = text_of("$TITLE   =");
            if (tables_.title.empty()) tables_.title = texts_.title;
            key_ = {};
            key_.subcase = 1;
            head_ = {};
            elements_.reset();
            unused_.clear();
            node_ = 0;
        } else if (line.starts_with("$SUBTITLE=")) {
            texts_.subtitle = text_of("$SUBTITLE=");
        } else if (line.starts_with("$LABEL   =")) {
            texts_.label = text_of("$LABEL   =");
        } else if (line.starts_with("$REAL OUTPUT")) {
            head_.numbers = PrintedNumbers::Real;
        } else if (line.starts_with("$REAL-IMAGINARY OUTPUT")) {
            head_.numbers = PrintedNumbers::RealImaginary;
        } else if (line.starts_with("$MAGNITUDE-PHASE OUTPUT")) {
            head_.numbers = PrintedNumbers::MagnitudePhase;
        } else {
            read_step(line);
        }
    }

    void read_step(std::string_view line) {
        if (const auto subcase = number_after(line, "$SUBCASE ID =")) {
            key_.subcase = *subcase > 0 && *subcase < 2e9 ? static_cast<std::int32_t>(*subcase) : 1;
        } else if (const auto eigenvalue = number_after(line, "$EIGENVALUE =")) {
            const double mode = number_after(line, "MODE =").value_or(1);
            key_.kind = StepKind::Mode;
            key_.number = mode > 0 && mode < 2e9 ? static_cast<std::int64_t>(mode) : 1;
            value_ = std::sqrt(std::abs(*eigenvalue)) / (2 * std::numbers::pi);
            // Steps of modes are told apart by their number.
            key_.value = 0;
            if (head_.kind == nullptr && unused_.empty()) head_.kind = &kPunchKinds[1];
        } else if (const auto time = number_after(line, "$TIME =")) {
            set_value(StepKind::Time, *time);
        } else if (const auto frequency = number_after(line, "$FREQUENCY =")) {
            set_value(StepKind::Frequency, *frequency);
        } else if (const auto node = number_after(line, "$POINT ID =")) {
            node_ = *node > 0 && *node < 9e15 ? static_cast<std::int64_t>(*node) : 0;
            key_.kind =
                line.find("FREQUENCY") != std::string_view::npos ? StepKind::Frequency : StepKind::Time;
        } else {
            read_kind(line.substr(1));
        }
    }

    void set_value(StepKind kind, double value) {
        key_.kind = kind;
        key_.value = std::isfinite(value) ? value : 0;
        value_ = key_.value;
    }

    void read_kind(std::string_view line) {
        const bool solution_set = line.find("SOLUTION SET") != std::string_view::npos;
        for (const PrintedKind& kind : kPunchKinds) {
            if (solution_set || !line.starts_with(kind.title)) continue;
            head_.kind = &kind;
            head_.is_scalar = kind.rotation.empty();
            unused_.clear();
            return;
        }
        if (line.starts_with("ELEMENT TYPE")) {
            if (elements_) read_element_type(line, *elements_);
            return;
        }
        if (line.starts_with("ELEMENT ID")) {
            by_element_ = true;
            return;
        }
        head_.kind = nullptr;
        elements_.reset();
        unused_ = trim(line);
        by_element_ = false;
        const bool strain = unused_ == "ELEMENT STRAINS";
        if (strain || unused_ == "ELEMENT STRESSES") elements_ = PunchedElements{strain, 0, {}};
    }

    /// Rows that end before `last`.
    void end_rows(std::size_t last) {
        if (!std::exchange(in_rows_, false)) return;
        if (head_.kind == nullptr && end_elements(last)) return;
        if (head_.kind == nullptr) {
            diagnostics_.add(
                Code::UnknownBlock, [&] { return input_.where_line(first_row_); }, unused_text()
            );
            return;
        }
        if (node_ == 0) {
            tables_.at(head_, key_, value_, texts_).rows.push_back({first_row_, last, 0, false});
            return;
        }
        PrintedRow row;
        for (std::size_t at = first_row_; at < last;) {
            const std::size_t first = at;
            if (!read_punch_row(input_.text(), at, last, {}, row)) break;
            set_value(key_.kind, row.step_value);
            tables_.at(head_, key_, value_, texts_).rows.push_back({first, at, node_, false});
        }
    }

    std::string unused_text() const {
        if (unused_.empty()) return "rows without a heading are not used";
        std::string text = unused_;
        if (elements_) text += fmt::format(" of {}", op2::element_name(elements_->type));
        if (head_.numbers != PrintedNumbers::Real) text += ", complex,";
        if (by_element_) text += ", sorted by element,";
        return text + " are not used";
    }

    /// Whether the rows are of elements that Feelem reads.
    bool end_elements(std::size_t last) {
        if (!elements_ || by_element_ || head_.numbers != PrintedNumbers::Real) return false;
        const op2::ElementLayout* layout = punched_layout(input_.text(), first_row_, last, elements_->type);
        if (layout == nullptr) return false;
        const auto kind = punched_kind(*elements_, *layout);
        if (!kind) return false;
        const PrintedElements table{unused_, key_, *kind, layout, {}};
        tables_.elements_at(table, value_, texts_).rows.push_back({first_row_, last, 0, false});
        return true;
    }

    const Input& input_;
    Diagnostics& diagnostics_;
    TextLines lines_;
    PrintedTables tables_;
    PrintedTables::Head head_;
    std::optional<PunchedElements> elements_;
    bool by_element_ = false;  ///< Rows are times, a table is an element.
    op2::StepKey key_{1, StepKind::Static, 0, 0};
    double value_ = 0;
    op2::Texts texts_;
    std::int64_t node_ = 0;
    std::string unused_;
    bool in_rows_ = false;
    std::size_t first_row_ = 0;
};

Likelihood recognise_punch(const Input& input) {
    const std::string_view head = head_of(input);
    if (!head.starts_with('$')) return Likelihood::No;
    for (const char* mark : {"\n$REAL OUTPUT", "\n$REAL-IMAGINARY OUTPUT", "\n$MAGNITUDE-PHASE OUTPUT"}) {
        if (head.find(mark) != std::string_view::npos) return Likelihood::Sure;
    }
    return head.find("\n-CONT-  ") != std::string_view::npos ? Likelihood::Sure : Likelihood::No;
}

std::unique_ptr<ModelSource> open_punch(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    const Input& input = inputs.front();
    return open_printed(
        input,
        PunchScanner(input, diagnostics).scan(),
        read_punch_row,
        read_punch_elements,
        context,
        diagnostics
    );
}

}  // namespace

ReadFormat nastran_punch_format() {
    return {
        {"nastran-punch", "Nastran results, punched", ".pch", false, true},
        false,
        recognise_punch,
        open_punch};
}

}  // namespace feelem
