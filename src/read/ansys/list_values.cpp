// SPDX-License-Identifier: Apache-2.0
// Values of one result out of its tables.
#include "base/huge_pages.hpp"
#include "model/node_lookup.hpp"
#include "read/ansys/list_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace feelem::ansys {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// What could not be used.
struct Losses {
    std::uint64_t without_place = 0;  ///< Rows of nodes or elements that the mesh does not have.
    std::uint64_t bad_values = 0;
    std::uint64_t conflicts = 0;  ///< Rows that repeat a node with another value.
    std::uint64_t owners = 0;     ///< Rows of a part that the mesh does not have.
};

bool same_row(const float* a, const float* b, std::size_t count) {
    return std::equal(a, a + count, b, [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    });
}

/// The columns of a result out of those of a row.
void pick(const ListedResult& listed, const float* row, float* to) {
    const std::size_t *column = listed.columns.data(), *const end = column + listed.columns.size();
    while (column != end) *to++ = row[*column++];
}

/// Values of a fixed number of rows (nodes or elements): a repeated row must say the same, else the row is
/// missing.
class Rows {
public:
    Rows(std::size_t rows, std::size_t width) : width_(width), seen_(rows) {
        reserve_big(values_, rows * width);
        values_.resize(rows * width, kNoValue);
    }

    void put(const ListedResult& listed, std::size_t at, const float* row, Losses& losses) {
        float* here = values_.data() + at * width_;
        if (seen_[at] == 0) {
            seen_[at] = 1;
            pick(listed, row, here);
            return;
        }
        scratch_.resize(width_);
        pick(listed, row, scratch_.data());
        if (same_row(here, scratch_.data(), width_)) return;
        conflicts_.push_back(at);
        ++losses.conflicts;
    }

    /// Rows one after the other of which all columns are used as they stand. False, and nothing done: one of
    /// them was there before.
    bool put_all(std::size_t first, std::span<const float> rows) {
        const auto seen = std::span(seen_).subspan(first, rows.size() / width_);
        if (std::ranges::find(seen, 1) != seen.end()) return false;
        std::ranges::fill(seen, 1);
        std::ranges::copy(rows, values_.begin() + static_cast<std::ptrdiff_t>(first * width_));
        return true;
    }

    std::size_t seen() const { return static_cast<std::size_t>(std::ranges::count(seen_, 1)); }

    std::vector<float> finish() {
        for (const std::size_t at : conflicts_)
            std::fill_n(values_.begin() + static_cast<std::ptrdiff_t>(at * width_), width_, kNoValue);
        return std::move(values_);
    }

private:
    std::size_t width_;
    std::vector<float> values_;
    std::vector<float> scratch_;
    std::vector<std::uint8_t> seen_;
    std::vector<std::size_t> conflicts_;
};

/// Rows with an owner (part or element), brought into order in the end.
struct OwnedRows {
    std::vector<std::uint32_t> owners;
    std::vector<NodeIndex> nodes;
    std::vector<float> values;

    void put(const ListedResult& listed, std::uint32_t owner, NodeIndex node, const float* row) {
        owners.push_back(owner);
        nodes.push_back(node);
        values.resize(values.size() + listed.columns.size());
        pick(listed, row, values.data() + values.size() - listed.columns.size());
    }
    void clear() {
        owners.clear();
        nodes.clear();
        values.clear();
    }
};

Result sorted_result(const ListedResult& listed, OwnedRows rows, Losses& losses) {
    const std::size_t width = listed.columns.size();
    std::vector<std::uint32_t> order(rows.owners.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t at) { return std::pair(rows.owners[at], raw(rows.nodes[at])); };
    if (!std::ranges::is_sorted(order, {}, key)) std::ranges::stable_sort(order, {}, key);
    Result result;
    result.info = listed.info;
    result.values.reserve(rows.values.size());
    for (std::size_t i = 0; i < order.size();) {
        const float* here = rows.values.data() + order[i] * width;
        bool conflict = false;
        std::size_t end = i + 1;
        for (; end < order.size() && key(order[end]) == key(order[i]); ++end) {
            if (same_row(here, rows.values.data() + order[end] * width, width)) continue;
            conflict = true;
            ++losses.conflicts;
        }
        result.row_owner.push_back(rows.owners[order[i]]);
        result.row_node.push_back(rows.nodes[order[i]]);
        for (std::size_t c = 0; c < width; ++c) result.values.push_back(conflict ? kNoValue : here[c]);
        i = end;
    }
    return result;
}

class ValueLoader {
public:
    ValueLoader(
        const ListModel& model, const ListedResult& listed, const Mesh& mesh, Diagnostics* diagnostics
    )
        : model_(model), listed_(listed), mesh_(mesh), lookup_(mesh.node_ids), diagnostics_(diagnostics) {}

