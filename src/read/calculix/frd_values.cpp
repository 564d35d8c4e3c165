// SPDX-License-Identifier: Apache-2.0
// Must: give each node the value of its own record, correctly rounded, at the speed of memory.
// Assumes: nothing about the records; the fast way below gives up on anything unusual.
// Algorithm: records of text are equally long, so record i is found by multiplication and chunks of records
// are read at once by threads. Node numbers must ascend over all chunks, so that no two threads write a row;
// where anything is not as expected the block is read again line by line, which also finds the words for an
// error. Binary bodies are the same with other fields.
// Data: nodes x columns floats, and nothing else.
#include "read/calculix/frd_values.hpp"

#include "base/byte_reader.hpp"
#include "base/columns.hpp"
#include "base/huge_pages.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "read/calculix/frd_fields.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace feelem::frd {
namespace {

constexpr std::size_t kChunkBytes = 1u << 20;
constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kPerLine = 6;
constexpr std::size_t kWidth = 12;
constexpr std::size_t kRecordsAtOnce = 16;

/// Rows of ascending node numbers: nearly always the next one.
class RowFinder {
public:
    explicit RowFinder(const std::vector<NodeId>& ids) : ids_(ids) {}
    std::size_t operator()(NodeId id) {
        if (next_ >= ids_.size() || ids_[next_] != id) {
            const auto found = std::ranges::lower_bound(ids_, id);
            if (found == ids_.end() || *found != id) return kNoRow;
            next_ = static_cast<std::size_t>(found - ids_.begin());
        }
        return next_++;
    }

private:
    const std::vector<NodeId>& ids_;
    std::size_t next_ = 0;
};

/// Where things are in each record, taken from the first one.
struct RecordShape {
    std::size_t bytes = 0;
    std::vector<std::size_t> lines;      ///< Start of each line.
    std::vector<std::size_t> fields;     ///< Start of each wanted field.
    std::vector<std::uint32_t> offsets;  ///< The same for kRecordsAtOnce records, one after the other.
};

class BlockReader {
public:
    BlockReader(const Input& input, const ResultBlock& block, Columns columns, const Mesh& mesh, bool swap)
        : input_(input), text_(input.text()), block_(block), body_(block.body), columns_(columns),
          mesh_(mesh), swap_(swap) {}

    Values read() {
        clear();
        if (is_text(body_.coding)) {
            const auto shape = shape_of_text();
            if (!shape || !read_regular_text(*shape)) {
                clear();
                read_any_text();
            }
        } else if (!read_binary(true)) {
            clear();
            read_binary(false);
        }
        input_.release(body_.first, body_.last);
        return {std::move(values_), without_node_, without_number_};
    }

private:
    void clear() {
        reserve_big(values_, mesh_.node_count() * columns_.count);
        values_.assign(mesh_.node_count() * columns_.count, std::numeric_limits<float>::quiet_NaN());
        without_node_ = 0;
        without_number_ = 0;
    }

    std::size_t field_start(std::size_t component, std::size_t line_start) const {
        return line_start + 3 + id_width(body_.coding) + component % kPerLine * kWidth;
    }

    std::size_t line_count() const { return (block_.components.size() + kPerLine - 1) / kPerLine; }

    /// Length of the part of line k that has fields.
    std::size_t used_length(std::size_t k) const {
        const std::size_t fields = std::min(kPerLine, block_.components.size() - k * kPerLine);
        return 3 + id_width(body_.coding) + fields * kWidth;
    }

    std::optional<RecordShape> shape_of_text() const {
        RecordShape shape;
        std::size_t at = body_.first;
        for (std::size_t k = 0; k < line_count(); ++k) {
            const std::size_t end = text_.find('\n', at);
            if (end >= body_.last) return std::nullopt;
            const std::size_t used = used_length(k);
            if (end - at < used || !trim(text_.substr(at + used, end - at - used)).empty())
                return std::nullopt;
            shape.lines.push_back(at - body_.first);
            at = end + 1;
        }
        shape.bytes = at - body_.first;
        if (shape.bytes * body_.count != body_.last - body_.first) return std::nullopt;
        for (std::size_t c = columns_.first; c < columns_.first + columns_.count; ++c) {
            shape.fields.push_back(field_start(c, shape.lines[c / kPerLine]));
        }
        for (std::size_t k = 0; k < kRecordsAtOnce; ++k) {
            for (const std::size_t field : shape.fields)
                shape.offsets.push_back(static_cast<std::uint32_t>(k * shape.bytes + field));
        }
        return shape;
    }

    bool read_regular_text(const RecordShape& shape) {
        return in_chunks(
            shape.bytes,
            [&](std::size_t first, std::size_t last, std::int64_t& id, Chunk& chunk) {
                return read_text_chunk(shape, first, last, id, chunk);
            }
        );
    }

    struct Chunk {
        RowFinder row;
        std::uint64_t without_node = 0;
        std::uint64_t without_number = 0;
    };

