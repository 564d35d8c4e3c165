// SPDX-License-Identifier: Apache-2.0
// A .op2 is a chain of Fortran records: mark, bytes, mark. A record of one word is a key: above 0 it says how
// many words the next record has, below 0 it ends a logical record, 0 ends a table.
#include "read/nastran/op2_records.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace feelem::op2 {
namespace {

constexpr std::size_t kMarkBytes = 4;

template <class T>
T load(const std::byte* at, bool swap) noexcept {
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), at, sizeof(T));
    if (swap) std::ranges::reverse(raw);
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
}

/// The bytes between two marks at `offset`, or nothing when the marks are not there or differ.
std::optional<Segment> segment_at(std::span<const std::byte> bytes, std::size_t offset, bool swap) {
    if (bytes.size() < 2 * kMarkBytes || offset > bytes.size() - 2 * kMarkBytes) return {};
    const std::size_t length = load<std::uint32_t>(bytes.data() + offset, swap);
    if (length > bytes.size() - 2 * kMarkBytes - offset) return {};
    const std::size_t end = offset + kMarkBytes + length;
    if (load<std::uint32_t>(bytes.data() + end, swap) != length) return {};
    return Segment{offset + kMarkBytes, length};
}

class Walker {
public:
    Walker(const Input& input, WordForm form, Diagnostics& diagnostics)
        : input_(input), diagnostics_(diagnostics) {
        layout_.form = form;
    }

    Layout walk() {
        skip_head();
        while (!at_end() && read_table()) {}
        if (layout_.tables.empty()) {
            throw Error(
                Code::Truncated,
                input_.where_byte(offset_),
                "the .op2 file ends before its first table. Was the solver stopped?"
            );
        }
        if (!whole_) {
            diagnostics_.add(
                Code::TruncatedInput,
                input_.where_byte(offset_),
                "the chain of records breaks off here; the tables before it are used"
            );
        }
        input_.release(0, input_.size());
        return std::move(layout_);
    }

private:
    bool at_end() const { return offset_ >= input_.size(); }

    std::optional<Segment> next() {
        const auto segment = segment_at(input_.bytes(), offset_, layout_.form.swap);
        if (segment) offset_ = segment->first + segment->bytes + kMarkBytes;
        return segment;
    }

    Words words(const Segment& segment) const {
        return {input_.bytes().subspan(segment.first, segment.bytes), layout_.form};
    }

    std::optional<std::int64_t> next_key() {
        const std::size_t start = offset_;
        const auto segment = next();
        if (segment && segment->bytes == layout_.form.size) return words(*segment).integer(0);
        offset_ = start;
        return {};
    }

    /// Date, tape label and version, ended by -1 and 0. Patran's form of the file has none.
    void skip_head() {
        constexpr std::int64_t kDateWords = 3;
        const std::size_t start = offset_;
        if (next_key() != kDateWords) {
            offset_ = start;
            return;
        }
        offset_ = start;
        for (;;) {
            const auto key = next_key();
            if (!key || *key == 0) return;
            if (*key < 0) continue;
            const auto segment = next();
            if (!segment) return;
            constexpr std::int64_t kVersionWords = 2;
            if (*key == kVersionWords) layout_.version = words(*segment).text(0, words(*segment).count());
        }
    }

    /// Segments of one logical record, to `to`; false at the end of a table or of what can be read.
    bool read_record(std::vector<Segment>& to) {
        for (;;) {
            const auto key = next_key();
            if (!key) {
                broken_ = true;
                return false;
            }
            if (*key == 0) return false;
            if (*key < 0) return true;
            const auto segment = next();
            if (!segment) {
                broken_ = true;
                return false;
            }
            to.push_back(*segment);
        }
    }

    /// False when nothing more can be read.
    bool read_table() {
        std::vector<Segment> head;
        if (!read_record(head)) {
            // A second 0 ends the file.
            if (broken_ && !at_end()) whole_ = false;
            return !broken_;
        }
        Table table;
        if (!head.empty()) table.name = words(head.front()).text(0, words(head.front()).count());
        std::vector<Segment> trailer, subname;
        bool more = read_record(trailer) && read_record(subname);
        table.first_record = layout_.record_ends.size();
        while (more) {
            const std::size_t before = layout_.segments.size();
            std::vector<Segment>& segments = layout_.segments;
            more = read_record(segments);
            if (!more) {
                segments.resize(before);
                break;
            }
            keep_record(table, before);
        }
        table.last_record = layout_.record_ends.size();
        if (broken_) whole_ = false;
        layout_.tables.push_back(std::move(table));
        return !broken_;
    }

