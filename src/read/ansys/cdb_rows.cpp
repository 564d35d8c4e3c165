// SPDX-License-Identifier: Apache-2.0
// Must: read rows fast when they are what solvers write, and rightly or not at all when they are not.
// Assumes: a line is a row; only elements go on to further lines.
// Algorithm: fixed columns, each first by the fast ways of cdb_format.hpp, then by the general ones.
#include "read/ansys/cdb_rows.hpp"

#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace feelem::ansys::cdb {
namespace {

constexpr std::size_t kSolidAttributes = 11;
constexpr std::size_t kPlainAttributes = 5;

std::string_view without_return(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string_view field_of(std::string_view line, std::size_t first, std::size_t width) {
    return first < line.size() ? line.substr(first, width) : std::string_view{};
}

Lines lines_of(const Deck& deck, const BlockRows& rows) {
    const std::string_view text = deck.inputs[rows.input].text();
    return {text, rows.begin, rows.end, line_end_of(text)};
}

}  // namespace

void RowPlace::bad_row(std::string_view line) const {
    if (line.find('\0') != std::string_view::npos) {
        throw Error(
            Code::Truncated,
            where(),
            fmt::format(
                "{} stops here and bytes of zero follow: the file was cut off. Write or copy it again.",
                block_
            )
        );
    }
    throw Error(
        Code::BadNumber,
        where(),
        fmt::format("this is no row of {}: \"{}\"", block_, trim(line).substr(0, 80))
    );
}

std::int64_t integer_field(
    std::string_view line, std::size_t first, std::size_t width, const RowPlace& place
) {
    std::int64_t value = 0;
    if (first + width <= line.size() && fast_integer(line.data() + first, width, value)) return value;
    const std::string_view field = field_of(line, first, width);
    if (field.find('\0') != std::string_view::npos) place.bad_row(line);
    if (trim(field).empty()) return 0;
    const auto general = parse_integer(field);
    if (!general) place.bad_row(line);
    return *general;
}

double real_field(
    std::string_view line, std::size_t first, std::size_t width, std::size_t decimals, const RowPlace& place
) {
    double value = 0;
    if (first + width <= line.size() && fast_real(line.data() + first, width, decimals, value)) return value;
    const std::string_view field = field_of(line, first, width);
    if (field.find('\0') != std::string_view::npos) place.bad_row(line);
    if (trim(field).empty()) return 0;
    const auto general = parse_double(field);
    if (!general) place.bad_row(line);
    return *general;
}

NodeRows::NodeRows(const Deck& deck, const BlockRows& rows)
    : rows_(rows), lines_(lines_of(deck, rows)), place_(deck.inputs[rows.input], "NBLOCK") {}

bool NodeRows::next() {
    while (lines_.next()) {
        place_.at(lines_.begin());
        // A number may be cut in two where the file ends.
        const std::string_view line = without_return(lines_.line());
        if (!rows_.ended && !lines_.ended()) {
            if (line.find('\0') != std::string_view::npos) place_.bad_row(line);
            cut_ = true;
            return false;
        }
        if (trim(line).empty() && line.find('\0') == std::string_view::npos) continue;
        read(line);
        ++count_;
        return true;
    }
    return false;
}

void NodeRows::read(std::string_view line) {
    const RowFormat& format = rows_.format;
    node_.id = integer_field(line, 0, format.id_width, place_);
    if (node_.id < 1) place_.bad_row(line);
    std::array<double, 6> reals{};
    const std::size_t count = std::min(reals.size(), format.others);
    std::size_t at = format.integers_end;
    for (std::size_t i = 0; i < count && at < line.size(); ++i, at += format.other_width)
        reals[i] = real_field(line, at, format.other_width, format.decimals, place_);
    node_.position = {reals[0], reals[1], reals[2]};
    node_.angles = {reals[3], reals[4], reals[5]};
}

ElementRowsReader::ElementRowsReader(const Deck& deck, const ElementRows& block, NodesOfType nodes_of_type)
    : block_(block), nodes_of_type_(std::move(nodes_of_type)), lines_(lines_of(deck, block.rows)),
      place_(deck.inputs[block.rows.input], "EBLOCK") {}

bool ElementRowsReader::next() {
    while (lines_.next()) {
        place_.at(lines_.begin());
        const std::string_view line = without_return(lines_.line());
        if (trim(line).empty() && line.find('\0') == std::string_view::npos) continue;
        node_count_ = 0;
        short_ = false;
        block_.form == ElementForm::Solid ? read_solid(line) : read_plain(line);
        const bool at_end = !block_.rows.ended && lines_.end() >= block_.rows.end;
        const bool partly = !lines_.ended() && lines_.line().size() % block_.rows.format.id_width != 0;
        if (at_end && (short_ || partly)) {
            cut_ = true;
            return false;
        }
        if (row_.id < 1) place_.bad_row(line);
        row_.nodes = std::span(nodes_).first(std::min(node_count_, nodes_.size()));
        row_.offset = place_.offset();
        ++count_;
        return true;
    }
    return false;
}

/// Material, type, real constant, section, system, death, solid, shape, number of nodes, (unused), number.
void ElementRowsReader::read_solid(std::string_view line) {
    const std::size_t width = block_.rows.format.id_width;
    row_.material = integer_field(line, 0, width, place_);
    row_.type = integer_field(line, width, width, place_);
    const std::int64_t says = integer_field(line, 8 * width, width, place_);
    row_.id = integer_field(line, 10 * width, width, place_);
    const std::size_t columns = std::max(block_.rows.format.integers, kSolidAttributes);
    const std::size_t wanted = says > 0 ? static_cast<std::size_t>(says) : columns - kSolidAttributes;
    add_nodes(line, kSolidAttributes, columns, wanted);
    if (says > 0 && node_count_ == columns - kSolidAttributes) add_lines(wanted);
    short_ = says > 0 && node_count_ < wanted;
}

/// Number, type, real constant, material, system; or the number alone (COMPACT).
void ElementRowsReader::read_plain(std::string_view line) {
    const std::size_t width = block_.rows.format.id_width;
    const bool compact = block_.form == ElementForm::Compact;
    const std::size_t attributes = compact ? 1 : kPlainAttributes;
    row_.id = integer_field(line, 0, width, place_);
    row_.type = compact ? block_.type : integer_field(line, width, width, place_);
    row_.material = compact ? block_.material : integer_field(line, 3 * width, width, place_);
    std::size_t most = nodes_of_type_(row_.type);
    if (most == 0 && !compact) {
        row_.type = block_.type;
        most = nodes_of_type_(row_.type);
    }
    const std::size_t columns = std::max(block_.rows.format.integers, attributes);
    add_nodes(line, attributes, columns, kMostNodes);
    if (node_count_ == columns - attributes && node_count_ < most) {
        add_lines(most);
        short_ = node_count_ < most;
    }
}

void ElementRowsReader::add_nodes(
    std::string_view line, std::size_t first_field, std::size_t last_field, std::size_t wanted
) {
    const std::size_t width = block_.rows.format.id_width;
    for (std::size_t field = first_field; field < last_field && node_count_ < wanted; ++field) {
        const std::size_t at = field * width;
        // What a writer leaves out at the end is no node; blanks behind the last one are not either.
        if (at >= line.size()) return;
        if (at + width > line.size() && trim(line.substr(at)).empty() &&
            line.find('\0', at) == std::string_view::npos)
            return;
        const std::int64_t node = integer_field(line, at, width, place_);
        if (node_count_ < nodes_.size()) nodes_[node_count_] = node;
        ++node_count_;
    }
}

void ElementRowsReader::add_lines(std::size_t wanted) {
    while (node_count_ < wanted && lines_.next()) {
        const std::size_t before = node_count_;
        const std::string_view line = without_return(lines_.line());
        add_nodes(line, 0, block_.rows.format.integers, wanted);
        if (node_count_ == before) return;
    }
}

}  // namespace feelem::ansys::cdb
