// SPDX-License-Identifier: Apache-2.0
// A universal file as a ModelSource: heads are listed on opening, values read on demand.
#include "read/unv/unv_format.hpp"

#include "read/merged_model.hpp"
#include "read/unv/unv_datasets.hpp"
#include "read/unv/unv_mesh.hpp"
#include "read/unv/unv_results.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace feelem {
namespace unv {
namespace {

Likelihood recognise_unv(const Input& input) {
    return starts_like_unv(input) ? Likelihood::Sure : Likelihood::No;
}

class UnvSource : public ModelSource {
public:
    UnvSource(Input input, const ReadContext& context, Diagnostics& diagnostics)
        : input_(std::move(input)), diagnostics_(diagnostics) {
        const std::vector<Dataset> datasets = find_datasets(input_, diagnostics);
        own_mesh_ = read_mesh(input_, datasets, diagnostics);
        choose_mesh(context);
        Contents contents = list_contents(input_, datasets, diagnostics);
        steps_ = std::move(contents.steps);
        listed_ = std::move(contents.results);
        for (const Listed& listed : listed_) infos_.push_back(listed.info);
        reported_.resize(listed_.size());
    }

    const Mesh& mesh() const override { return *mesh_; }
    std::span<const Step> steps() const override { return steps_; }
    std::span<const ResultInfo> results() const override { return infos_; }
    std::span<const InputRecord> inputs() const override { return {}; }

    Result load(std::size_t index) override {
        Values values = read_values(input_, listed_.at(index), *mesh_);
        if (!reported_[index]) report(infos_[index], values);
        reported_[index] = true;
        return std::move(values.result);
    }

private:
    void choose_mesh(const ReadContext& context) {
        const bool has_elements = own_mesh_.element_count() > 0 || !own_mesh_.skipped_elements.empty();
        if (context.mesh != nullptr && !has_elements) {
            own_mesh_ = {};
            mesh_ = context.mesh;
            return;
        }
        if (own_mesh_.node_count() == 0) {
            throw Error(
                Code::NoNodes,
                input_.name(),
                "the universal file defines no nodes (datasets 2411, 781, 15). Were results exported alone? "
                "Then "
                "name the file with the mesh before this one."
            );
        }
        mesh_ = own_or_shared(own_mesh_, context.mesh);
    }

    void report(const ResultInfo& info, const Values& values) {
        const auto add = [&](Code code, std::uint64_t count, std::string_view text) {
            if (count > 0)
                diagnostics_.add(code, input_.name(), fmt::format("{} {}", info.solver_name, text), count);
        };
        add(Code::ResultWithoutNode,
            values.without_owner,
            "lists nodes or elements that the mesh does not have");
        add(Code::NonFiniteValue,
            values.without_number,
            "has values that are no finite numbers; they count as missing");
        add(Code::SeveralValuesAtNode,
            values.left_over,
            "lists more values a place than its head says (shell layers); only the first are read");
    }

    Input input_;
    Diagnostics& diagnostics_;
    Mesh own_mesh_;
    const Mesh* mesh_ = nullptr;
    std::vector<Step> steps_;
    std::vector<Listed> listed_;
    std::vector<ResultInfo> infos_;
    std::vector<bool> reported_;
};

std::unique_ptr<ModelSource> open_unv(
    std::span<const Input> inputs, const ReadContext& context, Diagnostics& diagnostics
) {
    return std::make_unique<UnvSource>(inputs.front(), context, diagnostics);
}

}  // namespace
}  // namespace unv

ReadFormat unv_format() {
    return {
        {"unv", "Universal files of I-deas, NX, Salome, gmsh", ".unv .uff", true, true},
        false,
        unv::recognise_unv,
        unv::open_unv};
}

}  // namespace feelem
