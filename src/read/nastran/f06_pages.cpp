// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/f06_pages.hpp"

#include "base/number.hpp"
#include "read/nastran/f06_elements.hpp"
#include "read/nastran/f06_rows.hpp"
#include "read/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace feelem::nastran {
namespace {

constexpr PrintedKind kPageKinds[]{
    {"DISPLACEMENT VECTOR", "displacement", "rotation", {}},
    {"EIGENVECTOR NO.", "displacement", "rotation", {}},
    {"VELOCITY VECTOR", "velocity", "angular_velocity", "temperature_rate"},
    {"ACCELERATION VECTOR", "acceleration", "angular_acceleration", {}},
    {"TEMPERATURE VECTOR", "temperature", {}, "temperature"},
    {"LOAD VECTOR", "applied_force", "applied_moment", "applied_heat_flow"},
    {"FORCES OF SINGLE-POINT CONSTRAINT", "reaction_force", "reaction_moment", "reaction_heat_flow"},
    {"FORCES OF MULTIPOINT CONSTRAINT", "mpc_force", "mpc_moment", "mpc_heat_flow"},
};

std::optional<double> number_behind(std::string_view line, std::string_view key) {
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) return {};
    std::string_view rest = line.substr(at + key.size());
    std::string_view word = take_word(rest);
    if (word.ends_with(',')) word.remove_suffix(1);
    return parse_double(word);
}

class PageScanner {
public:
    PageScanner(const Input& input, Diagnostics& diagnostics)
        : input_(input), diagnostics_(diagnostics), lines_(input, 0, input.size()),
          thermal_(input.text().find("T E M P E R A T U R E   V E C T O R") != std::string_view::npos) {}

    PrintedTables scan() {
        while (const auto line = lines_.next()) {
            if (is_page_head(*line)) {
                end_rows(lines_.line_start());
                start_page(*line);
            } else {
                ++line_of_page_;
                read_line(*line);
            }
        }
        end_rows(input_.size());
        return std::move(tables_);
    }

private:
    void start_page(std::string_view line) {
        line_of_page_ = 0;
        head_ = {};
        elements_.reset();
        node_ = 0;
        eigenvalue_.reset();
        cycles_.reset();
        step_ = {};
        step_.subcase = 1;
        value_ = 0;
        in_eigenvalues_ = false;
        texts_ = {};
        // The title ends where the date begins, after a gap.
        const std::string_view title = trim(line.substr(1));
        texts_.title = title.substr(0, title.find("    "));
        if (tables_.title.empty()) tables_.title = texts_.title;
        for (const auto& [word, name] : kSolvers) {
            if (line.find(word) != std::string_view::npos) tables_.solver.name = name;
        }
    }

    void read_line(std::string_view line) {
        if (line_of_page_ == 1) texts_.subtitle = trim(line.substr(std::min<std::size_t>(line.size(), 1)));
        if (line_of_page_ == 2) read_label(line);
        if (line_of_page_ <= 2 || line.size() < 8) return;
        if (elements_ && !is_spaced(line)) {
            read_elements(line);
            return;
        }
        if (elements_) end_rows(lines_.line_start());
        if (in_rows_ || has_columns_) {
            if (read_row(line)) return;
            if (in_rows_ && !trim(line).empty()) end_rows(lines_.line_start());
        }
        if (in_eigenvalues_ && read_eigenvalue(line)) return;
        read_step(line);
        if (const std::string title = spaced_title(line); !title.empty()) {
            read_title(title);
        } else if (head_.kind != nullptr) {
            read_columns(line);
        }
    }

    void read_label(std::string_view line) {
        const std::size_t at = line.rfind("SUBCASE ");
        if (at == std::string_view::npos || at < 40) {
            texts_.label = trim(line.substr(std::min<std::size_t>(line.size(), 1)));
            return;
        }
        std::string_view rest = line.substr(at + 8);
        const auto subcase = take_integer(rest);
        if (subcase && *subcase > 0 && *subcase < std::numeric_limits<std::int32_t>::max())
            step_.subcase = static_cast<std::int32_t>(*subcase);
        texts_.label = trim(line.substr(1, at - 1));
    }