    /// Calls read(first, last, last id, counts) for runs of records; false when one gave up, or when node
    /// numbers do not ascend from run to run.
    template <class Read>
    bool in_chunks(std::size_t record, const Read& read) {
        const std::size_t per_chunk = std::max<std::size_t>(1, kChunkBytes / record);
        std::atomic<bool> regular{true};
        std::atomic<std::uint64_t> without_node{0};
        std::atomic<std::uint64_t> without_number{0};
        parallel_chunks(body_.count, per_chunk, [&](std::size_t first, std::size_t last) {
            if (!regular) return;
            Chunk chunk{RowFinder(mesh_.node_ids)};
            // Below the first number of the next run: then no other thread writes these rows.
            std::int64_t limit = std::numeric_limits<std::int64_t>::max();
            if (last < body_.count && !id_at(last * record, limit)) limit = 0;
            std::int64_t id = limit;
            if (!read(first, last, id, chunk)) regular = false;
            without_node += chunk.without_node;
            without_number += chunk.without_number;
            input_.release(body_.first + first * record, body_.first + last * record);
        });
        without_node_ = without_node;
        without_number_ = without_number;
        return regular;
    }

    bool id_at(std::size_t offset, std::int64_t& id) const {
        const char* at = text_.data() + body_.first + offset;
        if (is_text(body_.coding)) return fast_integer(at + 3, id_width(body_.coding), id);
        id = ByteReader(input_, body_.first + offset, swap_).read<std::int32_t>();
        return true;
    }

    bool read_text_chunk(
        const RecordShape& shape, std::size_t first, std::size_t last, std::int64_t limit, Chunk& chunk
    ) {
        std::int64_t previous = std::numeric_limits<std::int64_t>::min();
        const std::size_t fields = shape.fields.size();
        std::vector<float> some(kRecordsAtOnce * fields);
        std::array<std::size_t, kRecordsAtOnce> rows{};
        for (std::size_t i = first; i < last;) {
            const char* const records = text_.data() + body_.first + i * shape.bytes;
            const std::size_t count = std::min(kRecordsAtOnce, last - i);
            for (std::size_t k = 0; k < count; ++k, ++i) {
                std::int64_t id = 0;
                if (!id_at(i * shape.bytes, id) || id <= previous || id >= limit) return false;
                previous = id;
                if (!is_shaped(shape, records + k * shape.bytes, i == 0)) return false;
                rows[k] = chunk.row(NodeId{id});
                if (rows[k] == kNoRow) ++chunk.without_node;
            }
            const auto offsets = std::span(shape.offsets).first(count * fields);
            if (columns_of_reals(records, offsets, kWidth, some.data()))
                put_records(std::span(rows).first(count), some);
            else if (!read_one_by_one(shape, records, std::span(rows).first(count), chunk))
                return false;
        }
        return true;
    }

    /// Their values, one record after the other; those of nodes that are not there go nowhere.
    void put_records(std::span<const std::size_t> rows, std::span<const float> some) {
        const std::size_t width = columns_.count;
        const bool all_there = std::ranges::find(rows, kNoRow) == rows.end();
        if (all_there && rows.back() - rows.front() + 1 == rows.size()) {
            std::copy_n(some.data(), rows.size() * width, values_.data() + rows.front() * width);
            return;
        }
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (rows[k] != kNoRow)
                std::copy_n(some.data() + k * width, width, values_.data() + rows[k] * width);
        }
    }

    bool read_one_by_one(
        const RecordShape& shape, const char* at, std::span<const std::size_t> rows, Chunk& chunk
    ) {
        std::vector<float> nowhere(shape.fields.size());
        for (const std::size_t row : rows) {
            float* const out = row == kNoRow ? nowhere.data() : values_.data() + row * columns_.count;
            std::uint64_t odd = 0;
            for (std::size_t c = 0; c < shape.fields.size(); ++c)
                out[c] = real12<float>(at + shape.fields[c], odd);
            if (odd != 0 && !read_odd_record(shape, at, row, chunk)) return false;
            at += shape.bytes;
        }
        return true;
    }

    /// Whether lines start and end where those of the first record do.
    static bool is_shaped(const RecordShape& shape, const char* at, bool is_first) {
        for (std::size_t k = 0; k < shape.lines.size(); ++k) {
            const char* line = at + shape.lines[k];
            if (line[0] != ' ' || line[1] != '-' || line[2] != (k == 0 ? '1' : '2')) return false;
            if (!(is_first && k == 0) && line[-1] != '\n') return false;
        }
        return at[shape.bytes - 1] == '\n';
    }

    /// A record with a number that needs more care.
    bool read_odd_record(const RecordShape& shape, const char* at, std::size_t row, Chunk& chunk) {
        for (std::size_t c = 0; c < shape.fields.size(); ++c) {
            float value = 0;
            const char* field = at + shape.fields[c];
            if (!fast_real12(field, value)) {
                const auto general = parse_float({field, kWidth});
                if (!general) return false;
                value = *general;
            }
            if (row != kNoRow) store(row, c, value, chunk.without_number);
        }
        return true;
    }

