// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/op2_nodal.hpp"

#include "model/node_lookup.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace feelem::op2 {
namespace {

constexpr int kGridStressCode = 27;
constexpr std::size_t kGridStressRow = 9;
constexpr std::size_t kRealRow = 8;
constexpr std::size_t kComplexRow = 14;

struct KindRow {
    int code;
    NodalKind structural;
    NodalKind thermal;  ///< Without a name: not known.
};
constexpr KindRow kKinds[]{
    {1, {"displacement", "rotation"}, {"temperature", {}}},
    {2, {"applied_force", "applied_moment"}, {"applied_heat_flow", {}}},
    {3, {"reaction_force", "reaction_moment"}, {"reaction_heat_flow", {}}},
    {7, {"displacement", "rotation"}, {}},
    {10, {"velocity", "angular_velocity"}, {"temperature_rate", {}}},
    {11, {"acceleration", "angular_acceleration"}, {"temperature_acceleration", {}}},
    {39, {"mpc_force", "mpc_moment"}, {"mpc_heat_flow", {}}},
};

class RowReader {
public:
    RowReader(const Input& input, const Layout& layout, const NodalBlock& block)
        : input_(input), layout_(layout), block_(block) {}

    /// Calls each(id, row) for the rows of the block's step.
    template <class Each>
    void rows(const Each& each) {
        const std::size_t width = block_.row_words();
        if (block_.by_node == nullptr) {
            check_length(block_.record);
            for_each_row(input_, layout_, block_.record, width, [&](const Words& row) {
                each(NodeId{row.integer(0) / 10}, row);
            });
            return;
        }
        for (const SortedRecord& one : *block_.by_node) {
            check_length(one.record);
            const Words rows_of_node = record_words(input_, layout_, one.record, scratch_);
            // Steps stand in the same order under each node as a rule, but a node may lack some.
            if (const auto at =
                    row_of_step(block_.ident, rows_of_node, width, block_.row * width, block_.step))
                each(NodeId{one.id}, rows_of_node.part(*at, width));
        }
    }

private:
    void check_length(std::size_t record) const {
        const std::size_t words = layout_.record_bytes(record) / layout_.form.size;
        if (words % block_.row_words() == 0) return;
        const auto segments = layout_.record(record);
        throw Error(
            Code::BadStructure,
            input_.where_byte(segments.empty() ? 0 : segments.front().first),
            fmt::format(
                "{} has {} words of data where each row needs {}", block_.table, words, block_.row_words()
            )
        );
    }

    const Input& input_;
    const Layout& layout_;
    const NodalBlock& block_;
    std::vector<std::byte> scratch_;
};

}  // namespace

std::optional<NodalKind> nodal_kind(const Ident& ident) {
    constexpr int kHeatTransfer = 1;
    if (ident.random || (ident.thermal != 0 && ident.thermal != kHeatTransfer)) return {};
    if (ident.table_code == kGridStressCode && ident.row_words == kGridStressRow && !ident.sort2)
        return NodalKind{"grid_point_stress", {}, true};
    if (ident.row_words != kRealRow && ident.row_words != kComplexRow) return {};
    for (const KindRow& kind : kKinds) {
        if (kind.code != ident.table_code) continue;
        const NodalKind& found = ident.thermal == kHeatTransfer ? kind.thermal : kind.structural;
        if (!found.name.empty()) return found;
    }
    return {};
}

bool NodalBlock::is_complex() const {
    return ident.row_words == kComplexRow;
}

std::size_t NodalBlock::first_number() const {
    // id * 10 + device and, but for stresses, the kind of point.
    return ident.table_code == kGridStressCode ? 1 : 2;
}

NodalValues read_nodal(
    const Input& input,
    const Layout& layout,
    const NodalBlock& block,
    const Mesh& mesh,
    std::size_t first,
    std::size_t columns
) {
    NodalValues out;
    out.values.assign(mesh.node_count() * columns, std::numeric_limits<float>::quiet_NaN());
    const NodeLookup lookup(mesh.node_ids);
    RowReader(input, layout, block).rows([&](NodeId id, const Words& row) {
        ++out.rows;
        const NodeIndex node = lookup(id);
        if (node == kNoNode) {
            ++out.without_node;
            return;
        }
        for (std::size_t c = 0; c < columns; ++c) {
            const auto value = static_cast<float>(row.real(block.first_number() + first + c));
            if (std::isfinite(value)) out.values[raw(node) * columns + c] = value;
            if (!std::isfinite(value)) ++out.without_number;
        }
    });
    return out;
}

void collect_ids(
    const Input& input, const Layout& layout, const NodalBlock& block, std::vector<NodeId>& ids
) {
    if (block.by_node != nullptr) {
        // Once for all steps of the table.
        if (block.row != 0) return;
        for (const SortedRecord& one : *block.by_node) ids.push_back(NodeId{one.id});
        return;
    }
    for_each_row(input, layout, block.record, block.row_words(), [&](const Words& row) {
        ids.push_back(NodeId{row.integer(0) / 10});
    });
}

std::uint64_t row_count(const Layout& layout, const NodalBlock& block) {
    if (block.by_node != nullptr) return block.by_node->size();
    return layout.record_bytes(block.record) / layout.form.size / block.row_words();
}

}  // namespace feelem::op2