    void read_step(std::string_view line) {
        if (line.find("SOL 105") != std::string_view::npos ||
            line.find("SOL SEBUCKL") != std::string_view::npos)
            buckling_ = true;
        if (line.find('=') == std::string_view::npos) return;
        if (const auto cycles = number_behind(line, "CYCLES =")) cycles_ = cycles;
        if (const auto eigenvalue = number_behind(line, "EIGENVALUE =")) {
            eigenvalue_ = eigenvalue;
            // COMPLEX EIGENVALUE = real, imaginary
            const std::size_t comma = line.find(',');
            if (comma != std::string_view::npos) {
                if (const auto imaginary = number_behind(line, ","))
                    cycles_ = *imaginary / (2 * std::numbers::pi);
            }
        } else if (const auto time = number_behind(line, "      TIME =")) {
            set_value(StepKind::Time, *time);
        } else if (const auto frequency = number_behind(line, "FREQUENCY =")) {
            set_value(StepKind::Frequency, *frequency);
        } else if (const auto load = number_behind(line, "LOAD STEP =")) {
            set_value(StepKind::Static, *load);
        } else if (const auto node = number_behind(line, "POINT-ID =")) {
            node_ = *node > 0 && *node < 9e15 ? static_cast<std::int64_t>(*node) : 0;
        }
    }

    void set_value(StepKind kind, double value) {
        step_.kind = kind;
        step_.value = std::isfinite(value) ? value : 0;
        value_ = step_.value;
    }

    /// Lines under the title of a table of elements: those of its columns, then rows.
    void read_elements(std::string_view line) {
        const ElementLine row = element_line(line, *elements_);
        if (!in_rows_) {
            if (!row.is_row) {
                read_element_columns(line, *elements_);
                return;
            }
            if (printed_layout(*elements_) == nullptr) {
                report_unused(elements_->title + (elements_->by_step ? ", sorted by element," : ""));
                elements_.reset();
                return;
            }
            in_rows_ = true;
            first_row_ = lines_.line_start();
            find_mode(row.element, elements_->title);
        }
        if (row.element != 0) last_id_ = row.element;
    }

    void report_unused(const std::string& title) {
        diagnostics_.add(
            Code::UnknownBlock, [&] { return lines_.where(); }, fmt::format("{} is not used", title)
        );
    }

    void read_title(const std::string& title) {
        has_columns_ = false;
        elements_ = element_head(title);
        if (elements_) head_ = {};
        if (elements_) return;
        if (title.find("REAL EIGENVALUES") != std::string::npos) {
            in_eigenvalues_ = true;
            return;
        }
        const bool solution_set = title.find("SOLUTION SET") != std::string::npos;
        for (const PrintedKind& kind : kPageKinds) {
            const std::size_t at = title.find(kind.title);
            if (at == std::string::npos || solution_set) continue;
            head_ = {&kind, PrintedNumbers::Real, false};
            if (kind.title.ends_with("NO."))
                number_ = mode_number(std::string_view(title).substr(at + kind.title.size()));
            read_form(title);
            return;
        }
        head_ = {};
        const bool has_values =
            title.find("STRESS") != std::string::npos || title.find("STRAIN") != std::string::npos ||
            title.find("FORCES IN") != std::string::npos || title.find("GRID POINT") != std::string::npos ||
            title.find("ENERGIES") != std::string::npos || solution_set;
        if (has_values) report_unused(title);
    }

    static std::optional<std::int64_t> mode_number(std::string_view rest) {
        const auto number = take_integer(rest);
        return number && *number > 0 ? number : std::nullopt;
    }

    void read_form(std::string_view line) {
        if (line.find("(REAL/IMAGINARY)") != std::string_view::npos)
            head_.numbers = PrintedNumbers::RealImaginary;
        if (line.find("(MAGNITUDE/PHASE)") != std::string_view::npos)
            head_.numbers = PrintedNumbers::MagnitudePhase;
    }

    void read_columns(std::string_view line) {
        read_form(line);
        std::string_view rest = line.substr(1);
        const std::string_view first = take_word(rest);
        const bool by_node = first == "POINT" && line.find("TYPE") != std::string_view::npos;
        const bool by_step =
            (first == "TIME" || first == "FREQUENCY") && line.find("TYPE") != std::string_view::npos;
        if (!by_node && !by_step) return;
        if (by_step) step_.kind = first == "TIME" ? StepKind::Time : StepKind::Frequency;
        sorted_by_node_ = by_step;
        packed_ = line.find("ID+1") != std::string_view::npos;
        const bool one_number = packed_ || line.find("VALUE") != std::string_view::npos;
        head_.is_scalar = head_.kind->rotation.empty() || (thermal_ && one_number);
        has_columns_ = true;
    }

    bool read_row(std::string_view line) {
        if (in_rows_ && is_number_line(line)) return true;
        const auto start = row_start(line);
        if (!start) return trim(line).empty();
        if (sorted_by_node_) {
            const auto value = parse_double(start->number);
            if (!value || node_ == 0) return false;
            // A complex row's second line belongs to it.
            add_row_of_step(*value);
            return true;
        }
        const auto id = parse_integer(start->number);
        if (!id) return false;
        if (!in_rows_) {
            in_rows_ = true;
            first_row_ = lines_.line_start();
            find_mode(*id, std::string(head_.kind->title));
        }
        last_id_ = *id;
        return true;
    }