    void store(std::size_t row, std::size_t column, float value, std::uint64_t& without_number) {
        if (!std::isfinite(value)) {
            ++without_number;
            value = std::numeric_limits<float>::quiet_NaN();
        }
        values_[row * columns_.count + column] = value;
    }

    [[noreturn]] void bad_record(Code code, std::size_t at, std::string_view what) const {
        const std::size_t end = std::min({text_.find('\n', at), at + 100, text_.size()});
        throw Error(
            code,
            input_.where_line(at),
            fmt::format(
                "{} of {} (step {}): \"{}\"", what, block_.name, block_.step, trim(text_.substr(at, end - at))
            )
        );
    }

    /// Line by line, with columns that three-digit exponents have pushed along set right.
    void read_any_text() {
        RowFinder find(mesh_.node_ids);
        std::vector<float> row(block_.components.size());
        std::size_t at = body_.first;
        while (at < body_.last) {
            std::int64_t id = 0;
            for (std::size_t k = 0; k < line_count(); ++k) {
                const std::size_t end = std::min(text_.find('\n', at), body_.last);
                const std::string_view line = text_.substr(at, end - at);
                if (!line.starts_with(k == 0 ? " -1" : " -2"))
                    bad_record(Code::BadStructure, at, "this line is no record");
                if (k == 0) id = id_of(line, at);
                read_fields(line, k, row, at);
                at = std::min(end + 1, body_.last);
            }
            const std::size_t found = find(NodeId{id});
            if (found == kNoRow) {
                ++without_node_;
                continue;
            }
            for (std::size_t c = 0; c < columns_.count; ++c) {
                store(found, c, row[columns_.first + c], without_number_);
            }
        }
    }

    std::int64_t id_of(std::string_view line, std::size_t at) const {
        const auto id = parse_integer(line.substr(3, id_width(body_.coding)));
        if (!id) bad_record(Code::BadNumber, at, "no node number in a record");
        return *id;
    }

    void read_fields(std::string_view line, std::size_t k, std::vector<float>& row, std::size_t at) const {
        const std::size_t count = std::min(kPerLine, block_.components.size() - k * kPerLine);
        const std::size_t start = std::min(3 + id_width(body_.coding), line.size());
        std::string_view rest = line.substr(start);
        while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\r')) rest.remove_suffix(1);
        const bool in_columns = rest.size() <= count * kWidth;
        for (std::size_t c = 0; c < count; ++c) {
            const std::size_t width = in_columns ? std::min(kWidth, rest.size()) : number_length(rest);
            const auto value = parse_float(rest.substr(0, width));
            if (!value) bad_record(Code::BadNumber, at, "not a number in a record");
            row[k * kPerLine + c] = *value;
            rest.remove_prefix(width);
        }
        if (!trim(rest).empty())
            bad_record(Code::BadStructure, at, "more numbers than components in a record");
    }

    /// Blanks and one number: up to the last digit of its exponent.
    static std::size_t number_length(std::string_view text) {
        const std::size_t exponent = text.find_first_of("Ee");
        if (exponent == std::string_view::npos) return std::min(kWidth, text.size());
        return std::min(text.find_first_not_of("0123456789", exponent + 2), text.size());
    }

    /// In threads where node numbers ascend, else in order.
    bool read_binary(bool in_threads) {
        const std::size_t record = 4 + number_size() * block_.components.size();
        const auto read = [&](std::size_t first, std::size_t last, std::int64_t limit, Chunk& chunk) {
            std::int64_t previous = std::numeric_limits<std::int64_t>::min();
            for (std::size_t i = first; i < last; ++i) {
                ByteReader reader(input_, body_.first + i * record, swap_);
                const std::int64_t id = reader.read<std::int32_t>();
                if (in_threads && (id <= previous || id >= limit)) return false;
                previous = id;
                const std::size_t row = chunk.row(NodeId{id});
                if (row == kNoRow) {
                    ++chunk.without_node;
                    continue;
                }
                reader.take(columns_.first * number_size());
                for (std::size_t c = 0; c < columns_.count; ++c) {
                    const float value = body_.coding == Coding::Float
                                            ? reader.read<float>()
                                            : static_cast<float>(reader.read<double>());
                    store(row, c, value, chunk.without_number);
                }
            }
            return true;
        };
        if (in_threads) return in_chunks(record, read);
        Chunk chunk{RowFinder(mesh_.node_ids)};
        read(0, body_.count, 0, chunk);
        without_node_ = chunk.without_node;
        without_number_ = chunk.without_number;
        return true;
    }

    std::size_t number_size() const { return body_.coding == Coding::Float ? 4 : 8; }

    const Input& input_;
    std::string_view text_;
    const ResultBlock& block_;
    const Body& body_;
    Columns columns_;
    const Mesh& mesh_;
    bool swap_;
    std::vector<float> values_;
    std::uint64_t without_node_ = 0;
    std::uint64_t without_number_ = 0;
};

}  // namespace

Values read_values(
    const Input& input, const ResultBlock& block, Columns columns, const Mesh& mesh, bool swap
) {
    return BlockReader(input, block, columns, mesh, swap).read();
}

}  // namespace feelem::frd