    /// The first word of a record says what it is: 0 for rows of a table, else a column of a matrix.
    void keep_record(Table& table, std::size_t before) {
        std::vector<Segment>& segments = layout_.segments;
        if (segments.size() > before && segments[before].bytes == layout_.form.size) {
            if (words(segments[before]).integer(0) != 0) table.matrix = true;
            segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(before));
        }
        if (table.matrix) segments.resize(before);
        if (!table.matrix) layout_.record_ends.push_back(segments.size());
    }

    const Input& input_;
    Diagnostics& diagnostics_;
    Layout layout_;
    std::size_t offset_ = 0;
    bool broken_ = false;
    bool whole_ = true;
};

bool is_name(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

}  // namespace

std::int64_t Words::integer(std::size_t i) const noexcept {
    assert(i < count());
    const std::byte* at = bytes_.data() + i * form_.size;
    return form_.size == 4 ? load<std::int32_t>(at, form_.swap) : load<std::int64_t>(at, form_.swap);
}

double Words::real(std::size_t i) const noexcept {
    assert(i < count());
    const std::byte* at = bytes_.data() + i * form_.size;
    return form_.size == 4 ? static_cast<double>(load<float>(at, form_.swap)) : load<double>(at, form_.swap);
}

double Words::wide_real(std::size_t i) const noexcept {
    assert(i * form_.size + sizeof(double) <= bytes_.size());
    return load<double>(bytes_.data() + i * form_.size, form_.swap);
}

std::string Words::text(std::size_t i, std::size_t words) const {
    std::string out;
    for (std::size_t w = i; w < std::min(i + words, count()); ++w) {
        for (std::size_t c = 0; c < 4; ++c) {
            const char letter = static_cast<char>(bytes_[w * form_.size + c]);
            out += letter >= ' ' && letter <= '~' ? letter : letter == '\0' ? ' ' : '?';
        }
    }
    const std::size_t first = std::min(out.find_first_not_of(' '), out.size());
    out.erase(0, first);
    while (out.ends_with(' ')) out.pop_back();
    return out;
}

std::span<const Segment> Layout::record(std::size_t i) const noexcept {
    const std::size_t first = i == 0 ? 0 : record_ends[i - 1];
    return std::span(segments).subspan(first, record_ends[i] - first);
}

std::size_t Layout::record_bytes(std::size_t i) const noexcept {
    std::size_t bytes = 0;
    for (const Segment& segment : record(i)) bytes += segment.bytes;
    return bytes;
}

bool starts_op2(std::string_view head, WordForm& form) {
    const auto bytes = std::as_bytes(std::span(head.data(), head.size()));
    if (bytes.size() < kMarkBytes) return false;
    for (const bool swap : {false, true}) {
        const auto size = load<std::uint32_t>(bytes.data(), swap);
        if (size != 4 && size != 8) continue;
        form = {size, swap};
        const auto first = segment_at(bytes, 0, swap);
        if (!first) continue;
        const std::int64_t key = Words(bytes.subspan(first->first, first->bytes), form).integer(0);
        const auto second = segment_at(bytes, 2 * kMarkBytes + size, swap);
        if (!second || key < 2 || key > 3 || second->bytes != static_cast<std::size_t>(key) * size) continue;
        if (key == 3) return true;
        if (is_name(Words(bytes.subspan(second->first, second->bytes), form).text(0, 2))) return true;
    }
    return false;
}

Layout find_tables(const Input& input, Diagnostics& diagnostics) {
    WordForm form;
    if (!starts_op2(input.text().substr(0, 64), form)) {
        throw Error(
            Code::BadStructure,
            input.where_byte(0),
            "this is no binary .op2: it must start with a record of one word of 4 or 8 bytes"
        );
    }
    return Walker(input, form, diagnostics).walk();
}

Words record_words(
    const Input& input, const Layout& layout, std::size_t record, std::vector<std::byte>& scratch
) {
    return record_head(input, layout, record, std::numeric_limits<std::size_t>::max(), scratch);
}

Words record_head(
    const Input& input,
    const Layout& layout,
    std::size_t record,
    std::size_t words,
    std::vector<std::byte>& scratch
) {
    const std::span<const Segment> segments = layout.record(record);
    const std::size_t most = std::min(words, input.size()) * layout.form.size;
    if (segments.empty()) return {{}, layout.form};
    const auto bytes_of = [&](const Segment& segment, std::size_t limit) {
        return input.bytes().subspan(segment.first, std::min(segment.bytes, limit));
    };
    if (segments.size() == 1 || segments.front().bytes >= most)
        return {bytes_of(segments.front(), most), layout.form};
    scratch.clear();
    for (const Segment& segment : segments) {
        const auto bytes = bytes_of(segment, most - scratch.size());
        scratch.insert(scratch.end(), bytes.begin(), bytes.end());
        if (scratch.size() >= most) break;
    }
    return {scratch, layout.form};
}

}  // namespace feelem::op2
