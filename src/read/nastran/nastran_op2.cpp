// SPDX-License-Identifier: Apache-2.0
// A .op2 file as a ModelSource: tables are listed on opening, values read on demand.
#include "read/nastran/nastran_op2.hpp"

#include "model/mesh_builder.hpp"
#include "read/element_lookup.hpp"
#include "read/nastran/op2_contents.hpp"
#include "read/nastran/op2_mesh.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace feelem {
namespace {

using namespace op2;

/// The alphabet with which Nastran starts a text ("formatted") .op2.
bool is_formatted(std::string_view head) {
    return head.substr(0, 64).find("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ$/+-()") != std::string_view::npos;
}

Likelihood recognise_op2(const Input& input) {
    WordForm form;
    const std::string_view head = head_of(input);
    if (is_formatted(head)) return Likelihood::Sure;
    return starts_op2(head, form) ? Likelihood::Sure : Likelihood::No;
}

SolverInfo solver_of(const std::string& label) {
    if (label.starts_with("NX")) return {"NX Nastran", label.substr(2)};
    if (label.starts_with("OS")) return {"OptiStruct", label.substr(2)};
    if (label == "XXXXXXXX") return {"MSC Nastran", {}};
    if (label.starts_with("AUTODESK")) return {"Autodesk Nastran", {}};
    return {"Nastran", label};
}

class Op2Source : public ModelSource {
public:
    Op2Source(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics), layout_(find_tables(input_, diagnostics)),
          contents_(list_contents(input_, layout_, diagnostics)) {
        find_mesh(context);
        for (Listed& listed : contents_.results) {
            if (!listed.of_elements) {
                const bool is_basic = contents_.nodal[listed.block].is_basic();
                listed.info.nodal_system =
                    listed.info.shape == Shape::Vector && !is_basic && !mesh_->node_angles.empty();
            }
            infos_.push_back(listed.info);
        }
        reported_.resize(infos_.size());
        note_partial_results();
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return contents_.steps; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return solver_of(layout_.version); }
    std::string title() const override { return contents_.title; }

    Result load(std::size_t index) override {
        const Listed& listed = contents_.results.at(index);
        Result result;
        result.info = infos_[index];
        if (listed.of_elements) {
            load_elements(listed, result);
        } else {
            load_nodal(listed, result);
        }
        reported_[index] = true;
        return result;
    }

private:
    void load_nodal(const Listed& listed, Result& result) {
        const NodalBlock& block = contents_.nodal[listed.block];
        NodalValues values =
            read_nodal(input_, layout_, block, *mesh_, listed.first, listed.info.components.size());
        result.values = std::move(values.values);
        if (is_reported(listed)) return;
        report(
            Code::ResultWithoutNode,
            block.table,
            "lists nodes that the mesh does not have",
            values.without_node
        );
        report_missing(block.table, values.without_number);
    }

    void load_elements(const Listed& listed, Result& result) {
        const ElementResult& block = contents_.elements[listed.block];
        if (!lookup_) lookup_.emplace(*mesh_);
        ElementValues values = read_elements(input_, layout_, block, *mesh_, *lookup_);
        result.values = std::move(values.values);
        result.row_owner = std::move(values.row_owner);
        result.row_node = std::move(values.row_node);
        if (is_reported(listed)) return;
        report_values(values, block.table, input_.name(), diagnostics_);
    }

    bool is_reported(const Listed& listed) const {
        return reported_[static_cast<std::size_t>(&listed - contents_.results.data())];
    }

    void find_mesh(const ReadContext& context) {
        Diagnostics unsaid;
        if (context.mesh != nullptr) {
            // What is odd in the deck was said when it was read.
            const Mesh own = read_mesh(input_, layout_, unsaid);
            check_same_ids(*context.mesh, own, input_);
            if (own.node_count() == 0) check_most_are_known(*context.mesh, ids_of_first_block(), input_);
            mesh_ = context.mesh;
            return;
        }
        own_mesh_ = read_mesh(input_, layout_, diagnostics_);
        if (own_mesh_.node_count() == 0) own_mesh_ = nodes_of_results();
        if (own_mesh_.node_count() == 0) {
            throw Error(
                Code::NoNodes,
                input_.name(),
                "the .op2 file holds no geometry and no results at nodes. Give the .bdf with it, or write "
                "both "
                "with PARAM,POST,-1 and DISPLACEMENT(PLOT) = ALL"
            );
        }
        mesh_ = &own_mesh_;
    }

    /// Of one result: they are the same in all of a file.
    std::vector<NodeId> ids_of_first_block() const {
        std::vector<NodeId> ids;
        if (!contents_.nodal.empty()) collect_ids(input_, layout_, contents_.nodal.front(), ids);
        std::ranges::sort(ids);
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        return ids;
    }

    /// Without geometry the ids of the results are all that is known: their places are missing.
    Mesh nodes_of_results() {
        std::vector<NodeId> ids;
        const auto tidy = [&] {
            std::ranges::sort(ids);
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        };
        std::size_t limit = 0;
        for (const NodalBlock& block : contents_.nodal) {
            collect_ids(input_, layout_, block, ids);
            if (ids.size() < limit) continue;
            tidy();
            limit = 2 * ids.size() + 1000;
        }
        tidy();
        constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
        MeshBuilder builder(diagnostics_);
        builder.reserve_nodes(ids.size());
        for (const NodeId id : ids) builder.add_node(id, {kNowhere, kNowhere, kNowhere});
        builder.seal_nodes();
        return builder.finish();
    }

    void note_partial_results() {
        for (const Listed& listed : contents_.results) {
            if (listed.of_elements) continue;
            const std::uint64_t rows = row_count(layout_, contents_.nodal[listed.block]);
            if (rows >= mesh_->node_count()) continue;
            diagnostics_.add(
                Code::ResultForPartOfModel,
                input_.name(),
                fmt::format("{} has values for {} of {} nodes", listed.info.name, rows, mesh_->node_count())
            );
        }
    }

    void report(Code code, const std::string& table, const char* what, std::uint64_t count) {
        if (count > 0) diagnostics_.add(code, input_.name(), fmt::format("{} {}", table, what), count);
    }

    void report_missing(const std::string& table, std::uint64_t count) {
        report(
            Code::NonFiniteValue, table, "has values that are no finite numbers; they count as missing", count
        );
    }

    Input input_;
    Diagnostics& diagnostics_;
    Layout layout_;
    Contents contents_;
    Mesh own_mesh_;
    std::optional<ElementLookup> lookup_;
    const Mesh* mesh_ = nullptr;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

std::unique_ptr<ModelSource> open_op2(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    const Input& input = inputs.front();
    if (is_formatted(head_of(input))) {
        throw Error(
            Code::BadStructure,
            input.name(),
            "this is a formatted (text) .op2, which Feelem does not read. Write it in binary: ASSIGN "
            "OUTPUT2='name.op2' UNFORM UNIT=12 (without FORM), or PARAM,POST,-1 alone"
        );
    }
    return std::make_unique<Op2Source>(input, context, diagnostics);
}

}  // namespace

ReadFormat nastran_op2_format() {
    return {{"nastran-op2", "Nastran results, binary", ".op2", true, true}, false, recognise_op2, open_op2};
}

}  // namespace feelem
