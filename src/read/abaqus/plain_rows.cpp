// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/plain_rows.hpp"

#include "base/huge_pages.hpp"
#include "base/number.hpp"
#include "base/plain_real.hpp"
#include "base/take_numbers.hpp"
#include "base/text_fields.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace feelem::abaqus {
namespace {

template <class T>
void append_all(std::vector<T>& to, const std::vector<T>& from) {
    if (to.capacity() - to.size() < from.size())
        reserve_big(to, std::max(2 * to.capacity(), to.size() + from.size()));
    to.insert(to.end(), from.begin(), from.end());
}

bool is_blank_field(const TextField& field) {
    return std::all_of(field.first, field.last, [](char c) { return c == ' ' || c == '\r'; });
}

/// A field up to a comma or line end.
TextField field_to(const char* first, const char* end) {
    return {first, *end == '\n' && end != first && end[-1] == '\r' ? end - 1 : end};
}

/// A coordinate in any form.
bool read_coordinate(const TextField& field, double& out) {
    const char* at = behind_blanks(field.first, field.last);
    if (take_real(at, out) && behind_blanks(at, field.last) == field.last) return true;
    const auto value = parse_double({field.first, static_cast<std::size_t>(field.last - field.first)});
    if (value) out = *value;
    return value.has_value();
}

bool read_place(std::array<TextField, 3> fields, std::size_t count, Point3& place) {
    for (std::size_t i = count; i < 3; ++i) fields[i] = fields[i - 1];
    const bool is_plain = three_reals_between(fields, place.data());
    for (std::size_t i = 0; i < count && !is_plain; ++i) {
        if (!read_coordinate(fields[i], place[i])) return false;
    }
    for (std::size_t i = count; i < 3; ++i) place[i] = 0;
    return true;
}

/// Reads rows one after the other; `ends` stands at the row.
const char* read_node(const char* row, FieldEnds& ends, Label& id, Point3& place) {
    const char* end = ends.next();
    if (end == nullptr || *end != ',' || end == row) return nullptr;
    std::uint64_t bad = 0;
    id = static_cast<Label>(digits_between(row, end, bad));
    std::array<TextField, 3> fields;
    std::size_t count = 0;
    while (*end == ',' && count < 3) {
        const char* const first = end + 1;
        end = ends.next();
        if (end == nullptr) return nullptr;
        fields[count++] = field_to(first, end);
    }
    if (bad != 0 || id == 0 || *end != '\n' || !read_place(fields, count, place)) return nullptr;
    return end + 1;
}

class ElementRow {
public:
    /// Of `count` numbers; behind the row.
    const char* read(const char* row, FieldEnds& ends, std::size_t count) {
        const char* first = row;
        const char* end = nullptr;
        for (std::size_t i = 0; i < count; ++i) {
            end = ends.next();
            if (end == nullptr) return nullptr;
            if (*end == '\n' && i + 1 < count) {
                // Behind a comma a row goes on in the next line.
                if (i == 0 || !is_blank_field({first, end})) return nullptr;
                first = end + 1;
                end = ends.next();
                if (end == nullptr || *end != ',') return nullptr;
            } else if (i + 1 == count && *end == '\n' && is_blank_field({first, end})) {
                first = end + 1;
                end = ends.next();
                if (end == nullptr) return nullptr;
            }
            fields_[i] = {first, end};
            first = end + 1;
        }
        if (*end != '\n') return nullptr;
        fields_[count - 1] = field_to(fields_[count - 1].first, end);
        const auto fields = std::span(fields_).first(count);
        if (!whole_numbers_between(fields, numbers_.data()) && !read_trimmed(fields)) return nullptr;
        return numbers_[0] == 0 ? nullptr : first;
    }
    Label id() const { return static_cast<Label>(numbers_[0]); }
    std::span<const std::uint32_t> nodes() const { return std::span(numbers_).subspan(1); }

private:
    /// Blanks may stand before commas.
    bool read_trimmed(std::span<TextField> fields) {
        for (TextField& field : fields) {
            while (field.last != field.first && field.last[-1] == ' ') --field.last;
        }
        return whole_numbers_between(fields, numbers_.data());
    }

    std::array<TextField, 1 + kMaxElementNodes> fields_{};
    std::array<std::uint32_t, 1 + kMaxElementNodes> numbers_{};
};

bool has_text_before(std::size_t from) {
    return static_cast<std::ptrdiff_t>(from) >= kFieldReach;
}

}  // namespace

void PlainNodes::begin_like(const PlainNodes&) {
    ids.clear();
    places.clear();
}

void PlainNodes::add(const PlainNodes& further) {
    append_all(ids, further.ids);
    append_all(places, further.places);
}

std::size_t PlainNodes::read(std::string_view text, std::size_t from, std::size_t stop) {
    if (!has_text_before(from)) return from;
    FieldEnds ends(text.data() + from, text.data() + text.size());
    const char* const last = text.data() + stop;
    const char* row = text.data() + from;
    while (row < last) {
        Label id = 0;
        Point3 place;
        const char* const next = read_node(row, ends, id, place);
        if (next == nullptr) break;
        if (ids.size() == ids.capacity()) {
            const auto left = static_cast<std::size_t>(last - std::min(next, last));
            grow_by_text(ids, left, static_cast<std::size_t>(next - row));
            reserve_big(places, ids.capacity());
        }
        ids.push_back(id);
        places.push_back(place);
        row = next;
    }
    return static_cast<std::size_t>(row - text.data());
}

void PlainElementRows::begin_like(const PlainElementRows& other) {
    type = other.type;
    ids.clear();
    nodes.clear();
}

void PlainElementRows::add(const PlainElementRows& further) {
    append_all(ids, further.ids);
    append_all(nodes, further.nodes);
}

void PlainElementRows::add(Label id, std::span<const Label> nodes_of_file) {
    ids.push_back(id);
    for (std::size_t i = 0; i < type->most_nodes; ++i)
        nodes.push_back(nodes_of_file[type->order.empty() ? i : type->order[i]]);
}

std::size_t PlainElementRows::read(std::string_view text, std::size_t from, std::size_t stop) {
    if (!has_text_before(from)) return from;
    const std::size_t width = type->most_nodes;
    FieldEnds ends(text.data() + from, text.data() + text.size());
    const char* const last = text.data() + stop;
    const char* row = text.data() + from;
    ElementRow reader;
    while (row < last) {
        const char* const next = reader.read(row, ends, 1 + width);
        if (next == nullptr) break;
        if (ids.size() == ids.capacity()) {
            const auto left = static_cast<std::size_t>(last - std::min(next, last));
            grow_by_text(ids, left, static_cast<std::size_t>(next - row));
            reserve_big(nodes, ids.capacity() * width);
        }
        ids.push_back(reader.id());
        const auto found = reader.nodes();
        if (type->order.empty()) {
            nodes.insert(nodes.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(width));
        } else {
            for (std::size_t i = 0; i < width; ++i)
                nodes.push_back(static_cast<Label>(found[type->order[i]]));
        }
        row = next;
    }
    return static_cast<std::size_t>(row - text.data());
}

std::size_t start_of_row(std::string_view text, std::size_t at) {
    std::size_t line =
        at == 0 || text[at - 1] == '\n' ? at : std::min(text.find('\n', at), text.size() - 1) + 1;
    while (line > 0 && line < text.size()) {
        std::size_t end = line - 1;
        while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\r')) --end;
        if (end == 0 || text[end - 1] != ',') break;
        line = std::min(text.find('\n', line), text.size() - 1) + 1;
    }
    return line;
}

}  // namespace feelem::abaqus
