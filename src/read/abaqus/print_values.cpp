// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/print_values.hpp"

#include "base/number.hpp"
#include "read/text_lines.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace feelem::printed {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kNoPrintedRow = std::numeric_limits<std::size_t>::max();

/// One unit of the last digit of a printed number: 2.9412E+08 -> 1E+04. Zero is printed for zero alone.
double last_digit(std::string_view text, double value) {
    if (value == 0) return 0;
    const std::size_t exponent_at = text.find_first_of("EeDd");
    const std::string_view mantissa = text.substr(0, exponent_at);
    const std::size_t point = mantissa.find('.');
    const double digits =
        point == std::string_view::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
    double exponent = 0;
    if (exponent_at != std::string_view::npos)
        exponent = static_cast<double>(parse_integer(text.substr(exponent_at + 1)).value_or(0));
    return std::pow(10.0, exponent - digits);
}

/// Follows a column beside its printed extreme.
class ExtremeCheck {
public:
    ExtremeCheck(const PrintedTable& table, std::size_t column, bool largest)
        : table_(table), column_(column), largest_(largest) {
        const Summary& summary = largest ? table.largest : table.smallest;
        if (column >= summary.values.size() || column >= summary.ids.size() ||
            summary.values.size() != table.columns.size())
            return;
        text_ = summary.values[column];
        id_ = summary.ids[column];
        expected_ = parse_double(text_);
        if (expected_) digit_ = last_digit(text_, *expected_);
    }

    void use(std::int64_t id, std::string_view text, double value) {
        if (!expected_ || !std::isfinite(value)) return;
        const double beyond = largest_ ? value - *expected_ : *expected_ - value;
        // Rows may have more digits than their extremes, or fewer.
        const double tolerance = 0.5001 * std::max(digit_, last_digit(text, value));
        if (beyond > tolerance && beyond > worst_) {
            worst_ = beyond;
            worst_row_ = fmt::format("{} has {}", id, text);
        }
        if (id == id_) {
            listed_ = true;
            found_ = found_ || std::abs(beyond) <= tolerance;
        }
    }

    /// Empty when they agree.
    std::string disagreement() const {
        if (!expected_) return {};
        // A row of zeros alone is not printed.
        const bool there = listed_ ? found_ : *expected_ == 0;
        if (there && worst_row_.empty()) return {};
        return fmt::format(
            "{} of {} in the table \"{}\" is {} at {}, but {}",
            largest_ ? "the maximum" : "the minimum",
            table_.columns[column_],
            table_.title,
            text_,
            id_,
            !worst_row_.empty() ? worst_row_
            : listed_           ? "its row has another value"
                                : "the table has no such row"
        );
    }

private:
    const PrintedTable& table_;
    std::size_t column_;
    bool largest_;
    std::string text_, worst_row_;
    std::int64_t id_ = 0;
    std::optional<double> expected_;
    double digit_ = 0, worst_ = 0;
    bool listed_ = false, found_ = false;
};

/// What one table gives to a result.
struct TableColumns {
    std::size_t table = 0;
    std::vector<Source> sources;
    std::vector<ExtremeCheck> checks;
};

class PrintLoader {
public:
    PrintLoader(const PrintedResult& listed, const Mesh& mesh, const ElementLookup& elements)
        : listed_(listed), mesh_(mesh), elements_(elements), width_(listed.info.components.size()) {
        const Location location = listed.info.location;
        const std::size_t rows = location == Location::Nodal       ? mesh.node_count()
                                 : location == Location::Elemental ? mesh.element_count()
                                                                   : 0;
        out_.result.info = listed.info;
        out_.result.values.assign(rows * width_, kNoValue);
        if (listed.place == Place::Point) {
            sums_.resize(rows * width_);
            counts_.resize(rows * width_);
        }
    }

    void read(const Input& input, const PrintedTable& table, TableColumns& columns) {
        TextLines lines(input, table.begin, table.end);
        PrintedRow row;
        while (const auto line = lines.next()) {
            if (!read_printed_row(table, *line, row)) continue;
            const bool wanted = table.section_key == 0 || row.keys[table.section_key] == listed_.section;
            const std::size_t at = wanted ? row_of(table, row) : kNoPrintedRow;
            if (wanted && at == kNoPrintedRow) ++out_.without_place;
            for (std::size_t i = 0; i < columns.sources.size(); ++i) {
                const Source& source = columns.sources[i];
                const std::string_view text = row.values[source.column];
                const auto value = parse_double(text);
                if (!value) throw_no_number(lines.where(), text, table.columns[source.column]);
                columns.checks[2 * i].use(row.keys[0], text, *value);
                columns.checks[2 * i + 1].use(row.keys[0], text, *value);
                if (at != kNoPrintedRow) put(at, source.component, text, *value);
            }
        }
        for (const ExtremeCheck& check : columns.checks) {
            if (std::string text = check.disagreement(); !text.empty()) out_.disagreements.push_back(text);
        }
    }

