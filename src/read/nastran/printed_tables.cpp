// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/printed_tables.hpp"

#include "model/mesh_builder.hpp"
#include "model/node_lookup.hpp"
#include "read/element_lookup.hpp"
#include "read/nastran/element_rows.hpp"
#include "read/nastran/op2_steps.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace feelem::nastran {
namespace {

constexpr std::size_t kDegrees = 6;  ///< Three translations, three rotations.

struct ListedTable {
    ResultInfo info;
    std::size_t table = 0;
    std::size_t first = 0;  ///< First number of a row.
};

class PrintedSource : public ModelSource {
public:
    PrintedSource(
        Input input,
        PrintedTables tables,
        ReadPrintedRow read_row,
        ReadPrintedElements read_elements,
        const ReadContext& context,
        Diagnostics& diagnostics
    )
        : input_(std::move(input)), tables_(std::move(tables)), read_row_(read_row),
          read_elements_(read_elements), diagnostics_(diagnostics) {
        const bool has_elements = context.mesh != nullptr && !tables_.elements.empty();
        if (tables_.tables.empty() && !has_elements) {
            throw Error(
                Code::NoNodes,
                input_.name(),
                tables_.elements.empty()
                    ? "the file holds no results at grid points or of elements. Ask for them in the case "
                      "control: "
                      "DISPLACEMENT(PRINT,PUNCH) = ALL, STRESS(PRINT,PUNCH) = ALL"
                    : "the file holds results of elements and no grid points: give the deck (.bdf) with it"
            );
        }
        own_mesh_ = context.mesh == nullptr ? nodes_of_rows() : Mesh{};
        mesh_ = context.mesh == nullptr ? &own_mesh_ : context.mesh;
        lookup_.emplace(mesh_->node_ids);
        list();
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return tables_.solver; }
    std::string title() const override { return tables_.title; }
    Result load(std::size_t index) override;

private:
    /// Calls each(id, kind, numbers) for all values of a table.
    template <class Each>
    void for_rows(const PrintedTable& table, const Each& each) const {
        PrintedRow row;
        for (const PrintedRows& rows : table.rows) {
            std::size_t at = rows.first;
            while (read_row_(input_.text(), at, rows.last, rows, row)) {
                if (rows.node != 0) row.id = rows.node;
                if (!rows.packed) {
                    each(row.id, row);
                    continue;
                }
                const PrintedRow several = row;
                for (std::size_t i = 0; i < several.count; ++i) {
                    row.numbers[0] = several.numbers[i];
                    row.count = 1;
                    row.kind = 'S';
                    each(several.id + static_cast<std::int64_t>(i), row);
                }
            }
        }
    }

    Mesh nodes_of_rows() const {
        std::vector<NodeId> ids;
        for (const PrintedTable& table : tables_.tables) {
            for_rows(table, [&](std::int64_t id, const PrintedRow&) {
                if (ids.empty() || ids.back() != NodeId{id}) ids.push_back(NodeId{id});
            });
            std::ranges::sort(ids);
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        }
        constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
        MeshBuilder builder(diagnostics_);
        for (const NodeId id : ids) builder.add_node(id, {kNowhere, kNowhere, kNowhere});
        builder.seal_nodes();
        return builder.finish();
    }

    void list() {
        for (const PrintedTables::StepEntry& step : tables_.steps)
            step_list_.add(step.key, step.value, step.texts);
        steps_ = step_list_.finish();
        for (std::size_t i = 0; i < tables_.tables.size(); ++i) {
            const PrintedTable& table = tables_.tables[i];
            const std::uint32_t step = step_list_.index_of(table.step);
            add(i, step, table.name, 0, !table.rotation.empty());
            if (!table.rotation.empty()) add(i, step, table.rotation, 3, true);
        }
        list_elements();
        reported_.resize(infos_.size());
    }

    /// Where there is no deck, nobody knows the elements.
    void list_elements() {
        if (tables_.elements.empty()) return;
        if (mesh_->element_count() == 0) {
            diagnostics_.add(
                Code::UnknownBlock,
                input_.name(),
                "results of elements are not used without the deck (.bdf): give it with this file",
                tables_.elements.size()
            );
            return;
        }
        elements_.emplace(*mesh_);
        op2::ElementGroups groups;
        for (std::size_t i = 0; i < tables_.elements.size(); ++i) {
            const PrintedElements& table = tables_.elements[i];
            groups.add({table.table, table.step, table.kind, false}, {table.layout, i, nullptr, 0});
        }
        results_of_elements_ = groups.finish();
        op2::ResultNames names;
        for (const op2::ElementResult& result : results_of_elements_) {
            ResultInfo info = op2::element_info(result);
            info.step = step_list_.index_of(result.step);
            info.name = names.unique(info, info.name);
            infos_.push_back(std::move(info));
        }
    }

    Result load_elements(std::size_t index) {
        const op2::ElementResult& listed = results_of_elements_[index - listed_.size()];
        op2::ElementRowReader reader(listed, *mesh_, *elements_);
        for (const op2::ElementBlockRef& block : listed.blocks) {
            read_elements_(
                input_,
                tables_.elements[block.record],
                [&](std::int64_t element, const op2::Words& row) { reader.read(element, row, *block.layout); }
            );
        }
        op2::ElementValues values = reader.finish();
        if (!reported_[index]) op2::report_values(values, listed.table, input_.name(), diagnostics_);
        reported_[index] = true;
        return {
            infos_[index], std::move(values.values), std::move(values.row_owner), std::move(values.row_node)};
    }

