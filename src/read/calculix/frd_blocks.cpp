// SPDX-License-Identifier: Apache-2.0
#include "read/calculix/frd_blocks.hpp"

#include "base/number.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace feelem::frd {
namespace {

/// More are a damaged head: SDV, the longest known, has as many as a material model has state variables.
constexpr std::size_t kMostComponents = 1000;

/// Columns [first, first + width) of a line, as far as it goes.
std::string_view columns(std::string_view line, std::size_t first, std::size_t width) {
    return first < line.size() ? line.substr(first, width) : std::string_view{};
}

std::int32_t integer_or(std::string_view field, std::int32_t otherwise) {
    const auto value = parse_integer(field);
    return value && *value >= INT32_MIN && *value <= INT32_MAX ? static_cast<std::int32_t>(*value)
                                                               : otherwise;
}

/// Walks the file from head to head.
class Scanner {
public:
    Scanner(const Input& input, Diagnostics& diagnostics)
        : input_(input), text_(input.text()), diagnostics_(diagnostics) {}

    Layout scan() {
        bool ended = false;
        while (!ended && at_ < text_.size()) ended = read_head();
        if (!ended) {
            diagnostics_.add(
                Code::TruncatedInput,
                [&] { return place(text_.size()); },
                "the .frd file has no end mark (9999): the solver was stopped, or is still running"
            );
        }
        return std::move(layout_);
    }

private:
    std::string place(std::size_t offset) const {
        return binary_ ? input_.where_byte(offset) : input_.where_line(offset);
    }

