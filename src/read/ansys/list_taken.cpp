// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/list_taken.hpp"

#include "base/columns.hpp"
#include "base/count_character.hpp"
#include "base/eight_digits.hpp"
#include "base/huge_pages.hpp"
#include "read/ansys/list_element_lines.hpp"
#include "read/ansys/list_text.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace feelem::ansys {
namespace {

/// So much of a file at once: the scanner gives back what lies behind.
constexpr std::size_t kPieceOfFile = std::size_t{1} << 20U;
constexpr std::uint64_t kEightBlanks = 0x2020202020202020;

bool stands_there(const char* at, std::string_view wanted) {
    return same_characters(at, wanted.data(), wanted.size());
}

/// Right-aligned in columns with a blank before each; bytes before the first column may be looked at.
bool ids_in_columns(const char* at, std::size_t width, std::size_t count, std::uint32_t* out) {
    std::uint64_t bad = 0;
    for (std::size_t i = 0; i < count; ++i) bad |= static_cast<std::uint64_t>(at[i * width] != ' ');
    if (width < 8) {
        const std::size_t foreign = 8 * (8 - width);
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t word = load8(at + (i + 1) * width - 8);
            out[i] = eight_columns((word >> foreign << foreign) | (kEightBlanks >> (64 - foreign)), bad);
        }
        return bad == 0;
    }
    return bad == 0 && columns_of_integers(at, width, count, out);
}

/// Some runs more than pages are taken apart; a list that is a patchwork is left to be read later.
bool has_too_many_runs(const List& list) {
    return list.runs.size() > 64 + list.rows / 4;
}

}  // namespace

bool AlikeElements::read(std::string_view text, std::uint32_t& id, std::uint32_t* nodes) const {
    if (length_ == 0 || text.size() < length_) return false;
    const char* at = text.data();
    constexpr std::size_t kAhead = 1024;  // What will be read soon, beyond the end too.
    __builtin_prefetch(at + kAhead);
    __builtin_prefetch(at + kAhead + 64);
    std::int64_t number = 0;
    if (!fast_integer(at, id_end_, number) || number > std::numeric_limits<std::uint32_t>::max())
        return false;
    id = static_cast<std::uint32_t>(number);
    at += id_end_;
    for (const Line& line : lines_) {
        if (!stands_there(at, line.before)) return false;
        at += line.before.size();
        if (!ids_in_columns(at, width_, line.nodes, nodes)) return false;
        at += line.nodes * width_;
        nodes += line.nodes;
    }
    return stands_there(at, tail_);
}

void AlikeElements::learn(std::string_view text, char line_end) {
    ++misses_;
    if (misses_ > 8 && misses_ % 64 != 0) return;
    length_ = 0;
    std::vector<std::uint32_t> wanted;
    if (!find_columns(text, line_end, wanted)) return;
    const std::size_t length = length_;
    std::array<std::uint32_t, kMostIds> found{};
    std::uint32_t id = 0;
    const bool is_alike = read(text, id, found.data());
    length_ = is_alike && std::equal(wanted.begin(), wanted.end(), found.begin()) ? length : 0;
}

bool AlikeElements::find_columns(std::string_view text, char line_end, std::vector<std::uint32_t>& nodes) {
    constexpr std::size_t kMostLines = 4, kLongest = 1024;
    lines_.clear();
    nodes_ = 0;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t end = text.substr(0, begin + kLongest).find(line_end, begin);
        if (end == std::string_view::npos) return false;
        const std::string_view line = text.substr(begin, end - begin);
        const bool is_further =
            begin > 0 && indent_of(line) >= kContinuationIndent && is_digit(first_mark(line));
        if (begin > 0 && !is_further) break;
        if (lines_.size() == kMostLines || !add_line(text.substr(0, end), begin, nodes)) return false;
        begin = end + 1;
    }
    tail_ = text.substr(0, begin).substr(static_cast<std::size_t>(tail_.data() - text.data()));
    length_ = begin;
    return true;
}

