// SPDX-License-Identifier: Apache-2.0
// Must: read rows fast when they are what solvers write, and rightly or not at all when they are not.
// Assumes: a line is a row; only elements go on to further lines.
// Algorithm: fixed columns, each first by the fast ways of cdb_format.hpp, then by the general ones.
#include "read/ansys/cdb_rows.hpp"

#include "base/columns.hpp"
#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace feelem::ansys::cdb {
namespace {

std::string_view field_of(std::string_view line, std::size_t first, std::size_t width) {
    return first < line.size() ? line.substr(first, width) : std::string_view{};
}

bool is_blank(std::string_view line) {
    return line.find_first_not_of(" \t") == std::string_view::npos;
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

std::optional<std::string_view> BlockCursor::next() {
    if (at >= end) return std::nullopt;
    const char* from = text.data() + at;
    const void* found = std::memchr(from, line_end, end - at);
    std::size_t length = end - at;
    if (found != nullptr) length = static_cast<std::size_t>(static_cast<const char*>(found) - from);
    at = std::min(at + length + 1, end);
    if (length > 0 && from[length - 1] == '\r') --length;
    const std::string_view line(from, length);
    if (checked_width != 0 && !starts_row(line, checked_width)) throw NotAsAssumed{};
    return line;
}

NodeRows::NodeRows(const Deck& deck, const BlockRows& rows, RowRange range)
    : rows_(rows), lines_(deck, rows, range), place_(deck.inputs[rows.input], "NBLOCK") {}

bool NodeRows::next() {
    place_.at(lines_.at);
    if (lines_.at >= lines_.stop) return false;
    if (length_ != 0 && read_fast()) {
        ++count_;
        return true;
    }
    while (lines_.at < lines_.stop) {
        const auto line = lines_.next();
        if (!line) return false;
        // A number may be cut in two where the file ends.
        if (!rows_.ended && lines_.at_end() && !lines_.was_ended()) {
            if (line->find('\0') != std::string_view::npos) place_.bad_row(*line);
            cut_ = true;
            return false;
        }
        if (!is_blank(*line)) {
            read(*line);
            ++count_;
            return true;
        }
        place_.at(lines_.at);
    }
    return false;
}

/// A row as long as the one before, each column as solvers print it: one test at its end.
bool NodeRows::read_fast() {
    const RowFormat& format = rows_.format;
    if (lines_.end - lines_.at < length_) return false;
    const char* row = lines_.text.data() + lines_.at;
    const char* reals = row + format.integers_end;
    const char* reals_end = reals + reals_ * format.other_width;
    bool plain = row[length_ - 1] == lines_.line_end &&
                 (reals_end + 1 == row + length_ || *reals_end == '\r') &&
                 stays_in_line(row + format.id_width, format.integers_end - format.id_width);
    std::int64_t id = 0;
    plain = plain && fast_integer(row, format.id_width, id) && id > 0;
    std::array<double, 6> values{};
    const bool usual = reals_ == 3 && format.other_width == 21 && format.decimals == 13;
    if (usual && plain && three_reals_of_21(reals, values.data())) {
        // The columns of nearly all archives.
    } else if (format.decimals == 13) {
        for (std::size_t i = 0; i < reals_; ++i)
            plain = plain && fast_real_of<13>(reals + i * format.other_width, format.other_width, values[i]);
    } else {
        for (std::size_t i = 0; i < reals_; ++i)
            plain = plain && fast_real_of<9>(reals + i * format.other_width, format.other_width, values[i]);
    }
    if (!plain) return false;
    node_.id = id;
    node_.position = {values[0], values[1], values[2]};
    node_.angles = {values[3], values[4], values[5]};
    lines_.at += length_;
    return true;
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
    if (format.others == 0) return;
    reals_ = line.size() < format.integers_end ? 0 : (line.size() - format.integers_end) / format.other_width;
    const bool whole =
        line.size() == format.integers_end + reals_ * format.other_width && reals_ <= reals.size();
    const bool usual = format.decimals == 13 || format.decimals == 9;
    length_ = whole && usual && lines_.was_ended() ? lines_.at - place_.offset() : 0;
}

ElementRowsReader::ElementRowsReader(
    const Deck& deck, const ElementRows& block, RowRange range, NodesOfType nodes_of_type
)
    : block_(block), nodes_of_type_(std::move(nodes_of_type)), lines_(deck, block.rows, range),
      place_(deck.inputs[block.rows.input], "EBLOCK") {}

bool ElementRowsReader::next() {
    place_.at(lines_.at);
    if (lines_.at >= lines_.stop) return false;
    if (!alike_.empty() && read_fast()) {
        ++count_;
        return true;
    }
    is_plain_ = false;
    while (lines_.at < lines_.stop) {
        const auto line = lines_.next();
        if (!line) return false;
        if (is_blank(*line)) {
            place_.at(lines_.at);
            continue;
        }
        node_count_ = 0;
        short_ = false;
        block_.form == ElementForm::Solid ? read_solid(*line) : read_plain(*line);
        const bool at_end = !block_.rows.ended && lines_.at_end();
        const bool partly =
            !lines_.was_ended() && (lines_.at - place_.offset()) % block_.rows.format.id_width != 0;
        if (at_end && (short_ || partly)) {
            cut_ = true;
            return false;
        }
        if (row_.id < 1) place_.bad_row(*line);
        row_.nodes = std::span(nodes_).first(std::min(node_count_, nodes_.size()));
        row_.offset = place_.offset();
        if (block_.form == ElementForm::Solid) remember(line->size());
        ++count_;
        return true;
    }
    return false;
}

/// Whether the next row may be read like this one: whole lines of columns, as many nodes as it says.
void ElementRowsReader::remember(std::size_t first) {
    const std::size_t width = block_.rows.format.id_width;
    const std::size_t on_first = std::min<std::size_t>(node_count_, 8);
    const std::size_t bytes = (kSolidAttributes + node_count_) * width;
    const std::size_t lines = node_count_ > on_first ? 2 : 1;
    const std::size_t ends = lines_.at - place_.offset() - std::min(bytes, lines_.at - place_.offset());
    const bool usual = width >= 8 && width <= 10 && block_.rows.format.integers == 19 && !short_ &&
                       node_count_ >= 1 && node_count_ <= 27 &&
                       first == (kSolidAttributes + on_first) * width &&
                       (ends == lines || ends == 2 * lines) && lines_.was_ended();
    alike_ = usual ? lines_.text.substr(place_.offset(), kAlike * width) : std::string_view{};
    line_end_size_ = ends / lines;
}

/// A row with the same attributes as the one before, so with as many nodes: one test at its end.
bool ElementRowsReader::read_fast() {
    const std::size_t width = block_.rows.format.id_width;
    const std::size_t on_first = std::min<std::size_t>(node_count_, 8);
    const std::size_t first = (kSolidAttributes + on_first) * width;
    const std::size_t second = (node_count_ - on_first) * width;
    const std::size_t size = first + line_end_size_ + (second == 0 ? 0 : second + line_end_size_);
    if (lines_.end - lines_.at < size) return false;
    const char* row = lines_.text.data() + lines_.at;
    if (std::memcmp(row, alike_.data(), alike_.size()) != 0) return false;
    bool plain = stays_in_line(row + kAlike * width, width);
    const auto ends_line = [&](const char* at) {
        return (line_end_size_ == 1 || *at == '\r') && at[line_end_size_ - 1] == lines_.line_end;
    };
    // The number stands in the column before the nodes.
    const char* nodes = row + kSolidAttributes * width;
    std::int64_t id = 0;
    plain = plain && fast_integer(nodes - width, width, id) && id > 0 &&
            columns_of_integers(nodes, width, on_first, columns_.data()) &&
            ends_line(nodes + on_first * width);
    const char* further = nodes + on_first * width + line_end_size_;
    if (second != 0) {
        const std::size_t count = node_count_ - on_first;
        plain = plain && columns_of_integers(further, width, count, columns_.data() + on_first) &&
                ends_line(further + second);
    }
    if (!plain) return false;
    is_plain_ = true;
    row_.id = id;
    row_.offset = lines_.at;
    lines_.at += size;
    return true;
}

const ElementRowIds& ElementRowsReader::row() {
    if (is_plain_) {
        std::copy_n(columns_.begin(), node_count_, nodes_.begin());
        row_.nodes = std::span(nodes_).first(node_count_);
    }
    return row_;
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
    while (node_count_ < wanted) {
        const auto line = lines_.next();
        if (!line) return;
        const std::size_t before = node_count_;
        add_nodes(*line, 0, block_.rows.format.integers, wanted);
        if (node_count_ == before) return;
    }
}

}  // namespace feelem::ansys::cdb
