// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/fil_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem::fil {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

class Loader {
public:
    Loader(const Listed& listed, const Mesh& mesh, const ElementLookup& elements)
        : listed_(listed), mesh_(mesh), elements_(elements), width_(listed.columns.size()) {
        const Location location = listed.info.location;
        const std::size_t rows = location == Location::Nodal       ? mesh.node_count()
                                 : location == Location::Elemental ? mesh.element_count()
                                                                   : 0;
        out_.result.info = listed.info;
        if (listed.at == At::Point) {
            sums_.resize(rows * width_);
            counts_.resize(rows * width_);
        }
        out_.result.values.assign(rows * width_, kMissing);
    }

    void use(const Record& record) {
        if (record.key == 1) head_ = read_head(record);
        const bool of_nodes = listed_.at == At::Node;
        if (record.key != listed_.key) return;
        if (!of_nodes && (head_.at != listed_.at || head_.section_point != listed_.section_point)) return;
        if (of_nodes && record.words.empty()) return;
        words_ = std::span(record.words).subspan(of_nodes ? 1 : 0);
        if (listed_.imaginary > 0) {
            const std::size_t half = words_.size() / 2;
            words_ = listed_.imaginary == 1 ? words_.subspan(half) : words_.first(half);
        }
        const std::size_t row = row_of(of_nodes ? record.words[0].as_integer() : head_.id);
        if (row == kNowhere) {
            ++out_.without_place;
            return;
        }
        for (std::size_t i = 0; i < width_; ++i) put(row, i, value_of(listed_.columns[i]));
    }

    LoadedValues finish() {
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            if (counts_[i] > 0) out_.result.values[i] = static_cast<float>(sums_[i] / counts_[i]);
        }
        if (listed_.info.location == Location::ElementNodal) sort_rows();
        return std::move(out_);
    }

private:
    struct Row {
        std::uint32_t element = 0;
        NodeIndex node{};
        std::size_t at = 0;  ///< In the values as they came.
    };

    std::size_t row_of(std::int64_t id) {
        if (listed_.info.location == Location::Nodal) {
            const NodeIndex node = find_node(mesh_, NodeId{id});
            return node == kNoNode ? kNowhere : raw(node);
        }
        const ElementIndex element = elements_(ElementId{id});
        if (element == kNoElement) return kNowhere;
        if (listed_.at != At::ElementNodes) return raw(element);
        const auto nodes = element_at(mesh_, element).nodes();
        // The point's number is the node's; where the element has no such node, its place in the element.
        NodeIndex node = find_node(mesh_, NodeId{head_.point});
        if (node == kNoNode || std::ranges::find(nodes, node) == nodes.end()) {
            const auto place = static_cast<std::size_t>(head_.point - 1);
            if (head_.point < 1 || place >= nodes.size() || nodes[place] == kNoNode) return kNowhere;
            node = nodes[place];
        }
        rows_.push_back({raw(element), node, rows_.size()});
        out_.result.values.resize(rows_.size() * width_, kMissing);
        return rows_.size() - 1;
    }

    double value_of(std::int32_t column) const {
        const int word = listed_.is_tensor ? tensor_word(head_, column) : column;
        if (word < 0 || static_cast<std::size_t>(word) >= words_.size()) return std::nan("");
        return words_[static_cast<std::size_t>(word)].as_real();
    }

    void put(std::size_t row, std::size_t component, double value) {
        const auto single = static_cast<float>(value);
        const int word = listed_.is_tensor ? tensor_word(head_, listed_.columns[component]) : 0;
        if (!std::isfinite(single)) {
            if (word >= 0) ++out_.without_number;
            return;
        }
        const std::size_t at = row * width_ + component;
        if (listed_.at == At::Point) {
            sums_[at] += value;
            ++counts_[at];
        } else {
            out_.result.values[at] = single;
        }
    }

    void sort_rows() {
        std::ranges::stable_sort(rows_, [](const Row& a, const Row& b) {
            return std::pair(a.element, a.node) < std::pair(b.element, b.node);
        });
        Result& result = out_.result;
        std::vector<float> values;
        values.reserve(result.values.size());
        for (const Row& row : rows_) {
            const bool again = !result.row_owner.empty() && result.row_owner.back() == row.element &&
                               result.row_node.back() == row.node;
            if (again) continue;
            result.row_owner.push_back(row.element);
            result.row_node.push_back(row.node);
            const auto first = result.values.begin() + static_cast<std::ptrdiff_t>(row.at * width_);
            values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(width_));
        }
        result.values = std::move(values);
    }

    const Listed& listed_;
    const Mesh& mesh_;
    const ElementLookup& elements_;
    std::size_t width_;
    Head head_;
    std::span<const Word> words_;
    LoadedValues out_;
    std::vector<double> sums_;
    std::vector<std::uint32_t> counts_;
    std::vector<Row> rows_;
};

}  // namespace

LoadedValues load_values(
    const Input& input, Coding coding, const Listed& listed, const Mesh& mesh, const ElementLookup& elements
) {
    Loader loader(listed, mesh, elements);
    RecordReader reader(input, coding, listed.begin);
    Record record;
    while (reader.position() < listed.end && reader.next(record)) loader.use(record);
    return loader.finish();
}

}  // namespace feelem::fil
