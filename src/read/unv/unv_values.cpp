// SPDX-License-Identifier: Apache-2.0
// Records of a result dataset -> values in Feelem's order.
#include "model/node_lookup.hpp"
#include "read/element_lookup.hpp"
#include "read/text_lines.hpp"
#include "read/unv/unv_elements.hpp"
#include "read/unv/unv_results.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace feelem::unv {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// The next number of a line of E13.5 fields, which touch where signs fill them: a sign that follows neither
/// a blank nor an exponent's letter starts a number, unless it is the exponent itself (1.5-101).
std::string_view take_field(std::string_view& rest) {
    std::string_view word = take_word(rest);
    bool has_letter = false;
    for (std::size_t i = 1; i < word.size(); ++i) {
        const char before = word[i - 1];
        const bool letter = before == 'E' || before == 'e' || before == 'D' || before == 'd';
        has_letter = has_letter || letter;
        if ((word[i] != '-' && word[i] != '+') || letter) continue;
        const bool exponent =
            !has_letter && word.size() - i >= 4 && word.find_first_not_of("0123456789", i + 1) >= i + 4;
        if (exponent && word.substr(i + 1, 3).find('.') == std::string_view::npos) continue;
        const std::size_t cut = word.size() - i;
        rest = {word.data() + i, rest.size() + cut};
        return word.substr(0, i);
    }
    return word;
}

class RecordReader {
public:
    RecordReader(const Input& input, const Listed& listed, const Mesh& mesh)
        : listed_(listed), mesh_(mesh), lines_(input, listed.first, listed.last) {}

    LoadedResult read() {
        values_.result.info = listed_.info;
        switch (listed_.info.location) {
        case Location::Nodal: read_nodes(); break;
        case Location::Elemental: read_elements(); break;
        default: read_element_nodes(); break;
        }
        return std::move(values_);
    }

private:
    [[noreturn]] void bad(std::string_view text) const {
        throw Error(Code::BadNumber, lines_.where(), fmt::format("{}: {}", listed_.info.solver_name, text));
    }

    std::int64_t integer(std::string_view& line) const {
        const auto value = take_integer(line);
        if (!value) bad("an integer is missing at the head of a record");
        return *value;
    }

    /// The numbers of one row into row_; they may run over lines.
    void read_row(std::size_t count) {
        row_.clear();
        while (row_.size() < count) {
            std::string_view word = take_field(rest_);
            if (word.empty()) {
                const auto line = lines_.next();
                if (!line) bad("the dataset ends within a record");
                rest_ = *line;
                continue;
            }
            const auto value = parse_float(word);
            if (!value) bad(fmt::format("\"{}\" is no number", word.substr(0, 40)));
            row_.push_back(*value);
        }
    }

    /// Numbers of the file are as many as records hold: never reserve by a count of the file.
    std::size_t count_of(std::int64_t count) const {
        if (count <= 0 || count > 100'000) bad(fmt::format("a record says that it has {} values", count));
        return static_cast<std::size_t>(count);
    }

    void store(float* to, std::size_t offset = 0) {
        for (std::size_t c = 0; c < listed_.places.size(); ++c) {
            const std::size_t place = offset + listed_.places[c];
            float value = place < row_.size() ? row_[place] : kMissing;
            if (!std::isfinite(value)) {
                ++values_.without_number;
                value = kMissing;
            }
            to[c] = value;
        }
    }

    void read_nodes() {
        std::vector<float>& out = values_.result.values;
        const std::size_t width = listed_.places.size();
        out.assign(mesh_.node_count() * width, kMissing);
        const NodeLookup lookup(mesh_.node_ids);
        while (auto line = lines_.next()) {
            if (trim(*line).empty()) continue;
            const std::int64_t id = integer(*line);
            rest_ = {};
            read_row(listed_.numbers_a_row);
            const NodeIndex node = lookup(NodeId{id});
            if (node == kNoNode) {
                ++values_.without_owner;
            } else {
                store(&out[raw(node) * width]);
            }
        }
    }

    void read_elements() {
        std::vector<float>& out = values_.result.values;
        const std::size_t width = listed_.places.size();
        out.assign(mesh_.element_count() * width, kMissing);
        const ElementLookup lookup(mesh_);
        while (auto line = lines_.next()) {
            if (trim(*line).empty()) continue;
            const std::int64_t id = integer(*line);
            const std::size_t count = count_of(integer(*line)) * complex_factor();
            rest_ = {};
            read_row(count);
            if (count > listed_.numbers_a_row) ++values_.left_over;
            const ElementIndex element = lookup(ElementId{id});
            if (element == kNoElement) {
                ++values_.without_owner;
            } else {
                store(&out[raw(element) * width]);
            }
        }
    }

    std::size_t complex_factor() const { return listed_.info.complex == Complex::No ? 1 : 2; }

    void read_element_nodes() {
        const ElementLookup lookup(mesh_);
        while (auto line = lines_.next()) {
            if (trim(*line).empty()) continue;
            const std::int64_t id = integer(*line);
            const bool one_for_all = integer(*line) == 1;
            const std::size_t nodes = count_of(integer(*line));
            const std::size_t count = count_of(integer(*line)) * complex_factor();
            rest_ = {};
            read_row(one_for_all ? count : count * nodes);
            if (count > listed_.numbers_a_row) ++values_.left_over;
            const ElementIndex element = lookup(ElementId{id});
            if (element == kNoElement || !add_element(element, nodes, one_for_all ? 0 : count))
                ++values_.without_owner;
        }
        sort_rows_by_owner(values_.result);
    }

    /// Rows of an element's nodes, from the file's order; false when their number fits no form of it.
    bool add_element(ElementIndex element, std::size_t count, std::size_t stride) {
        const ElementRef ref = element_at(mesh_, element);
        const ElementRow& row = element_row(ref.block->type);
        const auto nodes = ref.nodes();
        const auto order = file_order(ref.block->type);
        if (count != row.node_count && count != row.corner_count) return false;
        for (std::size_t i = 0; i < count; ++i) {
            if (nodes[i] == kNoNode) continue;
            const bool whole = count == row.node_count && !order.empty();
            const std::size_t place = whole ? order[i] : i;
            values_.result.row_owner.push_back(raw(element));
            values_.result.row_node.push_back(nodes[i]);
            values_.result.values.resize(values_.result.values.size() + listed_.places.size());
            store(&*(values_.result.values.end() - std::ssize(listed_.places)), place * stride);
        }
        return true;
    }

    const Listed& listed_;
    const Mesh& mesh_;
    TextLines lines_;
    std::string_view rest_;
    std::vector<float> row_;
    LoadedResult values_;
};

}  // namespace

LoadedResult read_values(const Input& input, const Listed& listed, const Mesh& mesh) {
    return RecordReader(input, listed, mesh).read();
}

}  // namespace feelem::unv