    /// The line at `at` without its end; `next` is where the following one starts.
    std::string_view line_at(std::size_t at, std::size_t& next) const {
        const std::size_t end = std::min(text_.find('\n', at), text_.size());
        next = std::min(end + 1, text_.size());
        std::string_view line = text_.substr(at, end - at);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    std::string_view take_line() { return line_at(at_, at_); }

    bool starts_with(std::size_t at, std::string_view key) const {
        return text_.substr(std::min(at, text_.size()), key.size()) == key;
    }

    /// One line that is no record; true at the end mark.
    bool read_head() {
        const std::size_t start = at_;
        const std::string_view line = take_line();
        if (line.starts_with(" 9999")) return true;
        const std::string_view key = columns(line, 4, 2);
        if (line.starts_with("  100C")) {
            read_result(line, start);
        } else if (!line.starts_with("    ")) {
            if (!trim(line).empty() && !line.starts_with(" -3")) {
                diagnostics_.add(
                    Code::UnknownBlock, [&] { return place(start); }, "lines outside all blocks are skipped"
                );
            }
        } else if (key == "1C") {
            if (layout_.title.empty()) layout_.title = trim(columns(line, 6, line.size()));
        } else if (key == "1U") {
            read_user(columns(line, 6, line.size()));
        } else if (key == "1P") {
            read_parameter(line);
        } else if (key == "2C") {
            read_mesh_body(line, start, layout_.nodes, layout_.has_nodes, "nodes");
        } else if (key == "3C") {
            read_mesh_body(line, start, layout_.elements, layout_.has_elements, "elements");
        }
        return false;
    }

    void read_user(std::string_view text) {
        constexpr std::string_view kKnown[]{
            "USER", "DATE", "TIME", "HOST", "PGM", "DIR", "DBN", "MAT", "COMPILETIME", "VERSION"};
        const auto known = std::ranges::find_if(kKnown, [&](std::string_view key) {
            return text.starts_with(key) && (text.size() == key.size() || text[key.size()] == ' ');
        });
        if (known == std::end(kKnown)) {
            if (layout_.title.empty()) layout_.title = trim(text);
            return;
        }
        std::string_view value = trim(text.substr(known->size()));
        if (*known == "PGM") layout_.solver.name = value;
        if (*known == "VERSION") {
            if (value.starts_with("Version ")) value = trim(value.substr(8));
            layout_.solver.version = value;
        }
    }

    void read_parameter(std::string_view line) {
        const std::string_view first = columns(line, 24, 12);
        if (line.starts_with("    1PSTEP")) {
            next_.increment = integer_or(columns(line, 36, 12), -1);
            next_.load_step = integer_or(columns(line, 48, 12), -1);
        } else if (line.starts_with("    1PMODE")) {
            next_.mode = integer_or(first, -1);
        } else if (line.starts_with("    1PHID")) {
            next_.diameter = integer_or(first, -1);
        }
    }

    Coding coding_of(std::string_view digit, std::size_t start) const {
        const auto value = parse_integer(digit);
        if (!value || *value < 0 || *value > 3) {
            throw Error(
                Code::BadStructure,
                place(start),
                fmt::format(
                    "a block's head ends in the format digit \"{}\"; 0, 1 (text), 2 or 3 (binary) are known",
                    trim(digit)
                )
            );
        }
        return static_cast<Coding>(*value);
    }

    std::uint64_t count_of(std::string_view field, Coding coding, std::size_t start) const {
        const auto count = parse_integer(field);
        if (count && *count >= 0) return static_cast<std::uint64_t>(*count);
        if (is_text(coding)) return 0;  // Found by looking: fluid results leave it out.
        throw Error(
            Code::BadStructure,
            place(start),
            fmt::format("the head of a binary block has \"{}\" where the count must be", trim(field))
        );
    }

    void read_mesh_body(
        std::string_view line, std::size_t start, Body& body, bool& found, std::string_view what
    ) {
        Body here;
        here.coding = coding_of(columns(line, 73, 1), start);
        here.count = count_of(columns(line, 24, 12), here.coding, start);
        here.first = at_;
        bool whole = false;
        if (is_text(here.coding)) {
            whole = skip_text(here);
        } else if (what == "nodes") {
            find_byte_order(here);
            whole = skip_bytes(here, here.coding == Coding::Float ? 16 : 28);
        } else {
            find_byte_order(here);
            whole = skip_binary_elements(here);
        }
        if (!whole) {
            throw Error(
                Code::Truncated,
                place(text_.size()),
                fmt::format("the file ends within its {}. Was it copied whole?", what)
            );
        }
        if (found) {
            diagnostics_.add(
                Code::UnknownBlock,
                [&] { return place(start); },
                fmt::format("a second block of {} is skipped", what)
            );
            return;
        }
        found = true;
        body = here;
    }

    /// The file does not say its byte order: the one in which the first id of its first binary block is
    /// smaller. One order for all blocks: each is looked over here and read later.
    void find_byte_order(const Body& body) {
        if (binary_ || body.count == 0 || text_.size() - body.first < 4) return;
        binary_ = true;
        std::uint32_t id = 0;
        std::memcpy(&id, text_.data() + body.first, sizeof id);
        layout_.swap = __builtin_bswap32(id) < id;
    }

    std::uint32_t word_at(std::size_t at) const {
        std::uint32_t word = 0;
        std::memcpy(&word, text_.data() + at, sizeof word);
        return layout_.swap ? __builtin_bswap32(word) : word;
    }

    bool skip_bytes(Body& body, std::size_t record) {
        if (body.count > (text_.size() - body.first) / record) return false;
        body.last = body.first + body.count * record;
        at_ = body.last;
        skip_end_mark();
        return true;
    }

    bool skip_binary_elements(Body& body) {
        constexpr std::uint32_t kNodes[]{0, 8, 6, 4, 20, 15, 10, 3, 6, 4, 8, 2, 3};
        std::size_t at = body.first;
        for (std::uint64_t i = 0; i < body.count; ++i) {
            if (text_.size() - at < 16) return false;
            const std::uint32_t type = word_at(at + 4);
            if (type == 0 || type >= std::size(kNodes)) {
                throw Error(
                    Code::BadStructure,
                    place(at + 4),
                    fmt::format("element type {} in a binary block; 1 to 12 are known", type)
                );
            }
            const std::size_t record = 16 + 4 * kNodes[type];
            if (text_.size() - at < record) return false;
            at += record;
        }
        body.last = at;
        at_ = at;
        skip_end_mark();
        return true;
    }

    /// Binary bodies end without a mark; other writers may set one.
    void skip_end_mark() {
        if (starts_with(at_, "\n")) ++at_;
        if (starts_with(at_, " -3")) take_line();
    }

    /// To the " -3" line. Where records are equally long (nearly always) by one jump, so that a body is not
    /// even touched; load() looks at every record anyway.
    bool skip_text(Body& body) {
        const std::size_t record = first_record_length();
        if (record > 0 && body.count > 0 && body.count <= (text_.size() - at_) / record) {
            const std::size_t end = at_ + body.count * record;
            if (starts_with(end - record, " -1") && text_[end - 1] == '\n' && starts_with(end, " -3")) {
                body.last = end;
                at_ = end;
                take_line();
                return true;
            }
        }
        std::uint64_t count = 0;
        while (at_ < text_.size()) {
            const std::size_t start = at_;
            const std::string_view line = take_line();
            if (line.starts_with(" -1")) ++count;
            const bool ended = line.starts_with(" -3");
            const bool next_block = line.starts_with("  100C") || line.starts_with(" 9999") ||
                                    line.starts_with("    1P") || line.starts_with("    3C");
            if (!ended && !next_block) continue;
            if (next_block) at_ = start;
            body.count = count;
            body.last = start;
            return true;
        }
        return false;
    }

    std::size_t first_record_length() const {
        constexpr int kMostLines = 64;
        std::size_t at = at_;
        if (!starts_with(at, " -1")) return 0;
        for (int i = 0; i < kMostLines && at < text_.size(); ++i) {
            line_at(at, at);
            if (!starts_with(at, " -2")) return at - at_;
        }
        return 0;
    }

    void read_result(std::string_view line, std::size_t start) {
        ResultBlock block = std::exchange(next_, {});
        block.value = parse_double(columns(line, 12, 12)).value_or(0.0);
        block.analysis = integer_or(columns(line, 56, 2), 0);
        block.step = integer_or(columns(line, 58, 5), 1);
        block.body.coding = coding_of(columns(line, 74, 1), start);
        block.body.count = count_of(columns(line, 24, 12), block.body.coding, start);
        int kind = 1;
        while (starts_with(at_, " -4") || starts_with(at_, " -5")) {
            const std::string_view head = take_line();
            if (head.starts_with(" -4")) {
                block.name = trim(columns(head, 5, 8));
                kind = integer_or(columns(head, 18, 5), 1);
            } else if (integer_or(columns(head, 33, 5), 0) != 1) {
                block.components.push_back(
                    {std::string(trim(columns(head, 5, 8))),
                     integer_or(columns(head, 18, 5), 1),
                     integer_or(columns(head, 23, 5), 0),
                     integer_or(columns(head, 28, 5), 0)}
                );
            }
        }
        block.body.first = at_;
        bool whole = false;
        if (is_text(block.body.coding)) {
            whole = skip_text(block.body);
        } else {
            find_byte_order(block.body);
            const std::size_t number = block.body.coding == Coding::Float ? 4 : 8;
            whole = skip_bytes(block.body, 4 + number * block.components.size());
        }
        if (!whole) at_ = text_.size();
        keep(std::move(block), kind, whole, start);
    }

    void keep(ResultBlock block, int kind, bool whole, std::size_t start) {
        const auto where = [&] { return place(start); };
        if (!whole) {
            diagnostics_.add(
                Code::TruncatedInput,
                where,
                fmt::format("the file ends within {} of step {}; it is left out", block.name, block.step)
            );
        } else if (block.components.empty() || block.components.size() > kMostComponents || kind != 1) {
            diagnostics_.add(
                Code::UnknownBlock,
                where,
                fmt::format("{} is no result at nodes of a kind that is known; it is left out", block.name)
            );
        } else if (block.body.count == 0) {
            diagnostics_.add(
                Code::EmptyResult, where, fmt::format("{} has no values; it is left out", block.name)
            );
        } else {
            layout_.results.push_back(std::move(block));
        }
    }

    const Input& input_;
    std::string_view text_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    bool binary_ = false;
    Layout layout_;
    ResultBlock next_;  ///< Parameters for the result to come.
};

}  // namespace

Layout find_blocks(const Input& input, Diagnostics& diagnostics) {
    return Scanner(input, diagnostics).scan();
}

}  // namespace feelem::frd