    PrintedValues finish() {
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            if (counts_[i] > 0) out_.result.values[i] = static_cast<float>(sums_[i] / counts_[i]);
        }
        if (listed_.info.location == Location::ElementNodal) sort_rows();
        const std::vector<float>& values = out_.result.values;
        for (std::size_t first = 0; first + width_ <= values.size(); first += width_) {
            const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
            const auto end = begin + static_cast<std::ptrdiff_t>(width_);
            if (std::any_of(begin, end, [](float value) { return !std::isnan(value); })) ++out_.nodes;
        }
        return std::move(out_);
    }

private:
    struct RowOfElement {
        std::uint32_t element = 0;
        NodeIndex node{};
        std::size_t at = 0;
    };

    [[noreturn]] static void throw_no_number(
        const std::string& where, std::string_view text, const std::string& column
    ) {
        throw Error(
            Code::BadNumber, where, fmt::format("found \"{}\" where a value of {} is expected", text, column)
        );
    }

    std::size_t row_of(const PrintedTable& table, const PrintedRow& row) {
        if (listed_.info.location == Location::Nodal) {
            const NodeIndex node = find_node(mesh_, NodeId{row.keys[0]});
            return node == kNoNode ? kNoPrintedRow : raw(node);
        }
        const ElementIndex element = elements_(ElementId{row.keys[0]});
        if (element == kNoElement) return kNoPrintedRow;
        if (listed_.place != Place::ElementNodes) return raw(element);
        const NodeIndex node = node_of(element, row.keys[table.point_key]);
        if (node == kNoNode) return kNoPrintedRow;
        rows_.push_back({raw(element), node, rows_.size()});
        out_.result.values.resize(rows_.size() * width_, kNoValue);
        return rows_.size() - 1;
    }

    /// The number is the node's; where the element has no such node, its place in the element.
    NodeIndex node_of(ElementIndex element, std::int64_t number) const {
        const auto nodes = element_at(mesh_, element).nodes();
        const NodeIndex node = find_node(mesh_, NodeId{number});
        if (node != kNoNode && std::ranges::find(nodes, node) != nodes.end()) return node;
        if (number < 1 || static_cast<std::size_t>(number) > nodes.size()) return kNoNode;
        return nodes[static_cast<std::size_t>(number - 1)];
    }

    void put(std::size_t row, std::size_t component, std::string_view text, double value) {
        const float single = parse_float(text).value_or(kNoValue);
        if (!std::isfinite(single)) {
            ++out_.without_number;
            return;
        }
        const std::size_t at = row * width_ + component;
        if (listed_.place == Place::Point) {
            sums_[at] += value;
            ++counts_[at];
        } else {
            out_.result.values[at] = single;
        }
    }

    /// By element and node; a row that comes again (in a table of other components) adds its values.
    void sort_rows() {
        std::ranges::stable_sort(rows_, [](const RowOfElement& a, const RowOfElement& b) {
            return std::pair(a.element, a.node) < std::pair(b.element, b.node);
        });
        Result& result = out_.result;
        std::vector<float> values;
        values.reserve(result.values.size());
        for (const RowOfElement& row : rows_) {
            const bool again = !result.row_owner.empty() && result.row_owner.back() == row.element &&
                               result.row_node.back() == row.node;
            if (!again) {
                result.row_owner.push_back(row.element);
                result.row_node.push_back(row.node);
                values.resize(values.size() + width_, kNoValue);
            }
            for (std::size_t i = 0; i < width_; ++i) {
                const float value = result.values[row.at * width_ + i];
                if (!std::isnan(value)) values[values.size() - width_ + i] = value;
            }
        }
        result.values = std::move(values);
    }

    const PrintedResult& listed_;
    const Mesh& mesh_;
    const ElementLookup& elements_;
    std::size_t width_;
    PrintedValues out_;
    std::vector<double> sums_;
    std::vector<std::uint32_t> counts_;
    std::vector<RowOfElement> rows_;
};

std::vector<TableColumns> by_table(const PrintedResult& listed, std::span<const PrintedTable> tables) {
    std::vector<TableColumns> out;
    for (const Source& source : listed.sources) {
        if (out.empty() || out.back().table != source.table) out.push_back({source.table, {}, {}});
        TableColumns& columns = out.back();
        columns.sources.push_back(source);
        columns.checks.emplace_back(tables[source.table], source.column, true);
        columns.checks.emplace_back(tables[source.table], source.column, false);
    }
    return out;
}

}  // namespace

PrintedValues load_printed(
    const Input& input,
    const PrintedResult& listed,
    std::span<const PrintedTable> tables,
    const Mesh& mesh,
    const ElementLookup& elements
) {
    PrintLoader loader(listed, mesh, elements);
    for (TableColumns& columns : by_table(listed, tables)) loader.read(input, tables[columns.table], columns);
    return loader.finish();
}

}  // namespace feelem::printed