/// The line of `text` from `first` on, its last one.
bool AlikeElements::add_line(std::string_view text, std::size_t first, std::vector<std::uint32_t>& nodes) {
    const std::string_view line = text.substr(first);
    Numbers numbers;
    const bool is_first = lines_.empty();
    const std::size_t skipped = is_first ? kAttributes : 0;
    if (!read_numbers(line, 0, numbers) || numbers.count <= skipped) return false;
    const std::size_t first_end = numbers.ends[skipped];
    if (is_first) {
        if (has_touching_attributes(line) || indent_of(line) >= kContinuationIndent) return false;
        id_end_ = numbers.ends[0];
        material_ = numbers.values[1];
        type_ = numbers.values[2];
        const bool has_two = numbers.count > skipped + 1;
        width_ = has_two ? numbers.ends[skipped + 1] - first_end
                         : std::min<std::size_t>(8, first_end - numbers.ends[skipped - 1]);
        // Of twelve: see has_touching_ids() of the general way.
        if (id_end_ > kContinuationIndent || width_ < 2 || width_ > 16 || width_ == 12) return false;
    }
    const std::size_t least = is_first ? numbers.ends[skipped - 1] : kContinuationIndent;
    const std::size_t count = numbers.count - skipped;
    if (first_end < least + width_ || nodes_ + count > kMostIds) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (numbers.ends[skipped + i] != first_end + i * width_) return false;
        if (numbers.values[skipped + i] > std::numeric_limits<std::uint32_t>::max()) return false;
        nodes.push_back(static_cast<std::uint32_t>(numbers.values[skipped + i]));
    }
    const std::size_t behind_before =
        is_first ? id_end_ : static_cast<std::size_t>(tail_.data() - text.data());
    lines_.push_back({text.substr(behind_before, first + first_end - width_ - behind_before), count});
    tail_ = text.substr(first + first_end + (count - 1) * width_);
    nodes_ += count;
    return true;
}

void RowTaker::begin(const List& list) {
    nodes_.reset();
    if (list.kind == ListKind::Nodes) nodes_.emplace(list.has_angles);
}

std::size_t RowTaker::take(List& list, std::size_t at, bool new_run) {
    switch (list.kind) {
    case ListKind::Nodes: return nodes_ ? take_nodes(list, at, new_run) : at;
    case ListKind::Elements: return list.has_nodes ? take_elements(list, at, new_run) : at;
    default: return new_run ? at : pass_values(list, at);
    }
}

RowRun& RowTaker::run_for(List& list, std::size_t at, bool new_run) {
    const bool goes_on =
        !new_run && !list.runs.empty() && list.runs.back().taken > 0 && list.runs.back().end == at;
    if (!goes_on) list.runs.push_back({at, at, 0, 0, 0, 0});
    return list.runs.back();
}

std::size_t RowTaker::take_nodes(List& list, std::size_t at, bool new_run) {
    if (has_too_many_runs(list)) return at;
    const std::size_t size = file_.input.size();
    RowCursor cursor(file_, {at, size});
    NodeRows rows;
    TakenRows& taken = list.taken;
    std::size_t length = 0, end = at;
    const std::size_t before = taken.node_ids.size();
    while (!cursor.at_end() && end < at + kPieceOfFile) {
        const std::size_t count = nodes_->read(cursor, rows, length);
        if (count == 0) break;
        if (rows.angles != NodalAngles{}) {
            nodes_.reset();  // They are kept elsewhere.
            break;
        }
        grow_by_text(taken.node_ids, size - end, (cursor.at() - end) / count, count);
        grow_by_text(taken.places, size - end, (cursor.at() - end) / count, count);
        for (std::size_t i = 0; i < count; ++i) taken.node_ids.push_back(NodeId{rows.ids[i]});
        taken.places.insert(taken.places.end(), rows.places.begin(), rows.places.begin() + count);
        end = cursor.at();
    }
    const std::size_t count = taken.node_ids.size() - before;
    if (count == 0) return at;
    RowRun& run = run_for(list, at, new_run);
    run.taken += count;
    run.end = end;
    list.rows += count;
    return end;
}