    void add_row_of_step(double value) {
        set_value(step_.kind, value);
        std::size_t last = lines_.offset();
        TextLines ahead(input_, last, input_.size());
        if (const auto next = ahead.next(); next && is_number_line(*next)) last = ahead.offset();
        tables_.at(head_, step_, value_, texts_).rows.push_back({lines_.line_start(), last, node_, false});
    }

    /// The mode of a page that tells its eigenvalue: equal ones come one after the other. `first_id` is 0
    /// where the page goes on with the last page's element.
    void find_mode(std::int64_t first_id, const std::string& title) {
        if (!eigenvalue_) return;
        step_.kind = buckling_ ? StepKind::Buckling : StepKind::Mode;
        Sequence& sequence = sequences_[{step_.subcase, title}];
        const bool goes_on = sequence.mode > 0 && sequence.eigenvalue == *eigenvalue_ &&
                             (first_id == 0 || first_id > sequence.last_id);
        if (number_) {
            sequence.mode = *number_;
        } else if (!goes_on) {
            sequence.mode = next_mode(sequence.mode);
        }
        sequence.eigenvalue = *eigenvalue_;
        open_sequence_ = &sequence;
        step_.number = sequence.mode;
        value_ = buckling_ ? *eigenvalue_
                           : cycles_.value_or(std::sqrt(std::abs(*eigenvalue_)) / (2 * std::numbers::pi));
    }

    std::int64_t next_mode(std::int64_t previous) const {
        for (const auto& [mode, eigenvalue] : eigenvalues_) {
            if (mode > previous && eigenvalue == *eigenvalue_) return mode;
        }
        return previous + 1;
    }

    /// The table ends before `last`.
    void end_rows(std::size_t last) {
        if (in_rows_) {
            const PrintedRows rows{first_row_, last, 0, packed_};
            if (elements_) {
                const char* table = elements_->kind.strain ? "STRAINS" : "STRESSES";
                const PrintedElements head{table, step_, elements_->kind, printed_layout(*elements_), {}};
                tables_.elements_at(head, value_, texts_).rows.push_back(rows);
            } else {
                tables_.at(head_, step_, value_, texts_).rows.push_back(rows);
            }
            if (open_sequence_ != nullptr) open_sequence_->last_id = last_id_;
        }
        open_sequence_ = nullptr;
        number_.reset();
        in_rows_ = has_columns_ = sorted_by_node_ = packed_ = false;
    }

    /// MODE, EXTRACTION ORDER, EIGENVALUE, RADIANS, CYCLES ...
    bool read_eigenvalue(std::string_view line) {
        std::string_view rest = line.substr(1);
        const auto mode = take_integer(rest);
        const auto order = take_integer(rest);
        const auto eigenvalue = parse_double(take_word(rest));
        if (!mode || !order || !eigenvalue || *mode <= 0) return false;
        eigenvalues_.emplace_back(*mode, *eigenvalue);
        return true;
    }

    struct Sequence {
        std::int64_t mode = 0;
        double eigenvalue = 0;
        std::int64_t last_id = 0;
    };
    static constexpr std::pair<std::string_view, const char*> kSolvers[]{
        {"MSC.NASTRAN", "MSC Nastran"},
        {"MSC NASTRAN", "MSC Nastran"},
        {"NX NASTRAN", "NX Nastran"},
        {"SIMCENTER NASTRAN", "Simcenter Nastran"},
        {"AUTODESK NASTRAN", "Autodesk Nastran"},
    };

    const Input& input_;
    Diagnostics& diagnostics_;
    TextLines lines_;
    PrintedTables tables_;
    PrintedTables::Head head_;
    std::optional<ElementHead> elements_;  ///< The table of elements that the page is in.
    op2::StepKey step_{1, StepKind::Static, 0, 0};
    double value_ = 0;
    op2::Texts texts_;
    std::int64_t node_ = 0;
    std::optional<double> eigenvalue_, cycles_;
    std::optional<std::int64_t> number_;
    std::map<std::pair<std::int32_t, std::string>, Sequence> sequences_;
    Sequence* open_sequence_ = nullptr;
    std::vector<std::pair<std::int64_t, double>> eigenvalues_;
    std::size_t line_of_page_ = 0;
    std::size_t first_row_ = 0;
    std::int64_t last_id_ = 0;
    bool in_rows_ = false, has_columns_ = false, sorted_by_node_ = false, packed_ = false;
    bool in_eigenvalues_ = false, buckling_ = false;
    bool thermal_;  ///< Tables of one number are heat flows.
};

}  // namespace

PrintedTables find_pages(const Input& input, Diagnostics& diagnostics) {
    return PageScanner(input, diagnostics).scan();
}

}  // namespace feelem::nastran