    void add(
        std::size_t index, std::uint32_t step, const std::string& name, std::size_t first, bool is_vector
    ) {
        const PrintedTable& table = tables_.tables[index];
        const bool is_complex = table.numbers != PrintedNumbers::Real;
        const bool polar = table.numbers == PrintedNumbers::MagnitudePhase;
        for (std::size_t part = 0; part < (is_complex ? 2U : 1U); ++part) {
            ResultInfo info;
            info.name = name;
            info.solver_name = table.solver_name;
            info.step = step;
            info.location = Location::Nodal;
            info.shape = is_vector ? Shape::Vector : Shape::Scalar;
            info.components =
                is_vector ? std::vector<std::string>{"x", "y", "z"} : std::vector<std::string>{"value"};
            info.nodal_system = is_vector && !mesh_->node_angles.empty();
            if (is_complex && part == 0) info.complex = polar ? Complex::Amplitude : Complex::Real;
            if (is_complex && part == 1) info.complex = polar ? Complex::Phase : Complex::Imaginary;
            listed_.push_back({info, index, part * kDegrees + first});
            infos_.push_back(std::move(info));
        }
    }

    void report(const PrintedTable& table, std::uint64_t rows, std::uint64_t lost, std::uint64_t bad) {
        const auto add_note = [&](Code code, std::string text, std::uint64_t count) {
            diagnostics_.add(code, input_.name(), std::move(text), count);
        };
        if (lost > 0)
            add_note(
                Code::ResultWithoutNode, table.solver_name + " lists nodes that the mesh does not have", lost
            );
        if (bad > 0)
            add_note(
                Code::NonFiniteValue,
                table.solver_name + " has values that are no finite numbers; they count as missing",
                bad
            );
        if (rows < mesh_->node_count())
            add_note(
                Code::ResultForPartOfModel,
                fmt::format("{} has values for {} of {} nodes", table.name, rows, mesh_->node_count()),
                1
            );
    }

    Input input_;
    PrintedTables tables_;
    ReadPrintedRow read_row_;
    ReadPrintedElements read_elements_;
    Diagnostics& diagnostics_;
    Mesh own_mesh_;
    const Mesh* mesh_ = nullptr;
    std::optional<NodeLookup> lookup_;
    op2::StepList step_list_;
    std::vector<Step> steps_;
    std::vector<ListedTable> listed_;                      ///< Results at grid points; then come
    std::vector<op2::ElementResult> results_of_elements_;  ///< those of elements.
    std::optional<ElementLookup> elements_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

Result PrintedSource::load(std::size_t index) {
    if (index >= listed_.size() && index < infos_.size()) return load_elements(index);
    const ListedTable& listed = listed_.at(index);
    const PrintedTable& table = tables_.tables[listed.table];
    const std::size_t width = listed.info.components.size();
    Result result;
    result.info = listed.info;
    result.values.assign(mesh_->node_count() * width, std::numeric_limits<float>::quiet_NaN());
    std::uint64_t rows = 0, lost = 0, bad = 0;
    for_rows(table, [&](std::int64_t id, const PrintedRow& row) {
        const NodeIndex node = (*lookup_)(NodeId{id});
        if (node == kNoNode) {
            ++lost;
            return;
        }
        ++rows;
        for (std::size_t i = 0; i < width; ++i) {
            // A scalar point has its one number and, where complex, that number's other part.
            const std::size_t at = listed.first + i;
            if (at >= row.count || (row.kind == 'S' && at % kDegrees != 0)) continue;
            const float value = row.numbers[at];
            if (!std::isfinite(value)) ++bad;
            result.values[raw(node) * width + i] =
                std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
        }
    });
    if (!reported_[index]) report(table, rows, lost, bad);
    reported_[index] = true;
    return result;
}

}  // namespace

PrintedTable& PrintedTables::at(
    const Head& head, const op2::StepKey& step, double value, const op2::Texts& texts
) {
    const bool heat = head.is_scalar && !head.kind->thermal.empty();
    const std::string name(heat ? head.kind->thermal : head.kind->name);
    const auto [found, is_new] = index_.try_emplace(std::tuple(name, step, head.numbers), tables.size());
    if (is_new) {
        PrintedTable& table = tables.emplace_back();
        table.name = name;
        table.rotation = heat ? std::string_view{} : head.kind->rotation;
        table.solver_name = head.kind->title;
        table.step = step;
        table.numbers = head.numbers;
        steps.push_back({step, value, texts});
    }
    return tables[found->second];
}

PrintedElements& PrintedTables::elements_at(
    const PrintedElements& head, double value, const op2::Texts& texts
) {
    const auto [found, is_new] = element_index_.try_emplace(
        std::tuple(head.table, head.step, head.kind, head.layout->type), elements.size()
    );
    if (is_new) {
        elements.push_back(head);
        elements.back().rows.clear();
        steps.push_back({head.step, value, texts});
    }
    return elements[found->second];
}

std::unique_ptr<ModelSource> open_printed(
    Input input,
    PrintedTables tables,
    ReadPrintedRow read_row,
    ReadPrintedElements read_elements,
    const ReadContext& context,
    Diagnostics& diagnostics
) {
    return std::make_unique<PrintedSource>(
        std::move(input), std::move(tables), read_row, read_elements, context, diagnostics
    );
}

}  // namespace feelem::nastran