std::size_t RowTaker::take_elements(List& list, std::size_t at, bool new_run) {
    if (has_too_many_runs(list)) return at;
    const std::string_view text = file_.input.text();
    constexpr std::size_t kAtOnce = 32;
    std::array<std::uint32_t, kAtOnce> ids;               // NOLINT: all that are used are written
    std::array<std::uint32_t, kAtOnce * kMostIds> nodes;  // NOLINT
    if (elements_.read(text.substr(at), ids[0], nodes.data())) {
        elements_.found_alike();
    } else {
        if (indent_of(text.substr(at, kContinuationIndent)) == kContinuationIndent) return at;
        elements_.learn(text.substr(at), file_.line_end);
        if (!elements_.read(text.substr(at), ids[0], nodes.data())) return at;
        new_run = true;
    }
    RowRun& run = run_for(list, at, new_run);
    run.nodes_each = elements_.nodes();
    run.material = elements_.material();
    run.type = elements_.type();
    const std::size_t length = elements_.length(), width = run.nodes_each;
    std::size_t end = at + length;
    bool goes_on = true;
    for (std::size_t count = 1; goes_on; count = 0) {
        for (; count < kAtOnce && goes_on; end += goes_on ? length : 0) {
            goes_on = end < at + kPieceOfFile &&
                      elements_.read(text.substr(end), ids[count], nodes.data() + count * width);
            count += goes_on ? 1 : 0;
        }
        add_elements(list, std::span(ids).first(count), std::span(nodes).first(count * width), end);
    }
    run.taken += (end - at) / length;
    run.end = end;
    list.rows += (end - at) / length * elements_.lines();
    if (end > at + length) elements_.found_alike();
    return end;
}

/// `end`: where they end.
void RowTaker::add_elements(
    List& list, std::span<const std::uint32_t> ids, std::span<const std::uint32_t> nodes, std::size_t end
) {
    std::vector<ElementId>& all_ids = list.taken.element_ids;
    std::vector<NodeIndex>& all_nodes = list.taken.element_nodes;
    const std::size_t left = file_.input.size() - end, length = elements_.length(), used = all_nodes.size();
    grow_by_text(all_ids, left, length, ids.size());
    if (all_nodes.capacity() < used + nodes.size())
        reserve_big(all_nodes, used + used / 2 + nodes.size() + left / length * elements_.nodes());
    for (const std::uint32_t id : ids) all_ids.push_back(ElementId{id});
    all_nodes.resize(used + nodes.size());
    std::ranges::transform(nodes, all_nodes.begin() + static_cast<std::ptrdiff_t>(used), [](auto id) {
        return NodeIndex{id};
    });
}

/// How many rows of `length` begin there: a blank and later a digit (whatever stands in the first column may
/// be another thing), and a line's end at the end and nowhere else.
std::size_t RowTaker::rows_of_length(std::string_view text, std::size_t length) const {
    const std::size_t most = text.size() / length;
    std::size_t rows = 0;
    for (; rows < most; ++rows) {
        const char* row = text.data() + rows * length;
        const std::uint64_t others = load8(row) ^ kEightBlanks;
        if ((others & 0xFF) != 0 || others == 0 || !is_digit(row[std::countr_zero(others) / 8]) ||
            row[length - 1] != file_.line_end)
            break;
    }
    if (count_character(text.substr(0, rows * length), file_.line_end) == rows) return rows;
    const auto is_one_line = [&](std::size_t i) {
        return text.find(file_.line_end, i * length) == (i + 1) * length - 1;
    };
    std::size_t good = 0;
    while (good < rows && is_one_line(good)) ++good;
    return good;
}

/// Rows as long as the one before only make their run longer.
std::size_t RowTaker::pass_values(List& list, std::size_t at) {
    constexpr std::size_t kShortest = 16;
    const std::string_view text = file_.input.text();
    const std::string_view piece = text.substr(at, kPieceOfFile);
    const std::size_t rows = row_length_ < kShortest ? 0 : rows_of_length(piece, row_length_);
    if (rows > 0) {
        list.rows += rows;
        list.runs.back().end = at + rows * row_length_;
        return list.runs.back().end;
    }
    const std::size_t line_end = text.find(file_.line_end, at);
    row_length_ = line_end == std::string_view::npos ? 0 : line_end + 1 - at;
    return at;
}

void RowTaker::give_back(List& list) {
    RowRun& run = list.runs.back();
    const std::size_t length = (run.end - run.begin) / run.taken;
    const std::size_t end = run.end;
    list.taken.element_ids.pop_back();
    list.taken.element_nodes.resize(list.taken.element_nodes.size() - run.nodes_each);
    run.end -= length;
    if (--run.taken == 0) list.runs.pop_back();
    list.runs.push_back({end - length, end, 0, 0, 0, 0});
    elements_.forget();
}

}  // namespace feelem::ansys
