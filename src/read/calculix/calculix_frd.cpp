// SPDX-License-Identifier: Apache-2.0
// A .frd file as a ModelSource: heads are listed on opening, values read on demand.
#include "read/calculix/calculix_frd.hpp"

#include "read/calculix/frd_blocks.hpp"
#include "read/calculix/frd_mesh.hpp"
#include "read/calculix/frd_names.hpp"
#include "read/calculix/frd_values.hpp"
#include "read/merged_model.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace feelem {
namespace {

using namespace frd;

Likelihood recognise_frd(const Input& input) {
    const std::string_view head = head_of(input);
    if (head.starts_with("    1C")) return Likelihood::Sure;
    return head.starts_with("    1U") || head.starts_with("    2C") ? Likelihood::Maybe : Likelihood::No;
}

class FrdSource : public ModelSource {
public:
    FrdSource(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics), layout_(find_blocks(input_, diagnostics)) {
        read_own_mesh(context);
        frd::Contents contents = list_contents(layout_.results);
        steps_ = std::move(contents.steps);
        listed_ = std::move(contents.results);
        for (const frd::Listed& listed : listed_) infos_.push_back(listed.info);
        reported_.resize(listed_.size());
        note_partial_results();
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }
    SolverInfo solver() const override { return layout_.solver; }
    std::string title() const override { return layout_.title; }

    Result load(std::size_t index) override {
        const frd::Listed& listed = listed_.at(index);
        const ResultBlock& block = layout_.results[listed.block];
        Values values = read_values(input_, block, listed.columns, *mesh_, layout_.swap);
        if (!reported_[index]) report(block, values);
        reported_[index] = true;
        Result result;
        result.info = listed.info;
        result.values = std::move(values.values);
        return result;
    }

private:
    void read_own_mesh(const ReadContext& context) {
        if (layout_.has_nodes) own_mesh_ = read_mesh(input_, layout_, diagnostics_);
        const bool has_mesh = own_mesh_.element_count() > 0 || !own_mesh_.skipped_elements.empty();
        if (context.mesh != nullptr && !has_mesh) {  // Results alone are matched by id.
            own_mesh_ = {};
            mesh_ = context.mesh;
            return;
        }
        if (own_mesh_.node_count() == 0) {
            throw Error(
                Code::NoNodes,
                input_.name(),
                "the .frd file defines no nodes. Was the solver stopped before it wrote its mesh?"
            );
        }
        mesh_ = own_or_shared(own_mesh_, context.mesh);
    }

    void note_partial_results() {
        for (const ResultBlock& block : layout_.results) {
            if (block.body.count >= mesh_->node_count()) continue;
            diagnostics_.add(
                Code::ResultForPartOfModel,
                input_.name(),
                fmt::format(
                    "{} has values for {} of {} nodes", block.name, block.body.count, mesh_->node_count()
                )
            );
        }
    }

    void report(const ResultBlock& block, const Values& values) {
        const std::string where = input_.name();
        if (values.without_node > 0) {
            diagnostics_.add(
                Code::ResultWithoutNode,
                where,
                fmt::format("{} lists nodes that the mesh does not have", block.name),
                values.without_node
            );
        }
        if (values.without_number > 0) {
            diagnostics_.add(
                Code::NonFiniteValue,
                where,
                fmt::format("{} has values that are no finite numbers; they count as missing", block.name),
                values.without_number
            );
        }
    }

    Input input_;
    Diagnostics& diagnostics_;
    Layout layout_;
    Mesh own_mesh_;
    const Mesh* mesh_ = nullptr;
    std::vector<Step> steps_;
    std::vector<frd::Listed> listed_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

std::unique_ptr<ModelSource> open_frd(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<FrdSource>(inputs.front(), context, diagnostics);
}

}  // namespace

ReadFormat calculix_frd_format() {
    return {
        {"calculix-frd", "CalculiX results, text and binary", ".frd", true, true},
        false,
        recognise_frd,
        open_frd};
}

}  // namespace feelem