    Result load() {
        Result result;
        switch (listed_.info.location) {
        case Location::Nodal: result = nodal(); break;
        case Location::PartNodal: result = part_nodal(); break;
        case Location::Elemental: result = elemental(); break;
        case Location::ElementNodal: result = element_nodal(); break;
        }
        if (diagnostics_ != nullptr) report();
        return result;
    }

private:
    template <class Use>
    void each_row(
        const Table& table, const Use& use, const std::function<void(const ValueRows&)>& use_many = nullptr
    ) {
        const auto use_one = [&](const ValueRow& row) {
            if (row.has_bad_value) ++losses_.bad_values;
            use(row);
        };
        for_each_table_row(model_, table, diagnostics_, use_one, use_many);
    }

    /// Calls use(values, node) for the rows of the result's layer: the first or second row of each node;
    /// before that use_many(rows), which may take some rows at once.
    template <class Use, class UseMany>
    void each_node_row(const Table& table, const Use& use, const UseMany& use_many) {
        const bool layered = !table.is_export && model_.files[table.file].lists[table.list].head.has_layers;
        const unsigned wanted = listed_.info.layer == Layer::Bottom ? 2 : 1;
        std::vector<std::uint8_t> rows_of_node(layered ? mesh_.node_count() : 0);
        const auto use_row = [&](std::int64_t id, const float* values) {
            const NodeIndex node = lookup_(NodeId{id});
            if (node == kNoNode) {
                ++losses_.without_place;
                return;
            }
            if (layered) {
                std::uint8_t& rows = rows_of_node[raw(node)];
                rows = static_cast<std::uint8_t>(std::min(rows + 1, 3));
                if (rows == 3) ++losses_.conflicts;
                if (rows != wanted) return;
            }
            use(values, node);
        };
        each_row(
            table,
            [&](const ValueRow& row) { use_row(row.id, row.values.data()); },
            [&](const ValueRows& rows) {
                if (!layered && use_many(rows)) return;
                const std::size_t columns = rows.values.size() / rows.ids.size();
                for (std::size_t i = 0; i < rows.ids.size(); ++i)
                    use_row(rows.ids[i], rows.values.data() + i * columns);
            }
        );
    }

    /// The node of the first of rows whose nodes are one after the other; kNoNode when they are not.
    NodeIndex first_of_neighbours(std::span<const std::int64_t> ids) const {
        const NodeIndex first = lookup_(NodeId{ids.front()});
        if (first == kNoNode || mesh_.node_count() - raw(first) < ids.size()) return kNoNode;
        const auto wanted = std::span(mesh_.node_ids).subspan(raw(first), ids.size());
        const bool are_same = std::ranges::equal(ids, wanted, {}, {}, raw<NodeId>);
        return are_same ? first : kNoNode;
    }

    Result nodal() {
        Rows rows(mesh_.node_count(), listed_.columns.size());
        std::vector<std::size_t> all_columns(listed_.columns.size());
        std::iota(all_columns.begin(), all_columns.end(), std::size_t{0});
        const auto put_many = [&](const ValueRows& some) {
            if (listed_.columns != all_columns || some.values.size() != some.ids.size() * all_columns.size())
                return false;
            const NodeIndex first = first_of_neighbours(some.ids);
            return first != kNoNode && rows.put_all(raw(first), some.values);
        };
        const auto put_one = [&](const float* row, NodeIndex node) {
            rows.put(listed_, raw(node), row, losses_);
        };
        for (const Table& table : listed_.tables) each_node_row(table, put_one, put_many);
        note_part_of_model(rows.seen(), mesh_.node_count(), "nodes");
        return {listed_.info, rows.finish(), {}, {}};
    }

    Result part_nodal() {
        OwnedRows rows;
        for (const Table& table : listed_.tables) {
            if (!table.part) {
                each_row(table, [&](const ValueRow&) { ++losses_.owners; });
                continue;
            }
            const auto put = [&](const float* row, NodeIndex node) {
                rows.put(listed_, raw(*table.part), node, row);
            };
            each_node_row(table, put, [](const ValueRows&) { return false; });
        }
        return sorted_result(listed_, std::move(rows), losses_);
    }

    Result elemental() {
        ElementFinder find(mesh_);
        Rows rows(mesh_.element_count(), listed_.columns.size());
        for (const Table& table : listed_.tables) {
            each_row(table, [&](const ValueRow& row) {
                const ElementIndex element = find(row.id);
                if (element == kNoElement)
                    ++losses_.without_place;
                else
                    rows.put(listed_, raw(element), row.values.data(), losses_);
            });
        }
        note_part_of_model(rows.seen(), mesh_.element_count(), "elements");
        return {listed_.info, rows.finish(), {}, {}};
    }

    Result element_nodal() {
        ElementFinder find(mesh_);
        OwnedRows rows;
        std::vector<std::int64_t> nodes;  // Of the element that is being read.
        OwnedRows of_element;
        std::int64_t element = 0;
        const auto close = [&] {
            take_layer(nodes, of_element, rows);
            nodes.clear();
            of_element.clear();
        };
        for (const Table& table : listed_.tables) {
            each_row(table, [&](const ValueRow& row) {
                if (row.element != element) close();
                element = row.element;
                const ElementIndex index = find(row.element);
                const NodeIndex node = lookup_(NodeId{row.id});
                nodes.push_back(row.id);
                of_element.put(listed_, raw(index), node, row.values.data());
            });
        }
        close();
        return sorted_result(listed_, std::move(rows), losses_);
    }

