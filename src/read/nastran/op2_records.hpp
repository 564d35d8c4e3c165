// SPDX-License-Identifier: Apache-2.0
// The records of a Nastran .op2 file: which tables there are and where their records stand. Data is skipped.
#pragma once

#include "base/input.hpp"

#include "feelem/diagnostics.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::op2 {

/// How numbers stand in the file: four or eight bytes a word, in this machine's byte order or the other.
struct WordForm {
    std::size_t size = 4;
    bool swap = false;
};

/// Whole words of one record. Indexes are the caller's duty: below count().
class Words {
public:
    Words() = default;
    Words(std::span<const std::byte> bytes, WordForm form) : bytes_(bytes), form_(form) {}

    std::size_t count() const noexcept { return bytes_.size() / form_.size; }
    std::int64_t integer(std::size_t i) const noexcept;
    double real(std::size_t i) const noexcept;
    /// A float64 that fills two words of four bytes (one of eight).
    double wide_real(std::size_t i) const noexcept;
    /// Four characters a word, whatever its size; printable ASCII without blanks at the ends.
    std::string text(std::size_t i, std::size_t words) const;
    Words part(std::size_t first, std::size_t words) const noexcept {
        return {bytes_.subspan(first * form_.size, words * form_.size), form_};
    }
    std::span<const std::byte> bytes() const noexcept { return bytes_; }

private:
    std::span<const std::byte> bytes_;
    WordForm form_;
};

/// A run of bytes of a record. Long records are cut into several.
struct Segment {
    std::size_t first = 0;
    std::size_t bytes = 0;
};

struct Table {
    std::string name;
    std::size_t first_record = 0;  ///< Into Layout's records; name, trailer and head are not among them.
    std::size_t last_record = 0;
    bool matrix = false;  ///< Its records are not kept.
};

struct Layout {
    WordForm form;
    std::string version;  ///< Label of the head: "XXXXXXXX" (MSC), "NX8.5", "OS2022.2"; empty: no head.
    std::vector<Table> tables;
    std::vector<Segment> segments;
    std::vector<std::size_t> record_ends;  ///< Record i: segments [record_ends[i - 1], record_ends[i]).

    std::span<const Segment> record(std::size_t i) const noexcept;
    std::size_t record_bytes(std::size_t i) const noexcept;
};

/// The form that the first record's mark says, or nothing when these bytes start no .op2.
bool starts_op2(std::string_view head, WordForm& form);

/// Walks from mark to mark. Throws Error(BadStructure | Truncated) when not even one table can be found;
/// what a damaged or cut end leaves is used (TruncatedInput).
Layout find_tables(const Input& input, Diagnostics& diagnostics);

/// A record in one piece: viewed where it stands, or put together in `scratch`.
Words record_words(
    const Input& input, const Layout& layout, std::size_t record, std::vector<std::byte>& scratch
);
/// Its first words only (fewer when it is shorter).
Words record_head(
    const Input& input,
    const Layout& layout,
    std::size_t record,
    std::size_t words,
    std::vector<std::byte>& scratch
);

/// Calls each(Words) for every `width` words of a record, in place where a row is not cut by the end of a
/// segment, and lets go of the bytes behind. What does not fill a row at the end is left out.
template <class Each>
void for_each_row(
    const Input& input, const Layout& layout, std::size_t record, std::size_t width, const Each& each
) {
    const std::size_t row_bytes = width * layout.form.size;
    std::vector<std::byte> cut;
    for (const Segment& segment : layout.record(record)) {
        std::span<const std::byte> rest = input.bytes().subspan(segment.first, segment.bytes);
        if (!cut.empty()) {
            const std::size_t missing = std::min(row_bytes - cut.size(), rest.size());
            cut.insert(cut.end(), rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(missing));
            rest = rest.subspan(missing);
            if (cut.size() < row_bytes) continue;
            each(Words(cut, layout.form));
            cut.clear();
        }
        for (; rest.size() >= row_bytes; rest = rest.subspan(row_bytes))
            each(Words(rest.first(row_bytes), layout.form));
        cut.assign(rest.begin(), rest.end());
        input.release(segment.first, segment.first + segment.bytes);
    }
}

}  // namespace feelem::op2