    /// The rows of an element that belong to the result's layer.
    void take_layer(std::span<const std::int64_t> nodes, const OwnedRows& from, OwnedRows& to) {
        const std::size_t layers = count_layers(nodes);
        const std::size_t count = nodes.size() / layers;
        std::size_t first = 0;
        switch (listed_.info.layer) {
        case Layer::No:
            if (layers != 1) return;
            break;
        case Layer::Top:
            if (layers < 2) return;
            break;
        case Layer::Bottom:
            if (layers < 2) return;
            first = count;
            break;
        case Layer::Middle:
            if (layers < 3) return;
            first = 2 * count;
            break;
        }
        const std::size_t width = listed_.columns.size();
        for (std::size_t i = first; i < first + count; ++i) {
            if (from.owners[i] == raw(kNoElement) || from.nodes[i] == kNoNode) {
                ++losses_.without_place;
                continue;
            }
            to.owners.push_back(from.owners[i]);
            to.nodes.push_back(from.nodes[i]);
            const auto values = from.values.begin() + static_cast<std::ptrdiff_t>(i * width);
            to.values.insert(to.values.end(), values, values + static_cast<std::ptrdiff_t>(width));
        }
    }

    void note_part_of_model(std::size_t seen, std::size_t all, std::string_view what) {
        if (diagnostics_ == nullptr || seen >= all || listed_.info.corner_only) return;
        diagnostics_->add(
            Code::ResultForPartOfModel,
            listed_.where,
            fmt::format("{} has values for {} of {} {}", name(), seen, all, what)
        );
    }

    const std::string& name() const {
        return listed_.info.solver_name.empty() ? listed_.info.name : listed_.info.solver_name;
    }

    void report() {
        const auto add = [&](Code code, std::uint64_t count, std::string_view text) {
            if (count > 0) diagnostics_->add(code, listed_.where, fmt::format("{} {}", name(), text), count);
        };
        add(Code::ResultWithoutNode,
            losses_.without_place,
            "lists nodes or elements that the mesh does not have");
        add(Code::ResultWithoutNode, losses_.owners, "lists values of a material that no element has");
        add(Code::NonFiniteValue,
            losses_.bad_values,
            "has rows with NaN, *** or too large numbers; these are missing");
        add(Code::SeveralValuesAtNode,
            losses_.conflicts,
            "lists a node more than once with other values, and not by material or layer; it is missing there"
        );
    }

    const ListModel& model_;
    const ListedResult& listed_;
    const Mesh& mesh_;
    NodeLookup lookup_;
    Diagnostics* diagnostics_;
    Losses losses_;
};

}  // namespace

ElementFinder::ElementFinder(const Mesh& mesh) {
    std::uint32_t index = 0;
    indices_.reserve(mesh.element_count());
    for (const ElementBlock& block : mesh.blocks) {
        for (const ElementId id : block.ids) indices_.emplace_back(raw(id), index++);
    }
    std::ranges::sort(indices_);
}

ElementIndex ElementFinder::operator()(std::int64_t id) {
    for (std::size_t at = last_; at < std::min(last_ + 2, indices_.size()); ++at) {
        if (indices_[at].first != id || (at > 0 && indices_[at - 1].first == id)) continue;
        last_ = at;
        return ElementIndex{indices_[at].second};
    }
    const auto found =
        std::ranges::lower_bound(indices_, id, {}, &std::pair<std::int64_t, std::uint32_t>::first);
    if (found == indices_.end() || found->first != id) return kNoElement;
    last_ = static_cast<std::size_t>(found - indices_.begin());
    return ElementIndex{found->second};
}

Result load_values(
    const ListModel& model, const ListedResult& listed, const Mesh& mesh, Diagnostics* diagnostics
) {
    Result result = ValueLoader(model, listed, mesh, diagnostics).load();
    for (const ListedResult& further : listed.further) {
        const Result more = ValueLoader(model, further, mesh, diagnostics).load();
        const std::size_t width = more.component_count();
        const std::size_t before = mesh.node_count() == 0 ? 0 : result.values.size() / mesh.node_count();
        std::vector<float> joined;
        joined.reserve(result.values.size() + more.values.size());
        for (std::size_t row = 0; row < mesh.node_count(); ++row) {
            const auto first = result.values.begin() + static_cast<std::ptrdiff_t>(row * before);
            joined.insert(joined.end(), first, first + static_cast<std::ptrdiff_t>(before));
            const auto next = more.values.begin() + static_cast<std::ptrdiff_t>(row * width);
            joined.insert(joined.end(), next, next + static_cast<std::ptrdiff_t>(width));
        }
        result.values = std::move(joined);
    }
    return result;
}

}  // namespace feelem::ansys
